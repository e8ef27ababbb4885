//! Numbers with known errors: double-doubles, balls, exact degrees, and their cosines and sines.

mod ball;
pub(crate) mod cos_sin;
mod degrees;
mod double_double;
mod series;
mod sines;
mod vector;

pub use ball::Ball;
pub use degrees::{COS_SIN_ERROR, Degrees, TAILED_ERROR, Turn};
pub(crate) use double_double::fast_two_sum;
pub use double_double::{COMBINED_ERROR, Dd, combined, taming_power, two_product, two_sum};
pub(crate) use vector::{two_product_each, two_sum_each};
