//! "When do they first touch, if neither turns?" Over the motion, t in [0, 1].
//!
//! Seen from A, B moves on a straight line, so that B ⊖ A keeps its shape and one ray against it answers
//! exactly. Answered by [`crate::collision::Impact`], with tolerance 0 where the answer is direct. A body
//! with a spin is an error of the scene: [the time of impact](super::time_of_impact) is what it wants.

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::LinearSweep,
    word: "linear-sweep",
    about: "first contact of two bodies that move and do not turn",
    bodies: Bodies::Two,
    when: When::OverTheMotion,
    shapes: Shapes::Convex,
    motion: Motion::Unturning,
};
