//! Exact signed separation of two placed bodies, by all edges of B ⊖ A.
//!
//! B ⊖ A = {b − a} is a convex polygon (or a segment, or a point) whose edges are those of B and of A
//! reversed, merged by direction. The origin outside it: the distance of the cores is the least distance to
//! an edge. Inside: the depth is the least distance to an edge's line. The separation is that less the radii.
//! No pruning and no early exit: what is slow here is simple, and the solver's short cuts are what it checks.

use std::cmp::Ordering;

use crate::float::Real;
use crate::placement::Placed;
use crate::point::Point;

/// Cosine-like measure below which two directions are the same: |sin| of their angle.
///
/// Directions of one angle come out within 2⁻³¹⁵ of each other; doubles in degrees differ by 5e-324 at least,
/// which is 2⁻¹⁰⁷⁹, but such an angle moves no vertex by an amount that any check here could see.
#[must_use]
pub fn parallel_sine() -> Real {
    Real::power_of_two(-290)
}

/// An edge of B ⊖ A, counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// Where it starts.
    pub start: Point,
    /// From its start to its end.
    pub along: Point,
}

/// The difference of two cores.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Edges by direction; none for a point, two opposite ones for a segment.
    pub edges: Vec<Edge>,
    /// A vertex of it.
    pub vertex: Point,
    /// Whether it has interior points.
    pub solid: bool,
}

/// Which of the two half-turns a direction is in: 0 for [0°, 180°), 1 for [180°, 360°).
fn half(d: Point) -> u8 {
    u8::from(d.y.signum() < 0 || (d.y.is_zero() && d.x.signum() < 0))
}

/// Distance, as a part of the size of B ⊖ A and its distance, below which cores touch: the rounding of 320
/// bits leaves a direction to what is farther apart than this, and none to what is nearer.
#[must_use]
pub fn touching() -> Real {
    Real::power_of_two(-200)
}

fn parallel(a: Point, b: Point) -> bool {
    a.cross(b).squared() <= a.dot(a) * b.dot(b) * parallel_sine().squared()
}

/// Order by angle from 0°; parallel directions (to [`parallel_sine`]) are equal.
fn by_angle(a: Point, b: Point) -> Ordering {
    if parallel(a, b) && a.dot(b).signum() > 0 {
        return Ordering::Equal;
    }
    half(a).cmp(&half(b)).then_with(|| Real::ZERO.cmp(&a.cross(b)))
}

/// The edges of a convex ring from its lowest (of these the leftmost) vertex on, so that their angles rise
/// from 0°.
fn ring(points: &[Point]) -> (Point, Vec<Point>) {
    let n = points.len();
    let lowest = (0..n)
        .min_by(|i, j| points[*i].y.cmp(&points[*j].y).then_with(|| points[*i].x.cmp(&points[*j].x)))
        .unwrap_or(0);
    let at = |i: usize| points[(lowest + i) % n];
    let edges = if n < 2 { Vec::new() } else { (0..n).map(|i| at(i + 1).minus(at(i))).collect() };
    (at(0), edges)
}

impl Difference {
    /// B ⊖ A of two cores.
    #[must_use]
    pub fn of(a: &Placed, b: &Placed) -> Self {
        let reversed: Vec<Point> = a.core_points().map(Point::reversed).collect();
        let (start_a, edges_a) = ring(&reversed);
        let (start_b, edges_b) = ring(&b.core_points().collect::<Vec<_>>());
        let vertex = start_a.plus(start_b);
        let (mut i, mut j) = (0, 0);
        let mut at = vertex;
        let mut edges = Vec::with_capacity(edges_a.len() + edges_b.len());
        while i < edges_a.len() || j < edges_b.len() {
            let order = match (edges_a.get(i), edges_b.get(j)) {
                (Some(x), Some(y)) => by_angle(*x, *y),
                (Some(_), None) => Ordering::Less,
                _ => Ordering::Greater,
            };
            let mut along = Point::ZERO;
            if order != Ordering::Greater {
                along = along.plus(edges_a[i]);
                i += 1;
            }
            if order != Ordering::Less {
                along = along.plus(edges_b[j]);
                j += 1;
            }
            edges.push(Edge { start: at, along });
            at = at.plus(along);
        }
        let solid = edges.len() > 2;
        Self { edges, vertex, solid }
    }

    /// Its largest coordinate.
    fn size(&self) -> Real {
        let size = |p: Point| p.x.abs().max(p.y.abs());
        self.edges.iter().map(|edge| size(edge.start)).max().unwrap_or(Real::ZERO).max(size(self.vertex))
    }

    /// Whether the origin is inside or on the boundary.
    fn holds_origin(&self) -> bool {
        self.solid && self.edges.iter().all(|edge| edge.along.cross(edge.start).signum() <= 0)
    }
}

/// A direction along which B may move out, and what it costs.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Separation along this way: minus the depth, minus the radii.
    pub separation: Real,
    /// Unit vector from A to B.
    pub normal: Point,
}

/// The exact answer.
#[derive(Clone, Debug)]
pub struct Exact {
    /// Signed separation.
    pub separation: Real,
    /// Distance of the cores; negative (minus the depth) where they overlap.
    pub core: Real,
    /// Unit normal from A to B; None where only the cores' zero distance is known and the direction is free.
    pub normal: Option<Point>,
    /// Where the cores overlap: every edge of B ⊖ A as a way out; where they are apart: the one direction.
    pub ways: Vec<Way>,
    /// Whether B ⊖ A of the cores has interior points.
    pub solid: bool,
    /// Number of its edges.
    pub edges: usize,
}

/// The point of an edge nearest to the origin.
fn nearest(edge: &Edge) -> Point {
    let t = -edge.start.dot(edge.along);
    let whole = edge.along.dot(edge.along);
    if t.signum() <= 0 {
        edge.start
    } else if t >= whole {
        edge.start.plus(edge.along)
    } else {
        edge.start.plus(edge.along.times(t.over(whole)))
    }
}

/// Exact signed separation.
#[must_use]
pub fn separation(a: &Placed, b: &Placed) -> Exact {
    let difference = Difference::of(a, b);
    let radii = a.radius + b.radius;
    if difference.holds_origin() {
        return inside(&difference, radii);
    }
    let mut best = difference.vertex;
    let mut least = best.dot(best);
    for edge in &difference.edges {
        let point = nearest(edge);
        let square = point.dot(point);
        if square < least {
            (best, least) = (point, square);
        }
    }
    let core = least.sqrt();
    if difference.solid && core <= difference.size() * touching() {
        return inside(&difference, radii);
    }
    let apart = core > difference.size() * touching();
    let core = if apart { core } else { Real::ZERO };
    let normal = apart.then(|| best.times(core.recip()));
    let ways = match normal {
        Some(normal) => vec![Way { separation: core - radii, normal }],
        None => flat_ways(&difference, radii),
    };
    Exact {
        separation: core - radii,
        core,
        normal,
        ways,
        solid: difference.solid,
        edges: difference.edges.len(),
    }
}

/// The origin inside: each edge's line is a way out.
fn inside(difference: &Difference, radii: Real) -> Exact {
    let ways: Vec<Way> = difference
        .edges
        .iter()
        .map(|edge| {
            let length = edge.along.length();
            let normal = edge.along.perp().times(length.recip());
            Way { separation: edge.along.cross(edge.start).over(length) - radii, normal }
        })
        .collect();
    let best = ways.iter().max_by(|x, y| x.separation.cmp(&y.separation)).copied();
    let best = best.unwrap_or(Way { separation: -radii, normal: Point::ZERO });
    Exact {
        separation: best.separation,
        core: best.separation + radii,
        normal: Some(best.normal),
        ways,
        solid: true,
        edges: difference.edges.len(),
    }
}

/// Cores without interior that meet: a segment may be left to either side, a point to all.
fn flat_ways(difference: &Difference, radii: Real) -> Vec<Way> {
    let way = |edge: &Edge| Way { separation: -radii, normal: edge.along.perp().unit() };
    difference.edges.iter().map(way).collect()
}

/// The gap of the supports along a unit direction n, less the radii: at most the separation, whatever n is.
#[must_use]
pub fn gap_along(a: &Placed, b: &Placed, n: Point) -> Real {
    let far = a.core_points().map(|p| p.dot(n)).max().unwrap_or(Real::ZERO);
    let near = b.core_points().map(|p| p.dot(n)).min().unwrap_or(Real::ZERO);
    near - far - a.radius - b.radius
}
