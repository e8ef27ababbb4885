//! Round numbers: those of a scale.

use crate::geometry::read;

/// The least of 1, 2 and 5 times a power of ten that is `least` or more; `None` where there is no such
/// double.
pub(crate) fn round_up(least: f64) -> Option<f64> {
    if !(least.is_finite() && least > 0.0) {
        return None;
    }
    let e = exponent(least);
    let steps = [(1, e - 1), (1, e), (2, e), (5, e), (1, e + 1)];
    steps.into_iter().filter_map(|(m, e)| decimal(m, e)).find(|step| *step >= least)
}

/// The decimal exponent of the first digit of a number.
pub(crate) fn exponent(x: f64) -> i32 {
    let text = format!("{:e}", x.abs());
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// The double nearest to m · 10ᵉ; `None` where that is too large, or 0.
pub(crate) fn decimal(m: u32, e: i32) -> Option<f64> {
    read(&format!("{m}e{e}")).filter(|x| x.is_finite() && *x > 0.0)
}
