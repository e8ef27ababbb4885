//! The gap between the bodies along the normal of every edge, in doubles with a proven bound.
//!
//! Each edge of A or B gives an edge of B ⊖ A: that edge and the vertex of the other body that is nearest
//! along its normal. The signed distance of the origin from that edge's line is the gap between the cores
//! along the normal; the largest of them is minus the penetration depth where they are all negative, and a
//! lower bound of the distance where one is positive. As the normals of a convex polygon turn one way, so
//! does the nearest vertex: one pointer goes round the other body while the edges go by, O(n + m) (Toussaint,
//! *Solving geometric problems with the rotating calipers*, 1983). Each pass works in the frame of the body
//! whose edges it visits, and asks the other body in its own.

use crate::collision::certified::distance::pair::Pair;
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{DVec2, Hull, Rotation, Side};

/// The edge of B ⊖ A with the widest gap.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Widest {
    /// Which edge of B ⊖ A.
    pub(crate) facing: DifferenceEdge,
    /// Its gap, within [`Pair::gap_error`].
    pub(crate) gap: f64,
    /// The others whose gap rounding can't tell from it.
    pub(crate) ties: Ties,
}

/// Which other gaps come within twice the error of the widest.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Ties {
    /// No other edge ties.
    None,
    /// Exactly one other edge ties: this one.
    One(Side, usize),
    /// Two or more tie: it is left to the full search.
    More,
}

/// The widest gap of a pair of any size, O(n + m); None where B ⊖ A has no edges.
pub(crate) fn widest(pair: &Pair) -> Option<Widest> {
    let [mut top, mut second, mut third] = [f64::NEG_INFINITY; 3];
    let (mut best, mut next) = (None, None);
    every_gap(pair, |facing, gap| {
        if gap > top {
            (third, second, top) = (second, top, gap);
            (next, best) = (best, Some(facing));
        } else if gap > second {
            (third, second) = (second, gap);
            next = Some(facing);
        } else if gap > third {
            third = gap;
        }
    });
    let floor = top - 2.0 * pair.gap_error();
    let ties = match next {
        _ if third >= floor => Ties::More,
        Some(next) if second >= floor => Ties::One(next.source, next.edge),
        _ => Ties::None,
    };
    best.map(|facing| Widest { facing, gap: top, ties })
}

/// Calls `visit` with every edge of B ⊖ A and its gap, within [`Pair::gap_error`] of the exact one: A's edges
/// first.
#[inline]
pub(crate) fn every_gap(pair: &Pair, mut visit: impl FnMut(DifferenceEdge, f64)) {
    let rotation = pair.b_rotation.rounded();
    let c = pair.center / pair.scale;
    pass(pair.hull(Side::A), pair.hull(Side::B), (c, rotation), |edge, vertex, gap| {
        visit(DifferenceEdge { source: Side::A, edge, vertex }, gap);
    });
    let back = (-rotation.undo(c), rotation.inverse());
    pass(pair.hull(Side::B), pair.hull(Side::A), back, |edge, vertex, gap| {
        visit(DifferenceEdge { source: Side::B, edge, vertex }, gap);
    });
}

/// One body's edges against the other's vertices: `center` is the other's origin and `rotation` leads from
/// its frame to the first one's.
#[inline]
pub(crate) fn pass(
    own: &Hull,
    other: &Hull,
    (center, rotation): (DVec2, Rotation<f64>),
    mut visit: impl FnMut(usize, usize, f64),
) {
    let Some(&first) = own.normals.first() else { return };
    let mut vertex = 0;
    let mut before = -first;
    for (edge, (&n, &offset)) in own.normals.iter().zip(&own.offsets).enumerate() {
        let u = rotation.undo(*n);
        if before.dot(*n) <= 0.0 {
            // More than a quarter turn (three times at most, and at the start): after a half turn the pointer
            // would stand on the highest vertex, where rounding may take a level edge for the bottom.
            vertex = lowest(other, u);
        }
        before = n;
        // At most once round: each step goes down along u.
        for _ in 0..other.edges.len() {
            if u.dot(other.edges[vertex]) >= 0.0 {
                break;
            }
            vertex = other.next(vertex);
        }
        visit(edge, vertex, n.dot(center) + u.dot(other.vertices[vertex]) - offset);
    }
}

/// The vertex that is lowest along `u`, in the hull's frame; the first of several.
#[inline]
pub(crate) fn lowest(hull: &Hull, u: DVec2) -> usize {
    let (mut best, mut least) = (0, f64::INFINITY);
    for (k, q) in hull.vertices.iter().enumerate() {
        let height = u.dot(*q);
        if height < least {
            (best, least) = (k, height);
        }
    }
    best
}
