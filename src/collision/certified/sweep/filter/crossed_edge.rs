//! The edge of B ⊖ A that a ray crosses, by bisection: O(log n log m), nothing trusted.
//!
//! Let the ray run along v, and let u be v turned left by a quarter. The edges of B ⊖ A that face the ray
//! make one chain; along it the offset from the ray's line falls all the way from the leftmost vertex to the
//! rightmost:
//!
//! ```text
//! F(w_j − v_i) = u·c + u·R q_j − u·v_i       of a vertex; an edge with the normal N adds ρ u·N at both ends
//! ```
//!
//! The ray enters through the edge at whose start F ≥ 0 and at whose end F < 0; or, if ρ > 0 leaves a gap
//! between two edges, through the disc at the vertex between them. The chain is never built: it is made of
//! one chain of A's edges and one of B's, each of them sorted by direction. The middle edge of the longer one
//! is an edge of B ⊖ A together with the vertex of the other that supports it, which bisection finds as well;
//! F there tells which half of both to keep (the merge itself is de Berg, Cheong, van Kreveld, Overmars,
//! *Computational Geometry*, 2008, §13.3).
//!
//! If the leftmost vertex is right of the line, or the rightmost left of it, by more than ρ |v|, the ray
//! passes.

use crate::collision::certified::distance::Pair;
use crate::collision::certified::rounding::LEVEL_ERROR;
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{DVec2, Hull, Rotation, Side};

/// What a ray's line seems to cross first.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Crossed {
    /// Nothing: all of B ⊖ A is off the line, by this much times |v|.
    Passed(f64),
    /// An edge of B ⊖ A, grown by ρ.
    Edge(CrossedEdge),
    /// The disc at the vertex [i, j] of B ⊖ A.
    Vertex([usize; 2]),
}

/// An edge of B ⊖ A that a line seems to cross.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CrossedEdge {
    /// Which edge of B ⊖ A.
    pub(crate) edge: DifferenceEdge,
    /// The smaller of F at its start and −F at its end.
    pub(crate) inside: f64,
    /// Whether the other body's vertex clearly supports it, alone.
    pub(crate) is_supported: bool,
}

/// Cores of up to this many vertices are looked at whole, not searched.
const FEW: usize = 8;

/// The edges of one body that face the ray, in the order in which F falls, and which of them are left.
struct Chain<'h> {
    /// The body whose edges they are.
    side: Side,
    /// Its core.
    hull: &'h Hull,
    /// What a vertex adds to F is its height along this: u for B, −u for A, in the body's frame.
    up: DVec2,
    /// The highest vertex, where the chain starts.
    first: usize,
    /// From this body's frame to the other's.
    rotation: Rotation<f64>,
    /// The first edge that is left, counted along the chain.
    from: usize,
    /// One past the last edge that is left.
    to: usize,
}

impl<'h> Chain<'h> {
    /// The whole chain, with the heights of its first and its last vertex.
    #[inline]
    fn new(side: Side, hull: &'h Hull, up: DVec2, rotation: Rotation<f64>) -> (Self, [f64; 2]) {
        let ([first, last], heights) = ends(hull, up);
        let to = if last < first { last + hull.vertices.len() - first } else { last - first };
        (Self { side, hull, up, first, rotation, from: 0, to }, heights)
    }

    /// The hull's number of the chain's k-th vertex, and of the edge that starts there.
    #[inline]
    fn number(&self, k: usize) -> usize {
        let number = self.first + k;
        if number < self.hull.vertices.len() { number } else { number - self.hull.vertices.len() }
    }

    /// How much a vertex adds to F.
    #[inline]
    fn height(&self, vertex: usize) -> f64 {
        self.up.dot(self.hull.vertices[vertex])
    }

    /// Index of the first remaining edge whose direction is not before that of the other body's edge with
    /// this normal (turned into this body's frame): the vertex in front of it supports that edge.
    #[inline]
    fn support(&self, normal: DVec2) -> usize {
        let (mut from, mut to) = (self.from, self.to);
        while from < to {
            let middle = usize::midpoint(from, to);
            if normal.dot(self.hull.edges[self.number(middle)]) < 0.0 {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        from
    }

    /// Whether a vertex is clearly the only lowest along a normal of the other body, turned into this body's
    /// frame.
    #[inline]
    fn is_lowest(&self, vertex: usize, normal: DVec2) -> bool {
        if self.hull.edges.is_empty() {
            return true;
        }
        let (ahead, behind) = (self.hull.edges[vertex], self.hull.edges[self.hull.previous(vertex)]);
        let slack = |edge: DVec2| LEVEL_ERROR * (edge.x.abs() + edge.y.abs());
        normal.dot(ahead) > slack(ahead) && normal.dot(behind) < -slack(behind)
    }
}

/// The vertices that are highest and lowest along `up`, in the hull's frame, up to rounding, and how high.
#[inline]
fn ends(hull: &Hull, up: DVec2) -> ([usize; 2], [f64; 2]) {
    if hull.vertices.len() > FEW {
        let ends = [hull.highest(up, usize::MAX), hull.highest(-up, usize::MAX)];
        return (ends, ends.map(|k| up.dot(hull.vertices[k])));
    }
    let (mut first, mut last) = (0, 0);
    let (mut most, mut least) = (f64::NEG_INFINITY, f64::INFINITY);
    for (k, q) in hull.vertices.iter().enumerate() {
        let height = up.dot(*q);
        first = if height > most { k } else { first };
        last = if height < least { k } else { last };
        most = if height > most { height } else { most };
        least = if height < least { height } else { least };
    }
    ([first, last], [most, least])
}

/// What the line along `v` from the origin (A's frame) seems to cross first.
#[inline]
pub(crate) fn crossed(pair: &Pair, v: DVec2) -> Crossed {
    let rotation = pair.b_rotation.rounded();
    let u = DVec2::new(-v.y, v.x);
    let (mut a, [top_of_a, bottom_of_a]) = Chain::new(Side::A, pair.hull(Side::A), -u, rotation.inverse());
    let (mut b, [top_of_b, bottom_of_b]) =
        Chain::new(Side::B, pair.hull(Side::B), rotation.undo(u), rotation);
    let (start, radius) = (u.dot(pair.center), pair.radius.hi);
    let (top, bottom) = (start + top_of_a + top_of_b, start + bottom_of_a + bottom_of_b);
    if top < 0.0 || bottom > 0.0 {
        let past = bottom.max(-top) - radius * v.dot(v).sqrt();
        if past > 0.0 {
            return Crossed::Passed(past);
        }
    }
    // Each round takes away half of the longer chain, or finds the edge.
    while a.from < a.to || b.from < b.to {
        let a_is_longer = a.to - a.from >= b.to - b.from;
        let (own, other) = if a_is_longer { (&mut a, &mut b) } else { (&mut b, &mut a) };
        if let Some(edge) = halve(own, other, start, radius) {
            return Crossed::Edge(edge);
        }
    }
    Crossed::Vertex([a.number(a.from), b.number(b.from)])
}

/// Looks at the middle of what is left of `own` and keeps one half of both chains; or that edge, if the line
/// crosses it.
#[inline]
fn halve(own: &mut Chain, other: &mut Chain, start: f64, radius: f64) -> Option<CrossedEdge> {
    let middle = usize::midpoint(own.from, own.to);
    let edge = own.number(middle);
    let normal = own.hull.normals[edge];
    let turned = own.rotation.apply(*normal);
    let supporting = other.support(turned);
    let vertex = other.number(supporting);
    let before = start + own.height(edge) + other.height(vertex) + radius * own.up.dot(*normal);
    if before < 0.0 {
        (own.to, other.to) = (middle, supporting);
        return None;
    }
    let behind = before + own.up.dot(own.hull.edges[edge]);
    if behind >= 0.0 {
        (own.from, other.from) = (middle + 1, supporting);
        return None;
    }
    Some(CrossedEdge {
        edge: DifferenceEdge { source: own.side, edge, vertex },
        inside: before.min(-behind),
        is_supported: other.is_lowest(vertex, turned),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::Bodies;

    #[test]
    fn the_edge_crossed_is_the_facing_one_whose_line_is_met_last() {
        let mut bodies = Bodies::new(3);
        let mut edges = 0;
        for count in [3, 8, 9, 40, 300] {
            for k in 0..100 {
                let (a, b) = (bodies.of_many_vertices(count), bodies.of_many_vertices(7));
                let pair = Pair::at(&a, &b, 0.0);
                let v = DVec2::new(bodies.roll() - 0.5, bodies.roll() - 0.5);
                let last = crate::collision::certified::sweep::balls::last_line(&pair, v).unwrap();
                match crossed(&pair, v) {
                    Crossed::Edge(edge) => {
                        assert!(edge.is_supported && edge.edge == last, "{count} {k}: {edge:?} {last:?}");
                        edges += 1;
                    }
                    Crossed::Passed(past) => assert!(past > 0.0, "{count} {k}"),
                    Crossed::Vertex(vertices) => panic!("{count} {k}: no disc here, but {vertices:?}"),
                }
            }
        }
        assert!(edges > 150, "{edges} of 500 rays cross an edge");
    }
}
