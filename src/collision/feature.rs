//! A part of the boundary of B ⊖ A = {b − a}, named by the parts of the two cores that make it.
//!
//! Whether bodies touch, how far apart or how deep they are, and where a ray between them enters: each is a
//! question about the point of B ⊖ A that is nearest the origin, or that the ray meets. That point lies on
//! one of two things:
//!
//! ```text
//! edge     edge k of one core and the vertex of the other that supports it along the edge's normal
//! vertex   w_j − v_i: vertex i of A's core and vertex j of B's
//! ```
//!
//! Indices count the core's vertices, counter-clockwise, not the file's; core edge k runs from vertex k to
//! the next.

use crate::geometry::Side;

/// An edge of B ⊖ A: an edge of one core, and the vertex of the other that supports it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct DifferenceEdge {
    /// The body whose edge it is.
    pub(crate) source: Side,
    /// The edge of `source`, counted along its core.
    pub(crate) edge: usize,
    /// The other body's supporting vertex, counted along its core.
    pub(crate) vertex: usize,
}

/// An edge or a vertex of B ⊖ A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DifferenceFeature {
    /// An edge.
    Edge(DifferenceEdge),
    /// The vertex `w_j − v_i`, as [i, j]: vertex i of A and vertex j of B.
    Vertex([usize; 2]),
}

impl DifferenceEdge {
    /// The vertex [i, j] of B ⊖ A that the edge's own first vertex makes.
    #[inline]
    pub(crate) fn start(self) -> [usize; 2] {
        a_then_b(self.source, self.edge, self.vertex)
    }
}

/// What belongs to `source` and what belongs to the other body, in the order A, B.
#[inline]
pub(crate) fn a_then_b<T>(source: Side, own: T, other: T) -> [T; 2] {
    match source {
        Side::A => [own, other],
        Side::B => [other, own],
    }
}
