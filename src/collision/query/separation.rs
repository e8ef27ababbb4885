//! "How far apart are they, or how deep inside each other?" At one moment, in world units, negative inside.
//!
//! The distance of the origin from B ⊖ A, or minus its depth in it. Answered by
//! [`crate::collision::Separation`], with the normal, the witness points and the features that carry them.

use super::{Bodies, Motion, QueryKind, Question, Shapes, When};

/// Its row in the table of questions.
pub(super) const QUESTION: Question = Question {
    kind: QueryKind::Separation,
    word: "separation",
    about: "signed distance, normal, witness points and closest features",
    bodies: Bodies::Two,
    when: When::AtAMoment,
    shapes: Shapes::Convex,
    motion: Motion::Any,
};
