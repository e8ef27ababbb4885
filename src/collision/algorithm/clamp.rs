//! Circle against box, by clamping, in the box's own frame.
//!
//! Seen from its own frame an oriented box is an AABB. With V from the box's centre to the circle's and h the
//! half-extents,
//!
//! ```text
//! B_c = clamp(V, −h, h)      D = B − B_c      distance = ‖D‖ − r
//! ```
//!
//! `B_c` is the point of the box closest to the circle; taken back into the world it gives D there. The
//! article stops where the circle's centre is outside the box. Inside, clamping changes nothing and D would
//! be 0: `B_c` is then the nearest point of the nearest edge, and the distance is −‖D‖ − r. On an edge or
//! vertex exactly, D is 0 and the normal is that of an edge.
//!
//! Either body may be the box; a rounded box adds its radius to r.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), sections Circle vs AABB and Circle vs OBB.

use crate::collision::algorithm::candidate::{self, Candidate, CoreFeature};
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops};
use crate::collision::{Answer, Query};
use crate::geometry::{Body, DVec2, Side, length};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "clamp",
    about: "circle against box: V clamped in the box's frame (Firth 2011, Circle vs AABB, Circle vs OBB)",
    kinds: DISCRETE,
    shapes,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Takes a circle and a box or AABB, in either order.
fn shapes(query: &Query) -> Result<(), &'static str> {
    let circle = |body: &Body| body.shape.core.len() == 1;
    let boxed = |body: &Body| body.shape.half_extents.is_some() && body.shape.core.len() == 4;
    // A circle's centre is the origin of its frame, which no matrix moves.
    let multiplied = |body: &Body| boxed(body) && !body.shape.is_as_written();
    match query.b {
        Some(b) if multiplied(query.a) || multiplied(b) => Err(
            "clamps in a box's own frame, in which lengths are the world's: takes the box with `angle_deg` \
             or `angle_rad`, without `rotation`",
        ),
        Some(b) if (circle(query.a) && boxed(b)) || (boxed(query.a) && circle(b)) => Ok(()),
        _ => Err("takes a circle and a box or aabb"),
    }
}

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    outline::tell(&pair, tracer);
    let body = if pair.count(Side::A) == 4 { Side::A } else { Side::B };
    // The box's own frame: that of A, or of the same pair with its bodies swapped.
    let seen = if body == Side::A { pair } else { PairView::at(pair.b, pair.a, query.time) };
    let half = seen.vertex(Side::A, 2);
    let v = seen.vertex(Side::B, 0);
    let clamped = v.clamp(-half, half);
    let found = if v == clamped { inside(v, half) } else { outside(v, clamped) };
    let closest = v - found.normal * found.distance;
    tracer.record(|| Event::Clamped {
        body,
        v,
        half_extents: half,
        clamped,
        closest: seen.world_point(if v == clamped { closest } else { clamped }),
        d: seen.world_vector(found.normal * found.distance),
        radius: pair.radius(),
    });
    let found = if body == Side::A { found } else { found.swapped(&seen, &pair) };
    let separation = candidate::conclude(&pair, &found, tracer);
    candidate::finish(query.kind, separation, tracer)
}

/// The candidate of a centre outside: V was cut in x or in y (an edge faces the circle), or in both (a vertex
/// does).
fn outside(v: DVec2, clamped: DVec2) -> Candidate {
    let d = v - clamped;
    let distance = length(d);
    let facing = if d.x != 0.0 && d.y != 0.0 { CoreFeature::box_vertex(d) } else { CoreFeature::box_edge(d) };
    Candidate { distance, normal: d / distance, features: [facing, CoreFeature::Vertex(0)] }
}

/// The candidate of a centre inside or on the boundary: the nearest edge, a vertical one of two as near.
fn inside(v: DVec2, half: DVec2) -> Candidate {
    let depth = half - v.abs();
    let (distance, normal) = if depth.x <= depth.y {
        (-depth.x, if v.x >= 0.0 { DVec2::X } else { DVec2::NEG_X })
    } else {
        (-depth.y, if v.y >= 0.0 { DVec2::Y } else { DVec2::NEG_Y })
    };
    Candidate { distance, normal, features: [CoreFeature::box_edge(normal), CoreFeature::Vertex(0)] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed, polygon};
    use crate::collision::{Answer, QueryKind};
    use crate::trace::Trace;

    fn clamp(a: &Body, b: &Body) -> (f64, DVec2, Event) {
        let kind = QueryKind::Separation;
        let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let mut trace = Trace::default();
        let Answer::Separation(s) = answer(&query, &mut trace) else { panic!("{trace:?}") };
        let clamped = trace.events.into_iter().find(|e| matches!(e, Event::Clamped { .. }));
        (s.separation, *s.normal, clamped.unwrap())
    }

    #[test]
    fn a_centre_inside_leaves_by_the_nearest_edge() {
        let a = boxed("box", 4., 2.);
        let b = placed(polygon(&[[0., 0.]], 0.5), 1., -1.5, 0.);
        let (s, n, event) = clamp(&a, &b);
        assert_eq!((s, n), (-1.0, DVec2::NEG_Y));
        let Event::Clamped { closest, d, v, clamped, .. } = event else { panic!("{event:?}") };
        assert_eq!((closest, d, v == clamped), (DVec2::new(1., -2.), DVec2::new(0., 0.5), true));
    }

    #[test]
    fn either_body_may_be_the_box() {
        let a = placed(polygon(&[[0., 0.]], 0.5), 6., 0., 0.);
        let (s, n, event) = clamp(&a, &boxed("aabb", 4., 2.));
        assert_eq!((s, n), (1.5, DVec2::NEG_X));
        assert!(matches!(event, Event::Clamped { body: Side::B, .. }));
    }

    #[test]
    fn a_rounded_box_adds_its_radius() {
        let mut a = boxed("box", 4., 2.);
        a.shape.radius = 0.25;
        let (s, _, event) = clamp(&a, &placed(polygon(&[[0., 0.]], 0.5), 6., 0., 0.));
        assert_eq!(s, 1.25);
        assert!(matches!(event, Event::Clamped { radius: 0.75, .. }));
    }
}
