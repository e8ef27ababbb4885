//! Shapes, queries, and the algorithms that take them.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use tracefig::collision::{ALGORITHMS, Algorithm, Query, QueryKind};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Body, Shape};

/// A shape that is known to be valid.
pub(crate) fn of_kind(kind: &str, fields: &[(&str, FieldValue)]) -> Shape {
    Shape::of_kind(kind, fields).unwrap()
}

/// A query of two bodies at t = 0.
pub(crate) fn query<'s>(kind: QueryKind, a: &'s Body, b: &'s Body) -> Query<'s> {
    Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 100 }
}

/// The algorithms that take a query.
pub(crate) fn takers(query: &Query) -> Vec<&'static Algorithm> {
    ALGORITHMS.iter().filter(|x| x.takes(query)).collect()
}
