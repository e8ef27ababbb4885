//! Random pairs of every kind of shape, half of them on quarters, so that edges are parallel, bodies touch
//! and centres coincide.

use super::asking::of_kind;
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Body, DVec2, Degrees, Shape};

/// `SplitMix64` (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// In [lo, hi).
    fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * ((self.next() >> 11) as f64 / 9_007_199_254_740_992.0)
    }

    /// A multiple of a quarter in [lo, hi]: makes ties, touching and parallel edges.
    fn quarter(&mut self, lo: i32, hi: i32) -> f64 {
        let steps = u64::try_from((hi - lo) * 4 + 1).unwrap();
        f64::from(lo) + f64::from(u32::try_from(self.below(steps)).unwrap()) / 4.0
    }
}

/// Vertices on an ellipse: convex, counter-clockwise.
fn polygon(r: &mut Random, radius: f64) -> Shape {
    let n = 3 + r.below(6);
    let (a, b, start) = (r.within(0.5, 2.0), r.within(0.5, 2.0), r.within(0.0, 360.0));
    let vertices = (0..n).map(|k| {
        let angle = (start + 360.0 * (k as f64 + r.within(-0.3, 0.3)) / n as f64).to_radians();
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
        _ => r.within(-720.0, 720.0),
    };
    let position = match r.below(8) {
        0 => DVec2::ZERO,
        1..4 => DVec2::new(r.quarter(-4, 4), r.quarter(-4, 4)),
        _ => DVec2::new(r.within(-4.0, 4.0), r.within(-4.0, 4.0)),
    };
    Body { shape, position, angle: Degrees(angle), velocity: DVec2::ZERO, spin: Degrees(0.0) }
}

/// Seeded pairs of bodies at rest.
pub(crate) fn pairs(count: u64) -> impl Iterator<Item = (u64, Body, Body)> {
    (0..count).map(|seed| {
        let mut r = Random(seed);
        (seed, body(&mut r), body(&mut r))
    })
}
