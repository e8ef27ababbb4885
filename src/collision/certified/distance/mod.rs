//! The separation of a pair at one moment, proved.
//!
//! A question goes to the [`filter`] first: doubles guess the nearest feature of B ⊖ A and mostly prove it.
//! Where they leave something open, the [`search`] decides in balls, starting from a feature that the asker
//! holds to be nearest.

pub(super) mod balls;
mod boundary;
pub(super) mod filter;
pub(super) mod gaps;
pub(super) mod pair;
pub(super) mod refine;
pub(super) mod search;
pub(super) mod witnesses;

pub use pair::Pair;

use crate::collision::answer::Separation;
use crate::collision::feature::DifferenceFeature;

/// The separation of a pair, proved. Of directions that tie, that of the `hint` is taken.
#[inline]
pub(crate) fn certify(pair: &Pair, hint: Option<DifferenceFeature>) -> Separation {
    match filter::proved(pair) {
        Some(proved) => witnesses::answer(pair, &proved),
        None => search::settle(pair, hint),
    }
}

impl Pair<'_> {
    /// Signed separation with its witnesses, in world units, negative inside.
    ///
    /// The bounds enclose the exact separation of the bodies as their doubles say it; see [`Pair::at`] for an
    /// example.
    #[must_use]
    pub fn separation(&self) -> Separation {
        certify(self, None)
    }
}
