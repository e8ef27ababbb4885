//! The quick proof: a guessed feature, its conditions checked in doubles, its distance in one pass of
//! double-doubles.
//!
//! A guess is right if the other body's supporting vertex is the one that it names and if the foot of the
//! origin lies inside the feature. Both are signs of dot products; here they must be clear of a bound on all
//! rounding. Then the gap along the side's normal (or the distance of two vertices) is the separation of the
//! cores, and only its last digits are left to compute (a side of the other body may be parallel, if that is
//! exact):
//!
//! ```text
//! gap = n · (c + R q_j − v_i)
//! error ≤ |error of c and R q_j| + |error of n| |c + R q_j − v_i| + 64 ε² M
//! ```
//!
//! Where any condition is not clear, or the error is more than [`TIGHT`] of the separation, there is no quick
//! proof.

pub(crate) mod descent;
pub(crate) mod expanding;
pub(crate) mod small;

use crate::collision::certified::distance::filter::descent::{ANYWHERE, Asked, Guess, guess};
use crate::collision::certified::distance::gaps::{self, Close, Widest};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::refine::{Measured, along_edge, between_vertices};
use crate::collision::certified::distance::witnesses::{Carrier, Proved};
use crate::collision::certified::rounding::{DOT_ERROR, LAST_ERROR, LEVEL_ERROR};
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{DVec2, Dd, Enclosure, Hull, Side};

/// Largest error of a quick proof relative to the separation: with 1 ulp on either side of it the bounds are
/// 18 ε wide at most, far below the 450 ε (1e-13) that are promised, and the error is below 45 ε (1e-14).
const TIGHT: f64 = 8.0 * f64::EPSILON;

/// A separation that can be proved with little work.
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

/// How the vertex of an edge of B ⊖ A supports it.
#[derive(Clone, Copy)]
pub(crate) enum Support {
    /// Clearly alone.
    Vertex,
    /// With the whole of this side.
    Face(usize),
    /// Rounding hides it.
    Unclear,
}

/// The feature of a pair whose widest gap is known, whichever sign it has.
#[inline]
fn crossing(pair: &Pair, widest: Widest) -> Option<Carrier> {
    if widest.gap < 0.0 {
        return deepest(pair, widest);
    }
    let DifferenceEdge { source, edge, vertex } = widest.facing;
    let end = match span(pair, widest.facing, None) {
        Span::Before => edge,
        Span::After => pair.hull(source).next(edge),
        _ => return apart(pair, DifferenceFeature::Edge(widest.facing)),
    };
    apart(pair, DifferenceFeature::Vertex(a_then_b(source, end, vertex))).or_else(|| again(pair))
}

/// The feature of a pair of few vertices that is apart, where what is quicker did not find it.
#[cold]
fn again(pair: &Pair) -> Option<Carrier> {
    if !small::are_few(pair) {
        return None;
    }
    match descent::search(&Asked::of(pair), pair.center, ANYWHERE) {
        Guess::Apart(hint) => apart(pair, hint),
        _ => None,
    }
}

/// The widest gap of all, if it is clearly negative and clearly the widest but for a parallel side's.
#[inline]
fn deepest(pair: &Pair, Widest { facing, gap, close }: Widest) -> Option<Carrier> {
    if gap >= -pair.gap_error() {
        return None;
    }
    match (support(pair, facing), close) {
        (Support::Vertex, Close::None) => Some(Carrier::Edge(facing)),
        (Support::Face(partner), Close::None) => Some(Carrier::ParallelEdges(facing, partner)),
        (Support::Face(partner), Close::One(source, edge)) => {
            (source != facing.source && edge == partner).then_some(Carrier::ParallelEdges(facing, partner))
        }
        _ => None,
    }
}

/// The guessed feature, if it is clearly the closest.
#[inline]
fn apart(pair: &Pair, hint: DifferenceFeature) -> Option<Carrier> {
    match hint {
        DifferenceFeature::Edge(facing) => match support(pair, facing) {
            Support::Vertex => {
                matches!(span(pair, facing, None), Span::Within).then_some(Carrier::Edge(facing))
            }
            Support::Face(partner) => matches!(span(pair, facing, Some(partner)), Span::Within)
                .then_some(Carrier::ParallelEdges(facing, partner)),
            Support::Unclear => None,
        },
        DifferenceFeature::Vertex([i, j]) => {
            let d = vertex_b(pair, j) - pair.hull(Side::A).vertices[i];
            are_closest(pair, [i, j], d).then_some(Carrier::Vertex([i, j]))
        }
    }
}

/// Whether vertices i of A and j of B, `d` apart in doubles, are clearly the closest points of the cores.
#[inline]
pub(crate) fn are_closest(pair: &Pair, [i, j]: [usize; 2], d: DVec2) -> bool {
    is_lowest(pair, Side::B, j, d) && is_lowest(pair, Side::A, i, -d)
}

/// B's vertex in A's frame.
#[inline]
fn vertex_b(pair: &Pair, j: usize) -> DVec2 {
    pair.center + pair.vector_from_b(pair.hull(Side::B).vertices[j])
}

/// The normal of a side from A to B, in A's frame.
#[inline]
fn normal(pair: &Pair, facing: DifferenceEdge) -> DVec2 {
    let outward = pair.hull(facing.source).normals[facing.edge];
    match facing.source {
        Side::A => *outward,
        Side::B => -pair.vector_from_b(*outward),
    }
}

/// The 1-norm.
#[inline]
fn size(v: DVec2) -> f64 {
    v.x.abs() + v.y.abs()
}

/// Whether vertex k of a body is clearly the lowest along `down` (A's frame); `down` may be off by
/// [`Pair::gap_error`] where it is a difference of vertices.
#[inline]
pub(crate) fn is_lowest(pair: &Pair, side: Side, k: usize, down: DVec2) -> bool {
    let slack = slack(pair, down);
    let down = match side {
        Side::A => down,
        Side::B => pair.vector_to_b(down),
    };
    clearly_lowest(pair.hull(side), k, down, slack)
}

/// What rounding may add to a slope along `down`, a difference of vertices, as a multiple of a side's 1-norm.
/// In the other frame the 1-norm of `down` is at most √2 of this one; a difference of vertices is off by the
/// gap error.
#[inline]
pub(crate) fn slack(pair: &Pair, down: DVec2) -> f64 {
    DOT_ERROR * std::f64::consts::SQRT_2 * size(down) + pair.gap_error()
}

/// Whether vertex k of a core is the lowest along `down`, in its own frame, by more than `slack` of each
/// side.
#[inline]
pub(crate) fn clearly_lowest(hull: &Hull, k: usize, down: DVec2, slack: f64) -> bool {
    if hull.edges.is_empty() {
        return true;
    }
    let (ahead, behind) = (hull.edges[k], hull.edges[hull.previous(k)]);
    ahead.dot(down) > slack * size(ahead) && behind.dot(down) < -slack * size(behind)
}

/// How the vertex of an edge of B ⊖ A supports it.
#[inline]
pub(crate) fn support(pair: &Pair, facing: DifferenceEdge) -> Support {
    let other = facing.source.other();
    let n = normal(pair, facing);
    let hull = pair.hull(other);
    if hull.edges.is_empty() {
        return Support::Vertex;
    }
    let down = match other {
        Side::A => -n,
        Side::B => pair.vector_to_b(n),
    };
    let back = hull.previous(facing.vertex);
    let (ahead, behind) = (hull.edges[facing.vertex], hull.edges[back]);
    let (rise, fall) = (ahead.dot(down), behind.dot(down));
    let (rises, falls) = (rise > LEVEL_ERROR * size(ahead), fall < -LEVEL_ERROR * size(behind));
    // With a direction along an axis, and no turn or quarter turns only, the dot product is a coordinate's
    // difference: its 0 is exact.
    let exact = pair.turn_error == 0.0 && (down.x == 0.0 || down.y == 0.0);
    if rises && falls {
        Support::Vertex
    } else if exact && rise == 0.0 && falls {
        Support::Face(facing.vertex)
    } else if exact && fall == 0.0 && rises {
        Support::Face(back)
    } else {
        Support::Unclear
    }
}

/// Where the foot of a vertex lies on a side's line.
enum Span {
    /// Clearly inside the side, and the vertex clearly outside its line.
    Within,
    /// Beyond its start.
    Before,
    /// Beyond its end.
    After,
    /// Rounding hides it.
    Unclear,
}

/// Whether the vertex (or with `partner` the parallel side) that faces a side is clearly outside its line,
/// with its foot (or a part of its span) clearly inside the side.
#[inline]
fn span(
    pair: &Pair,
    DifferenceEdge { source, edge, vertex }: DifferenceEdge,
    partner: Option<usize>,
) -> Span {
    let (hull, other) = (pair.hull(source), pair.hull(source.other()));
    let seen = |k: usize| match source {
        Side::A => vertex_b(pair, k),
        Side::B => pair.local_to_b(pair.hull(Side::A).vertices[k]),
    };
    let (along, n) = (hull.edges[edge], hull.normals[edge]);
    let (start, end) = (hull.vertices[edge], hull.vertices[hull.next(edge)]);
    let error = pair.gap_error();
    let slack = error * size(along);
    let point = seen(vertex);
    if n.dot(point - start) <= error {
        return Span::Unclear;
    }
    // How far inside each end of the side the point is, in units of the side's length.
    let inside = |point: DVec2| ((point - start).dot(along), (end - point).dot(along));
    let (mut from, mut to) = inside(point);
    if let Some(k) = partner {
        let (f, t) = inside(seen(if k == vertex { other.next(k) } else { k }));
        (from, to) = (from.max(f), to.max(t));
    }
    if from > slack && to > slack {
        Span::Within
    } else if from < 0.0 {
        Span::Before
    } else if to < 0.0 {
        Span::After
    } else {
        Span::Unclear
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
