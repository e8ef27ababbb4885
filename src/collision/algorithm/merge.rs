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
use crate::collision::{Answer, Query};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "merge",
    about: "B - A with its edges merged by direction, O(n + m) (de Berg et al. 2008, 13.3)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    quiet: answer,
    traced: answer,
    ready: None,
};

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    tell_rounding(&pair, tracer);
    let mut nearest = NearestEdge::default();
    each_edge(&pair, |edge| {
        tracer.record(|| edge.found(&pair));
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
