//! When a search that only asks for overlap may stop: at the first axis that certainly separates.
//!
//! Along the normal of an edge of B ⊖ A the origin is as far outside as the cores are apart there. If that is
//! more than the radii and whatever doubles may have lost,
//!
//! ```text
//! line > r_A + r_B + error
//! ```
//!
//! the bodies are apart, and no other edge needs to be looked at. How far apart remains unknown: the answer
//! has a lower bound only.

use crate::collision::algorithm::outline::Projection;
use crate::collision::algorithm::view::PairView;
use crate::collision::{Overlap, QueryKind};
use crate::geometry::Enclosure;
use crate::trace::{Event, Tracer};

/// Whether a separating axis ends a search.
#[derive(Clone, Copy, Debug)]
pub(crate) enum EarlyOut {
    /// It does not: the nearest edge is asked for.
    Never,
    /// The first axis does whose gap between the cores, in world units, is beyond this, the radii and the
    /// rounding.
    Beyond(f64),
}

impl EarlyOut {
    /// The rule for a kind of question.
    pub(crate) fn of(kind: QueryKind, pair: &PairView) -> Self {
        match kind {
            QueryKind::Overlap => Self::Beyond(pair.radius() + pair.gap_error()),
            _ => Self::Never,
        }
    }

    /// Whether the search is over with this edge, since the line along it separates.
    #[inline]
    pub(crate) fn is_reached(self, edge: &Projection) -> bool {
        matches!(self, Self::Beyond(line) if edge.line > line)
    }
}

/// The answer of a search that ended at this edge, told: apart, by at least the gap less its rounding.
pub(crate) fn separated(pair: &PairView, edge: &Projection, tracer: &mut impl Tracer) -> Overlap {
    let gap = edge.line - pair.radius();
    let lo = (gap - pair.gap_error()).max(0.0);
    let answer = Overlap { overlap: Some(false), separation_bounds: Enclosure { lo, hi: f64::INFINITY } };
    let normal = pair.world_vector(-edge.outward);
    tracer.record(|| Event::SeparatingAxisFound { normal, gap });
    tracer.record(|| Event::Finished { outcome: answer.word() });
    answer
}
