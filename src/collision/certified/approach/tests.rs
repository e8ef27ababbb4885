//! What must hold of a closest approach: on pairs that nobody chose, and on hard ones. `tests/exact.rs` holds
//! it to 320 bits.

use super::*;
use crate::collision::answer::Outcome;
use crate::collision::certified::distance::Pair;
use crate::collision::tests::bodies::{Bodies, boxed, moving, placed, polygon};
use crate::geometry::Angle;

/// The closest approach of a pair that misses; None for another.
fn of_miss(a: &Body, b: &Body) -> Option<ClosestApproach> {
    let missed = MovingPair::new(a, b).first_contact(1e-12, 10_000).outcome == Outcome::Miss;
    missed.then(|| closest_approach(a, b))
}

/// The closest approach of a pair that is known to miss.
fn closest(a: &Body, b: &Body) -> ClosestApproach {
    of_miss(a, b).expect("a miss")
}

/// The least separation at 400 moments.
fn least_of_many(a: &Body, b: &Body) -> f64 {
    let at = |k: u32| Pair::at(a, b, f64::from(k) / 400.0).separation().bounds.hi;
    (0..=400).map(at).fold(f64::INFINITY, f64::min)
}

/// The width of the bounds in parts of the pair's size.
fn width(a: &Body, b: &Body, found: &ClosestApproach) -> f64 {
    (found.bounds.hi - found.bounds.lo) / MovingPair::new(a, b).size()
}

#[test]
fn bodies_that_are_closest_at_the_start_are_so_at_0_and_not_a_step_of_the_search_later() {
    let turning = moving(polygon(&[[0.0, 0.0], [2.0, 0.0]], 0.2), [0.0, 0.0], 700.0);
    let wall = placed(boxed("box", 0.2, 2.0), 2.5, 0.0, 0.0);
    let found = closest(&turning, &wall);
    assert_eq!(found.time, 0.0, "{found:?}");
    assert!(found.bounds.lo <= 0.1 && found.bounds.hi >= 0.1 - 1e-15, "{found:?}");
}

#[test]
fn bodies_that_do_not_turn_are_nowhere_closer_and_bounds_are_a_few_roundings_apart() {
    let mut bodies = Bodies::new(31);
    let mut misses = 0;
    for _ in 0..2_000 {
        let (a, b) = bodies.flying_pair(0.0);
        let Some(found) = of_miss(&a, &b) else { continue };
        misses += 1;
        assert!(found.bounds.lo <= least_of_many(&a, &b), "{a:?} {b:?} {found:?}");
        assert!(width(&a, &b, &found) <= 4.0 * f64::EPSILON, "{a:?} {b:?} {found:?}");
        let then = Pair::at(&a, &b, found.time).separation();
        assert!(found.bounds.lo <= then.bounds.hi && then.bounds.lo <= found.bounds.hi, "{then:?} {found:?}");
    }
    assert!(misses > 300, "{misses}");
}

#[test]
fn bodies_that_turn_are_nowhere_closer_than_proved_and_hardly_than_found() {
    let mut bodies = Bodies::new(37);
    let (mut misses, mut narrow) = (0, 0);
    for k in 0..1_200 {
        let (a, b) = bodies.flying_pair(if k % 4 == 0 { 3_600.0 } else { 500.0 });
        let Some(found) = of_miss(&a, &b) else { continue };
        misses += 1;
        let least = least_of_many(&a, &b);
        assert!(found.bounds.lo <= least && 0.0 < found.bounds.lo, "{a:?} {b:?} {found:?} {least}");
        assert!(found.bounds.hi <= least + 1e-12, "{a:?} {b:?} {found:?} {least}");
        narrow += i32::from(width(&a, &b, &found) <= 1e-10);
    }
    assert!(misses > 150 && narrow == misses, "{narrow} of {misses}");
}

#[test]
fn the_closest_moment_may_be_the_start_the_end_or_the_first_of_many() {
    let square = boxed("box", 1.0, 1.0);
    let from = |x, y, velocity| moving(placed(square.clone(), x, y, 0.0), velocity, 0.0);
    let still = from(0.0, 0.0, [0.0, 0.0]);
    let cases = [
        ("parting", from(3.0, 0.5, [1.0, 0.0]), 0.0, 1.0),
        ("closing in", from(4.0, 0.5, [-1.0, 0.0]), 1.0, 1.0),
        ("at rest", from(3.0, 0.5, [0.0, 0.0]), 0.0, 1.0),
        ("along a face", from(2.5, 0.5, [0.0, 0.25]), 0.0, 0.5),
        ("over it from afar", from(-6.0, 3.0, [16.0, 0.0]), 0.25, 1.0),
        ("over it to the end", from(-6.0, 3.0, [8.0, 0.0]), 0.5, 1.0),
        ("past a vertex", from(4.0, 2.0, [-2.0, 2.0]), 0.5, 2f64.sqrt()),
    ];
    for (name, other, time, separation) in cases {
        let found = closest(&still, &other);
        assert!((found.time - time).abs() < 1e-15, "{name}: {found:?}");
        assert!((found.contact.separation - separation).abs() < 1e-15, "{name}: {found:?}");
        assert!(found.bounds.hi - found.bounds.lo < 1e-15, "{name}: {found:?}");
    }
}

#[test]
fn a_graze_by_a_billionth_is_told_to_its_last_digits() {
    for turned in [0.0, 10.0, 30.0, 45.0] {
        let a = moving(placed(boxed("box", 0.5, 1.0), -4.0, 0.0, turned), [8.0, 0.0], 0.0);
        let top = a.shape.vertices.iter().map(|&v| a.pose_at(0.0).point(v).y).fold(0.0, f64::max);
        let b = placed(polygon(&[[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0]], 0.0), 0.0, top + 1e-9, 0.0);
        let found = closest(&a, &b);
        assert!((found.contact.separation - 1e-9).abs() < 1e-15, "{found:?}");
        assert!(found.bounds.hi - found.bounds.lo < 4.0 * f64::EPSILON, "{found:?}");
    }
}

#[test]
fn discs_that_turn_side_by_side_keep_their_distance() {
    // Carried round their origins alike, they are as far apart at all times: each axis of the world lasts for
    // the root of the margin, one that turns with them for ever.
    let disc = |x: f64| polygon(&[[x, 0.0]], 0.5);
    let (a, b) = (moving(disc(1.0), [0.0, 0.0], 720.0), moving(disc(3.0), [0.0, 0.0], 720.0));
    let found = closest(&a, &b);
    assert!((found.contact.separation - 1.0).abs() < 1e-14, "{found:?}");
    assert!(found.bounds.lo > 1.0 - 1e-9, "{found:?}");
    // About the other's middle: the axis is fixed in the body that turns faster.
    let (a, b) = (polygon(&[[0.0, 0.0], [0.0, 0.1]], 0.5), moving(disc(3.0), [0.0, 0.0], 720.0));
    let found = closest(&a, &b);
    assert!((found.contact.separation - 1.9).abs() < 1e-9 && found.bounds.lo > 1.9 - 1e-8, "{found:?}");
}

#[test]
fn turns_without_end_leave_a_bound_that_holds_and_cost_what_they_may() {
    // Two bars that mesh like gears, in reach of each other at every turn.
    let a = moving(boxed("box", 1.0, 0.05), [0.0, 0.0], 1e7);
    let b = moving(placed(boxed("box", 1.0, 0.05), 2.2, 0.0, 90.0), [0.0, 0.0], 1e7);
    let found = closest_approach(&a, &b);
    assert!(found.bounds.lo >= 0.0 && found.bounds.lo <= found.contact.separation, "{found:?}");
    assert!(found.contact.separation < 1.2, "{found:?}");
}

/// Four looks at a motion found the nearest of none of the turns, and the bound was 0 of 335.
#[test]
fn bodies_far_apart_that_turn_fast_have_a_bound_of_their_reach_and_the_nearest_of_their_turns() {
    let a =
        [[0.532_969, 0.846_135], [-0.506_671, 0.862_140], [-0.721_789, 0.692_114], [-0.808_910, 0.587_933]];
    let b =
        [[0.792_640, 0.609_690], [0.445_818, 0.895_124], [-0.085_376, 0.996_349], [0.884_628, -0.466_296]];
    let turning = |body: Body, rad: f64| Body { spin: Angle::Radians(rad), ..body };
    for far in [300.0, 2e5, 2e8] {
        let a = turning(moving(polygon(&a, 0.0), [-66.0, -277.0], 0.0), -81.3);
        let b = placed(polygon(&b, 0.0), far, -2.8, 0.0);
        let b = turning(moving(b, [-67.0, -277.5], 0.0), -46.0);
        let found = closest(&a, &b);
        let at = |k: u32| Pair::at(&a, &b, f64::from(k) / 20_000.0).separation().separation;
        let least = (0..=20_000).map(at).fold(f64::INFINITY, f64::min);
        assert!(found.contact.separation <= least + 1e-15 * far, "{far}: {found:?}, {least}");
        assert!(found.bounds.lo <= least && found.bounds.lo > far - 4.0, "{far}: {found:?}, {least}");
    }
}

/// Beside a wall, which does not turn, the circle of what does is enough.
#[test]
fn a_wheel_that_spins_beside_a_long_wall_is_as_far_as_its_circle() {
    let wall = placed(boxed("box", 500.0, 1.0), 300.0, 0.0, 0.0);
    let wheel = moving(placed(boxed("box", 1.0, 0.5), 0.0, 40.0, 0.0), [3.0, 0.0], 1e8);
    let found = closest(&wheel, &wall);
    let circle = 39.0 - 1.25_f64.sqrt();
    assert!((found.bounds.lo - circle).abs() < 1e-6, "{found:?}");
    assert!(found.contact.separation < circle + 1e-3, "{found:?}");
}

#[test]
fn whoever_is_asked_first_the_bounds_overlap() {
    let mut bodies = Bodies::new(41);
    for k in 0..600 {
        let (a, b) = bodies.flying_pair(if k % 2 == 0 { 0.0 } else { 400.0 });
        let Some(found) = of_miss(&a, &b) else { continue };
        let swapped = closest(&b, &a);
        assert!(found.bounds.lo <= swapped.bounds.hi && swapped.bounds.lo <= found.bounds.hi, "{found:?}");
        assert!(
            (found.contact.separation - swapped.contact.separation).abs() < 1e-9,
            "{found:?} {swapped:?}"
        );
    }
}

#[test]
fn scenes_of_any_scale_have_a_closest_approach() {
    for exponent in [-300, -200, -60, 60, 200, 290] {
        let unit = libm::ldexp(1.0, exponent * 3);
        let unit = if unit.is_finite() && unit > 0.0 { unit } else { libm::ldexp(1.0, exponent) };
        let square = boxed("box", unit, unit);
        let a = moving(square.clone(), [8.0 * unit, 0.0], 0.0);
        let b = placed(square.clone(), 4.0 * unit, 3.0 * unit, 0.0);
        let found = closest(&a, &b);
        assert!((found.contact.separation / unit - 1.0).abs() < 1e-15, "2^{exponent}: {found:?}");
        assert!((found.bounds.lo / unit - 1.0).abs() < 1e-14, "2^{exponent}: {found:?}");
        let turning = moving(square, [8.0 * unit, 0.0], 45.0);
        let found = closest(&turning, &b);
        assert!(found.bounds.lo / unit > 0.5, "2^{exponent}: {found:?}");
        assert!((found.bounds.hi - found.bounds.lo) / unit < 1e-9, "2^{exponent}: {found:?}");
    }
}
