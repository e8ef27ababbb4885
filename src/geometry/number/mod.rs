//! Numbers with known errors: double-doubles, balls, exact angles, and their cosines and sines.

mod angle;
mod ball;
pub(crate) mod cos_sin;
mod degrees;
mod double_double;
mod exact;
mod expansion;
mod length;
mod radians;
mod read;
#[cfg(test)]
mod roundings;
mod series;
mod sines;

pub use angle::Angle;
pub(crate) use ball::Ball;
pub(crate) use degrees::Turn;
pub(crate) use double_double::{Dd, combined, fast_two_sum, taming_power, two_product, two_sum};
pub(crate) use exact::Exact;
pub(crate) use length::length;
pub(crate) use read::{power_of_ten, read};

/// The most units of S ε that people are told how far another answer is off: some twenty roundings of single
/// precision. What is off by more has no rounding to blame.
pub(crate) const MOST_EPS: f64 = 1e10;
