//! EPA, the expanding polytope: depth from a simplex of B ⊖ A that holds the origin, as [`super::gjk`] finds
//! it.
//!
//! The polytope's vertices are kept counter-clockwise. Its edge nearest the origin, with outward normal N and
//! distance d, is split by the farthest vertex w of B ⊖ A along N; when w·N is no farther than d the edge is
//! one of B ⊖ A itself, and d the depth:
//!
//! ```text
//! w = s_B(N) − s_A(−N)      stop: w·N ≤ d, or w is an end of the edge
//! ```
//!
//! It may start from a segment, which is a polytope of two edges, there and back, with no inside: a body
//! without interior, or a search that met the origin on its way.

use crate::collision::algorithm::simplex::Vertex;
use crate::collision::algorithm::view::PairView;
use crate::geometry::{DVec2, length};
use crate::trace::{Event, Tracer};

/// Most vertices that a polytope may have; it grows by one a step.
///
/// Only vertices that are all about as deep use it up, as those of two regular polygons of 65 vertices that
/// lie on one another; [`super::merge`] finishes such a search. At half of it 33 vertices do. At twice it the
/// search itself is dearer, for the storage is copied: 9,900 instructions a query of `benches/trace_cost`
/// instead of 6,200.
const CAPACITY: usize = 128;

/// A convex polygon inside B ⊖ A, counter-clockwise.
struct Polytope {
    /// The vertices, of which the first `count` are in use.
    vertices: [Vertex; CAPACITY],
    /// How many vertices it has.
    count: usize,
}

/// The edge of B ⊖ A nearest the origin; None when the storage is used up or B ⊖ A is a point.
pub(crate) fn expand(pair: &PairView, simplex: &[Vertex], tracer: &mut impl Tracer) -> Option<[Vertex; 2]> {
    let mut polytope = Polytope::from_simplex(pair, simplex)?;
    loop {
        let (edge, outward, distance) = polytope.nearest();
        let (p, q) = polytope.ends(edge);
        let w = Vertex::farthest(pair, outward);
        let is_end = w.is(&p) || w.is(&q);
        tracer.record(|| Event::PolytopeExpanded {
            vertices: polytope.vertices[..polytope.count]
                .iter()
                .map(|v| pair.world_vector(v.point))
                .collect(),
            nearest: distance,
            edge,
            normal: pair.world_vector(outward),
            support: pair.world_vector(w.point),
            beyond: if is_end { 0.0 } else { w.point.dot(outward) - distance },
        });
        if is_end || w.point.dot(outward) <= distance {
            return Some([p, q]);
        }
        if polytope.vertices[..polytope.count].iter().any(|v| v.is(&w)) || !polytope.insert(edge, w) {
            return None;
        }
    }
}

impl Polytope {
    /// The polytope of a triangle, turned counter-clockwise, or of a segment, from a vertex to another one.
    fn from_simplex(pair: &PairView, simplex: &[Vertex]) -> Option<Self> {
        let first = *simplex.first()?;
        let mut vertices = [first; CAPACITY];
        let count = match *simplex {
            [p, q, r] => {
                let counter_clockwise = (q.point - p.point).perp_dot(r.point - p.point) > 0.0;
                vertices[..3].copy_from_slice(&if counter_clockwise { [p, q, r] } else { [p, r, q] });
                3
            }
            [p, q] => {
                vertices[..2].copy_from_slice(&[p, q]);
                2
            }
            _ => {
                let directions = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];
                let other = directions.map(|d| Vertex::farthest(pair, d)).into_iter();
                vertices[1] = other.into_iter().find(|v| v.point != first.point)?;
                2
            }
        };
        Some(Self { vertices, count })
    }

    /// The ends of edge k: vertex k and the next.
    fn ends(&self, k: usize) -> (Vertex, Vertex) {
        let next = if k + 1 == self.count { 0 } else { k + 1 };
        (self.vertices[k], self.vertices[next])
    }

    /// The edge nearest the origin, its outward normal and its distance.
    fn nearest(&self) -> (usize, DVec2, f64) {
        let mut best = (0, DVec2::ZERO, f64::INFINITY);
        for k in 0..self.count {
            let (p, q) = self.ends(k);
            let d = q.point - p.point;
            let outward = DVec2::new(d.y, -d.x) / length(d);
            let distance = outward.dot(p.point);
            if distance < best.2 {
                best = (k, outward, distance);
            }
        }
        best
    }

    /// Splits edge k by a vertex; false where there is no room.
    fn insert(&mut self, k: usize, w: Vertex) -> bool {
        if self.count == CAPACITY {
            return false;
        }
        self.vertices.copy_within(k + 1..self.count, k + 2);
        self.vertices[k + 1] = w;
        self.count += 1;
        true
    }
}
