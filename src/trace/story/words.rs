//! Numbers, points and moments in the words of a story.

use super::{Moment, SupportVertex};
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side};

/// Significant digits of the numbers: a reader compares the first three, and a step of 1e-6 still shows.
const DIGITS: usize = 6;

/// The share of a point's larger coordinate below which the other one is what rounding left of a 0, and told
/// as 0: a thousand times what a few roundings leave. The JSON lines have every bit.
const NOTHING: f64 = 1e-12;

/// A moment, with the angles where a body is turned.
pub(super) fn moment(at: &Moment, names: &Names) -> String {
    let time = format!("t = {}", number(at.time));
    if at.angle_a == 0.0 && at.angle_b == 0.0 {
        return time;
    }
    let of_each = [(Side::A, at.angle_a), (Side::B, at.angle_b)];
    let there = of_each.into_iter().filter(|(side, _)| !names.of(*side).is_empty());
    let turned = there.map(|(side, angle)| format!("{} at {} deg", names.quoted(side), number(angle)));
    format!("{time} ({})", turned.collect::<Vec<_>>().join(", "))
}

/// Vertices in words: "vertex 0 at (1, 2) and vertex 1 at (3, 4)".
pub(super) fn list(vertices: &[SupportVertex]) -> String {
    let one = |v: &SupportVertex| format!("vertex {} at {}", v.index, point(v.point));
    vertices.iter().map(one).collect::<Vec<_>>().join(" and ")
}

/// Points, one after the other.
pub(super) fn points(vertices: &[DVec2]) -> String {
    vertices.iter().map(|&p| point(p)).collect::<Vec<_>>().join(" ")
}

/// A distance from the boundary in words: "2 inside" or "2 away".
pub(super) fn away(distance: f64) -> String {
    let size = number(distance.abs());
    if distance < 0.0 { format!("{size} inside") } else { format!("{size} away") }
}

/// A distance from a line in words: "2 inside" or "2 outside".
pub(super) fn aside(distance: f64) -> String {
    let size = number(distance.abs());
    if distance < 0.0 { format!("{size} inside") } else { format!("{size} outside") }
}

pub(super) fn interval(x: Enclosure) -> String {
    format!("{} to {}", number(x.lo), number(x.hi))
}

pub(super) fn part(feature: Feature) -> String {
    match feature {
        Feature::Vertex(i) => format!("vertex {i}"),
        Feature::Edge(i) => format!("edge {i}"),
    }
}

pub(super) fn point(p: DVec2) -> String {
    let size = p.abs().max_element();
    let shown = |x: f64| number(if x.abs() < NOTHING * size { 0.0 } else { x });
    format!("({}, {})", shown(p.x), shown(p.y))
}

/// A number to [`DIGITS`] significant digits, without trailing zeros; with an exponent where it is very large
/// or small.
pub(super) fn number(x: f64) -> String {
    let written = format!("{:.*e}", DIGITS - 1, x);
    let Ok(rounded) = written.parse::<f64>() else { return written };
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
        assert_eq!(point(DVec2::new(4.4e-16, 5.0)), "(0, 5)");
        assert_eq!(point(DVec2::new(4e-16, 5e-16)), "(4e-16, 5e-16)");
    }
}
