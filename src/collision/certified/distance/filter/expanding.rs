//! The depth of large cores without a look at every edge: a polygon inside B ⊖ A that grows where the origin
//! is nearest.
//!
//! With the origin inside a polygon P whose vertices belong to B ⊖ A, no direction has less depth than the
//! nearest edge of P is away. So the nearest edge is replaced by two, with the vertex of B ⊖ A farthest
//! beyond it, until the nearest edge is one of B ⊖ A itself: then its distance is the depth, and all that
//! lies behind the other edges need never be seen. (van den Bergen, *Proximity Queries and Penetration Depth
//! Computation on 3D Game Objects*, 2001, section 3: the expanding polytope.) The number of steps hardly
//! grows with the number of vertices; each is a search of O(log n).
//!
//! Vertices here are doubles within [`Pair::gap_error`] of theirs, and so are the distances of segments
//! between them from the origin, so that two of these that differ by more than twice that are in the order in
//! which they are computed.

use crate::collision::certified::distance::conditions::{Support, support};
use crate::collision::certified::distance::filter::descent::{SupportPair, Vertex, facing};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::feature::DifferenceEdge;
use crate::geometry::Side;

/// Edges of the polygon at most; more are needed only where many depths are nearly the same.
const EDGES: usize = 64;

/// With fewer edges than this B ⊖ A is measured edge by edge: about ten steps are needed, each as long as
/// four edges.
const WORTHWHILE: usize = 48;

/// A convex polygon P of vertices of B ⊖ A, counter-clockwise, that grows towards its boundary.
struct Inscribed {
    /// Its vertices, of which the first `count` are in use.
    vertices: [Vertex; EDGES],
    /// Distance of the origin from the line of the edge after each vertex, in scaled units.
    distances: [f64; EDGES],
    /// How many vertices it has.
    count: usize,
}

/// The distance of the origin from the line from p to q, positive on its left.
#[inline]
fn distance(p: Vertex, q: Vertex) -> f64 {
    let along = q.p - p.p;
    p.p.perp_dot(along) / along.length()
}

impl Inscribed {
    /// A triangle round the origin, either way round.
    fn new([p, q, r]: [Vertex; 3]) -> Self {
        let mut vertices = [Vertex::default(); EDGES];
        let mut distances = [0.0; EDGES];
        let (q, r) = if p.p.perp_dot(q.p) > 0.0 { (q, r) } else { (r, q) };
        (vertices[0], vertices[1], vertices[2]) = (p, q, r);
        (distances[0], distances[1], distances[2]) = (distance(p, q), distance(q, r), distance(r, p));
        Self { vertices, distances, count: 3 }
    }

    /// The nearest edge, and the distance of the nearest but that one.
    fn nearest(&self) -> (usize, f64) {
        let (mut best, mut least, mut second) = (0, f64::INFINITY, f64::INFINITY);
        for (k, &distance) in self.distances.iter().take(self.count).enumerate() {
            if distance < least {
                (best, second, least) = (k, least, distance);
            } else if distance < second {
                second = distance;
            }
        }
        (best, second)
    }

    /// The ends of edge k.
    fn ends(&self, k: usize) -> [Vertex; 2] {
        [self.vertices[k], self.vertices[if k + 1 == self.count { 0 } else { k + 1 }]]
    }

    /// Puts a vertex between the ends of edge k.
    fn split(&mut self, k: usize, vertex: Vertex) {
        let [p, q] = self.ends(k);
        self.vertices.copy_within(k + 1..self.count, k + 2);
        self.distances.copy_within(k + 1..self.count, k + 2);
        self.vertices[k + 1] = vertex;
        (self.distances[k], self.distances[k + 1]) = (distance(p, vertex), distance(vertex, q));
        self.count += 1;
    }
}

/// The edge of B ⊖ A that is nearest the origin, if it clearly is, from a triangle of vertices round the
/// origin; None also where a look at every edge is quicker.
pub(crate) fn deepest(pair: &Pair, triangle: [Vertex; 3]) -> Option<DifferenceEdge> {
    if pair.hull(Side::A).vertices.len() + pair.hull(Side::B).vertices.len() < WORTHWHILE {
        return None;
    }
    let supports = SupportPair::of(pair);
    let error = pair.gap_error();
    let mut inside = Inscribed::new(triangle);
    while inside.count < EDGES {
        let (k, second) = inside.nearest();
        let least = inside.distances[k];
        // Clear of 0: the polygon winds round the origin, once as the triangle does.
        if least <= 2.0 * error || least.is_nan() {
            return None;
        }
        let [p, q] = inside.ends(k);
        let along = q.p - p.p;
        let inward = crate::geometry::perp(along);
        let z = supports.lowest(inward, (p.i, p.j));
        if [(p.i, p.j), (q.i, q.j)].contains(&(z.i, z.j)) || inward.dot(z.p - p.p) >= 0.0 {
            let edge = facing(pair.hull(Side::A), pair.hull(Side::B), p, q)?;
            let alone = second > least + 2.0 * error;
            return (alone && matches!(support(pair, edge), Support::Vertex)).then_some(edge);
        }
        inside.split(k, z);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::certified::distance::filter::descent;
    use crate::collision::certified::distance::gaps;
    use crate::geometry::{Angle, Body, DVec2, Shape, shape::FieldValue};

    /// A polygon of `count` vertices on an ellipse.
    fn oval(count: u32, height: f64, position: DVec2, angle: f64) -> Body {
        let vertex = |k: u32| {
            let at = (f64::from(k) + 0.3 * libm::sin(f64::from(k * k))) / f64::from(count);
            let turn = at * std::f64::consts::TAU;
            DVec2::new(libm::cos(turn), height * libm::sin(turn))
        };
        let vertices = FieldValue::Points((0..count).map(vertex).collect());
        let shape = Shape::of_kind("polygon", &[("vertices", vertices)]).unwrap();
        Body {
            shape,
            position,
            angle: Angle::Degrees(angle),
            velocity: DVec2::ZERO,
            spin: Angle::Degrees(0.0),
        }
    }

    #[test]
    fn the_nearest_edge_is_that_of_a_look_at_every_edge() {
        let mut found = 0;
        for round in 0..300_u32 {
            let way = f64::from(round);
            let offset = DVec2::new(libm::cos(way), libm::sin(way)) * (0.2 + 0.002 * way);
            let a = oval(24 + round, 0.6 + 0.001 * way, DVec2::ZERO, way);
            let b = oval(24 + 3 * round, 0.8, offset, 7.0 * way);
            let pair = Pair::at(&a, &b, 0.0);
            let descent::Guess::Overlapping(triangle) = descent::guess(&pair) else {
                panic!("{round}: they overlap")
            };
            let Some(edge) = deepest(&pair, triangle) else { continue };
            found += 1;
            assert_eq!(gaps::widest(&pair).map(|widest| widest.facing), Some(edge), "{round}");
        }
        assert!(found > 270, "{found} of 300 were found");
    }

    #[test]
    fn parallel_edges_are_left_to_the_full_search() {
        let (a, b) = (oval(64, 1.0, DVec2::ZERO, 10.0), oval(64, 1.0, DVec2::new(0.3, 0.1), 190.0));
        let pair = Pair::at(&a, &b, 0.0);
        let descent::Guess::Overlapping(triangle) = descent::guess(&pair) else { panic!("they overlap") };
        assert_eq!(deepest(&pair, triangle), None);
    }
}
