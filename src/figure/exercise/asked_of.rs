//! The questions of whose answers a value that can be asked for is a part.

use crate::collision::QueryKind;
use crate::figure::question::is_of_a_moment;

/// Whether a question is for the first contact.
pub(super) fn moves(kind: QueryKind) -> bool {
    !is_of_a_moment(kind) && kind != QueryKind::MotionBound
}

/// Whether a question is for a motion bound.
pub(super) fn bounds_motion(kind: QueryKind) -> bool {
    kind == QueryKind::MotionBound
}

/// Whether a question is about two bodies.
pub(super) fn is_of_two(kind: QueryKind) -> bool {
    !bounds_motion(kind) && kind != QueryKind::Bounds
}

/// Whether a question is for a box.
pub(super) fn is_for_a_box(kind: QueryKind) -> bool {
    kind == QueryKind::Bounds
}
