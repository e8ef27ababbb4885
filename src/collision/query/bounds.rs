//! "Which axis-aligned box holds the body?" Of one body at one moment, or of two together.
//!
//! The one question that an outline which is not convex can be asked. Answered by
//! [`crate::collision::Bounds`]: corners, centre and half-extents in world units, rounded outward.

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::Bounds,
    word: "bounds",
    about: "the smallest axis-aligned box that holds a body, or two together",
    bodies: Bodies::OneOrTwo,
    when: When::AtAMoment,
    shapes: Shapes::Any,
    motion: Motion::Any,
};
