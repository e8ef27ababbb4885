//! Signed separation by the Minkowski difference, edge by edge, as the article does it.
//!
//! B ⊖ A = {b − a} holds the origin exactly when the bodies overlap, and its distance from the origin is
//! theirs. Loop over the edges of A with the vertices of B that support them, then over the edges of B with
//! the vertices of A: each pair is an edge of B ⊖ A. Project the origin onto it and keep the least
//! penetrating distance, or, once the origin is seen to be outside, the least positive one.
//!
//! ```text
//! s = supports of B along −N          N: outward normal of the edge v₀v₁ of A
//! edge of B ⊖ A: s − v₀ → s − v₁      dist = ± ‖foot‖, the sign that of (s − v₀)·N
//! ```
//!
//! Two edges that are exactly aligned have *two* supporting vertices; both are projected on ("re-project onto
//! the edge from the origin to make sure you don't accidentally pick the wrong edge-vertex pair").
//!
//! Two things differ from the article's listing. Its `Sign(0)` is 0, which calls a pair touching as soon as
//! the origin is on the *line* of an edge; here 0 counts as outside. And the round bodies that it leaves out
//! are core and radius: the distance of the cores less `r_A` + `r_B`. A core that is a point has no edges;
//! two points have none between them, and the one point of their difference is compared instead.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), sections OBB vs OBB and Poly vs Poly.
//! O(n·m).

use crate::collision::algorithm::candidate::{self, Candidate};
use crate::collision::algorithm::early_out::{self, EarlyOut};
use crate::collision::algorithm::nearest_edge::{NearestEdge, Offer, improved};
use crate::collision::algorithm::outline::{Projection, tell_rounding};
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::feature::DifferenceEdge;
use crate::collision::{Answer, Overlap, Query, QueryKind, Separation};
use crate::geometry::Side;
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "minkowski",
    about: "B - A edge by edge with all supporting vertices, O(n m) (Firth 2011, OBB vs OBB)",
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
    if query.kind == QueryKind::Overlap {
        Answer::Overlap(overlap(&pair, tracer))
    } else {
        Answer::Separation(separation(&pair, tracer))
    }
}

/// Signed separation of a pair, told.
pub(crate) fn separation(pair: &PairView, tracer: &mut impl Tracer) -> Separation {
    let found = match closest(pair, EarlyOut::Never, tracer) {
        Closest::Separates(edge) => Candidate::of_projection(pair, &edge),
        Closest::Nearest(edge) => edge.candidate(pair),
    };
    let answer = candidate::conclude_rounding(pair, &found, tracer);
    tracer.record(|| Event::Finished { outcome: answer.word() });
    answer
}

/// Whether a pair overlaps: the search ends at the first edge that separates.
fn overlap(pair: &PairView, tracer: &mut impl Tracer) -> Overlap {
    match closest(pair, EarlyOut::of(QueryKind::Overlap, pair), tracer) {
        Closest::Separates(edge) => early_out::separated(pair, &edge, tracer),
        Closest::Nearest(edge) => {
            let answer = Overlap::from(&candidate::conclude_rounding(pair, &edge.candidate(pair), tracer));
            tracer.record(|| Event::Finished { outcome: answer.word() });
            answer
        }
    }
}

/// What the loop over the edges found.
enum Closest {
    /// An edge whose line has the origin outside, beyond radii and rounding; no other was looked at.
    Separates(Projection),
    /// The edge that is nearest the origin, of all.
    Nearest(NearestEdge),
}

/// The edge of B ⊖ A nearest the origin, unless an edge before the last ends the search.
fn closest(pair: &PairView, early_out: EarlyOut, tracer: &mut impl Tracer) -> Closest {
    tell_rounding(pair, tracer);
    let mut nearest = NearestEdge::default();
    for source in [Side::A, Side::B] {
        for edge in 0..pair.edges(source) {
            for edge in edges_of(pair, source, edge, tracer).into_iter().flatten() {
                let p = edge.project(pair);
                tracer.record(|| Event::OriginProjected {
                    foot: pair.world_vector(p.foot),
                    distance: p.distance,
                });
                if early_out.is_reached(&p) {
                    return Closest::Separates(p);
                }
                if nearest.offer(p.distance, p) == Offer::Improves {
                    tracer.record(|| improved(pair, &p));
                }
            }
        }
    }
    Closest::Nearest(nearest)
}

/// An edge of a body with each vertex of the other that supports it: one, or two where an edge there is
/// aligned.
///
/// The first, which is told as an edge of B ⊖ A, is the one that stands in the outline, where B's edges come
/// first.
fn edges_of(
    pair: &PairView,
    source: Side,
    edge: usize,
    tracer: &mut impl Tracer,
) -> [Option<DifferenceEdge>; 2] {
    let (first, second) = pair.supports_of_edge(source, edge);
    let other = source.other();
    tracer.record(|| Event::SupportFound {
        body: other,
        direction: pair.world_vector(-pair.outward(source, edge)),
        vertices: [Some(first), second].into_iter().flatten().map(|k| pair.told(other, k)).collect(),
    });
    let (outline, beside) = match (source, second) {
        (Side::A, Some(second)) => (second, Some(first)),
        _ => (first, second),
    };
    let of = |vertex| DifferenceEdge { source, edge, vertex };
    tracer.record(|| of(outline).found(pair));
    [Some(of(outline)), beside.map(of)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed};
    use crate::trace::Trace;

    #[test]
    fn a_test_for_overlap_stops_at_the_first_edge_that_separates() {
        let (a, b) = (boxed("box", 1., 1.), placed(boxed("box", 1., 1.), 4., 0.5, 30.));
        let kind = QueryKind::Overlap;
        let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let mut trace = Trace::default();
        let Answer::Overlap(found) = answer(&query, &mut trace) else { panic!("{trace:?}") };
        assert_eq!((found.overlap, found.separation_bounds.hi), (Some(false), f64::INFINITY));
        let edges = trace.events.iter().filter(|e| matches!(e, Event::DifferenceEdgeFound { .. })).count();
        // A's right edge is its second.
        assert_eq!(edges, 2);
        assert_eq!(trace.events.last(), Some(&Event::Finished { outcome: "separating axis" }));
    }
}
