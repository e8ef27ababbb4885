//! The simplex of GJK: one to three vertices of B ⊖ A, and the part of it that is closest to the origin.
//!
//! A vertex of B ⊖ A is a pair of core vertices, one of each body, so that two of them are told apart by
//! counting and not by comparing rounded points. The closest part of a triangle is found by its edges: those
//! that the origin is beyond, as seen from the inside, are projected on, and the nearest foot wins; where it
//! is beyond none, it is inside.
//!
//! Source: van den Bergen, "Collision detection in interactive 3D environments" (2003), section 4.3.1.

use crate::collision::algorithm::view::PairView;
use crate::geometry::{DVec2, Side, length, perp};

/// A vertex b − a of B ⊖ A.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    /// A's vertex, counted along its core.
    pub(crate) a: usize,
    /// B's vertex, counted along its core.
    pub(crate) b: usize,
    /// The point b − a, in A's frame.
    pub(crate) point: DVec2,
}

/// A point, a segment or a triangle of vertices of B ⊖ A.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Simplex {
    /// Its vertices, of which the first `count` are in use.
    vertices: [Vertex; 3],
    /// One, two or three.
    count: usize,
}

impl Vertex {
    /// The vertex of B ⊖ A farthest along a direction (A's frame).
    pub(crate) fn farthest(pair: &PairView, direction: DVec2) -> Self {
        let (a, b) = (pair.support(Side::A, -direction), pair.support(Side::B, direction));
        Self { a, b, point: pair.vertex(Side::B, b) - pair.vertex(Side::A, a) }
    }

    /// Whether this and the other are made of the same core vertices.
    pub(crate) fn is(&self, other: &Self) -> bool {
        self.a == other.a && self.b == other.b
    }
}

impl Simplex {
    /// The simplex of one vertex.
    pub(crate) fn point(vertex: Vertex) -> Self {
        Self { vertices: [vertex; 3], count: 1 }
    }

    /// Its vertices, in the order in which they were found.
    pub(crate) fn vertices(&self) -> &[Vertex] {
        &self.vertices[..self.count]
    }

    /// The simplex of one to three vertices.
    fn of(kept: &[Vertex]) -> Self {
        let mut vertices = [kept[0]; 3];
        vertices[..kept.len()].copy_from_slice(kept);
        Self { vertices, count: kept.len() }
    }

    /// The vertex that was found first.
    pub(crate) fn first(&self) -> Vertex {
        self.vertices[0]
    }

    /// Adds a vertex to a simplex of one or two.
    pub(crate) fn push(&mut self, w: Vertex) {
        self.vertices[self.count.min(2)] = w;
        self.count = (self.count + 1).min(3);
    }

    /// The smallest part of the simplex that holds its point closest to the origin, and that point; None
    /// where a triangle holds the origin.
    pub(crate) fn closest(&self) -> Option<(Self, DVec2)> {
        match *self.vertices() {
            [p, q] => Some(on_segment(p, q)),
            [p, q, r] => {
                let area = (q.point - p.point).perp_dot(r.point - p.point);
                let outside = |u: Vertex, v: Vertex| {
                    let turn = (v.point - u.point).perp_dot(-u.point);
                    if area > 0.0 { turn < 0.0 } else { turn > 0.0 || area == 0.0 }
                };
                let edges = [(p, q), (q, r), (r, p)];
                let nearest = |best: Option<(Self, DVec2)>, (u, v): (Vertex, Vertex)| {
                    if !outside(u, v) {
                        return best;
                    }
                    let found = on_segment(u, v);
                    match best {
                        Some(b) if length(b.1) <= length(found.1) => best,
                        _ => Some(found),
                    }
                };
                edges.into_iter().fold(None, nearest)
            }
            _ => Some((*self, self.vertices[0].point)),
        }
    }
}

/// The part of a segment closest to the origin, and the point.
fn on_segment(p: Vertex, q: Vertex) -> (Simplex, DVec2) {
    let along = q.point - p.point;
    let len = length(along);
    if len == 0.0 {
        return (Simplex::of(&[p]), p.point);
    }
    let d = along / len;
    let at = -p.point.dot(d);
    if at <= 0.0 {
        (Simplex::of(&[p]), p.point)
    } else if at >= len {
        (Simplex::of(&[q]), q.point)
    } else {
        let normal = perp(d);
        (Simplex::of(&[p, q]), normal * normal.dot(p.point))
    }
}
