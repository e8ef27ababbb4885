//! Features of a shape in the file's numbering, from vertices and edges of its core.
//!
//! The core runs counter-clockwise without collinear vertices; the file may run clockwise and have more
//! vertices. An answer names what the file has: the vertex, or the edge that holds the witness point.

use glam::DVec2;

use super::Shape;
use crate::geometry::Feature;

/// Which vertices the numbered edges of a shape run between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// Edge i runs from vertex i to vertex i + 1 of the file.
    OfFile,
    /// Edge i runs from vertex i to the hull's next vertex, counter-clockwise; clockwise where the file has
    /// them in that order.
    OfHull,
}

impl Shape {
    /// The feature in the file's numbering for vertex `k` of the core.
    #[inline]
    #[must_use]
    pub(crate) fn vertex_feature(&self, k: usize) -> Feature {
        Feature::Vertex(self.core.get(k).copied().unwrap_or(0))
    }

    /// The file's edge that holds `point` (body frame, multiplied by the matrix), which lies on edge `k` of
    /// the core.
    ///
    /// Where collinear vertices were dropped, the edge is made of several edges of the file: the one whose
    /// ends have the point between them is taken, the first in the file's order on a tie.
    #[inline]
    #[must_use]
    pub(crate) fn edge_feature(&self, k: usize, point: DVec2) -> Feature {
        let (count, vertices) = (self.vertices.len(), self.core.len());
        if vertices < 2 {
            return self.vertex_feature(0);
        }
        if count == 2 {
            return Feature::Edge(0);
        }
        let next = |k: usize, count: usize| if k + 1 == count { 0 } else { k + 1 };
        let k = if k < vertices { k } else { k % vertices };
        let (from, to) = (self.core[k], self.core[next(k, vertices)]);
        if self.edges == Edges::OfHull {
            return Feature::Edge(if self.hull_runs_clockwise() { to } else { from });
        }
        if next(from, count) == to { Feature::Edge(from) } else { self.edge_between(from, to, point) }
    }

    /// The numbers of the vertices at both ends of an edge that is numbered as in answers; None where there
    /// is no such edge.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Shape};
    /// let triangle = Shape::polygon(vec![DVec2::ZERO, DVec2::X, DVec2::Y])?;
    /// assert_eq!((triangle.edge_ends(2), triangle.edge_ends(3)), (Some([2, 0]), None));
    /// # Ok::<(), tracefig::geometry::shape::ShapeError>(())
    /// ```
    #[must_use]
    pub fn edge_ends(&self, i: usize) -> Option<[usize; 2]> {
        if self.edges == Edges::OfHull {
            let count = self.core.len();
            let k = self.core.iter().position(|&vertex| vertex == i)?;
            let next = if self.hull_runs_clockwise() { k + count - 1 } else { k + 1 };
            return Some([i, self.core[next % count]]);
        }
        let count = self.vertices.len();
        let edges = if count > 2 { count } else { count.saturating_sub(1) };
        (i < edges).then(|| [i, (i + 1) % count])
    }

    /// Whether the shape is the polygon through the vertices of the file in their order, and not only the
    /// hull of them.
    pub(crate) fn is_in_order(&self) -> bool {
        let falls = |(i, &k): (usize, &usize)| self.core[(i + 1) % self.core.len()] < k;
        let count = self.core.iter().enumerate().filter(|&at| falls(at)).count();
        let around = count == 1 || count + 1 == self.core.len();
        self.edges == Edges::OfFile || self.core.len() == self.vertices.len() && around
    }

    /// Whether the file has the hull's vertices in clockwise order, from any one of them on.
    fn hull_runs_clockwise(&self) -> bool {
        let count = self.core.len();
        let rises = (0..count).filter(|&k| self.core[k] < self.core[(k + 1) % count]).count();
        count > 2 && rises == 1
    }

    /// Core edge k in the file's numbering where the file runs clockwise, or has more vertices between the
    /// two.
    #[cold]
    fn edge_between(&self, from: usize, to: usize, point: DVec2) -> Feature {
        let (from, to) = if self.is_counter_clockwise() { (from, to) } else { (to, from) };
        self.nearest_edge(from, to, point)
    }

    /// Whether the core runs in the file's order.
    fn is_counter_clockwise(&self) -> bool {
        // The indices of the core rise (with one wrap) or fall (with one wrap).
        let falls = self.core.windows(2).filter(|pair| pair[1] < pair[0]).count();
        falls <= 1 || self.core.len() < 3
    }

    /// The file's edge that comes nearest to holding `point`, of those from vertex `from` on to vertex `to`.
    fn nearest_edge(&self, from: usize, to: usize, point: DVec2) -> Feature {
        let count = self.vertices.len();
        let (mut best, mut least) = (from, f64::INFINITY);
        let mut i = from;
        while i != to {
            let next = (i + 1) % count;
            let (p, q) = (self.multiplied_vertex(i), self.multiplied_vertex(next));
            // How far the point is outside the edge's bounding box; 0 inside.
            let outside = (p.min(q) - point).max(point - p.max(q)).max(DVec2::ZERO);
            let miss = outside.x.max(outside.y);
            if p != q && miss < least {
                (best, least) = (i, miss);
            }
            i = next;
        }
        Feature::Edge(best)
    }
}
