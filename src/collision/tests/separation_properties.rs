//! What must hold of the proved separation: exact cases, and pairs that nobody chose.

use crate::collision::tests::asking::separation as ask;
use crate::collision::tests::bodies::{Bodies, body, placed};
use crate::collision::{Pair, Separation};
use crate::geometry::{Angle, Body, DVec2, Feature, Shape, Side, shape::FieldValue};
use crate::trace::Event;

fn at(shape: Shape, position: (f64, f64), angle: f64) -> Body {
    placed(body(shape), position.0, position.1, angle)
}

fn square(half: f64) -> Shape {
    Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::splat(half)))]).unwrap()
}

fn circle(radius: f64) -> Shape {
    Shape::of_kind("circle", &[("radius", FieldValue::Number(radius))]).unwrap()
}

#[test]
fn coincident_squares_have_depth_one_and_four_ties() {
    let (a, b) = (at(square(0.5), (0.0, 0.0), 30.0), at(square(0.5), (0.0, 0.0), 30.0));
    let found = Pair::at(&a, &b, 0.0).separation();
    assert_eq!((found.separation, found.bounds.lo, found.bounds.hi, found.ties), (-1.0, -1.0, -1.0, 4));
}

#[test]
fn faces_that_touch_are_exactly_zero_apart() {
    let (a, b) = (at(square(0.5), (0.0, 0.0), 0.0), at(square(0.5), (1.0, 0.25), 0.0));
    let found = Pair::at(&a, &b, 0.0).separation();
    assert_eq!((found.separation, found.bounds.lo, found.bounds.hi), (0.0, 0.0, 0.0));
    assert_eq!((*found.normal, found.features), (DVec2::X, [Feature::Edge(1), Feature::Edge(3)]));
    assert_eq!(found.points, [DVec2::new(0.5, 0.125); 2]);
}

#[test]
fn circles_in_three_four_five_touch_exactly() {
    let (a, b) = (at(circle(2.0), (0.0, 0.0), 0.0), at(circle(3.0), (3.0, 4.0), 0.0));
    let found = Pair::at(&a, &b, 0.0).separation();
    assert_eq!((found.bounds.lo, found.bounds.hi, found.ties), (0.0, 0.0, 1));
}

#[test]
fn concentric_circles_tie_in_all_directions() {
    let (a, b) = (at(circle(2.0), (1.0, 1.0), 0.0), at(circle(3.0), (1.0, 1.0), 7.0));
    let found = Pair::at(&a, &b, 0.0).separation();
    assert_eq!((found.separation, found.ties, *found.normal), (-5.0, 0, DVec2::X));
}

fn found([a, b]: &[Body; 2]) -> Separation {
    Pair::at(a, b, 0.0).separation()
}

fn meet(x: &Separation, y: &Separation, factor: f64) -> bool {
    x.bounds.lo * factor <= y.bounds.hi && y.bounds.lo <= x.bounds.hi * factor
}

#[test]
fn exchanging_the_bodies_changes_nothing_but_the_sign_of_the_normal() {
    let mut bodies = Bodies::new(1);
    for round in 0..2000 {
        let [a, b] = bodies.resting_pair();
        let (one, two) = (found(&[a.clone(), b.clone()]), found(&[b, a]));
        assert!(meet(&one, &two, 1.0), "{round}: {one:?} {two:?}");
        assert_eq!(one.ties, two.ties, "{round}");
        if one.ties == 1 {
            assert!((*one.normal + *two.normal).length() < 1e-14, "{round}: {one:?} {two:?}");
        }
    }
}

#[test]
fn a_quarter_turn_and_a_power_of_two_of_everything_keep_the_answer() {
    let mut bodies = Bodies::new(2);
    for round in 0..1000 {
        let pair = bodies.resting_pair();
        let one = found(&pair);
        let turned = pair.clone().map(|body| Body {
            position: crate::geometry::perp(body.position),
            angle: Angle::Degrees(
                body.angle.degrees() + if body.angle.degrees() < 0.0 { 90.0 } else { -270.0 },
            ),
            ..body
        });
        // The sum of degrees may round: then the bodies are others.
        if turned
            .iter()
            .zip(&pair)
            .all(|(t, p)| (t.angle.degrees() - p.angle.degrees()).rem_euclid(360.0) == 90.0)
        {
            let two = found(&turned);
            assert!(meet(&one, &two, 1.0), "{round}: {one:?} {two:?}");
        }
    }
}

#[test]
fn tiny_and_huge_scenes_have_the_same_answer_scaled() {
    let mut bodies = Bodies::new(3);
    for exponent in [-900, -300, 300, 800_i32] {
        let factor = libm::scalbn(1.0, exponent);
        for round in 0..200 {
            let pair = bodies.resting_pair();
            let scaled = pair.clone().map(|body| {
                let vertices: Vec<DVec2> = body.shape.vertices.iter().map(|v| *v * factor).collect();
                let hull = crate::geometry::Hull::new(body.shape.core.iter().map(|&k| vertices[k]).collect());
                let radius = body.shape.radius * factor;
                let shape = Shape { vertices, radius, hull, ..body.shape };
                Body { shape, position: body.position * factor, ..body }
            });
            let (one, two) = (found(&pair), found(&scaled));
            assert!(meet(&one, &two, factor), "{exponent} {round}: {one:?} {two:?}");
            assert!(two.bounds.hi - two.bounds.lo <= 1e-14 * factor, "{exponent} {round}: {two:?}");
        }
    }
}

/// How far a point is from a segment.
fn beside(p: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let along = to - from;
    (p - from - along * ((p - from).dot(along) / along.length_squared()).clamp(0.0, 1.0)).length()
}

#[test]
fn the_edge_that_is_told_nearest_holds_the_point_that_is_told_nearest() {
    let mut bodies = Bodies::new(41);
    let mut told = 0;
    for k in 0..300 {
        let [a, b] = bodies.resting_pair().map(|body| Body { angle: Angle::ZERO, ..body });
        let edges = ask("merge", &a, &b).1.events;
        // A segment's edge is there twice: there and back.
        let off = |source: Side, i: usize, p: DVec2| {
            let of = edges.iter().filter_map(|event| match event {
                Event::DifferenceEdgeFound { source: s, edge, from, to, .. }
                    if (*s, *edge) == (source, i) =>
                {
                    Some(beside(p, [*from, *to]))
                }
                _ => None,
            });
            of.reduce(f64::min)
        };
        for name in ["closest-features", "gjk", "separating-axes"] {
            let (answer, trace) = ask(name, &a, &b);
            let last = trace.events.iter().rev().find_map(|event| match event {
                Event::CandidateImproved { foot, source: (side, Feature::Edge(i)), .. } => {
                    Some((*foot + *answer.normal * (a.shape.radius + b.shape.radius), *side, *i))
                }
                _ => None,
            });
            let Some((core, side, i)) = last else { continue };
            let off = off(side, i, core).expect("an edge of the outline");
            assert!(off < 1e-9, "{k}: {name} tells {core:?} on {side:?} {i}, {off} off");
            told += 1;
        }
    }
    assert!(told > 300, "{told} of 900");
}
