//! Asks an algorithm by its name, with and without a listener, and holds that listening changes nothing.

use crate::collision::{ALGORITHMS, Algorithm, Answer, Impact, Query, QueryKind, Separation};
use crate::geometry::Body;
use crate::trace::{NoTrace, Trace};

/// A question about two bodies at t = 0.
pub(crate) fn query<'s>(kind: QueryKind, a: &'s Body, b: &'s Body) -> Query<'s> {
    Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 20_000 }
}

/// An algorithm of the table.
pub(crate) fn algorithm(name: &str) -> &'static Algorithm {
    ALGORITHMS.iter().find(|algorithm| algorithm.name == name).expect("in the table")
}

/// The answer of an algorithm, and what it told.
pub(crate) fn ask(name: &str, query: &Query) -> (Answer, Trace) {
    let algorithm = algorithm(name);
    assert!(algorithm.kinds.contains(&query.kind), "{name}");
    assert_eq!((algorithm.shapes)(query), Ok(()), "{name}");
    let mut trace = Trace::default();
    let answer = (algorithm.traced)(query, &mut trace);
    assert_eq!(answer, (algorithm.quiet)(query, &mut NoTrace), "listening changed the answer of {name}");
    (answer, trace)
}

/// The separation at t = 0.
pub(crate) fn separation(name: &str, a: &Body, b: &Body) -> (Separation, Trace) {
    match ask(name, &query(QueryKind::Separation, a, b)) {
        (Answer::Separation(found), trace) => (found, trace),
        other => panic!("{other:?}"),
    }
}

/// The first contact, by an algorithm that answers one question about it.
pub(crate) fn impact(name: &str, a: &Body, b: &Body, tolerance: f64) -> (Impact, Trace) {
    let kind = algorithm(name).kinds[0];
    match ask(name, &Query { tolerance, ..query(kind, a, b) }) {
        (Answer::Impact(found), trace) => (found, trace),
        other => panic!("{other:?}"),
    }
}
