//! The axis-aligned bounding box of a body, or of two together.
//!
//! Loop over all vertices keeping the smallest and largest coordinate on each axis, and add the radius. Two
//! boxes are joined by doing the same with their vertices:
//!
//! ```text
//! min = min pᵢ − r      max = max pᵢ + r      c = (min + max)/2      h = (max − min)/2
//! ```
//!
//! Any shape has one, an outline that is not convex too. Every number is rounded outward: the body lies in
//! [min, max] and in c ± h, whatever was rounded on the way: doubles with a bound find the vertices that may
//! be outermost, and those are placed again in double-doubles. Coordinates that need no rounding stay as they
//! are.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section AABB vs AABB, "Fun AABB facts".

use crate::collision::algorithm::{Algorithm, Stops};
use crate::collision::certified::rounding::{EXTREME_ERROR, TAME};
use crate::collision::{Answer, Bounds, Query, QueryKind};
use crate::geometry::{Ball, Body, DVec2, Pose, Rotation, Side, Turn, taming_power, two_sum};
use crate::trace::{Event, Moment, SupportVertex, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "extremes",
    about: "smallest and largest coordinates of the vertices, and their union (Firth 2011, AABB vs AABB)",
    kinds: &[QueryKind::Bounds],
    shapes,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Takes one body or two, of any shape.
#[expect(clippy::unnecessary_wraps, reason = "a predicate in the table of algorithms")]
fn shapes(_: &Query) -> Result<(), &'static str> {
    Ok(())
}

/// Answers a query for bounds.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    tracer.record(|| {
        let angle = |body: &Body| body.angle_at(query.time);
        let at = Moment { time: query.time, angle_a: angle(query.a), angle_b: query.b.map_or(0.0, angle) };
        Event::Started { algorithm: ALGORITHM.name, at }
    });
    let [min, max] = extremes(Side::A, query.a, query.time, tracer);
    let Some(b) = query.b else {
        return Answer::Bounds(centered(min, max));
    };
    let [min_b, max_b] = extremes(Side::B, b, query.time, tracer);
    let (min, max) = (min.min(min_b), max.max(max_b));
    tracer.record(|| Event::BoundsFound { of: None, min, max, touching: [const { Vec::new() }; 4] });
    Answer::Bounds(centered(min, max))
}

/// Smallest and largest coordinates of a body in the world, rounded outward, told as those of body `of`.
fn extremes(of: Side, body: &Body, t: f64, tracer: &mut impl Tracer) -> [DVec2; 2] {
    let placing = Placing::new(body, t);
    let vertices = &body.shape.vertices;
    // Left, bottom, right, top, each counted outward: −x, −y, x, y.
    let mut tops = [f64::NEG_INFINITY; 4];
    for &v in vertices {
        let reach = placing.rough(v);
        tops = std::array::from_fn(|direction| tops[direction].max(reach[direction]));
    }
    // Rounding may have kept any of these from the top.
    let may_touch = tops.map(|top| top - 2.0 * placing.error);
    let mut ends = [f64::NEG_INFINITY; 4];
    for &v in vertices {
        let reach = placing.rough(v);
        for direction in 0..4 {
            if reach[direction] >= may_touch[direction] {
                ends[direction] = ends[direction].max(placing.outermost(direction, v));
            }
        }
    }
    let ends = [DVec2::new(-ends[0], -ends[1]), DVec2::new(ends[2], ends[3])];
    tracer.record(|| {
        let touching = std::array::from_fn(|direction| {
            let touches = |v: &DVec2| placing.rough(*v)[direction] >= may_touch[direction];
            let places = vertices.iter().enumerate().filter(|(_, v)| touches(v));
            places.map(|(index, &v)| SupportVertex { index, point: placing.pose.point(v) }).collect()
        });
        Event::BoundsFound { of: Some(of), min: ends[0], max: ends[1], touching }
    });
    ends
}

/// Where a body is at a moment: in doubles with a bound, and in balls.
pub(crate) struct Placing {
    /// From the body's frame to the world, in doubles.
    pub(crate) pose: Pose,
    /// Bound on the error of a coordinate placed by `pose`, world units.
    pub(crate) error: f64,
    /// The body's origin in the world, in balls, times `unit`.
    position: [Ball; 2],
    /// From the body's frame to the world, in balls.
    rotation: Rotation<Ball>,
    /// The shape's radius, times `unit`.
    radius: f64,
    /// Power of two by which the balls are multiplied: 1 but for tiny scenes, whose products would underflow.
    unit: f64,
}

impl Placing {
    /// The body at time `t` in [0, 1].
    pub(crate) fn new(body: &Body, t: f64) -> Self {
        let moved = body.position.abs() + (body.velocity * t).abs();
        // An outline has no core to give its reach.
        let written = body.shape.vertices.iter().fold(0.0, |reach: f64, v| reach.max(v.x.abs() + v.y.abs()));
        let reach = written * body.shape.stretch();
        let size = moved.max_element() + reach + body.shape.radius;
        // With a matrix, cosine and sine are sums of two products themselves.
        let roundings = if body.shape.is_as_written() { 1.0 } else { 2.0 };
        let unit = if size < TAME.start { taming_power(size) } else { 1.0 };
        let position = |at: f64, speed: f64| Ball::new(at * unit) + Ball::product(speed * unit, t);
        Self {
            pose: body.pose_at(t),
            error: (moved.max_element() + reach) * EXTREME_ERROR * roundings + f64::MIN_POSITIVE,
            position: [
                position(body.position.x, body.velocity.x),
                position(body.position.y, body.velocity.y),
            ],
            rotation: rotation(body, t),
            radius: body.shape.radius * unit,
            unit,
        }
    }

    /// How far a vertex reaches to the left, bottom, right and top, in doubles, without the radius.
    #[inline]
    fn rough(&self, v: DVec2) -> [f64; 4] {
        let p = self.pose.point(v);
        [-p.x, -p.y, p.x, p.y]
    }

    /// How far a vertex reaches in one of these directions with the radius: not below the exact value.
    fn outermost(&self, direction: usize, v: DVec2) -> f64 {
        let (Rotation { cos, sin }, v) = (self.rotation, v * self.unit);
        let turned = if direction.is_multiple_of(2) {
            cos.scale(v.x) - sin.scale(v.y)
        } else {
            sin.scale(v.x) + cos.scale(v.y)
        };
        let place = self.position[direction % 2] + turned;
        let radius = Ball::new(self.radius);
        (if direction < 2 { radius - place } else { radius + place }).enclosure_scaled(1.0 / self.unit).hi
    }
}

/// From a vertex as written to the world's axes at time `t`: the shape's matrix, and then the turn.
#[inline]
fn rotation(body: &Body, t: f64) -> Rotation<Ball> {
    let turn = Turn::at(body.angle, body.spin, t).rotation_in_balls();
    if body.shape.is_as_written() {
        return turn;
    }
    let Rotation { cos, sin } = body.shape.matrix;
    let [cos, sin] = turn.apply([Ball::new(cos), Ball::new(sin)]);
    Rotation { cos, sin }
}

/// Not above x + y, and equal to it where that is a double.
fn sum_down(x: f64, y: f64) -> f64 {
    let (sum, error) = two_sum(x, y);
    if error < 0.0 { sum.next_down() } else { sum }
}

/// Centre and half-extents of [min, max], such that c ± h holds it.
fn centered(min: DVec2, max: DVec2) -> Bounds {
    let center = min * 0.5 + max * 0.5;
    let half = |lo: f64, hi: f64, c: f64| (-sum_down(-hi, c)).max(-sum_down(lo, -c));
    let half_extents = DVec2::new(half(min.x, max.x, center.x), half(min.y, max.y, center.y));
    Bounds { min, max, center, half_extents }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{TILT, boxed, placed, polygon};
    use crate::collision::{Answer, Bounds, QueryKind};
    use crate::trace::{NoTrace, Trace};

    fn ask(a: &Body, b: Option<&Body>, tracer: &mut impl Tracer) -> Bounds {
        let query = Query { kind: QueryKind::Bounds, a, b, time: 0.0, tolerance: 0.0, max_iterations: 1 };
        match answer(&query, tracer) {
            Answer::Bounds(b) => b,
            other => panic!("{other:?}"),
        }
    }

    fn v(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    #[test]
    fn one_vertex_of_figure_2_touches_each_side() {
        let outline = [
            [-5., 0.5],
            [-3., -1.],
            [-2., -3.],
            [0., -1.5],
            [3., -2.],
            [4., -0.5],
            [7., 1.],
            [4., 1.5],
            [3., 3.],
            [1., 1.],
            [-2., 2.],
            [-2., 0.5],
        ];
        let mut a = polygon(&outline, 0.0);
        a.shape.core.clear();
        let mut trace = Trace::default();
        let found = ask(&a, None, &mut trace);
        let expected =
            Bounds { min: v(-5., -3.), max: v(7., 3.), center: v(1., 0.), half_extents: v(6., 3.) };
        assert_eq!(found, expected);
        assert_eq!(found, ask(&a, None, &mut NoTrace));
        let Some(Event::BoundsFound { touching, .. }) = trace.events.last() else { panic!("{trace:?}") };
        assert_eq!(
            touching.each_ref().map(|t| t.iter().map(|v| v.index).collect::<Vec<_>>()),
            [[0], [2], [6], [8]]
        );
    }

    #[test]
    fn the_union_holds_both_and_the_radius_counts() {
        let a = placed(polygon(&[[0., 0.]], 1.5), -2., 0., 0.);
        let b = placed(boxed("box", 3., 1.5), 1., 2., TILT);
        let found = ask(&a, Some(&b), &mut NoTrace);
        // Half-extents of the tilted box: 3·0.8 + 1.5·0.6 = 3.3 and 3·0.6 + 1.5·0.8 = 3.
        assert!(
            (found.min - v(-3.5, -1.5)).length() < 1e-13 && (found.max - v(4.3, 5.)).length() < 1e-13,
            "{found:?}"
        );
        assert!(found.max.x >= 4.3 && found.max.y >= 5.0);
    }

    #[test]
    fn rounding_goes_outward() {
        let a = placed(polygon(&[[1.0, -1.0]], 0.1), 1e16, -1e16, 0.);
        let found = ask(&a, None, &mut NoTrace);
        assert!(found.max.x > 1e16 + 1.0 && found.min.y < -1e16 - 1.0);
        assert!(found.center.x + found.half_extents.x >= found.max.x);
    }
}
