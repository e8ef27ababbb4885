//! Numbers, points and moments in the words of a story.

use super::phrases::{
    AT_ANGLE, AWAY, BOTH, EDGE, INSIDE, INSIDE_LINE, OUTSIDE_LINE, SPAN, VERTEX, VERTEX_AT,
};
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side, read};
use crate::trace::tongue::{Phrase, Tongue};
use crate::trace::{Moment, SupportVertex};

/// Significant digits of the numbers: a reader compares the first three, and a step of 1e-6 still shows.
const DIGITS: usize = 6;

/// The share of a point's larger coordinate below which the other one is what rounding left of a 0, and told
/// as 0: a thousand times what a few roundings leave. The JSON lines have every bit.
const NOTHING: f64 = 1e-12;

/// Whose story it is and in which language: every number, point and name in it goes through here.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Voice<'n> {
    /// What the bodies are called.
    pub(crate) names: &'n Names,
    /// The language.
    pub(crate) tongue: Tongue,
}

impl<'n> Voice<'n> {
    /// A story in English.
    pub(super) const fn english(names: &'n Names) -> Self {
        Self { names, tongue: Tongue::ENGLISH }
    }

    /// A phrase with the values that stand for its stars.
    pub(super) fn say(self, phrase: &Phrase, values: &[&str]) -> String {
        self.tongue.say(phrase, values)
    }

    /// A phrase without a star.
    pub(super) fn word(self, phrase: &Phrase) -> String {
        self.tongue.word(phrase).to_owned()
    }

    /// The name of a body.
    pub(super) fn of(self, side: Side) -> String {
        self.names.quoted(side)
    }

    /// All names: "A and B".
    pub(super) fn all(self) -> String {
        let [a, b] = Side::BOTH.map(|side| self.of(side));
        if b.is_empty() { a } else { self.say(&BOTH, &[&a, &b]) }
    }

    /// A moment, with the angles where a body is turned.
    pub(super) fn moment(self, at: &Moment) -> String {
        let time = format!("t = {}", self.number(at.time));
        if at.angle_a == 0.0 && at.angle_b == 0.0 {
            return time;
        }
        let of_each = [(Side::A, at.angle_a), (Side::B, at.angle_b)];
        let there = of_each.into_iter().filter(|(side, _)| !self.names.of(*side).is_empty());
        let turned = there.map(|(side, angle)| self.say(&AT_ANGLE, &[&self.of(side), &self.number(angle)]));
        format!("{time} ({})", turned.collect::<Vec<_>>().join(self.tongue.between()))
    }

    /// Vertices in words: "vertex 0 at (1, 2) and vertex 1 at (3, 4)".
    pub(super) fn list(self, vertices: &[SupportVertex]) -> String {
        let mut all = vertices.iter().map(|vertex| self.vertex(vertex));
        let first = all.next().unwrap_or_default();
        all.fold(first, |before, next| self.say(&BOTH, &[&before, &next]))
    }

    /// A vertex and its place: "vertex 0 at (1, 2)".
    pub(super) fn vertex(self, vertex: &SupportVertex) -> String {
        self.say(&VERTEX_AT, &[&vertex.index.to_string(), &self.point(vertex.point)])
    }

    /// Points, one after the other.
    pub(super) fn points(self, vertices: &[DVec2]) -> String {
        vertices.iter().map(|&p| self.point(p)).collect::<Vec<_>>().join(" ")
    }

    /// A distance from the boundary in words: "2 inside" or "2 away".
    pub(super) fn away(self, distance: f64) -> String {
        self.say(if distance < 0.0 { &INSIDE } else { &AWAY }, &[&self.number(distance.abs())])
    }

    /// A distance from a line in words: "2 inside" or "2 outside".
    pub(super) fn aside(self, distance: f64) -> String {
        let phrase = if distance < 0.0 { &INSIDE_LINE } else { &OUTSIDE_LINE };
        self.say(phrase, &[&self.number(distance.abs())])
    }

    /// An interval: "0 to 2".
    pub(super) fn interval(self, x: Enclosure) -> String {
        self.say(&SPAN, &[&self.number(x.lo), &self.number(x.hi)])
    }

    /// A vertex or an edge by its index.
    pub(super) fn part(self, feature: Feature) -> String {
        match feature {
            Feature::Vertex(i) => self.say(&VERTEX, &[&i.to_string()]),
            Feature::Edge(i) => self.say(&EDGE, &[&i.to_string()]),
        }
    }

    /// A point; a coordinate that is rounding beside the other one is told as 0.
    pub(super) fn point(self, p: DVec2) -> String {
        let size = p.abs().max_element();
        self.tongue.point([p.x, p.y].map(|x| number(if x.abs() < NOTHING * size { 0.0 } else { x })))
    }

    /// A number.
    pub(super) fn number(self, x: f64) -> String {
        self.tongue.decimal(number(x))
    }
}

/// A number to [`DIGITS`] significant digits, without trailing zeros; with an exponent where it is very large
/// or small.
fn number(x: f64) -> String {
    let written = format!("{:.*e}", DIGITS - 1, x);
    let Some(rounded) = read(&written) else { return written };
    if rounded == 0.0 {
        return "0".to_owned();
    }
    if (1e-4..1e7).contains(&rounded.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_six_digits_and_no_zeros() {
        let cases = [
            (1.0 / 3.0, "0.333333"),
            (-0.0, "0"),
            (2.5, "2.5"),
            (1e-9, "1e-9"),
            (123_456_789.0, "1.23457e8"),
        ];
        for (x, expected) in cases {
            assert_eq!(number(x), expected);
        }
    }

    #[test]
    fn what_rounding_left_of_a_zero_is_told_as_zero() {
        let names = Names::default();
        let told = |x, y| Voice::english(&names).point(DVec2::new(x, y));
        assert_eq!(told(4.4e-16, 5.0), "(0, 5)");
        assert_eq!(told(4e-16, 5e-16), "(4e-16, 5e-16)");
    }
}
