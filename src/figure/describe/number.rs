//! Numbers and points in running text.

use crate::figure::text::{in_words, plain, rounded, rounded_down, rounded_up};
use crate::geometry::DVec2;

/// A number lying in [`lo`, `hi`], to three digits and no more than both ends share.
pub(super) fn number(lo: f64, hi: f64) -> String {
    plain(&in_words(&rounded(lo, hi)))
}

/// A double, to three digits.
pub(super) fn value(v: f64) -> String {
    number(v, v)
}

/// A double of which is said that something is no more, to three digits.
pub(super) fn at_most(v: f64) -> String {
    plain(&in_words(&rounded_up(v)))
}

/// A double of which is said that something is no less, to three digits.
pub(super) fn at_least(v: f64) -> String {
    plain(&in_words(&rounded_down(v)))
}

/// A coordinate this much smaller than the other one is rounding, far below what three digits or an eye tell.
const NOTHING_BESIDE: f64 = 1e-12;

/// A point or vector as `(x, y)`.
pub(super) fn point(p: DVec2) -> String {
    let least = NOTHING_BESIDE * p.abs().max_element();
    let [x, y] = [p.x, p.y].map(|c| value(if c.abs() < least { 0.0 } else { c }));
    format!("({x}, {y})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_that_is_rounding_reads_as_zero() {
        assert_eq!(point(DVec2::new(1.5, -1.12e-16)), "(1.5, 0)");
        assert_eq!(point(DVec2::new(1.5e-13, -1.12e-16)), "(1.5 × 10^−13, −1.12 × 10^−16)");
    }
}
