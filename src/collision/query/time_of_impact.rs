//! "When do they first touch?" Over the motion, t in [0, 1], both moving and turning evenly.
//!
//! Answered by [`crate::collision::Impact`]: a hit with bounds on its time, a miss, an overlap at the start,
//! or what kept it undecided and until when the bodies are proved free. Never a guess.

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::TimeOfImpact,
    word: "time-of-impact",
    about: "first contact of two bodies that move and turn",
    bodies: Bodies::Two,
    when: When::OverTheMotion,
    shapes: Shapes::Convex,
    motion: Motion::Any,
};
