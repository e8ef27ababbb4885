//! The separation of a pair at one moment, proved.

pub(crate) mod balls;
pub(crate) mod boundary;
pub(crate) mod filter;
pub(crate) mod gaps;
pub(crate) mod pair;
pub(crate) mod refine;
pub(crate) mod search;
pub(crate) mod witnesses;
