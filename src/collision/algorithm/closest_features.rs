//! Signed separation with proven bounds: the default for every pair of convex bodies.
//!
//! See [`crate::collision::certified::distance::search`] for the proof; here it meets queries.

use crate::collision::algorithm::candidate;
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::{Answer, Query};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "closest-features",
    about: "closest features of B - A, proved by supports and witnesses in double-doubles (Toussaint 1983)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    quiet: answer,
    traced: answer,
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
        tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: pair.at });
        outline::tell(&pair, tracer);
        candidate::tell(&pair, &found, tracer);
    }
    candidate::finish(query.kind, found, tracer)
}
