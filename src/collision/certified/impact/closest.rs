//! A guess, in doubles, of the features by which two cores are closest: whatever follows from it is proved
//! elsewhere, so a wrong guess costs time and nothing else.
//!
//! The edge with the widest gap is the closest feature if its supporting vertex, of the other core, lies
//! above it: if it projects between the edge's ends. If it projects beyond an end, two vertices are closest;
//! from that end and that vertex, steps to neighbours lead to them, since along the boundary of B ⊖ A the
//! distance has one minimum.

use crate::collision::Separation;
use crate::collision::certified::distance::gaps::pass;
use crate::collision::certified::distance::{Pair, certify};
use crate::collision::certified::impact::moving_pair::{MovingPair, RelativePose};
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{Body, DVec2, Side};

/// The closest features at time `t`, and the distance of the cores (negative inside), in scaled units. O(n +
/// m).
pub(crate) fn closest_features(pair: &MovingPair, t: f64) -> (DifferenceFeature, f64) {
    let pose = pair.relative_pose(Side::A, t, &pair.rotations(Side::A, t));
    let center = DVec2::new(pose.offset[0], pose.offset[1]) / pair.unit;
    let rotation = pose.rotation;
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let mut best: Option<(DifferenceEdge, f64)> = None;
    let mut visit = |source: Side, edge: usize, vertex: usize, gap: f64| {
        if best.is_none_or(|(_, widest)| gap > widest) {
            best = Some((DifferenceEdge { source, edge, vertex }, gap));
        }
    };
    pass(a, b, (center, rotation), |edge, vertex, gap| visit(Side::A, edge, vertex, gap));
    let back = (-rotation.undo(center), rotation.inverse());
    pass(b, a, back, |edge, vertex, gap| visit(Side::B, edge, vertex, gap));
    let cores = Cores { pair, pose };
    let Some((DifferenceEdge { source: owner, edge, vertex }, gap)) = best else {
        return (DifferenceFeature::Vertex([0, 0]), cores.between(0, 0).length());
    };
    let gap = gap * pair.unit;
    if gap > 0.0
        && let Some(above) = cores.above(owner, edge, vertex)
    {
        return match above {
            Above::ParallelEdge(vertex) => {
                (DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex }), gap)
            }
            Above::Nothing(end) if owner == Side::A => cores.descend(end, vertex),
            Above::Nothing(end) => cores.descend(vertex, end),
        };
    }
    (DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex }), gap)
}

/// What lies above an edge when its supporting vertex projects beyond one of the edge's ends.
enum Above {
    /// A parallel edge of the other core, with this vertex of it.
    ParallelEdge(usize),
    /// Nothing: this end of the edge is closest to the other core.
    Nothing(usize),
}

/// Both cores at a moment, in A's frame.
struct Cores<'p, 'q> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// Where B is in A's frame.
    pose: RelativePose<f64>,
}

impl Cores<'_, '_> {
    /// Vertex k of a core.
    fn point(&self, side: Side, k: usize) -> DVec2 {
        let q = self.pair.vertex(side, k);
        if side == Side::A { q } else { self.pose.point(q) }
    }

    /// From A's vertex i to B's vertex j.
    fn between(&self, i: usize, j: usize) -> DVec2 {
        self.point(Side::B, j) - self.point(Side::A, i)
    }

    /// What lies above an edge; None where its supporting vertex does.
    fn above(&self, owner: Side, edge: usize, vertex: usize) -> Option<Above> {
        let end = self.pair.hull(owner).next(edge);
        let (from, to) = (self.point(owner, edge), self.point(owner, end));
        let along = to - from;
        // Where on the edge's line a point is: at most 0 before its start, at least 0 after its end.
        let place = |x: DVec2| ((x - from).dot(along), (x - to).dot(along));
        let x = self.point(owner.other(), vertex);
        let (start, stop) = place(x);
        if start > 0.0 && stop < 0.0 {
            return None;
        }
        // An edge of the other core that is parallel to this one reaches over it, though its first end may
        // not.
        let other = self.pair.hull(owner.other());
        let level = self.pair.rounding * along.length();
        let over = [other.previous(vertex), other.next(vertex)].into_iter().find(|&k| {
            let y = self.point(owner.other(), k);
            let (first, last) = place(y);
            (y - x).perp_dot(along).abs() <= level && if start <= 0.0 { first > 0.0 } else { last < 0.0 }
        });
        let end = if start <= 0.0 { edge } else { end };
        Some(over.map_or(Above::Nothing(end), Above::ParallelEdge))
    }

    /// The closest two vertices, by steps from vertex i of A and vertex j of B, and their distance.
    fn descend(&self, mut i: usize, mut j: usize) -> (DifferenceFeature, f64) {
        let (a, b) = (self.pair.hull(Side::A), self.pair.hull(Side::B));
        let squared = |i: usize, j: usize| self.between(i, j).length_squared();
        let mut best = squared(i, j);
        for _ in 0..a.vertices.len() + b.vertices.len() {
            let around = [(a.next(i), j), (a.previous(i), j), (i, b.next(j)), (i, b.previous(j))];
            let Some((k, l, closer)) =
                around.into_iter().map(|(k, l)| (k, l, squared(k, l))).find(|(_, _, d)| *d < best)
            else {
                break;
            };
            (i, j, best) = (k, l, closer);
        }
        (DifferenceFeature::Vertex([i, j]), best.sqrt())
    }
}

/// The certified separation at `t`, looked for at the given features first.
pub(crate) fn separation_at(a: &Body, b: &Body, t: f64, near: DifferenceFeature) -> Separation {
    certify(&Pair::at(a, b, t), Some(near))
}
