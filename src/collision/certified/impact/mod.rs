//! The first contact of two bodies that move and turn, proved.

pub(crate) mod axis;
pub(crate) mod closest;
pub(crate) mod contact;
pub(crate) mod filter;
pub(crate) mod moving_pair;
pub(crate) mod search;
pub(crate) mod taylor;
