//! What a figure has to know of a kind of query: the one place here that asks.

use crate::collision::{Motion, QueryKind, When};

/// Whether the question is about one moment, so that a panel at another moment asks it again there. The
/// others are about all of [0, 1].
pub(crate) fn is_of_a_moment(kind: QueryKind) -> bool {
    kind.question().when == When::AtAMoment
}

/// Whether the bodies keep their attitude all the way, so that B ⊖ A is at every step what it was at the
/// start.
pub(crate) fn keeps_the_difference(kind: QueryKind) -> bool {
    kind.question().motion == Motion::Unturning
}

/// Whether the answer is within a tolerance that the scene may choose.
pub(crate) fn has_a_tolerance(kind: QueryKind) -> bool {
    kind == QueryKind::TimeOfImpact
}

/// Whether an answer is found among the edges of B ⊖ A, where the algorithm tells of them.
pub(crate) fn is_found_on_the_difference(kind: QueryKind) -> bool {
    matches!(kind, QueryKind::Separation | QueryKind::LinearSweep)
}
