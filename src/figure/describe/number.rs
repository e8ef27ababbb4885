//! Numbers and points in running text, in the language of a scene.

use crate::figure::text::{in_words, plain, rounded, rounded_down, rounded_up};
use crate::geometry::DVec2;
use crate::trace::{Phrase, Tongue};

/// A coordinate this much smaller than the other one is rounding, far below what three digits or an eye tell.
const NOTHING_BESIDE: f64 = 1e-12;

/// A language in which a figure is told.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speech(pub(super) Tongue);

impl Speech {
    /// A phrase with the values that stand for its stars.
    pub(super) fn say(self, phrase: &Phrase, values: &[&str]) -> String {
        self.0.say(phrase, values)
    }

    /// A number lying in [`lo`, `hi`], to three digits and no more than both ends share.
    pub(super) fn number(self, lo: f64, hi: f64) -> String {
        self.0.decimal(plain(&in_words(&rounded(lo, hi))))
    }

    /// A double, to three digits.
    pub(super) fn value(self, v: f64) -> String {
        self.number(v, v)
    }

    /// A double of which is said that something is no more, to three digits.
    pub(super) fn at_most(self, v: f64) -> String {
        self.0.decimal(plain(&in_words(&rounded_up(v))))
    }

    /// A double of which is said that something is no less, to three digits.
    pub(super) fn at_least(self, v: f64) -> String {
        self.0.decimal(plain(&in_words(&rounded_down(v))))
    }

    /// A point or vector as `(x, y)`.
    pub(super) fn point(self, p: DVec2) -> String {
        let least = NOTHING_BESIDE * p.abs().max_element();
        let [x, y] = [p.x, p.y].map(|c| self.value(if c.abs() < least { 0.0 } else { c }));
        format!("({x}{}{y})", self.0.between())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_that_is_rounding_reads_as_zero() {
        assert_eq!(Speech(Tongue::ENGLISH).point(DVec2::new(1.5, -1.12e-16)), "(1.5, 0)");
        assert_eq!(
            Speech(Tongue::ENGLISH).point(DVec2::new(1.5e-13, -1.12e-16)),
            "(1.5 × 10^−13, −1.12 × 10^−16)"
        );
    }
}
