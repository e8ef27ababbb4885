//! Bodies in motion at the ends of the range of doubles and of shapes: far away, huge and tiny, thin,
//! many-cornered, fast turning, nearly parallel.

use super::draft::{Shape, direction, sign};
use super::pair::{IMPACT, SWEEP, approaching, carried, scene, spun};
use crate::json::Json;
use crate::random::Random;

/// Coordinates to 1e12.
pub(super) fn far(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let pair = approaching(random, shapes, 1.0);
    let pair = spun(random, pair, 300.0);
    let away = random.magnitude(3.0, 12.0);
    let off = direction(random, away);
    scene(random, IMPACT, carried(pair, off), &[])
}

/// Sizes from 1e-15 to 1e12.
pub(super) fn sizes(random: &mut Random) -> Json {
    let size = random.magnitude(-12.0, 12.0);
    let other = size * random.magnitude(-3.0, 0.0);
    let shapes = [Shape::any(random, size), Shape::any(random, other)];
    let pair = approaching(random, shapes, size);
    let pair = spun(random, pair, 300.0);
    scene(random, IMPACT, pair, &[])
}

/// A bar a billion times longer than wide.
pub(super) fn sliver(random: &mut Random) -> Json {
    let needle = Shape::Box([1.0, random.magnitude(-9.0, -3.0)], 0.0);
    let shapes = [needle, Shape::any(random, 0.6)];
    let pair = approaching(random, shapes, 0.7);
    let pair = spun(random, pair, 300.0);
    scene(random, IMPACT, pair, &[])
}

/// Up to 150 vertices, and now and then 1000.
pub(super) fn many_vertices(random: &mut Random) -> Json {
    let polygon = |random: &mut Random, most: f64| {
        let target = random.magnitude(0.9, most);
        let vertices = (3..1000).find(|n| f64::from(*n) >= target).unwrap_or(1000);
        let half = [random.between(0.5, 1.0), random.between(0.5, 1.0)];
        Shape::polygon(random, usize::try_from(vertices).unwrap_or(3), half, 0.0)
    };
    let shapes = if random.once_in(16) {
        [polygon(random, 3.0), polygon(random, 3.0)]
    } else {
        [polygon(random, 2.2), polygon(random, 1.8)]
    };
    let pair = approaching(random, shapes, 0.8);
    let pair = spun(random, pair, 400.0);
    scene(random, IMPACT, pair, &[])
}

/// Ten turns and more while they approach.
pub(super) fn many_turns(random: &mut Random) -> Json {
    let shapes = [Shape::Box([1.0, 0.1], 0.0), Shape::any(random, 0.8)];
    let pair = approaching(random, shapes, 1.0);
    let mut pair = spun(random, pair, 100.0);
    pair[0].spin = sign(random) * if random.once_in(8) { 18_000.0 } else { random.between(3600.0, 12_000.0) };
    scene(random, IMPACT, pair, &[])
}

/// Faces 1e-3 to 1e-16 rad off parallel that close, without turning or hardly turning.
pub(super) fn near_parallel(random: &mut Random) -> Json {
    let tilt = if random.once_in(2) { 0.0 } else { random.between(-180.0, 180.0) };
    let half = [random.between(0.5, 1.5), random.between(0.5, 1.5)];
    let shapes = [Shape::Box(half, 0.0), Shape::Box([half[1], half[0]], 0.0)];
    let [mut a, mut b] = approaching(random, shapes, 1.0);
    a.angle = tilt;
    b.angle = tilt + sign(random) * random.magnitude(-15.0, -1.0);
    if random.once_in(2) {
        a.spin = sign(random) * random.magnitude(-12.0, 0.0);
    }
    let kind = if a.spin == 0.0 && random.once_in(2) { SWEEP } else { IMPACT };
    scene(random, kind, [a, b], &[])
}

/// Sweeps of extreme bodies.
pub(super) fn sweep(random: &mut Random) -> Json {
    let size = if random.once_in(2) { 1.0 } else { random.magnitude(-12.0, 12.0) };
    let smaller = size * random.between(1e-3, 1.0);
    let a = match random.below(3) {
        0 => Shape::Box([size, size * random.magnitude(-9.0, -2.0)], 0.0),
        1 => Shape::any(random, smaller),
        _ => Shape::any(random, size),
    };
    let b = Shape::any(random, size);
    let mut pair = approaching(random, [a, b], size);
    if random.once_in(2) {
        let away = size * random.magnitude(2.0, 8.0);
        let off = direction(random, away);
        pair = carried(pair, off);
    }
    scene(random, SWEEP, pair, &[])
}
