//! The separating-axis test.
//!
//! Two convex polygons are apart exactly when the normal of one of their edges separates them: when along it
//! the interval of B begins beyond the end of A's,
//!
//! ```text
//! gap(n) = min over B of n·b − max over A of n·a − (r_A + r_B)
//! ```
//!
//! which is the signed distance of the other body's support from the edge's line: the gap of the intervals
//! where it is positive, else the depth of that support behind the edge. (How much the intervals share may be
//! less: one may reach past the other's far end, where another edge tells of it.)
//! A test for overlap stops at the first such axis. The largest gap, when all are negative, is the depth.
//! When the bodies are apart it is only a lower bound of the distance, for two vertices may face each other,
//! and no edge is square to the line that joins them; so the edge and vertex of each axis are held against
//! each other too, and where vertices win, the axis that joins them is the last one tested. The normal of an
//! edge of A is, mirrored, that of an edge of B ⊖ A: this is the Minkowski loop seen from the world.
//!
//! Source: Gottschalk, Lin, Manocha, "`OBBTree`" (1996), section 5; Eberly, "Method of Separating Axes"
//! (2001). O(n·m).

use crate::collision::algorithm::candidate::{self, CoreFeature};
use crate::collision::algorithm::early_out::{self, EarlyOut};
use crate::collision::algorithm::nearest_edge::NearestEdge;
use crate::collision::algorithm::outline::{self, Projection};
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::feature::DifferenceEdge;
use crate::collision::{Answer, Query};
use crate::geometry::{DVec2, Enclosure, Feature, Side};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "separating-axes",
    about: "a gap along the normal of an edge (Gottschalk et al. 1996, section 5)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    outline::tell(&pair, tracer);
    let early_out = EarlyOut::of(query.kind, &pair);
    let mut nearest = NearestEdge::default();
    for source in [Side::A, Side::B] {
        for edge in 0..pair.edges(source) {
            let (first, second) = pair.supports_of_edge(source, edge);
            let p = DifferenceEdge { source, edge, vertex: first }.project(&pair);
            let feature = Feature::Edge(pair.file_edge(source, edge));
            tell_axis(&pair, -p.outward, (source, feature), p.line, tracer);
            if early_out.is_reached(&p) {
                return Answer::Overlap(early_out::separated(&pair, &p, tracer));
            }
            let beside = second.map(|vertex| DifferenceEdge { source, edge, vertex }.project(&pair));
            for p in [Some(p), beside].into_iter().flatten() {
                nearest.offer(gap(&p), p);
            }
        }
    }
    let candidate = nearest.candidate(&pair);
    if let [CoreFeature::Vertex(a), CoreFeature::Vertex(_)] = candidate.features {
        let feature = Feature::Vertex(pair.file_vertex(Side::A, a));
        tell_axis(&pair, candidate.normal, (Side::A, feature), candidate.distance, tracer);
    }
    let separation = candidate::conclude(&pair, &candidate, tracer);
    candidate::finish(query.kind, separation, tracer)
}

/// What an axis is compared by: the gap along it or, where there is one, the distance of the vertex from the
/// edge.
fn gap(p: &Projection) -> f64 {
    if p.line < 0.0 { p.line } else { p.distance }
}

/// Tells the intervals of both bodies along an axis (A's frame), in world coordinates along it.
fn tell_axis(pair: &PairView, axis: DVec2, source: (Side, Feature), line: f64, tracer: &mut impl Tracer) {
    tracer.record(|| {
        let world = pair.world_vector(axis);
        let interval = |side: Side| {
            let reach = |k: usize| pair.world_point(pair.vertex(side, k)).dot(world);
            let radius = pair.body(side).shape.radius;
            Enclosure {
                lo: reach(pair.support(side, -axis)) - radius,
                hi: reach(pair.support(side, axis)) + radius,
            }
        };
        let (interval_a, interval_b) = (interval(Side::A), interval(Side::B));
        Event::AxisTested { axis: world, source, interval_a, interval_b, gap: line - pair.radius() }
    });
}
