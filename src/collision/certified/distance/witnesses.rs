//! From what was found in A's frame to the answer in the world: normal, witness points, features, bounds.
//!
//! With n the unit normal from A to B, s the separation, and c the points on the cores:
//!
//! ```text
//! p_A = c_A + r_A n        p_B = c_B − r_B n        p_B − p_A = s n
//! ```
//!
//! A vertex is placed by its own body's pose, so that it is as near to the exact one as doubles come. The
//! other witness follows along the normal.

use crate::collision::Separation;
use crate::collision::certified::distance::pair::{Pair, Placement};
use crate::collision::feature::{DifferenceEdge, a_then_b};
use crate::geometry::{DVec2, Enclosure, Feature, Side, UnitVector, perp};

/// What carries a separation: the nearest feature of B ⊖ A, counted along the cores.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Carrier {
    /// An edge of one core and a vertex of the other.
    Edge(DifferenceEdge),
    /// An edge, and the other core's edge that is parallel to it.
    ParallelEdges(DifferenceEdge, usize),
    /// Vertex i of A and vertex j of B: [i, j].
    Vertex([usize; 2]),
}

/// A separation that is proved, in A's frame and scaled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Proved {
    /// The nearest feature of B ⊖ A.
    pub(crate) carrier: Carrier,
    /// Unit vector from A to B; None where points coincide.
    pub(crate) normal: Option<UnitVector>,
    /// Signed distance of the cores.
    pub(crate) core: f64,
    /// Signed separation, not scaled.
    pub(crate) separation: f64,
    /// Its bounds, not scaled.
    pub(crate) bounds: Enclosure,
    /// Directions that tie.
    pub(crate) ties: u32,
}

impl Proved {
    /// Takes what other bounds of the same separation say besides.
    pub(super) fn narrow(&mut self, other: Enclosure) {
        let (lo, hi) = (self.bounds.lo.max(other.lo), self.bounds.hi.min(other.hi));
        if lo <= hi {
            self.bounds = Enclosure { lo, hi };
            self.separation = self.separation.max(lo).min(hi);
        }
    }
}

/// Witness points of the cores in the world, scaled (so that they round once), and the features that carry
/// them.
type Witnesses = ([DVec2; 2], [Feature; 2]);

/// The answer that was proved of a pair.
#[inline]
pub(crate) fn answer(pair: &Pair, proved: &Proved) -> Separation {
    answer_at(&pair.placement(), proved)
}

/// The answer that was proved of two bodies at the moment of their placement.
#[inline]
pub(crate) fn answer_at(at: &Placement, proved: &Proved) -> Separation {
    let pair = at.pair;
    let Proved { carrier, normal: local, core, separation, bounds, ties } = *proved;
    // Points that coincide: every direction is as good; the world's x axis is taken.
    let normal = local.map_or(UnitVector::X, |n| n.turned(pair.frame_rotation.rounded()));
    let n = *local.unwrap_or(UnitVector::X);
    let (cores, features) = match carrier {
        Carrier::Vertex([i, j]) => vertices(at, i, j),
        Carrier::Edge(facing) => edge_and_vertex(at, facing, n, core),
        Carrier::ParallelEdges(facing, partner) => parallel_edges(at, facing, partner, n, core),
    };
    let [r_a, r_b] = [pair.a.shape.radius * pair.scale, pair.b.shape.radius * pair.scale];
    let unscale = pair.unscale();
    let points = [(cores[0] + normal * r_a) * unscale, (cores[1] - normal * r_b) * unscale];
    Separation { separation, bounds, normal, ties, points, features }
}

/// Vertex i of A and vertex j of B.
fn vertices(at: &Placement, i: usize, j: usize) -> Witnesses {
    let pair = at.pair;
    let points = [world_vertex(at, Side::A, i), world_vertex(at, Side::B, j)];
    (points, [pair.a.shape.vertex_feature(i), pair.b.shape.vertex_feature(j)])
}

/// An edge of one body and a vertex of the other, `core` apart along `n`; scaled.
fn edge_and_vertex(at: &Placement, facing: DifferenceEdge, n: DVec2, core: f64) -> Witnesses {
    let pair = at.pair;
    let world = pair.world_vector(n) * core;
    let DifferenceEdge { source, edge, vertex } = facing;
    match source {
        Side::A => {
            let point = world_vertex(at, Side::B, vertex);
            let local = (at.point_from_b(pair.hull(Side::B).vertices[vertex]) - n * core) * pair.unscale();
            let features = [pair.a.shape.edge_feature(edge, local), pair.b.shape.vertex_feature(vertex)];
            ([point - world, point], features)
        }
        Side::B => {
            let point = world_vertex(at, Side::A, vertex);
            let local = at.point_to_b(pair.hull(Side::A).vertices[vertex] * pair.scale + n * core);
            let features = [pair.a.shape.vertex_feature(vertex), pair.b.shape.edge_feature(edge, local)];
            ([point, point + world], features)
        }
    }
}

/// Two parallel edges, `core` apart along `n`, at the middle of what they share; scaled.
fn parallel_edges(at: &Placement, facing: DifferenceEdge, partner: usize, n: DVec2, core: f64) -> Witnesses {
    let pair = at.pair;
    let [k, l] = a_then_b(facing.source, facing.edge, partner);
    let (a, b) = (pair.hull(Side::A), pair.hull(Side::B));
    let along = perp(n);
    // Places along the edge, measured from A's vertex so that nothing cancels twice.
    let start = a.vertices[k] * pair.scale;
    let end = (a.vertices[a.next(k)] * pair.scale - start).dot(along);
    let place = |j: usize| (at.point_from_b(b.vertices[j]) - start).dot(along);
    let (p, q) = (place(l), place(b.next(l)));
    let (from, to) = (p.min(q).max(end.min(0.0)), p.max(q).min(end.max(0.0)));
    let middle = start + along * (0.5 * (from + to));
    let point = world_point(at, Side::A, middle);
    let features = [
        pair.a.shape.edge_feature(k, middle * pair.unscale()),
        pair.b.shape.edge_feature(l, at.point_to_b(middle + n * core)),
    ];
    ([point, point + pair.world_vector(n) * core], features)
}

/// A core's vertex in the world.
fn world_vertex(at: &Placement, side: Side, k: usize) -> DVec2 {
    world_point(at, side, at.pair.hull(side).vertices[k] * at.pair.scale)
}

/// A point of a body's frame in the world; both scaled.
fn world_point(at: &Placement, side: Side, local: DVec2) -> DVec2 {
    let (pair, pose) = (at.pair, at.pose(side));
    pose.position * pair.scale + pose.vector(local)
}
