//! Random pairs of every kind of shape, half of them on quarters, so that edges are parallel, bodies touch
//! and centres coincide.

#![expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]

use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2, Shape};
use tracefig_reference::random::Random;

use crate::asking::of_kind;

/// Vertices on an ellipse: convex, counter-clockwise.
fn polygon(r: &mut Random, radius: f64) -> Shape {
    let n = 3 + r.below(6);
    let (a, b, start) = (r.between(0.5, 2.0), r.between(0.5, 2.0), r.between(0.0, 360.0));
    let vertices = (0..n).map(|k| {
        let angle = (start + 360.0 * (k as f64 + r.between(-0.3, 0.3)) / n as f64).to_radians();
        DVec2::new(a * libm::cos(angle), b * libm::sin(angle))
    });
    let fields =
        [("vertices", FieldValue::Points(vertices.collect())), ("radius", FieldValue::Number(radius))];
    of_kind("polygon", &fields)
}

fn shape(r: &mut Random) -> Shape {
    let radius = if r.below(2) == 0 { 0.0 } else { r.quarter(0, 2) };
    let half = DVec2::new(r.quarter(1, 3), r.quarter(1, 2));
    match r.below(6) {
        0 => of_kind("circle", &[("radius", FieldValue::Number(radius))]),
        1 => of_kind("aabb", &[("half_extents", FieldValue::Point(half))]),
        2 => of_kind(
            "box",
            &[("half_extents", FieldValue::Point(half)), ("radius", FieldValue::Number(radius))],
        ),
        3 => {
            let ends = vec![DVec2::new(-half.x, 0.0), DVec2::new(half.x, r.quarter(0, 1))];
            of_kind(
                "capsule",
                &[("points", FieldValue::Points(ends)), ("radius", FieldValue::Number(radius))],
            )
        }
        4 => polygon(r, 0.0),
        _ => polygon(r, radius),
    }
}

fn body(r: &mut Random) -> Body {
    let shape = shape(r);
    let turns = shape.kind != "aabb";
    let angle = match r.below(3) {
        _ if !turns => 0.0,
        0 => 90.0 * r.quarter(-2, 2).round(),
        1 => 30.0,
        _ => r.between(-720.0, 720.0),
    };
    let position = match r.below(8) {
        0 => DVec2::ZERO,
        1..4 => DVec2::new(r.quarter(-4, 4), r.quarter(-4, 4)),
        _ => DVec2::new(r.between(-4.0, 4.0), r.between(-4.0, 4.0)),
    };
    Body { shape, position, angle: Angle::Degrees(angle), velocity: DVec2::ZERO, spin: Angle::Degrees(0.0) }
}

/// Seeded pairs of bodies at rest.
pub(crate) fn pairs(count: u64) -> impl Iterator<Item = (u64, Body, Body)> {
    (0..count).map(|seed| {
        let mut r = Random::new(seed);
        (seed, body(&mut r), body(&mut r))
    })
}
