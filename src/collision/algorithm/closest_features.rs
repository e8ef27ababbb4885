//! Signed separation with proven bounds: the default for every pair of convex bodies.
//!
//! The features of two cores that face each other are an edge or a vertex of B ⊖ A: the one nearest the
//! origin where the bodies are apart, the one to leave by where they overlap. This algorithm has no way of
//! its own to it that would be drawn: it asks [`crate::collision::certified::distance`], which finds and
//! proves it, and tells the outcome.
//!
//! Source: Toussaint, "Solving geometric problems with the rotating calipers" (1983), for B ⊖ A by its edges.

use crate::collision::algorithm::candidate;
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::certified::distance::Pair;
use crate::collision::{Answer, Query};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "closest-features",
    about: "closest features of B - A, proved by supports and witnesses in double-doubles (Toussaint 1983)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: Some(|query| {
        let kind = query.kind;
        let pair = Pair::at(query.a, query.b.unwrap_or(query.a), query.time).refined();
        Box::new(move || candidate::answer(kind, pair.separation()))
    }),
};

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let found = Pair::at(query.a, query.b.unwrap_or(query.a), query.time).separation();
    if tracer.listens() {
        let pair = PairView::of(query);
        tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: pair.moment() });
        outline::tell(&pair, tracer);
        candidate::tell(&pair, &found, tracer);
    }
    candidate::finish(query.kind, found, tracer)
}
