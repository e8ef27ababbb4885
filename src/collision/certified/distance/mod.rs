//! The separation of a pair at one moment, proved.

pub(crate) mod balls;
pub(crate) mod boundary;
pub(crate) mod filter;
pub(crate) mod gaps;
pub(crate) mod pair;
pub(crate) mod refine;
pub(crate) mod search;
pub(crate) mod witnesses;

use crate::collision::answer::Separation;

impl pair::Pair<'_> {
    /// Signed separation with its witnesses, in world units, negative inside.
    ///
    /// The bounds enclose the exact separation of the bodies as their doubles say it; see [`pair::Pair::at`]
    /// for an example.
    #[must_use]
    pub fn separation(&self) -> Separation {
        search::certify(self, None)
    }
}
