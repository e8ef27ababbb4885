//! Pairs that have no obvious answer (coincident centres, points, segments, touching bodies) have a defined
//! one, the same from every algorithm.

#![expect(clippy::panic, reason = "a test fails by panicking")]

use crate::asking::{of_kind, query, takers};
use tracefig::collision::{Answer, QueryKind, Separation};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2, Shape};
use tracefig::trace::NoTrace;

fn at(shape: Shape, x: f64, y: f64) -> Body {
    Body {
        shape,
        position: DVec2::new(x, y),
        angle: Angle::Degrees(0.0),
        velocity: DVec2::ZERO,
        spin: Angle::Degrees(0.0),
    }
}

fn circle(radius: f64) -> Shape {
    of_kind("circle", &[("radius", FieldValue::Number(radius))])
}

fn point() -> Shape {
    circle(0.0)
}

fn square(kind: &str, half: f64) -> Shape {
    of_kind(kind, &[("half_extents", FieldValue::Point(DVec2::splat(half)))])
}

/// From (−1, 0) to (1, 0).
fn segment(radius: f64) -> Shape {
    let ends = vec![DVec2::NEG_X, DVec2::X];
    of_kind("capsule", &[("points", FieldValue::Points(ends)), ("radius", FieldValue::Number(radius))])
}

/// What every algorithm that takes the pair must answer.
struct Expected {
    separation: f64,
    ties: u32,
    /// One of these.
    normals: &'static [DVec2],
}

const AXES: &[DVec2] = &[DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];
const UPRIGHT: &[DVec2] = &[DVec2::Y, DVec2::NEG_Y];

#[track_caller]
fn check(a: &Body, b: &Body, expected: &Expected) {
    let asked = query(QueryKind::Separation, a, b);
    let found: Vec<(&str, Separation)> = takers(&asked)
        .into_iter()
        .map(|x| match (x.quiet)(&asked, &mut NoTrace) {
            Answer::Separation(s) => (x.name, s),
            other => panic!("{}: {other:?}", x.name),
        })
        .collect();
    assert!(found.len() >= 5);
    for (name, s) in &found {
        assert_eq!(s.separation, expected.separation, "{name}: {s:?}");
        assert!(s.bounds.lo <= s.separation && s.separation <= s.bounds.hi, "{name}: {s:?}");
        // An ulp to both sides; a 0 is exact.
        let width = s.bounds.hi - s.bounds.lo;
        assert!(width <= 2.0 * f64::EPSILON * expected.separation.abs(), "{name}: {s:?}");
        assert_eq!(s.ties, expected.ties, "{name}: {s:?}");
        assert!(expected.normals.contains(&s.normal), "{name}: {s:?}");
        assert_eq!(s.points[1] - s.points[0], s.normal * s.separation, "{name}: {s:?}");
    }
    for algorithm in takers(&query(QueryKind::Overlap, a, b)) {
        let Answer::Overlap(o) = (algorithm.quiet)(&query(QueryKind::Overlap, a, b), &mut NoTrace) else {
            panic!("{}", algorithm.name)
        };
        assert_eq!(o.overlap, Some(expected.separation <= 0.0), "{}: {o:?}", algorithm.name);
    }
}

#[test]
fn concentric_circles_tie_in_all_directions_and_take_the_x_axis() {
    let expected = Expected { separation: -5.0, ties: 0, normals: &[DVec2::X] };
    check(&at(circle(2.0), 1.0, 1.0), &at(circle(3.0), 1.0, 1.0), &expected);
}

#[test]
fn coincident_points_touch() {
    let expected = Expected { separation: 0.0, ties: 0, normals: &[DVec2::X] };
    check(&at(point(), 4.0, -1.0), &at(point(), 4.0, -1.0), &expected);
}

#[test]
fn circles_that_touch_are_not_apart() {
    let expected = Expected { separation: 0.0, ties: 1, normals: &[DVec2::X] };
    check(&at(circle(2.0), 0.0, 0.0), &at(circle(3.0), 5.0, 0.0), &expected);
}

#[test]
fn coincident_squares_have_four_ways_out() {
    let expected = Expected { separation: -1.0, ties: 4, normals: AXES };
    check(&at(square("box", 0.5), 0.0, 0.0), &at(square("box", 0.5), 0.0, 0.0), &expected);
    check(&at(square("aabb", 0.5), 0.0, 0.0), &at(square("aabb", 0.5), 0.0, 0.0), &expected);
}

#[test]
fn a_circle_at_the_centre_of_a_square_has_four_ways_out() {
    let expected = Expected { separation: -1.75, ties: 4, normals: AXES };
    check(&at(square("box", 1.0), 0.0, 0.0), &at(circle(0.75), 0.0, 0.0), &expected);
    check(&at(circle(0.75), 0.0, 0.0), &at(square("aabb", 1.0), 0.0, 0.0), &expected);
}

#[test]
fn a_circle_centred_on_an_edge_is_in_by_its_radius() {
    let expected = Expected { separation: -0.75, ties: 1, normals: &[DVec2::X] };
    check(&at(square("box", 1.0), 0.0, 0.0), &at(circle(0.75), 1.0, 0.25), &expected);
}

#[test]
fn faces_that_touch_are_zero_apart() {
    let expected = Expected { separation: 0.0, ties: 1, normals: &[DVec2::X] };
    check(&at(square("box", 0.5), 0.0, 0.0), &at(square("box", 0.5), 1.0, 0.25), &expected);
    check(&at(square("aabb", 0.5), 0.0, 0.0), &at(square("aabb", 0.5), 1.0, 0.25), &expected);
}

#[test]
fn a_point_on_a_segment_touches_it_from_both_sides() {
    let expected = Expected { separation: 0.0, ties: 2, normals: UPRIGHT };
    check(&at(segment(0.0), 0.0, 0.0), &at(point(), 0.5, 0.0), &expected);
    check(&at(point(), 0.5, 0.0), &at(segment(0.0), 0.0, 0.0), &expected);
}

#[test]
fn a_disc_on_a_segment_is_in_by_its_radius() {
    let expected = Expected { separation: -0.75, ties: 2, normals: UPRIGHT };
    check(&at(segment(0.25), 0.0, 0.0), &at(circle(0.5), 0.5, 0.0), &expected);
}

#[test]
fn a_point_beyond_the_end_of_a_segment_is_that_far_away() {
    let expected = Expected { separation: 2.0, ties: 1, normals: &[DVec2::X] };
    check(&at(segment(0.0), 0.0, 0.0), &at(point(), 3.0, 0.0), &expected);
}

#[test]
fn segments_on_one_line_are_as_far_apart_as_their_ends() {
    let expected = Expected { separation: 1.5, ties: 1, normals: &[DVec2::X] };
    check(&at(segment(0.25), 0.0, 0.0), &at(segment(0.25), 4.0, 0.0), &expected);
}

#[test]
fn parallel_segments_face_each_other() {
    let expected = Expected { separation: 1.5, ties: 1, normals: &[DVec2::Y] };
    check(&at(segment(0.25), 0.0, 0.0), &at(segment(0.25), 0.5, 2.0), &expected);
}

#[test]
fn parallel_segments_that_are_about_to_touch_are_known_as_well_in_either_order() {
    // The start of one edge lies behind the middle of B ⊖ A, a line: the walk around it comes by its back.
    for of in [["A", "B"], ["B", "A"]] {
        let line = format!(
            r#"{{"shapes": {{"A": {{"kind": "capsule", "points": [[-15, 9], [10, -6]], "radius": 0,
            "angle_deg": -134.06246857500142, "velocity": [-25, 15]}}, "B": {{"kind": "capsule", "points":
            [[-15, 9], [-7.5, 4.5]], "radius": 0, "position": [-2.5, 1.5], "angle_deg": -134.06246857500142}}}},
            "query": {{"kind": "time-of-impact", "of": {of:?}, "algorithm": "swept-axis"}}}}"#
        );
        let reply = tracefig::solve_jsonl_line(&line.replace('\n', " "), 1).line;
        let reply: serde_json::Value = serde_json::from_str(&reply).unwrap();
        let bounds = &reply["result"]["separation_bounds"];
        let [lo, hi] = [0, 1].map(|i| bounds[i].as_f64().unwrap());
        // ε times the size of the bodies, some 17: what is left of a separation that is as near as 1e-13.
        assert!(lo > 0.0 && hi - lo < 17.0 * f64::EPSILON, "{of:?}: {lo} to {hi}");
    }
}

#[test]
fn a_capsule_without_length_is_a_circle() {
    let ends = vec![DVec2::ONE, DVec2::ONE];
    let fields = [("points", FieldValue::Points(ends)), ("radius", FieldValue::Number(0.5))];
    let expected = Expected { separation: 0.5, ties: 1, normals: &[DVec2::X] };
    check(&at(of_kind("capsule", &fields), 0.0, 0.0), &at(circle(1.0), 3.0, 1.0), &expected);
}

#[test]
fn bodies_that_are_farther_apart_than_any_scene_have_bounds_that_are_numbers_around_the_answer() {
    for place in [1e154, 1e200, 1e290, 1e300] {
        for position in [[place, 0.0], [0.0, -place], [place, place]] {
            let line = format!(
                r#"{{"shapes": {{"A": {{"kind": "box", "half_extents": [1, 2], "angle_deg": 30}},
                "B": {{"kind": "polygon", "vertices": [[0, 0], [1, 0], [0, 1]], "position": {position:?}}}}},
                "query": {{"kind": "separation", "of": ["A", "B"]}}}}"#
            );
            let reply = tracefig::solve_jsonl_line(&line.replace('\n', " "), 1).line;
            let reply: serde_json::Value = serde_json::from_str(&reply).unwrap();
            let bounds = &reply["result"]["separation_bounds"];
            let (lo, hi) = (bounds[0].as_f64().unwrap(), bounds[1].as_f64().unwrap());
            // The distance is that of the places to all digits of a double: the bodies' size adds none.
            let apart = libm::hypot(position[0], position[1]);
            let ulps = 4.0 * f64::EPSILON * apart;
            assert!(lo <= apart + ulps && apart - ulps <= hi, "{position:?}: {lo:e} {hi:e}");
        }
    }
}
