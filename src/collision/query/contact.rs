//! "Where do they touch, and how deep at each place?" At one moment: one point or two, as an engine pushes
//! bodies apart at.
//!
//! The nearest edge of B ⊖ A is an edge of one body, the reference edge; the edge of the other body that
//! faces it is clipped to its ends. Answered by [`crate::collision::Contact`].

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::Contact,
    word: "contact",
    about: "reference and incident edge, and the points of contact with their depths",
    bodies: Bodies::Two,
    when: When::AtAMoment,
    shapes: Shapes::Convex,
    motion: Motion::Any,
};
