//! What must hold of the sweeps on pairs that nobody chose.

use crate::collision::tests::asking::impact as ask;
use crate::collision::tests::bodies::{Bodies, boxed, polygon};
use crate::collision::{Impact, Outcome};
use crate::geometry::{Angle, DVec2};

/// The last moment proved free, and the first with proved contact.
fn span(impact: &Impact) -> (f64, f64) {
    match impact.outcome {
        Outcome::Hit { time, .. } => (time.lo, time.hi),
        Outcome::Miss => (1.0, f64::INFINITY),
        Outcome::Overlapping { .. } => (0.0, 0.0),
        Outcome::Unresolved { free_until, .. } => (free_until, f64::INFINITY),
    }
}

#[test]
fn ray_clipping_never_passes_the_ray_cast() {
    let mut bodies = Bodies::new(5);
    for _ in 0..400 {
        let (a, b) = bodies.flying_pair(0.0);
        let (direct, clipped) = (ask("ray-cast", &a, &b, 0.0).0, ask("ray-clipping", &a, &b, 1e-9).0);
        assert!(
            span(&clipped).0 < span(&direct).1 || span(&direct).1 == 0.0,
            "{direct:?} {clipped:?} {a:?} {b:?}"
        );
        assert!(
            span(&direct).0 < span(&clipped).1 || span(&direct).1 == 0.0,
            "{direct:?} {clipped:?} {a:?} {b:?}"
        );
        assert!(!matches!(direct.outcome, Outcome::Unresolved { .. }), "{direct:?} {a:?} {b:?}");
    }
}

#[test]
fn the_swept_axis_agrees_with_the_ray_cast_where_nothing_turns() {
    let mut bodies = Bodies::new(6);
    for _ in 0..400 {
        let (a, b) = bodies.flying_pair(0.0);
        let (direct, swept) = (ask("ray-cast", &a, &b, 0.0).0, ask("swept-axis", &a, &b, 1e-12).0);
        assert_eq!(direct.outcome.word(), swept.outcome.word(), "{a:?} {b:?}");
        let ((lo, hi), (from, to)) = (span(&direct), span(&swept));
        assert!(lo <= to && from <= hi, "{direct:?} {swept:?} {a:?} {b:?}");
    }
}

#[test]
fn conservative_advancement_never_passes_the_swept_axis() {
    let mut bodies = Bodies::new(7);
    for _ in 0..300 {
        let (a, b) = bodies.flying_pair(400.0);
        let swept = ask("swept-axis", &a, &b, 1e-12).0;
        let advanced = ask("conservative-advancement", &a, &b, 1e-6).0;
        let ((lo, hi), (from, to)) = (span(&swept), span(&advanced));
        assert!((from < hi || hi == 0.0) && (lo < to || to == 0.0), "{swept:?} {advanced:?} {a:?} {b:?}");
        assert!(!matches!(swept.outcome, Outcome::Unresolved { .. }), "{swept:?} {a:?} {b:?}");
        if matches!(advanced.outcome, Outcome::Miss) {
            assert_eq!(swept.outcome, Outcome::Miss, "{a:?} {b:?}");
        }
    }
}

#[test]
fn swapping_the_bodies_keeps_the_time() {
    let mut bodies = Bodies::new(8);
    for _ in 0..300 {
        let (a, b) = bodies.flying_pair(400.0);
        let (there, back) = (ask("swept-axis", &a, &b, 1e-12).0, ask("swept-axis", &b, &a, 1e-12).0);
        assert_eq!(there.outcome.word(), back.outcome.word());
        let ((lo, hi), (from, to)) = (span(&there), span(&back));
        assert!(lo <= to && from <= hi, "{there:?} {back:?}");
        if let (Outcome::Hit { contact: x, .. }, Outcome::Hit { contact: y, .. }) =
            (there.outcome, back.outcome)
        {
            assert!((*x.normal + *y.normal).length() < 1e-6, "{x:?} {y:?}");
        }
    }
}

/// A miss was "proved" of a segment that spins past a box beside it, by 1e138 degrees and more; a scene of
/// them is refused.
#[test]
fn of_bodies_that_turn_beyond_all_products_nothing_is_told() {
    for spin in [-1e120, -1e138, -1e141, 3e200] {
        let mut a = polygon(&[[0.0, 3.3125], [0.0, 0.0]], 0.0);
        a.position = DVec2::new(6.0625, -0.01);
        a.spin = Angle::Degrees(spin);
        let mut b = boxed("aabb", 5.625, 3.3125);
        b.position = DVec2::new(0.0, -0.625);
        for (a, b) in [(&a, &b), (&b, &a)] {
            let found = ask("swept-axis", a, b, 1e-12).0;
            assert!(matches!(found.outcome, Outcome::Unresolved { .. }), "{spin}: {found:?}");
            // In a whole turn it hits.
            let stepped = ask("conservative-advancement", a, b, 1e-12).0;
            assert_ne!(stepped.outcome, Outcome::Miss, "{spin}");
        }
    }
}

/// A corner passes a corner by 1e-16 or less, long before the bodies meet for good: axes alone proved no
/// contact but the later one.
#[test]
fn a_graze_is_as_narrow_by_axes_as_by_the_ray() {
    let at = |vertices: &[[f64; 2]], x: f64, y: f64, velocity: [f64; 2]| {
        let mut body = polygon(vertices, 0.0);
        (body.position, body.velocity) = (DVec2::new(x, y), DVec2::from_array(velocity));
        body
    };
    let pairs = [
        (
            at(&[[1.0, 0.7], [-1.0, 1.1], [-1.0, -0.1]], 3.0, 1.5, [0.0, 0.0]),
            at(&[[0.0, 0.0], [-0.24, 0.72], [-0.24, -0.72]], 2.0, 1.4, [0.0, 2.9]),
        ),
        (
            at(&[[-2.0, -2.0], [3.0, -1.0], [2.4, -1.0]], -3.0, -5.0, [0.0, 0.0]),
            at(&[[2.7, -1.3], [-2.3, -2.3], [1.2, -6.8]], -7.7, -5.7, [10.0, 2.0]),
        ),
    ];
    for (a, b) in &pairs {
        for (a, b) in [(a, b), (b, a)] {
            let [(lo, hi), (from, to)] =
                ["ray-cast", "swept-axis"].map(|name| span(&ask(name, a, b, 1e-12).0));
            assert!(hi.is_finite() && to - from < 1e-15, "[{lo}, {hi}] [{from}, {to}]");
            assert!(from <= hi && lo <= to, "[{lo}, {hi}] [{from}, {to}]");
        }
    }
}

/// Vertices 1e-16 and less apart at t = 0, of which bodies that turn make an end at once, by parting or by
/// meeting.
#[test]
fn a_turning_pair_that_starts_a_rounding_apart_is_decided() {
    let corner = [[0.0, 0.0], [0.96, 7.0], [-7.04, -0.6]];
    let mut meeting = [polygon(&corner, 0.0), polygon(&[[1.4, -2.0], [2.0, 1.5], [-2.0, -2.3]], 0.0)];
    (meeting[0].position, meeting[0].spin) = (DVec2::new(0.4, 0.2), Angle::Degrees(-30.0));
    (meeting[1].position, meeting[1].spin) = (DVec2::new(-1.6, -1.3), Angle::Degrees(45.0));
    meeting[1].velocity = DVec2::new(0.0, -0.7);
    let mut parting = [boxed("box", 0.3, 2.3), boxed("box", 2.2, 2.8)];
    (parting[0].position, parting[0].spin) = (DVec2::new(3.0, -3.8), Angle::Degrees(90.0));
    (parting[1].position, parting[1].velocity) = (DVec2::new(0.5, 1.3), DVec2::new(-2.0, 1.0));
    parting[1].angle = Angle::Degrees(180.0);
    for ([a, b], word) in [(&meeting, "hit"), (&parting, "miss")] {
        for (a, b) in [(a, b), (b, a)] {
            let found = ask("swept-axis", a, b, 1e-12).0;
            assert_eq!(found.outcome.word(), word, "{found:?}");
            let (lo, hi) = span(&found);
            assert!(word == "miss" || (lo < 1e-15 && hi < 1e-13), "{found:?}");
        }
    }
}
