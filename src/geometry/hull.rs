//! A strictly convex core, prepared for queries: vertices counter-clockwise, its edges' directions and
//! normals.
//!
//! Where a matrix multiplies the core, its vertices are no doubles any more: doubles stand for them, within
//! half an ulp, and beside them balls with all that is known. Edges and normals are made of the multiplied
//! edges, not of the rounded vertices, and are as good as those of any core.
//!
//! A point has one vertex and no edge; a segment two vertices and two edges, there and back, which lets every
//! algorithm that walks round a polygon walk round a segment too.

use glam::DVec2;

use crate::geometry::Ball;
use crate::geometry::Dd;
use crate::geometry::Rotation;
use crate::geometry::UnitVector;
use crate::geometry::sort_by;
use crate::geometry::taming_power;

/// The vertices of a convex core in counter-clockwise order, and what follows from them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hull {
    /// Vertices in the body's frame: exactly as written, or, where a matrix multiplies them, each coordinate
    /// within half an ulp.
    pub vertices: Vec<DVec2>,
    /// Edge i runs from vertex i to vertex i + 1: their difference, each component within ε/2 of itself; of a
    /// multiplied core, each within ε/2 of the edge's length.
    pub edges: Vec<DVec2>,
    /// Outward unit normals of the edges; each component within ε/2.
    pub normals: Vec<UnitVector>,
    /// What `normals` leave out, so that both together are within 7 ε² of the exact normal, each component;
    /// of a multiplied core, within 16 ε².
    pub tails: Vec<DVec2>,
    /// Normal · vertex, the edge's distance from the body's origin: within 2ε of the reach.
    pub offsets: Vec<f64>,
    /// Not below the distance of any vertex from the body's origin.
    pub reach: f64,
    /// Rising [`diamond`] angles of the normals, from that of edge `first` on.
    angles: Vec<f64>,
    /// The edge whose normal has the least diamond angle.
    first: usize,
    /// What the doubles of a multiplied core stand for; None where they are exact.
    exact: Option<Box<Multiplied>>,
    /// Bound on what the double-doubles of `exact` are off, as a vector: 0 where the doubles are exact.
    pub(crate) error: f64,
}

/// The vertices and edges of a core that a matrix multiplies.
#[derive(Clone, Debug, PartialEq)]
struct Multiplied {
    /// The vertices.
    vertices: Vec<[Ball; 2]>,
    /// The edges; a component is exactly 0, or not 0 at all.
    edges: Vec<[Ball; 2]>,
}

/// Up to this many vertices it is quicker to look at all than to search.
const FEW: usize = 8;

/// A measure of a direction's angle that rises with it from 0 to 4, without a root.
#[inline]
fn diamond(v: DVec2) -> f64 {
    let share = v.y / (v.x.abs() + v.y.abs());
    if v.x < 0.0 {
        2.0 - share
    } else if share < 0.0 {
        4.0 + share
    } else {
        share
    }
}

/// Bound on the error of each component of a double-double normal: 7 ε². With u = ε/2 the square of an edge's
/// length is off by 11u² of itself (a product, a sum), its root by 5.5u² and 3.2u² of its own, the quotient
/// by 17u² more: 26u².
pub(crate) const NORMAL_ERROR: f64 = 7.0 * f64::EPSILON * f64::EPSILON;

/// Bound on the error of each component of a double-double normal of a multiplied core: 16 ε².
///
/// Of an edge, which is exact as written, each component loses 8u² in each of two products and 3u² in their
/// sum: 15u² of its length, or 20u² as a vector, which its length loses as well. That is 35u² more than
/// [`NORMAL_ERROR`]: 61u² = 15.3 ε². Rounded up to a power of two.
pub(crate) const MULTIPLIED_NORMAL_ERROR: f64 = 16.0 * f64::EPSILON * f64::EPSILON;

impl Hull {
    /// Prepares vertices that are strictly convex and counter-clockwise.
    #[must_use]
    pub(crate) fn new(vertices: Vec<DVec2>) -> Self {
        let n = vertices.len();
        let following = |i: usize| vertices[(i + 1) % n];
        let count = if n < 2 { 0 } else { n };
        let edges: Vec<DVec2> = (0..count).map(|i| following(i) - vertices[i]).collect();
        let normals: Vec<_> = (0..count).map(|i| outward(vertices[i], following(i))).collect();
        Self::of_parts(vertices, edges, normals)
    }

    /// Prepares such vertices after a multiplication by a matrix that is nearly a rotation.
    #[must_use]
    pub(crate) fn multiplied(written: &[DVec2], matrix: Rotation<f64>) -> Self {
        let n = written.len();
        let largest = written.iter().fold(0.0, |most: f64, v| most.max(v.x.abs()).max(v.y.abs()));
        let unit = taming_power(largest);
        let matrix = Rotation { cos: Ball::new(matrix.cos), sin: Ball::new(matrix.sin) };
        let written: Vec<DVec2> = written.iter().map(|v| *v * unit).collect();
        let count = if n < 2 { 0 } else { n };
        let tame_edges: Vec<[Ball; 2]> = (0..count)
            .map(|i| {
                let (from, to) = (written[i], written[(i + 1) % n]);
                let along = [Ball::difference(to.x, from.x), Ball::difference(to.y, from.y)];
                never_nearly_zero(matrix.apply(along))
            })
            .collect();
        let back = |v: &[Ball; 2]| v.map(|x| x.times_power_of_two(1.0 / unit));
        let vertices: Vec<[Ball; 2]> =
            written.iter().map(|v| back(&matrix.apply([Ball::new(v.x), Ball::new(v.y)]))).collect();
        let edges: Vec<[Ball; 2]> = tame_edges.iter().map(back).collect();
        let normals: Vec<_> = tame_edges.iter().map(|[x, y]| square_to(x.value, y.value)).collect();
        let high = |v: &[Ball; 2]| DVec2::new(v[0].value.hi, v[1].value.hi);
        let error = vertices.iter().fold(0.0, |most: f64, v| most.max(v[0].radius + v[1].radius));
        let doubles =
            Self::of_parts(vertices.iter().map(high).collect(), edges.iter().map(high).collect(), normals);
        // The doubles may be nearer to the origin than what they stand for.
        let reach = doubles.reach * (1.0 + f64::EPSILON);
        Self { exact: Some(Box::new(Multiplied { vertices, edges })), error, reach, ..doubles }
    }

    /// A core of its vertices, edges and normals.
    fn of_parts(vertices: Vec<DVec2>, edges: Vec<DVec2>, normals: Vec<(UnitVector, DVec2)>) -> Self {
        let (n, count) = (vertices.len(), edges.len());
        let (normals, tails): (Vec<UnitVector>, Vec<DVec2>) = normals.into_iter().unzip();
        let offsets = normals.iter().zip(&vertices).map(|(normal, vertex)| normal.dot(*vertex)).collect();
        let reach = vertices.iter().fold(0.0, |reach: f64, &q| reach.max(length(q)));
        let angle = |i: &usize| diamond(*normals[*i]);
        let first = (0..count).min_by(|i, j| angle(i).total_cmp(&angle(j))).unwrap_or(0);
        let mut angles: Vec<f64> = (0..count).map(|i| angle(&((first + i) % n))).collect();
        // Nearly parallel edges may come out of order by rounding.
        sort_by(&mut angles, f64::total_cmp);
        Self { vertices, edges, normals, tails, offsets, reach, angles, first, exact: None, error: 0.0 }
    }

    /// Whether a matrix multiplies the core, so that its doubles are rounded.
    #[inline]
    pub(crate) fn is_multiplied(&self) -> bool {
        self.exact.is_some()
    }

    /// What the double of a vertex leaves out, within [`Self::error`].
    #[inline]
    pub(crate) fn vertex_tail(&self, i: usize) -> DVec2 {
        self.exact.as_ref().map_or(DVec2::ZERO, |exact| {
            let [x, y] = exact.vertices[i];
            DVec2::new(x.value.lo, y.value.lo)
        })
    }

    /// Vertex `i`, all that is known of it.
    #[inline]
    pub(crate) fn vertex_in_balls(&self, i: usize) -> [Ball; 2] {
        let vertex = self.vertices[i];
        self.exact
            .as_ref()
            .map_or_else(|| [Ball::new(vertex.x), Ball::new(vertex.y)], |exact| exact.vertices[i])
    }

    /// Edge `i`, all that is known of it.
    #[inline]
    pub(crate) fn edge_in_balls(&self, i: usize) -> [Ball; 2] {
        if let Some(exact) = &self.exact {
            return exact.edges[i];
        }
        let (from, to) = (self.vertices[i], self.vertices[self.next(i)]);
        [Ball::difference(to.x, from.x), Ball::difference(to.y, from.y)]
    }

    /// Vertex after `i`, counter-clockwise.
    #[inline]
    #[must_use]
    pub(crate) fn next(&self, i: usize) -> usize {
        if i + 1 == self.vertices.len() { 0 } else { i + 1 }
    }

    /// Vertex before `i`.
    #[inline]
    #[must_use]
    pub(crate) fn previous(&self, i: usize) -> usize {
        if i == 0 { self.vertices.len() - 1 } else { i - 1 }
    }

    /// The vertex that is highest along `direction`, in the hull's frame, searched from vertex `from` on
    /// (from anywhere, if there is no such vertex). A guess: rounding may leave it at a neighbour that is as
    /// high.
    #[inline]
    #[must_use]
    pub(crate) fn highest(&self, direction: DVec2, from: usize) -> usize {
        let count = self.vertices.len();
        if count <= FEW {
            return self.highest_of_few(direction);
        }
        let mut k = if from < count { from } else { self.sector(direction) };
        if direction.dot(self.edges[k]) > 0.0 || direction.dot(self.edges[self.previous(k)]) < 0.0 {
            k = self.sector(direction);
        }
        for _ in 0..count {
            if direction.dot(self.edges[k]) > 0.0 {
                k = self.next(k);
            } else if direction.dot(self.edges[self.previous(k)]) < 0.0 {
                k = self.previous(k);
            } else {
                break;
            }
        }
        k
    }

    /// The highest vertex of a few, by looking at them all.
    #[inline]
    fn highest_of_few(&self, direction: DVec2) -> usize {
        let (mut best, mut top) = (0, f64::NEG_INFINITY);
        for (k, q) in self.vertices.iter().enumerate() {
            let height = direction.dot(*q);
            if height > top {
                (best, top) = (k, height);
            }
        }
        best
    }

    /// The vertex between the normals that have `direction` between them, by bisection: O(log n).
    #[inline]
    fn sector(&self, direction: DVec2) -> usize {
        let angle = diamond(direction);
        let k = self.angles.partition_point(|&a| a < angle);
        // Normal k − 1 is before the direction and normal k behind it: they meet in vertex k.
        let first = self.first + k;
        if first < self.vertices.len() { first } else { first - self.vertices.len() }
    }

    /// Outward unit normal of edge `i`, to twice the precision; exact where the edge is parallel to an axis.
    #[inline]
    #[must_use]
    pub(crate) fn normal_in_balls(&self, i: usize) -> [Ball; 2] {
        let (hi, lo) = (self.normals[i], self.tails[i]);
        let error = if self.is_multiplied() { MULTIPLIED_NORMAL_ERROR } else { NORMAL_ERROR };
        let radius = if hi.x == 0.0 || hi.y == 0.0 { 0.0 } else { error };
        [Ball::within(Dd { hi: hi.x, lo: lo.x }, radius), Ball::within(Dd { hi: hi.y, lo: lo.y }, radius)]
    }
}

/// |v|, rounded up, without overflow or underflow.
fn length(v: DVec2) -> f64 {
    let factor = taming_power(v.x.abs().max(v.y.abs()));
    let v = v * factor;
    // Two products, a sum and a root: 2ε; then the way back, which may round where it is denormal.
    let length = (v.x * v.x + v.y * v.y).sqrt() * (1.0 + 4.0 * f64::EPSILON);
    if length == 0.0 { 0.0 } else { (length / factor).next_up() }
}

/// The unit normal to the right of an edge, outward where vertices run counter-clockwise: its doubles and
/// their tails.
fn outward(from: DVec2, to: DVec2) -> (UnitVector, DVec2) {
    let rough = to - from;
    let factor = taming_power(rough.x.abs().max(rough.y.abs()));
    let along = |from: f64, to: f64| Dd::difference(to, from).scale_by_power_of_two(factor);
    // Where the rounded difference is 0, so is the exact one.
    square_to(along(from.x, to.x), along(from.y, to.y))
}

/// The unit normal to the right of a vector of about 1: its doubles and their tails.
fn square_to(x: Dd, y: Dd) -> (UnitVector, DVec2) {
    if x.hi == 0.0 {
        return (UnitVector::normalized(DVec2::new(y.hi.signum(), 0.0)), DVec2::ZERO);
    }
    if y.hi == 0.0 {
        return (UnitVector::normalized(DVec2::new(0.0, -x.hi.signum())), DVec2::ZERO);
    }
    let length = (x * x + y * y).sqrt();
    let (nx, ny) = (y.div(length), -x.div(length));
    (UnitVector::normalized(DVec2::new(nx.hi, ny.hi)), DVec2::new(nx.lo, ny.lo))
}

/// A vector of which a component that is 0 is exactly 0: one that may be 0 becomes a number within its
/// radius.
fn never_nearly_zero(v: [Ball; 2]) -> [Ball; 2] {
    v.map(|x| {
        let vague = x.value.hi == 0.0 && x.radius > 0.0;
        if vague { Ball::within(Dd::new(0.5 * x.radius), 1.5 * x.radius) } else { x }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tracefig_reference::float::Real;
    use tracefig_reference::random::Random;

    /// Share of the bound that a search must reach, so that a bound cut to less is seen.
    const LEAST: f64 = 0.1;

    #[test]
    fn a_segment_has_two_sides_there_and_back() {
        let hull = Hull::new(vec![DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)]);
        assert_eq!(hull.normals, vec![DVec2::new(0.0, -1.0), DVec2::new(0.0, 1.0)]);
    }

    #[test]
    fn normals_are_unit_at_every_size() {
        for scale in [1e-320, 1e-200, 1.0, 1e200] {
            let hull = Hull::new(
                [DVec2::ZERO, DVec2::new(3.0, 0.0), DVec2::new(0.0, 4.0)]
                    .iter()
                    .map(|v| *v * scale)
                    .collect(),
            );
            for normal in &hull.normals {
                assert!((normal.x * normal.x + normal.y * normal.y - 1.0).abs() < 1e-3, "{scale}");
            }
            assert!(hull.reach >= 4.0 * scale);
        }
    }

    /// The largest error of a component of a stored normal, as a share of [`NORMAL_ERROR`], over many edges.
    fn share_of_the_bound(count: usize) -> f64 {
        let mut random = Random::new(11);
        let mut most = 0.0_f64;
        for _ in 0..count {
            let [from, to] = [0, 1].map(|_| DVec2::new(random.between(-2.0, 2.0), random.between(-2.0, 2.0)));
            let (hi, lo) = outward(from, to);
            let x = Real::from(to.x) - Real::from(from.x);
            let y = Real::from(to.y) - Real::from(from.y);
            let length = (x * x + y * y).sqrt();
            for (exact, [hi, lo]) in [(y.over(length), [hi.x, lo.x]), (-x.over(length), [hi.y, lo.y])] {
                let error = (exact - Real::from(hi) - Real::from(lo)).abs().to_f64();
                most = most.max(error / NORMAL_ERROR);
            }
        }
        most
    }

    #[test]
    fn normals_are_within_their_bound_and_use_it() {
        let most = share_of_the_bound(20_000);
        assert!(most <= 1.0, "off by {most} of the bound");
        assert!(most > LEAST, "only {most} of the bound is used");
    }
}
