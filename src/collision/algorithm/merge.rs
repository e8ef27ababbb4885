//! Signed separation by the Minkowski difference, its edges merged by direction in O(n + m).
//!
//! The edges of B ⊖ A are the edges of B and the mirrored edges of A, sorted by direction. Both come sorted
//! already, since the cores are convex and counter-clockwise: start where A's first edge and B's supporting
//! vertex meet and always take the edge that turns less,
//!
//! ```text
//! −eₐ × e_b > 0: take A's      < 0: take B's      = 0: take B's, then A's, they lie on one line
//! ```
//!
//! with no angle computed. Two bodies never get half a turn out of step, for an edge of a convex core turns
//! less than that from the one before (and a segment's, by exactly that, is met as `Against`).
//!
//! Source: de Berg, Cheong, van Kreveld, Overmars, "Computational Geometry" (3rd ed., 2008), section 13.3;
//! the distance then as in [`crate::collision::algorithm::minkowski`].

use crate::collision::algorithm::candidate;
use crate::collision::algorithm::nearest_edge::{NearestEdge, Offer, improved};
use crate::collision::algorithm::outline::{each_edge, tell_rounding};
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::feature::DifferenceEdge;
use crate::collision::{Answer, Query};
use crate::geometry::Side;
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "merge",
    about: "B - A with its edges merged by direction, O(n + m) (de Berg et al. 2008, 13.3)",
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
    tell_rounding(&pair, tracer);
    let mut nearest = NearestEdge::default();
    let mut left = [pair.edges(Side::A), pair.edges(Side::B)];
    each_edge(&pair, |edge| {
        tracer.record(|| merged(&pair, edge, left));
        tracer.record(|| edge.found(&pair));
        left[edge.source as usize] -= 1;
        let p = edge.project(&pair);
        tracer.record(|| Event::OriginProjected { foot: pair.world_vector(p.foot), distance: p.distance });
        if nearest.offer(p.distance, p) == Offer::Improves {
            tracer.record(|| improved(&pair, &p));
        }
    });
    let candidate = nearest.candidate(&pair);
    let separation = candidate::conclude_rounding(&pair, &candidate, tracer);
    candidate::finish(query.kind, separation, tracer)
}

/// The choice of an edge, where so many edges of A and B are `left`. The vertex that the other body has in it
/// is where that body's next edge begins.
fn merged(pair: &PairView, edge: DifferenceEdge, left: [usize; 2]) -> Event {
    let other = edge.source.other();
    let vector = |side: Side, k: usize| pair.world_vector(pair.difference_edge(side, k));
    Event::EdgesMerged {
        taken: edge.source,
        at: pair.world_vector(edge.ends(pair)[0]),
        edge: vector(edge.source, edge.edge),
        other: (left[other as usize] > 0).then(|| vector(other, edge.vertex)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::QueryKind;
    use crate::collision::tests::bodies::{boxed, placed, polygon};
    use crate::geometry::Body;
    use crate::trace::Trace;

    /// The events of a run.
    fn told(a: &Body, b: &Body) -> Vec<Event> {
        let kind = QueryKind::Separation;
        let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let mut trace = Trace::default();
        answer(&query, &mut trace);
        trace.events
    }

    #[test]
    fn of_the_next_edges_the_one_that_turns_less_is_taken_and_they_close() {
        let a = polygon(&[[-2., -1.], [1., -2.], [2., 1.]], 0.0);
        let segment = placed(polygon(&[[0., 0.], [1., 2.]], 0.5), 3., 1., 10.);
        for b in [placed(boxed("box", 2., 1.), 5., 1., 20.), segment] {
            let events = told(&a, &b);
            let (mut sum, mut count) = (crate::geometry::DVec2::ZERO, 0);
            for pair in events.windows(2) {
                let (Event::EdgesMerged { taken, at, edge, other }, found) = (&pair[0], &pair[1]) else {
                    continue;
                };
                let Event::DifferenceEdgeFound { source, from, to, .. } = found else {
                    panic!("{found:?} after a choice")
                };
                assert_eq!((source, from), (taken, at));
                assert!((*to - *from - *edge).length() < 1e-14, "{pair:?}");
                // The other turns more: it is to the left.
                assert!(other.is_none_or(|other| edge.perp_dot(other) >= -1e-14), "{pair:?}");
                (sum, count) = (sum + *edge, count + 1);
            }
            let edges = a.shape.core.len() + b.shape.core.len();
            assert!(count == edges && sum.length() < 1e-13, "{count} edges, open by {sum}");
        }
    }
}
