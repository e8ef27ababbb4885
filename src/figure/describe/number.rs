//! Numbers and points in running text, in the language of a scene.

use crate::figure::text::{
    Places, bound_and_parts, in_words, plain, rounded, rounded_down, rounded_up_beside,
};
use crate::figure::tongue::tongue;
use crate::geometry::DVec2;
use crate::scene::Scene;
use crate::trace::{Phrase, Tongue};

/// A coordinate this much smaller than the other one is rounding, far below what three digits or an eye tell.
const NOTHING_BESIDE: f64 = 1e-12;

/// A language in which a figure is told.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speech(pub(super) Tongue, Places);

impl Speech {
    /// The language of a scene, and its places as fine as its bodies are large.
    pub(super) fn of(scene: &Scene) -> Self {
        Self(tongue(scene), Places::of(scene))
    }

    /// English, for bodies of any size.
    #[cfg(test)]
    pub(super) const ENGLISH: Self = Self(Tongue::ENGLISH, Places::ANY);

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

    /// A double of which is said that something is no more, which to three digits is what a picture has.
    pub(super) fn at_most(self, v: f64) -> String {
        self.0.decimal(plain(&in_words(&rounded_up_beside(v))))
    }

    /// A bound, a number that is part of it, and the bound of the rest, so that they add up as they are
    /// written; `None` where no few digits do.
    pub(super) fn bound_of(self, bound: f64, part: f64, rest: f64) -> Option<[String; 3]> {
        let written = bound_and_parts(bound, part, rest)?;
        Some(written.map(|text| self.0.decimal(plain(&in_words(&text)))))
    }

    /// A double of which is said that something is no less, to three digits.
    pub(super) fn at_least(self, v: f64) -> String {
        self.0.decimal(plain(&in_words(&rounded_down(v))))
    }

    /// A place as `(x, y)`, as fine as the bodies are large.
    pub(super) fn point(self, p: DVec2) -> String {
        self.pair(p, |x| self.0.decimal(plain(&in_words(&self.1.written(x)))))
    }

    /// A vector as `(x, y)`.
    pub(super) fn vector(self, v: DVec2) -> String {
        self.pair(v, |x| self.value(x))
    }

    /// Two components, of which one that is rounding is 0.
    fn pair(self, p: DVec2, written: impl Fn(f64) -> String) -> String {
        let least = NOTHING_BESIDE * p.abs().max_element();
        let [x, y] = [p.x, p.y].map(|c| written(if c.abs() < least { 0.0 } else { c }));
        format!("({x}{}{y})", self.0.between())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_that_is_rounding_reads_as_zero() {
        assert_eq!(Speech::ENGLISH.point(DVec2::new(1.5, -1.12e-16)), "(1.5, 0)");
        assert_eq!(Speech::ENGLISH.point(DVec2::new(1.5e-13, -1.12e-16)), "(1.5 × 10^−13, −1.12 × 10^−16)");
    }
}
