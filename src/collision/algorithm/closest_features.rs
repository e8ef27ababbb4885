//! Signed separation with proven bounds: the default for every pair of convex bodies.
//!
//! See [`crate::collision::certified::distance::search`] for the proof; here it meets queries.

use crate::collision::Answer;
use crate::collision::Query;
use crate::collision::algorithm::candidate;
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::Relative;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::certified::distance::pair::Pair;
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
        let pair = Relative::of(query);
        tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: pair.at });
        outline::record(&pair, tracer);
        candidate::tell(&pair, &found, tracer);
    }
    tracer.record(|| Event::Finished { outcome: found.word() });
    candidate::answer(query.kind, found)
}
