//! Where a body is at a moment: every vertex to 300 bits.
//!
//! A vertex is multiplied by its body's matrix first, whose numbers are exact, and then turned by its angle +
//! spin · t.

use crate::float::Real;
use crate::point::{Point, Rotation, degrees_of};
use crate::scene::Body;

/// A body at a moment.
#[derive(Clone, Debug)]
pub struct Placed {
    /// World vertices in the file's order.
    pub vertices: Vec<Point>,
    /// Indices of the strictly convex core, counter-clockwise.
    pub core: Vec<usize>,
    /// Whether the vertices close to a ring.
    pub ring: bool,
    /// Radius of the disc that sweeps the core.
    pub radius: Real,
    /// World place of the body's origin.
    pub origin: Point,
    /// How the body is turned, besides the matrix that its vertices are multiplied by.
    pub rotation: Rotation,
    /// Whether the body is the hull of its vertices, and its edges those of the core.
    pub hull: bool,
}

impl Placed {
    /// A body at time `t`; `core` is [`convex_core`] of it, which does not change with time.
    #[must_use]
    pub fn at(body: &Body, core: &[usize], t: Real) -> Self {
        let sum = |angle: f64, spin: f64| Real::from(angle) + Real::from(spin) * t;
        let (degrees, radians) =
            (sum(body.angle.degrees, body.spin.degrees), sum(body.angle.radians, body.spin.radians));
        let rotation = Rotation::of_degrees(degrees + degrees_of(radians));
        let origin = Point::of(body.position).plus(Point::of(body.velocity).times(t));
        Self {
            vertices: body.multiplied().map(|vertex| origin.plus(vertex.turned(rotation))).collect(),
            core: core.to_vec(),
            ring: body.ring,
            radius: Real::from(body.radius),
            origin,
            rotation,
            hull: body.hull,
        }
    }

    /// Indices of the two ends of edge `i` of the file: of a hull, from vertex `i` to the next vertex of the
    /// hull.
    #[must_use]
    pub fn edge(&self, i: usize) -> Option<[usize; 2]> {
        if self.hull {
            let count = self.core.len();
            let k = self.core.iter().position(|&vertex| vertex == i)?;
            let next = if self.runs_clockwise() { k + count - 1 } else { k + 1 };
            return Some([i, self.core[next % count]]);
        }
        let n = self.vertices.len();
        let edges = if self.ring { n } else { n - 1 };
        (i < edges).then(|| [i, (i + 1) % n])
    }

    /// Whether the file has the core's vertices in clockwise order, from any one of them on.
    fn runs_clockwise(&self) -> bool {
        let count = self.core.len();
        let rises = (0..count).filter(|&k| self.core[k] < self.core[(k + 1) % count]).count();
        count > 2 && rises == 1
    }

    /// The core's vertices.
    pub fn core_points(&self) -> impl Iterator<Item = Point> {
        self.core.iter().map(|i| self.vertices[*i])
    }
}

/// Indices of the vertices of the convex hull, counter-clockwise, without duplicates and without vertices of
/// 180°: Andrew's monotone chain, 1979, on exact doubles.
#[must_use]
pub fn convex_core(vertices: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..vertices.len()).collect();
    order.sort_by(|i, j| {
        // −0 is 0 here.
        let (p, q) = (vertices[*i].map(|x| x + 0.0), vertices[*j].map(|x| x + 0.0));
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(i.cmp(j))
    });
    order.dedup_by(|i, j| vertices[*i] == vertices[*j]);
    if order.len() < 3 {
        return order;
    }
    let left_turn = |a: usize, b: usize, c: usize| {
        let [p, q, r] = [a, b, c].map(|i| Point::of(vertices[i]));
        q.minus(p).cross(r.minus(p)).signum() > 0
    };
    let chain = |indices: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for i in indices {
            while let [.., a, b] = chain[..] {
                if left_turn(a, b, i) {
                    break;
                }
                chain.pop();
            }
            chain.push(i);
        }
        chain.pop();
        chain
    };
    let mut core = chain(&mut order.iter().copied());
    core.extend(chain(&mut order.iter().rev().copied()));
    core
}

#[cfg(test)]
mod tests {
    use super::convex_core;

    #[test]
    fn the_core_drops_duplicates_and_flat_vertices() {
        let square = [
            [-1.0, -1.0],
            [0.0, -1.0],
            [1.0, -1.0],
            [1.0, -1.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [-1.0, 1.0],
            [-1.0, 0.0],
        ];
        assert_eq!(convex_core(&square), [0, 2, 5, 6]);
        assert_eq!(convex_core(&[[1.0, 1.0], [1.0, 1.0]]), [0]);
    }
}
