//! Cores of few vertices, in plain doubles: a walk from vertices to their neighbours, and the table of all
//! gaps.
//!
//! At this size it is quicker to ask every vertex along every normal than to decide which to ask: nothing
//! branches, and the processor does several at once. The walk goes from a pair of vertices to the neighbour
//! that is nearer, as long as the foot of the one lies beyond the edge of the other; where it lies inside,
//! the edge may be the closest feature (Mirtich, *V-Clip: Fast and Robust Polyhedral Collision Detection*,
//! 1998). What either finds is a guess, that [`crate::collision::certified::distance::filter`] proves.

use crate::collision::certified::distance::conditions::{clearly_lowest, slack};
use crate::collision::certified::distance::gaps::{self, Ties, Widest};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{DVec2, Hull, Side};

/// Vertices of a core that count as few.
const FEW: usize = 8;

/// Vertices that are looked at together.
const TOGETHER: usize = 4;

/// Steps of a walk; twice round a core of [`FEW`].
const STEPS: usize = 2 * FEW;

/// Whether both cores have few vertices.
#[inline]
pub(crate) fn are_few(pair: &Pair) -> bool {
    pair.hull(Side::A).vertices.len() <= FEW && pair.hull(Side::B).vertices.len() <= FEW
}

/// The slopes of |d|² along the two edges at a vertex, `down` being the direction in which the vertex should
/// be lowest: how much nearer the ends of the edges ahead and behind are.
#[inline]
fn descents(hull: &Hull, k: usize, down: DVec2) -> [f64; 2] {
    if hull.edges.is_empty() {
        return [f64::NEG_INFINITY; 2];
    }
    [-hull.edges[k].dot(down), hull.edges[hull.previous(k)].dot(down)]
}

/// The closest features by a walk from vertices i of A and j of B.
///
/// A vertex of B ⊖ A only if it is clearly the closest, an edge if it seems to be; None where the walk ends
/// without either.
#[inline]
pub(crate) fn walk(pair: &Pair, [mut i, mut j]: [usize; 2]) -> Option<DifferenceFeature> {
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let rotation = pair.b_rotation.rounded();
    for _ in 0..STEPS {
        let d = pair.center + rotation.apply(b.vertices[j]) - a.vertices[i];
        let (down_a, down_b) = (-d, rotation.undo(d));
        let ([ahead_a, behind_a], [ahead_b, behind_b]) = (descents(a, i, down_a), descents(b, j, down_b));
        let (of_a, of_b) = (ahead_a.max(behind_a), ahead_b.max(behind_b));
        if of_a.max(of_b) < 0.0 {
            let slack = slack(pair, d);
            let clear = clearly_lowest(a, i, down_a, slack) && clearly_lowest(b, j, down_b, slack);
            return clear.then_some(DifferenceFeature::Vertex([i, j]));
        }
        let (source, descent, ahead) = if of_a >= of_b {
            (Side::A, of_a, ahead_a >= behind_a)
        } else {
            (Side::B, of_b, ahead_b >= behind_b)
        };
        let (hull, own, other, vertex) = if source == Side::A { (a, i, b, j) } else { (b, j, a, i) };
        let before = hull.previous(own);
        let (edge, end) = if ahead { (own, hull.next(own)) } else { (before, before) };
        let (mut own, mut vertex) = (own, vertex);
        if descent < hull.edges[edge].length_squared() {
            // The foot is inside the edge: the other vertex must be the nearest along its normal.
            let n = hull.normals[edge];
            let down = if source == Side::A { rotation.undo(*n) } else { rotation.apply(*n) };
            let [ahead, behind] = descents(other, vertex, down);
            if ahead.max(behind) <= 0.0 {
                return Some(DifferenceFeature::Edge(DifferenceEdge { source, edge, vertex }));
            }
            vertex = if ahead > behind { other.next(vertex) } else { other.previous(vertex) };
        } else {
            own = end;
        }
        [i, j] = a_then_b(source, own, vertex);
    }
    None
}

/// Vertices by coordinate, the first repeated to fill a block.
struct Lanes {
    /// Their x coordinates, scaled.
    x: [f64; FEW],
    /// Their y coordinates, scaled.
    y: [f64; FEW],
    /// How many blocks of vertices are filled.
    blocks: usize,
}

impl Lanes {
    /// The vertices of a core, each placed.
    #[inline]
    fn of(vertices: &[DVec2], place: impl Fn(DVec2) -> DVec2) -> Self {
        let mut block = Self { x: [0.0; FEW], y: [0.0; FEW], blocks: vertices.len().div_ceil(TOGETHER) };
        for k in 0..block.blocks * TOGETHER {
            let q = place(vertices[if k < vertices.len() { k } else { 0 }]);
            (block.x[k], block.y[k]) = (q.x, q.y);
        }
        block
    }

    /// The least of their heights along `n`.
    #[inline]
    fn least(&self, n: DVec2) -> f64 {
        let mut least = [f64::INFINITY; TOGETHER];
        for (x, y) in self.x.chunks_exact(TOGETHER).zip(self.y.chunks_exact(TOGETHER)).take(self.blocks) {
            for k in 0..TOGETHER {
                let height = n.x * x[k] + n.y * y[k];
                least[k] = if height < least[k] { height } else { least[k] };
            }
        }
        let [p, q, r, s] = least;
        let (p, q) = (if p < r { p } else { r }, if q < s { q } else { s });
        if p < q { p } else { q }
    }

    /// The vertex that is lowest along `n`.
    #[inline]
    fn lowest(&self, n: DVec2) -> usize {
        let (mut best, mut least) = (0, f64::INFINITY);
        for k in 0..self.blocks * TOGETHER {
            let height = n.x * self.x[k] + n.y * self.y[k];
            (best, least) = if height < least { (k, height) } else { (best, least) };
        }
        best
    }
}

/// The widest gap and the next of the edges of one core.
#[derive(Clone, Copy)]
struct BestGaps {
    /// The widest gap of all edges.
    gap: f64,
    /// The edge that has it.
    edge: usize,
    /// The widest gap of the other edges.
    second: f64,
}

/// The gaps along a core's normals.
#[inline]
fn top(hull: &Hull, others: &Lanes) -> BestGaps {
    let mut top = BestGaps { gap: f64::NEG_INFINITY, edge: 0, second: f64::NEG_INFINITY };
    for (edge, (n, offset)) in hull.normals.iter().zip(&hull.offsets).enumerate() {
        let gap = others.least(**n) - offset;
        let lower = if gap < top.gap { gap } else { top.gap };
        top.second = if lower > top.second { lower } else { top.second };
        top.edge = if gap > top.gap { edge } else { top.edge };
        top.gap = if gap > top.gap { gap } else { top.gap };
    }
    top
}

/// [`gaps::widest`] of cores with few vertices each; None where B ⊖ A has no edges.
#[inline]
pub(crate) fn widest(pair: &Pair) -> Option<Widest> {
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let of_b = Lanes::of(&b.vertices, |q| pair.center + pair.vector_from_b(q));
    let of_a = Lanes::of(&a.vertices, |v| pair.local_to_b(v));
    let (along_a, along_b) = (top(a, &of_b), top(b, &of_a));
    let (source, best, other) =
        if along_a.gap >= along_b.gap { (Side::A, along_a, along_b) } else { (Side::B, along_b, along_a) };
    if best.second.max(other.gap) >= best.gap - 2.0 * pair.gap_error() {
        return gaps::widest(pair);
    }
    let (own, seen) = if source == Side::A { (a, &of_b) } else { (b, &of_a) };
    let vertex = seen.lowest(*own.normals[best.edge]);
    Some(Widest {
        facing: DifferenceEdge { source, edge: best.edge, vertex },
        gap: best.gap,
        ties: Ties::None,
    })
}
