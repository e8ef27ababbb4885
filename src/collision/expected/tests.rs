use super::*;
use crate::collision::tests::bodies::{boxed, moving, placed, polygon};
use crate::collision::{ALGORITHMS, QueryKind, closest_approach};
use crate::geometry::Angle;

/// How far off an expectation is from the separation of two bodies.
fn off(a: &Body, b: &Body, expected: Expected) -> Off {
    let kind = QueryKind::Separation;
    let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
    let answer = query.answer().unwrap();
    expected.off(&query, &answer, None).unwrap()
}

fn normal(x: f64, y: f64) -> Expected {
    Expected { normal: UnitVector::along(DVec2::new(x, y)), ..Expected::default() }
}

#[test]
fn any_points_of_what_parallel_edges_share_are_right() {
    let (a, b) = (boxed("box", 1.0, 1.0), placed(boxed("box", 1.0, 1.0), 3.0, 0.5, 0.0));
    let points = |y: f64, x: f64| Expected {
        points: Some([DVec2::new(1.0, y), DVec2::new(x, y)]),
        ..Expected::default()
    };
    assert_eq!(off(&a, &b, points(0.9, 2.0)).points, Some([0.0, 0.0]));
    assert_eq!(off(&a, &b, points(-0.5, 2.125)).points, Some([0.0, 0.125]));
    // Each may be one of ours, but they are not across from each other.
    let theirs =
        Expected { points: Some([DVec2::new(1.0, 0.75), DVec2::new(2.0, -0.25)]), ..Expected::default() };
    // Which of them is wrong nobody knows: the same where the pair is asked the other way round.
    assert_eq!(off(&a, &b, theirs).points, Some([0.5, 0.5]));
    let swapped = Expected { points: theirs.points.map(|[p, q]| [q, p]), ..theirs };
    assert_eq!(off(&b, &a, swapped).points, Some([0.5, 0.5]));
    // They share −0.5 to 1.
    assert_eq!(off(&a, &b, points(-0.75, 2.0)).points, Some([0.25, 0.25]));
    assert_eq!(off(&a, &b, points(1.5, 2.0)).points, Some([0.5, 0.5]));
}

#[test]
fn any_of_the_normals_that_tie_is_right_and_points_are_not_held_against_one() {
    let (a, b) = (boxed("box", 1.0, 1.0), boxed("box", 1.0, 1.0));
    for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        assert_eq!(off(&a, &b, normal(x, y)).normal_deg, Some(0.0));
    }
    assert!(off(&a, &b, normal(1.0, 1.0)).normal_deg.unwrap() > 40.0);
    // As far from the nearest one, whichever of them is ours.
    let nearly = off(&a, &b, normal(-1.0, 5.960_464_5e-8)).normal_deg.unwrap();
    assert!(nearly > 0.0 && nearly < 4e-6, "{nearly}");
    let points = Expected { points: Some([DVec2::X, DVec2::Y]), ..Expected::default() };
    assert_eq!(off(&a, &b, points).points, None);
}

#[test]
fn of_a_hit_the_contact_is_right_and_of_a_miss_any_time_as_near() {
    let told = |a: &Body, b: &Body, expected: Expected| {
        let kind = QueryKind::TimeOfImpact;
        let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 1e-9, max_iterations: 1_000 };
        let answer = query.answer().unwrap();
        expected.off(&query, &answer, closest_approach(&query, &answer).as_ref()).unwrap()
    };
    let still = boxed("box", 1.0, 1.0);
    let turning = Body {
        velocity: DVec2::new(-4.0, 0.0),
        spin: Angle::Degrees(90.0),
        ..placed(polygon(&[[0.0, 0.0]], 1.0), 4.0, 0.0, 0.0)
    };
    let at = |x: f64| Expected {
        separation: Some(0.0),
        time: Some(0.5),
        points: Some([DVec2::new(1.0, 0.0), DVec2::new(x, 0.0)]),
        ..Expected::default()
    };
    let off = told(&still, &turning, at(1.0));
    assert_eq!((off.separation, off.time, off.points), (Some(0.0), Some(0.0), Some([0.0, 0.0])));
    let by = told(&still, &turning, at(1.25)).points.unwrap()[1];
    assert!((by - 0.25).abs() < 1e-6, "{by}");
    // They rest: any moment is as near as another.
    let rest = placed(boxed("box", 1.0, 1.0), 3.0, 0.0, 0.0);
    for (time, off) in [(0.0, 0.0), (1.0, 0.0), (1.5, 1.5)] {
        let expected = Expected { time: Some(time), ..Expected::default() };
        assert_eq!(told(&still, &rest, expected).time, Some(off), "{time}");
    }
}

#[test]
fn the_time_of_a_hit_is_not_held_against_that_of_a_miss() {
    let a = moving(boxed("box", 1.0, 1.0), [10.0, 0.0], 0.0);
    for (y, ours) in [(0.0, Verdict::Hit), (4.0, Verdict::Miss)] {
        let b = placed(boxed("box", 1.0, 1.0), 6.0, y, 0.0);
        let kind = QueryKind::LinearSweep;
        let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let answer = query.answer().unwrap();
        let closest = closest_approach(&query, &answer);
        for theirs in [Verdict::Hit, Verdict::Miss] {
            let expected = Expected { outcome: Some(theirs), time: Some(0.9), ..Expected::default() };
            let off = expected.off(&query, &answer, closest.as_ref()).unwrap();
            assert_eq!(off.time.is_some(), theirs == ours, "{theirs:?}, {ours:?}");
        }
    }
}

#[test]
fn an_axis_without_an_upper_bound_is_no_agreement() {
    let (a, b) = (boxed("box", 1.0, 1.0), placed(boxed("box", 1.0, 1.0), 4.0, 4.0, 0.0));
    let kind = QueryKind::Separation;
    let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
    let axes = ALGORITHMS.iter().find(|algorithm| algorithm.name == "separating-axes").unwrap();
    let expected = Expected { separation: Some(900.0), ..Expected::default() };
    let by = expected.off(&query, &axes.ask(&query), None).unwrap().separation.unwrap();
    assert!((by - (900.0 - 8.0_f64.sqrt())).abs() < 1e-9, "{by}");
}

#[test]
fn an_outcome_is_held_against_ours_where_that_is_decided() {
    let told = |x: f64, kind: QueryKind, theirs: Verdict| {
        let (a, b) = (boxed("box", 1.0, 1.0), placed(boxed("box", 1.0, 1.0), x, 0.0, 0.0));
        let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let answer = query.answer().unwrap();
        let expected = Expected { outcome: Some(theirs), separation: Some(9.0), ..Expected::default() };
        expected.off(&query, &answer, None).unwrap()
    };
    for kind in [QueryKind::Overlap, QueryKind::Separation, QueryKind::Contact] {
        for (x, ours) in [(3.0, Verdict::Apart), (1.5, Verdict::Overlapping)] {
            let off = told(x, kind, Verdict::Apart);
            assert_eq!(off.outcome, Some([Verdict::Apart, ours]), "{kind:?}");
            let by = off.separation.unwrap() - (9.0 - (x - 2.0));
            assert!(by.abs() < 1e-14, "a verdict is held against the separation too: {kind:?} {by}");
        }
    }
    let still = told(3.0, QueryKind::LinearSweep, Verdict::Hit);
    assert_eq!(still.outcome, Some([Verdict::Hit, Verdict::Miss]));
    // They are apart by four units in the last place, which a verdict need not see, but never denies.
    let near = told(2.0 + 4.0 * f64::EPSILON, QueryKind::Separation, Verdict::Apart);
    assert!(near.outcome.is_none_or(|[_, ours]| ours == Verdict::Apart), "{near:?}");
}

#[test]
fn a_normal_is_off_by_its_angle_and_a_separation_by_what_is_beyond_the_bounds() {
    let (a, b) = (polygon(&[[0.0, 0.0]], 1.0), placed(polygon(&[[0.0, 0.0]], 1.0), 3.0, 4.0, 0.0));
    assert_eq!(
        off(&a, &b, normal(0.6 + f64::EPSILON, 0.8)).normal_deg,
        Some(0.0),
        "the same but for rounding"
    );
    let found = off(&a, &b, normal(0.8, 0.6)).normal_deg.unwrap();
    assert!((found - 16.260_204_708_311_957).abs() < 1e-12, "{found}");
    let separation =
        |s: f64| off(&a, &b, Expected { separation: Some(s), ..Expected::default() }).separation.unwrap();
    assert_eq!(separation(3.0), 0.0);
    assert!((separation(3.5) - 0.5).abs() < 1e-15 && (separation(2.75) + 0.25).abs() < 1e-15);
}
