//! The parts of an answer: each a name and a kind of value, so that who writes answers need not know them.

use crate::geometry::{DVec2, Enclosure, Feature, Side};

/// The value of one part of an answer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Part {
    /// One of the words that an answer can give.
    Word(&'static str),
    /// Yes, no, or None: rounding forbids a verdict.
    Verdict(Option<bool>),
    /// How many.
    Count(usize),
    /// A length in world units, or a time.
    Number(f64),
    /// What encloses a length or a time; an end may be infinite.
    Interval(Enclosure),
    /// A point or a vector in the world.
    Point(DVec2),
    /// A point of A and one of B, in the world.
    Points([DVec2; 2]),
    /// A feature of A and one of B.
    Features([Feature; 2]),
    /// A length of A and one of B, in world units or in units of S ε.
    Lengths([f64; 2]),
    /// A feature of one of the bodies.
    Owned(Side, Feature),
    /// Several things of one kind, each in its parts.
    Each(Vec<Parts>),
}

/// The parts of an answer, each with its name in answers, in their order.
pub(crate) type Parts = Vec<(&'static str, Part)>;
