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
    /// The bounds enclose the exact separation of the bodies as their doubles say it.
    ///
    /// ```
    /// use tracefig::collision::Pair;
    /// use tracefig::geometry::{Body, DVec2, Degrees, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let moving = |x, v| Body {
    ///     shape: shape.clone(), position: DVec2::new(x, 0.0), angle: Degrees(0.0),
    ///     velocity: DVec2::new(v, 0.0), spin: Degrees(0.0),
    /// };
    /// let (a, b) = (moving(0.0, 4.0), moving(4.0, 0.0));
    /// let found = Pair::at(&a, &b, 0.0).separation();
    /// assert_eq!((found.separation, *found.normal), (2.0, DVec2::X));
    /// ```
    #[must_use]
    pub fn separation(&self) -> Separation {
        certify(self, None)
    }
}
