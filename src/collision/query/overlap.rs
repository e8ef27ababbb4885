//! "Do the bodies overlap?" Yes or no at one moment; touching is overlap.
//!
//! Easier than [the separation](super::separation), since a search may end at the first axis that separates.
//! Answered by [`crate::collision::Overlap`], which may also say that rounding forbids a verdict.

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::Overlap,
    word: "overlap",
    about: "whether two bodies share a point; touching counts",
    bodies: Bodies::Two,
    when: When::AtAMoment,
    shapes: Shapes::Convex,
    motion: Motion::Any,
};
