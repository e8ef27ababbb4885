//! "How far can any point move?" Over the motion, t in [0, 1]: of one body, or of one relative to the other.
//!
//! What conservative advancement divides a distance by. Answered by [`crate::collision::MotionBound`], in
//! world units, rounded up.

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::MotionBound,
    word: "motion-bound",
    about: "how far any point of a body can move over t in [0, 1]; of two, how much nearer they can come",
    bodies: Bodies::OneOrTwo,
    when: When::OverTheMotion,
    shapes: Shapes::Convex,
    motion: Motion::Any,
};
