//! The filter of distances: a guess in doubles, its conditions checked in doubles, its distance in one pass
//! of double-doubles.
//!
//! A guess is right if the other body's supporting vertex is the one that it names and if the foot of the
//! origin lies inside the feature ([`crate::collision::certified::distance::conditions`]). Then the gap along
//! the edge's normal (or the distance of two vertices) is the separation of the cores, and only its last
//! digits are left to compute; the other body may have a parallel edge, if that is exact:
//!
//! ```text
//! gap = n · (c + R q_j − v_i)
//! error ≤ |error of c and R q_j| + |error of n| |c + R q_j − v_i| + 64 ε² M
//! ```
//!
//! Where a condition is not clear, or the error is more than [`TIGHT`] of the separation, the filter has no
//! answer. It decides nearly all pairs; only speed needs it.

pub(crate) mod descent;
pub(crate) mod expanding;
pub(crate) mod small;

use crate::collision::certified::distance::conditions::{
    Foot, Support, are_closest, foot, support, vertex_b,
};
use crate::collision::certified::distance::filter::descent::{ANYWHERE, Guess, SupportPair, guess};
use crate::collision::certified::distance::gaps::{self, Ties, Widest};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::refine::{Measured, along_edge, between_vertices};
use crate::collision::certified::distance::witnesses::{Carrier, Proved};
use crate::collision::certified::rounding::LAST_ERROR;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{Dd, Enclosure, Side};

/// Largest error of the filter's answer relative to the separation.
///
/// With 1 ulp on either side of it the bounds are 18 ε wide at most, far below the 450 ε (1e-13) that are
/// promised, and the error is below 45 ε (1e-14). At half of it a few more pairs near touching go to balls;
/// at 25 times it the promise would break.
const TIGHT: f64 = 8.0 * f64::EPSILON;

/// The separation of a pair, where doubles and one pass of double-doubles prove it.
#[inline]
pub(crate) fn proved(pair: &Pair) -> Option<Proved> {
    if !pair.is_tame() {
        return None;
    }
    let carrier = match guess(pair) {
        Guess::Closest(vertices) => Carrier::Vertex(vertices),
        Guess::Apart(hint) => apart(pair, hint).or_else(|| again(pair))?,
        Guess::Crossing => crossing(pair, small::widest(pair)?)?,
        Guess::Overlapping(triangle) => match expanding::deepest(pair, triangle) {
            Some(facing) => Carrier::Edge(facing),
            None => deepest(pair, gaps::widest(pair)?)?,
        },
        Guess::Unclear => return None,
    };
    measured(pair, carrier).or_else(|| refined(pair, carrier))
}

/// [`measured`] of a pair that is nearer touching than its cosines are exact.
#[cold]
fn refined(pair: &Pair, carrier: Carrier) -> Option<Proved> {
    measured(&pair.refined(), carrier)
}

/// The feature of a small pair whose widest gap is known, whichever sign it has.
#[inline]
fn crossing(pair: &Pair, widest: Widest) -> Option<Carrier> {
    if widest.gap < 0.0 {
        return deepest(pair, widest);
    }
    let DifferenceEdge { source, edge, vertex } = widest.facing;
    let end = match foot(pair, widest.facing, None) {
        Foot::Before => edge,
        Foot::After => pair.hull(source).next(edge),
        _ => return apart(pair, DifferenceFeature::Edge(widest.facing)),
    };
    apart(pair, DifferenceFeature::Vertex(a_then_b(source, end, vertex))).or_else(|| again(pair))
}

/// The feature of a small pair that is apart, by descent, where the walk or the table of gaps did not find
/// it.
#[cold]
fn again(pair: &Pair) -> Option<Carrier> {
    if !small::are_few(pair) {
        return None;
    }
    match descent::search(&SupportPair::of(pair), pair.center, ANYWHERE) {
        Guess::Apart(hint) => apart(pair, hint),
        _ => None,
    }
}

/// The widest gap of all, if it is clearly negative and clearly the widest but for a parallel edge's.
#[inline]
fn deepest(pair: &Pair, Widest { facing, gap, ties }: Widest) -> Option<Carrier> {
    if gap >= -pair.gap_error() {
        return None;
    }
    match (support(pair, facing), ties) {
        (Support::Vertex, Ties::None) => Some(Carrier::Edge(facing)),
        (Support::ParallelEdge(partner), Ties::None) => Some(Carrier::ParallelEdges(facing, partner)),
        (Support::ParallelEdge(partner), Ties::One(source, edge)) => {
            (source != facing.source && edge == partner).then_some(Carrier::ParallelEdges(facing, partner))
        }
        _ => None,
    }
}

/// A guessed feature, if it is clearly the closest.
#[inline]
fn apart(pair: &Pair, hint: DifferenceFeature) -> Option<Carrier> {
    match hint {
        DifferenceFeature::Edge(facing) => match support(pair, facing) {
            Support::Vertex => {
                matches!(foot(pair, facing, None), Foot::Within).then_some(Carrier::Edge(facing))
            }
            Support::ParallelEdge(partner) => matches!(foot(pair, facing, Some(partner)), Foot::Within)
                .then_some(Carrier::ParallelEdges(facing, partner)),
            Support::Unclear => None,
        },
        DifferenceFeature::Vertex([i, j]) => {
            let d = vertex_b(pair, j) - pair.hull(Side::A).vertices[i];
            are_closest(pair, [i, j], d).then_some(Carrier::Vertex([i, j]))
        }
    }
}

/// The feature's distance to twice the precision, if that is tight enough.
#[inline]
fn measured(pair: &Pair, carrier: Carrier) -> Option<Proved> {
    let Measured { core, normal, turning } = match carrier {
        Carrier::Edge(facing) | Carrier::ParallelEdges(facing, _) => along_edge(pair, facing),
        Carrier::Vertex(vertices) => between_vertices(pair, vertices)?,
    };
    let separation = if pair.radius == Dd::ZERO { core } else { core - pair.radius };
    let error = pair.placing_error + turning + LAST_ERROR * (pair.magnitude + pair.radius.hi);
    let value = separation.hi;
    if error > TIGHT * value.abs() {
        return None;
    }
    let bounds = Enclosure {
        lo: (value + (separation.lo - error)).next_down(),
        hi: (value + (separation.lo + error)).next_up(),
    };
    Some(Proved { carrier, normal: Some(normal), core: core.hi, separation: value, bounds, ties: 1 })
}

#[cfg(test)]
mod tests;
