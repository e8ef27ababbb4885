//! What `solve` writes: the keys of its lines, and those of the answer to each kind of question.

use crate::collision::answer::fields::{
    OF_BOUNDS, OF_CONTACT, OF_IMPACT, OF_MOTION_BOUND, OF_OVERLAP, OF_SEPARATION,
};
use crate::collision::{AnswerField, QueryKind};

/// The keys of a line of `solve --json` and `solve --jsonl`.
pub static LINE_FIELDS: [AnswerField; 5] = [
    AnswerField::of("`--json`", "scene", "the name of the scene's file"),
    AnswerField::of("`--jsonl`", "id", "the `id` of the line, as it is written there; else null"),
    AnswerField::of("a scene that is right", "result", "the answer, with the keys below"),
    AnswerField::of("a line that is refused", "line", "its number, from 1"),
    AnswerField {
        inner: &[
            AnswerField::always("code", "the stable code of the first error: `tracefig list errors`"),
            AnswerField::always("message", "what is wrong, for people"),
        ],
        ..AnswerField::of("a line that is refused", "error", "why it is")
    },
];

/// The keys of the answer to a kind of question, in the order in which `solve` writes them.
///
/// ```
/// use tracefig::{collision::QueryKind, scene::answer_fields};
/// let keys: Vec<&str> = answer_fields(QueryKind::MotionBound).iter().map(|field| field.name).collect();
/// assert_eq!(keys, ["kind", "bound"]);
/// ```
#[must_use]
pub fn answer_fields(kind: QueryKind) -> &'static [AnswerField] {
    match kind {
        QueryKind::Bounds => OF_BOUNDS,
        QueryKind::Overlap => OF_OVERLAP,
        QueryKind::Separation => OF_SEPARATION,
        QueryKind::LinearSweep | QueryKind::TimeOfImpact => OF_IMPACT,
        QueryKind::MotionBound => OF_MOTION_BOUND,
        QueryKind::Contact => OF_CONTACT,
    }
}
