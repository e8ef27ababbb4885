//! Cases of bodies in motion: a row a category.

use super::draft::{Draft, Shape, direction, sign, turned_back};
use super::lattice;
use super::pair::{IMPACT, SWEEP, approaching, moved_to, near_each_other, scene, spun};
use crate::float::Real;
use crate::json::Json;
use crate::point::{Point, Rotation};
use crate::random::Random;

pub(super) fn sweep(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let pair = approaching(random, shapes, 1.0);
    scene(random, SWEEP, pair, &[])
}

/// Small integers: exact grazes along edges and past vertices, hits at t = 0 and t = 1.
pub(super) fn sweep_lattice(random: &mut Random) -> Json {
    let velocity = [lattice::halves(random, 6), lattice::halves(random, 6)];
    let pair = [lattice::body(random, 4).moving(velocity, 0.0), lattice::body(random, 4)];
    let kind = if random.once_in(4) { IMPACT } else { SWEEP };
    scene(random, kind, pair, &[])
}

/// Along a coordinate axis past a body, touching it exactly, or off by 10^−k.
pub(super) fn sweep_graze(random: &mut Random) -> Json {
    let (r, q) = (lattice::positive(random, 2), lattice::positive(random, 2));
    let off = if random.once_in(2) { 0.0 } else { sign(random) * random.magnitude(-17.0, -3.0) };
    let round = |random: &mut Random, r: f64| match random.below(3) {
        0 => Shape::Circle(r, [0.0, 0.0]),
        1 => Shape::Box([1.0, r], 0.0),
        _ => Shape::Polygon(vec![[-r, 0.0], [0.0, -r], [r, 0.0], [0.0, r]], 0.0),
    };
    let a =
        Draft::still(round(random, r), [-8.0, r], 0.0).moving([lattice::positive(random, 8) + 8.0, 0.0], 0.0);
    let mut b = Draft::still(round(random, q), [0.0, off - q], 0.0);
    if random.once_in(4) {
        // A centre whose height is a sum of two doubles: off by less than an ulp of it.
        let hair = sign(random) * random.magnitude(-34.0, -17.0);
        b = Draft::still(Shape::Circle(q, [0.0, hair]), [0.0, -q], 0.0);
    }
    let kind = if random.once_in(3) { IMPACT } else { SWEEP };
    scene(random, kind, [a, b], &[])
}

pub(super) fn turning(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let pair = approaching(random, shapes, 1.0);
    let pair = spun(random, pair, 500.0);
    scene(random, IMPACT, pair, &[])
}

pub(super) fn tolerances(random: &mut Random) -> Json {
    let shapes = [Shape::sharp(random, 1.0), Shape::sharp(random, 1.0)];
    let pair = approaching(random, shapes, 1.0);
    let pair = spun(random, pair, 400.0);
    let tolerance = random.one_of(&[1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15]);
    scene(random, IMPACT, pair, &[("tolerance", Json::Number(tolerance))])
}

/// A bar turns, and its vertex enters a wall by 10^−k, stays out of it by that, or grazes it.
pub(super) fn spinning_bar(random: &mut Random) -> Json {
    let mut half = [random.between(0.5, 2.0), random.between(0.05, 0.3)];
    let mut depth = sign(random) * random.magnitude(-12.0, -2.0);
    if random.once_in(6) {
        // 3-4-5: the vertex grazes the wall exactly.
        (half, depth) = ([1.0, 0.75], 0.0);
    }
    let vertex = Point::of(half).length();
    let wall = [0.5, 5.0];
    let x = (vertex + Real::from(wall[0]) - Real::from(depth)).to_f64();
    let spin = sign(random) * random.one_of(&[180.0, 360.0, 90.0, 1800.0]);
    let angle = random.between(-30.0, 30.0);
    let a = Draft::still(Shape::Box(half, 0.0), [0.0, 0.0], angle).moving([0.0, 0.0], spin);
    let b = Draft::still(Shape::Box(wall, 0.0), [x, random.between(-1.0, 1.0)], 0.0);
    scene(random, IMPACT, [a, b], &[])
}

/// A rod turns up to 20 times past a peg: only the first crossing counts.
pub(super) fn rod_past_peg(random: &mut Random) -> Json {
    let length = random.between(1.0, 3.0);
    let rod = if random.once_in(3) {
        Shape::Capsule([[-length, 0.0], [length, 0.0]], 0.0)
    } else {
        Shape::Box([length, random.between(0.01, 0.1)], 0.0)
    };
    let peg = match random.below(3) {
        0 => Shape::Circle(0.0, [0.0, 0.0]),
        1 => Shape::Circle(random.between(0.01, 0.1), [0.0, 0.0]),
        _ => Shape::Box([0.02, 0.02], 0.0),
    };
    let spin = sign(random) * random.one_of(&[180.0, 360.0, 1080.0, 3600.0, 18_000.0, 100_000.0]);
    let away = length * random.between(0.2, 0.98);
    let place = direction(random, away);
    let a = Draft::still(rod, [0.0, 0.0], random.between(-180.0, 180.0)).moving([0.0, 0.0], spin);
    let mut b = Draft::still(peg, place, 0.0);
    if random.once_in(3) {
        b.velocity = direction(random, 0.2);
    }
    scene(random, IMPACT, [a, b], &[])
}

/// A point on an arm meets a segment: no interior, contact by crossing.
pub(super) fn arm(random: &mut Random) -> Json {
    let reach = random.between(0.5, 2.0);
    let spin = sign(random) * random.one_of(&[180.0, 360.0, 3600.0]);
    let angle = random.one_of(&[30.0, 60.0, 45.0, 120.0, 77.0]);
    let point = Draft::still(Shape::Circle(0.0, [reach, 0.0]), [0.0, 0.0], 0.0).moving([0.0, 0.0], spin);
    let segment = Shape::Capsule([[0.5 * reach, 0.0], [random.between(1.2, 2.0) * reach, 0.0]], 0.0);
    let b = Draft::still(segment, [0.0, 0.0], angle);
    scene(random, IMPACT, [point, b], &[])
}

/// A point or a segment flies over a segment.
pub(super) fn flat(random: &mut Random) -> Json {
    let part = |random: &mut Random| {
        if random.once_in(2) { Shape::Circle(0.0, [0.0, 0.0]) } else { Shape::capsule(random, 0.5, 0.0) }
    };
    let shapes = [part(random), Shape::capsule(random, 1.5, 0.0)];
    let pair = approaching(random, shapes, 0.8);
    let still = random.once_in(3);
    let pair = if still { pair } else { spun(random, pair, 300.0) };
    let kind = if still && random.once_in(2) { SWEEP } else { IMPACT };
    scene(random, kind, pair, &[])
}

/// A body comes down and stops 10^−k above a ground.
pub(super) fn stops_above(random: &mut Random) -> Json {
    let gap = random.magnitude(-13.0, -3.0);
    let body = match random.below(3) {
        0 => Shape::Circle(0.0, [0.0, 0.0]),
        1 => Shape::Circle(0.5, [0.0, 0.0]),
        _ => Shape::Box([0.25, 0.5], 0.0),
    };
    let foot = if matches!(body, Shape::Circle(r, _) if r == 0.0) { 0.0 } else { 0.5 };
    let ground = if random.once_in(2) {
        Shape::Capsule([[-2.0, 0.0], [2.0, 0.0]], 0.0)
    } else {
        Shape::Box([2.0, 0.5], 0.0)
    };
    let top = if matches!(ground, Shape::Box(..)) { 0.5 } else { 0.0 };
    let a = Draft::still(body, [0.0, 1.0 + foot + top], 0.0).moving([0.0, gap - 1.0], 0.0);
    let b = Draft::still(ground, [0.0, 0.0], 0.0);
    let kind = if random.once_in(2) { SWEEP } else { IMPACT };
    scene(random, kind, [a, b], &[])
}

pub(super) fn no_relative_motion(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let pair = near_each_other(random, shapes, 1.0);
    let pair = moved_to(pair, random.magnitude(-10.0, 0.0));
    let speed = random.between(0.0, 5.0);
    let velocity = direction(random, speed);
    let pair = pair.map(|body| body.moving(velocity, 0.0));
    let kind = if random.once_in(2) { SWEEP } else { IMPACT };
    scene(random, kind, pair, &[])
}

/// Touching, overlapping or nearly so at t = 0.
pub(super) fn starts_near(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let mut pair = near_each_other(random, shapes, 1.0);
    let gap = sign(random) * random.magnitude(-14.0, -1.0);
    pair = match random.below(3) {
        0 => [lattice::body(random, 2), lattice::body(random, 2)],
        1 => pair,
        _ => moved_to(pair, gap),
    };
    let speed = random.between(0.0, 2.0);
    pair[0].velocity = direction(random, speed);
    pair = spun(random, pair, 200.0);
    scene(random, IMPACT, pair, &[])
}

/// Round against round: the least distance of the centres is the sum of the radii, but for 10^−k.
pub(super) fn near_graze(random: &mut Random) -> Json {
    let radii = [random.between(0.2, 2.0), random.between(0.2, 2.0)];
    let off = sign(random) * random.magnitude(-12.0, -2.0);
    let turn = Rotation::of_degrees(Real::from(random.between(0.0, 360.0)));
    let place = |x: f64, y: Real| {
        let p = Point { x: Real::from(x), y }.turned(turn);
        [p.x.to_f64(), p.y.to_f64()]
    };
    let height = Real::from(radii[0]) + Real::from(radii[1]) + Real::from(off);
    let spins = [random.between(-300.0, 300.0), random.between(-300.0, 300.0)];
    let shape = if random.once_in(2) {
        Shape::Capsule([[-0.3, 0.0], [0.0, 0.0]], radii[1])
    } else {
        Shape::Circle(radii[1], [0.0, 0.0])
    };
    let a = Draft::still(Shape::Circle(radii[0], [0.0, 0.0]), place(-2.0, height), 0.0);
    let a = a.moving(place(random.between(3.0, 6.0), Real::ZERO), spins[0]);
    let b = Draft::still(shape, [0.0, 0.0], 0.0);
    let b = if random.once_in(2) { b.moving([0.0, 0.0], spins[1] / 9.0) } else { b };
    scene(random, IMPACT, [a, b], &[])
}

/// Parallel faces that close while they slide, turning together or not at all.
pub(super) fn parallel_slide(random: &mut Random) -> Json {
    let angle = if random.once_in(2) { 0.0 } else { random.between(-180.0, 180.0) };
    let turn = Rotation::of_degrees(Real::from(angle));
    let world = |x: f64, y: f64| {
        let p = Point::of([x, y]).turned(turn);
        [p.x.to_f64(), p.y.to_f64()]
    };
    let half = [lattice::positive(random, 2), lattice::positive(random, 2)];
    let start = world(random.between(-2.0, 2.0), 6.0);
    let velocity = world(random.between(-2.0, 2.0), -random.between(3.0, 6.0));
    let a = Draft::still(Shape::Box(half, 0.0), start, angle).moving(velocity, 0.0);
    let mut b = Draft::still(Shape::Box([half[1], half[0]], 0.0), [0.0, 0.0], angle);
    if angle == 0.0 && random.once_in(2) {
        b = turned_back(random, half, [0.0, 0.0]);
    }
    let kind = if random.once_in(3) { SWEEP } else { IMPACT };
    scene(random, kind, [a, b], &[])
}
