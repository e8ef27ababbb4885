//! When an edge or vertex of B ⊖ A is surely the one nearest the origin: signs of dot products in doubles.
//!
//! Three conditions are checked, each clear of a bound on all rounding
//! ([`crate::collision::certified::rounding`]):
//!
//! ```text
//! support   no vertex of the other body is farther along an edge's normal: n·e > 0 ahead, n·e < 0 behind
//! foot      the foot of that vertex on the edge's line is between the edge's ends
//! lowest    for two vertices d apart, neither body has one nearer along d
//! ```
//!
//! A condition that is not clear is not false: whoever asks then leaves the pair to balls.

use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::rounding::{DOT_ERROR, LEVEL_ERROR};
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{DVec2, Hull, Side};

/// How the vertex of an edge of B ⊖ A supports it.
#[derive(Clone, Copy)]
pub(crate) enum Support {
    /// It is clearly lower than all the others.
    Vertex,
    /// It is as low as the whole of this edge of its body, exactly.
    ParallelEdge(usize),
    /// Rounding hides which vertex is lowest.
    Unclear,
}

/// Whether vertices i of A and j of B, `d` apart in doubles, are clearly the closest points of the cores.
#[inline]
pub(crate) fn are_closest(pair: &Pair, [i, j]: [usize; 2], d: DVec2) -> bool {
    is_lowest(pair, Side::B, j, d) && is_lowest(pair, Side::A, i, -d)
}

/// B's vertex in A's frame.
#[inline]
pub(crate) fn vertex_b(pair: &Pair, j: usize) -> DVec2 {
    pair.center + pair.vector_from_b(pair.hull(Side::B).vertices[j])
}

/// The normal of an edge from A to B, in A's frame.
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

/// What rounding may add to a slope along `down`, a difference of vertices, as a multiple of an edge's
/// 1-norm. In the other frame the 1-norm of `down` is at most √2 of this one; a difference of vertices is off
/// by the gap error.
#[inline]
pub(crate) fn slack(pair: &Pair, down: DVec2) -> f64 {
    DOT_ERROR * std::f64::consts::SQRT_2 * size(down) + pair.gap_error()
}

/// Whether vertex k of a core is the lowest along `down`, in its own frame, by more than `slack` of each
/// edge's 1-norm.
#[inline]
pub(crate) fn clearly_lowest(hull: &Hull, k: usize, down: DVec2, slack: f64) -> bool {
    if hull.edges.is_empty() {
        return true;
    }
    let (ahead, behind) = (hull.edges[k], hull.edges[hull.previous(k)]);
    ahead.dot(down) > slack * size(ahead) && behind.dot(down) < -slack * size(behind)
}

/// Whether the vertex of an edge of B ⊖ A surely supports it.
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
        Support::ParallelEdge(facing.vertex)
    } else if exact && fall == 0.0 && rises {
        Support::ParallelEdge(back)
    } else {
        Support::Unclear
    }
}

/// Where the foot of a vertex lies on an edge's line.
pub(crate) enum Foot {
    /// Clearly between the edge's ends, and the vertex clearly outside its line.
    Within,
    /// Before the edge's start.
    Before,
    /// After the edge's end.
    After,
    /// Rounding hides where.
    Unclear,
}

/// Where the foot of an edge's vertex (or of a part of `partner`, the other body's parallel edge) lies, if it
/// is clearly outside the edge's line.
#[inline]
pub(crate) fn foot(
    pair: &Pair,
    DifferenceEdge { source, edge, vertex }: DifferenceEdge,
    partner: Option<usize>,
) -> Foot {
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
        return Foot::Unclear;
    }
    // How far inside each end of the edge the point is, in units of the edge's length.
    let inside = |point: DVec2| ((point - start).dot(along), (end - point).dot(along));
    let (mut from, mut to) = inside(point);
    if let Some(k) = partner {
        let (f, t) = inside(seen(if k == vertex { other.next(k) } else { k }));
        (from, to) = (from.max(f), to.max(t));
    }
    if from > slack && to > slack {
        Foot::Within
    } else if from < 0.0 {
        Foot::Before
    } else if to < 0.0 {
        Foot::After
    } else {
        Foot::Unclear
    }
}
