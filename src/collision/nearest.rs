//! A guess, in plain doubles, of the features by which two cores are closest: whatever follows from it is proved
//! elsewhere, so a wrong guess costs time and nothing else.
//!
//! The side with the widest gap is the closest feature if the other core's corner lies over it. If it lies beyond an
//! end, two corners are closest; from that end and that corner, steps to neighbours lead to them, since along the boundary
//! of B ⊖ A the distance has one minimum.

use super::Separation;
use super::certify::{Hint, certify};
use super::gaps::{Facing, every_gap};
use super::pair::Pair;
use crate::geometry::{Body, DVec2, Side};

/// The closest features of two cores, counted along the cores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Nearest {
    /// An edge of `owner` and a vertex of the other.
    Edge {
        /// The body whose edge it is.
        owner: Side,
        /// The edge.
        edge: usize,
        /// The other body's vertex.
        vertex: usize,
    },
    /// A vertex of A and a vertex of B.
    Vertices(usize, usize),
}

/// The closest features of two bodies at time `t`, and the distance of the cores (negative inside). O(n + m).
pub(super) fn nearest(a: &Body, b: &Body, t: f64) -> (Nearest, f64) {
    let pair = Pair::at(a, b, t);
    let mut best: Option<(Facing, f64)> = None;
    every_gap(&pair, |facing, gap| {
        if best.is_none_or(|(_, widest)| gap > widest) {
            best = Some((facing, gap));
        }
    });
    let scene = 1.0 / pair.scale;
    let Some((Facing { source: owner, edge, corner: vertex }, gap)) = best else {
        return (Nearest::Vertices(0, 0), libm::hypot(pair.center.x, pair.center.y) * scene);
    };
    let over = Nearest::Edge { owner, edge, vertex };
    if gap <= 0.0 {
        return (over, gap);
    }
    let hull = pair.hull(owner);
    let end = hull.next(edge);
    let (from, to) = (point(&pair, owner, edge), point(&pair, owner, end));
    let along = to - from;
    // Where on the edge's line a vertex of the other core is: below 0 before its start, above 0 after its end.
    let place = |k: usize| {
        let x = point(&pair, owner.other(), k);
        ((x - from).dot(along), (x - to).dot(along))
    };
    let beyond = match place(vertex) {
        (start, _) if start <= 0.0 => edge,
        (_, stop) if stop >= 0.0 => end,
        _ => return (over, gap),
    };
    // A side of the other core that is parallel to the edge reaches over it, though its first end may not.
    let other = pair.hull(owner.other());
    for k in [other.previous(vertex), other.next(vertex)] {
        let (start, stop) = place(k);
        let step = point(&pair, owner.other(), k) - point(&pair, owner.other(), vertex);
        let level = step.perp_dot(along).abs() <= pair.gap_error() * along.length();
        if level && if beyond == edge { start > 0.0 } else { stop < 0.0 } {
            return (Nearest::Edge { owner, edge, vertex: k }, gap);
        }
    }
    let (i, j) = if owner == Side::A { (beyond, vertex) } else { (vertex, beyond) };
    descend(&pair, i, j, scene)
}

/// From two vertices to the closest two.
fn descend(pair: &Pair, mut i: usize, mut j: usize, scene: f64) -> (Nearest, f64) {
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let squared = |i: usize, j: usize| (point(pair, Side::B, j) - point(pair, Side::A, i)).length_squared();
    let mut best = squared(i, j);
    for _ in 0..a.corners.len() + b.corners.len() {
        let around = [(a.next(i), j), (a.previous(i), j), (i, b.next(j)), (i, b.previous(j))];
        let Some((k, l, closer)) =
            around.into_iter().map(|(k, l)| (k, l, squared(k, l))).find(|(_, _, d)| *d < best)
        else {
            break;
        };
        (i, j, best) = (k, l, closer);
    }
    (Nearest::Vertices(i, j), best.sqrt() * scene)
}

/// A vertex in A's frame, scaled.
fn point(pair: &Pair, side: Side, k: usize) -> DVec2 {
    let q = pair.hull(side).corners.get(k).copied().unwrap_or(DVec2::ZERO);
    match side {
        Side::A => q * pair.scale,
        Side::B => pair.from_b(q),
    }
}

/// The certified separation at `t`, looked for at the given features first.
pub(super) fn certified(a: &Body, b: &Body, t: f64, near: Nearest) -> Separation {
    let hint = match near {
        Nearest::Edge { owner, edge, vertex } => Hint::Edge(Facing { source: owner, edge, corner: vertex }),
        Nearest::Vertices(i, j) => Hint::Corners([i, j]),
    };
    certify(&Pair::at(a, b, t), Some(hint))
}
