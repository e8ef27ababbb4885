//! How far any point of a body can move: the arc of its extreme point.
//!
//! A body that turns by θ moves no point farther than the arc of the point farthest from its origin, at
//! distance r; a body that is carried along as well adds the length of that path; of two, relative to each
//! other, both turn:
//!
//! ```text
//! L = θ r          one body: ‖v‖ + θ r          two: ‖v_A − v_B‖ + θ_A r_A + θ_B r_B
//! ```
//!
//! for t in [0, 1]. A rounded body's farthest point is its radius beyond its farthest vertex. A body at rest
//! has 0 exactly; everything else is rounded up.
//!
//! Source: Brian Mirtich, "Impulse-based dynamic simulation of rigid body systems" (`PhD` thesis, Berkeley,
//! 1996), section 2.3.2; Paul Firth, "Collision detection for dummies" (2011), section Continuous
//! Angular/Linear, figure 8.

use crate::collision::algorithm::{Algorithm, Stops};
use crate::collision::{Answer, MotionBound, Query, QueryKind};
use crate::geometry::{Body, DVec2, Side, length};
use crate::trace::{Event, Moment, SupportVertex, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "arc",
    about: "the arc of the extreme point, L = theta r (Mirtich 1996, 2.3.2)",
    kinds: &[QueryKind::MotionBound],
    shapes,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// What a rounded sum is multiplied by so as not to be too small.
///
/// It has at most three terms, each of at most 6 roundings (a difference, a root of two squares, a sum,
/// π/180, two products): 9 ε of itself, and one for this product; rounded up to 12.
const ROUNDED_UP: f64 = 1.0 + 12.0 * f64::EPSILON;

/// Where terms underflow, each is off by less than one of the smallest steps of a double, and their sum by
/// less than four.
const UNDERFLOW: f64 = f64::from_bits(4);

/// Vertices whose distances differ by less than this part are all told as extreme points: a root of two
/// squares carries half as much.
const SAME_RADIUS: f64 = 1.0 - 4.0 * f64::EPSILON;

/// Takes one body or two, of any shape.
#[expect(clippy::unnecessary_wraps, reason = "a predicate in the table of algorithms")]
fn shapes(_: &Query) -> Result<(), &'static str> {
    Ok(())
}

/// Answers a query for a motion bound.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    tracer.record(|| {
        let angle_b = query.b.map_or(0.0, |b| b.angle_at(0.0));
        Event::Started {
            algorithm: ALGORITHM.name,
            at: Moment { time: 0.0, angle_a: query.a.angle_at(0.0), angle_b },
        }
    });
    let relative = query.a.velocity - query.b.map_or(DVec2::ZERO, |b| b.velocity);
    let linear = length(relative);
    let mut sum = linear + arc(Side::A, query.a, linear, tracer);
    if let Some(b) = query.b {
        sum += arc(Side::B, b, linear, tracer);
    }
    let bound = if is_at_rest(query, relative) { 0.0 } else { sum * ROUNDED_UP + UNDERFLOW };
    Answer::MotionBound(MotionBound { bound })
}

/// Whether no point moves: no (relative) velocity, and what turns is a point at its own origin.
fn is_at_rest(query: &Query, relative: DVec2) -> bool {
    let still = |body: &Body| {
        let point = body.shape.radius == 0.0 && body.shape.vertices.iter().all(|v| *v == DVec2::ZERO);
        body.spin.is_zero() || point
    };
    relative == DVec2::ZERO && still(query.a) && query.b.is_none_or(still)
}

/// θ r of one body in world units, told with the `linear` path that the bound adds to it.
#[inline]
fn arc(side: Side, body: &Body, linear: f64, tracer: &mut impl Tracer) -> f64 {
    let stretch = body.shape.stretch();
    let far = |v: &DVec2| length(*v);
    let reach = body.shape.vertices.iter().map(far).fold(0.0, f64::max);
    let radius = reach * stretch + body.shape.radius;
    let arc = body.spin.arc(radius);
    tracer.record(|| {
        let theta = body.spin.radians().abs();
        let pose = body.pose_at(0.0);
        let vertices = body.shape.vertices.iter().enumerate().filter(|(_, v)| far(v) >= reach * SAME_RADIUS);
        let vertices = vertices.map(|(index, &v)| SupportVertex { index, point: pose.point(v) }).collect();
        Event::MotionBounded { body: side, radius, theta, arc, linear, vertices }
    });
    arc
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, polygon};
    use crate::collision::{Answer, QueryKind};
    use crate::geometry::Angle;
    use crate::trace::{NoTrace, Trace};

    fn ask(a: &Body, b: Option<&Body>, tracer: &mut impl Tracer) -> f64 {
        let query =
            Query { kind: QueryKind::MotionBound, a, b, time: 0.0, tolerance: 0.0, max_iterations: 1 };
        match answer(&query, tracer) {
            Answer::MotionBound(m) => m.bound,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_box_of_figure_8_moves_no_farther_than_the_arc_of_its_vertex() {
        let mut a = boxed("box", 4., 0.9);
        a.spin = Angle::Degrees(60.0);
        let mut trace = Trace::default();
        let bound = ask(&a, None, &mut trace);
        // 4.1 π/3 to 25 digits: 4.29350995990605076…
        let exact = 4.293_509_959_906_051;
        assert!(bound >= exact && bound <= exact * (1.0 + 20.0 * f64::EPSILON), "{bound:e}");
        let Some(Event::MotionBounded { vertices, radius, .. }) = trace.events.last() else {
            panic!("{trace:?}")
        };
        assert_eq!((vertices.len(), *radius), (4, 4.1));
    }

    #[test]
    fn a_body_at_rest_does_not_move() {
        assert_eq!(ask(&boxed("box", 4., 0.9), None, &mut NoTrace), 0.0);
    }

    #[test]
    fn a_body_turning_about_a_point_of_itself_only_does_not_move() {
        let mut a = polygon(&[[0., 0.]], 0.0);
        a.spin = Angle::Degrees(360.0);
        assert_eq!(ask(&a, None, &mut NoTrace), 0.0);
    }

    #[test]
    fn a_bound_that_underflows_is_still_above_zero() {
        let mut a = polygon(&[[1e-200, 0.]], 0.0);
        a.spin = Angle::Degrees(1e-200);
        let bound = ask(&a, None, &mut NoTrace);
        assert!(bound > 0.0 && bound < 10.0 * UNDERFLOW, "{bound:e}");
        let mut b = polygon(&[[1e290, 0.]], 0.0);
        b.spin = Angle::Degrees(5e-324);
        // 4.94065645841246544e-324 π/180 1e290 to 20 digits.
        assert!(ask(&b, None, &mut NoTrace) >= 8.623_072_240_921_98e-36);
    }

    #[test]
    fn two_bodies_add_their_arcs_to_the_relative_path() {
        let mut a = polygon(&[[3., 0.]], 1.0);
        let mut b = polygon(&[[0., 2.]], 0.0);
        (a.spin, b.spin) = (Angle::Degrees(180.0), Angle::Degrees(-90.0));
        (a.velocity, b.velocity) = (DVec2::new(3., 0.), DVec2::new(0., 4.));
        let bound = ask(&a, Some(&b), &mut NoTrace);
        let exact = 5.0 + 5.0 * std::f64::consts::PI;
        assert!(bound >= exact && bound <= exact * (1.0 + 20.0 * f64::EPSILON));
    }

    #[test]
    fn vertices_that_rounding_tells_apart_are_not_both_extreme() {
        let told = |shorter: f64| {
            let mut a = polygon(&[[-4.0, 0.0], [0.0, -1.0], [shorter, 0.0]], 0.0);
            a.spin = Angle::Degrees(60.0);
            let mut trace = Trace::default();
            ask(&a, None, &mut trace);
            trace.events.iter().find_map(|event| match event {
                Event::MotionBounded { vertices, .. } => Some(vertices.len()),
                _ => None,
            })
        };
        assert_eq!(told(4.0 * (1.0 - 2.0 * f64::EPSILON)), Some(2));
        assert_eq!(told(4.0 * (1.0 - 16.0 * f64::EPSILON)), Some(1));
    }
}
