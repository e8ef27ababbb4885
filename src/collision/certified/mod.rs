//! What proves the numbers: bodies in, enclosures out; no query, no event.

pub(crate) mod distance;
pub(crate) mod impact;
pub(crate) mod rounding;
pub(crate) mod sweep;
