//! The axis-aligned bounding box of a body, or of two together.
//!
//! Loop over all vertices keeping the smallest and largest coordinate on each axis, and add the radius. Two boxes are
//! joined by doing the same with their corners:
//!
//! ```text
//! min = min pᵢ − r      max = max pᵢ + r      c = (min + max)/2      h = (max − min)/2
//! ```
//!
//! Any shape has one, an outline that is not convex too. Every number is rounded outward: the body lies in [min, max]
//! and in c ± h, whatever was rounded on the way; coordinates that need no rounding stay as they are.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section AABB vs AABB, "Fun AABB facts".

use super::{Answer, Bounds, Query};
use crate::geometry::{Body, DVec2, Pose, Side};
use crate::trace::{Event, Moment, SupportVertex, Tracer};

/// Its word in a scene file.
pub(crate) const NAME: &str = "extremes";

/// Half-width of a placed coordinate's bounds as a multiple of ε and of the sum of the magnitudes that make it:
/// position, velocity · t, and two products with cos and sin, each of those within 2 ulp.
const PLACING: f64 = 8.0 * f64::EPSILON;

/// One body or two, of any shape.
#[expect(clippy::unnecessary_wraps, reason = "a predicate in the table of algorithms")]
pub(crate) fn shapes(_: &Query) -> Result<(), &'static str> {
    Ok(())
}

/// Answers a query for bounds.
pub(crate) fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    tracer.record(|| {
        let angle = |body: &Body| body.angle_at(query.time);
        let at = Moment { time: query.time, angle_a: angle(query.a), angle_b: query.b.map_or(0.0, angle) };
        Event::Started { algorithm: NAME, at }
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

/// Smallest and largest coordinates of a body, rounded outward.
fn extremes(of: Side, body: &Body, t: f64, tracer: &mut impl Tracer) -> [DVec2; 2] {
    let pose = body.pose_at(t);
    let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    // What the outermost vertices reach for certain: whoever may reach that far touches.
    let mut inner = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    for &v in &body.shape.vertices {
        let [lo, hi] = place(body, &pose, t, v);
        (min, max) = (min.min(lo), max.max(hi));
        inner = [inner[0].min(hi), inner[1].max(lo)];
    }
    let radius = body.shape.radius;
    let corners = [
        DVec2::new(sum_down(min.x, -radius), sum_down(min.y, -radius)),
        DVec2::new(-sum_down(-max.x, -radius), -sum_down(-max.y, -radius)),
    ];
    tracer.record(|| {
        let touching = |reaches: &dyn Fn([DVec2; 2]) -> bool| {
            let places = body.shape.vertices.iter().enumerate();
            let reaching = places.filter(|&(_, &v)| reaches(place(body, &pose, t, v)));
            reaching.map(|(index, &v)| SupportVertex { index, point: pose.point(v) }).collect()
        };
        let touching = [
            touching(&|[lo, _]| lo.x <= inner[0].x),
            touching(&|[lo, _]| lo.y <= inner[0].y),
            touching(&|[_, hi]| hi.x >= inner[1].x),
            touching(&|[_, hi]| hi.y >= inner[1].y),
        ];
        Event::BoundsFound { of: Some(of), min: corners[0], max: corners[1], touching }
    });
    corners
}

/// Bounds of a vertex in the world.
fn place(body: &Body, pose: &Pose, t: f64, v: DVec2) -> [DVec2; 2] {
    let upright = pose.sin == 0.0 && pose.cos == 1.0;
    if upright && (t == 0.0 || body.velocity == DVec2::ZERO) {
        let lo = DVec2::new(sum_down(body.position.x, v.x), sum_down(body.position.y, v.y));
        let hi = DVec2::new(-sum_down(-body.position.x, -v.x), -sum_down(-body.position.y, -v.y));
        return [lo, hi];
    }
    let p = pose.point(v);
    let moved = body.position.abs() + (body.velocity * t).abs();
    let slack = (moved + DVec2::splat(v.x.abs() + v.y.abs())) * PLACING;
    let [lo, hi] = [p - slack, p + slack];
    [DVec2::new(lo.x.next_down(), lo.y.next_down()), DVec2::new(hi.x.next_up(), hi.y.next_up())]
}

/// x + y, rounded down unless it is exact.
fn sum_down(x: f64, y: f64) -> f64 {
    let sum = x + y;
    let part = sum - x;
    let error = (x - (sum - part)) + (y - part);
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
    use super::super::storyboard::{TILT, boxed, placed, polygon};
    use super::super::{Answer, Bounds, QueryKind};
    use super::*;
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
