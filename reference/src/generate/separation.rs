//! Cases at one moment: a row a category.

use super::draft::{Draft, Shape, direction, nudged, sign, turned_back};
use super::lattice;
use super::pair::{measured, moved_to, near_each_other, scene, without_spin_of_aabb};
use crate::float::Real;
use crate::json::Json;
use crate::random::Random;

fn ask(random: &mut Random, pair: [Draft; 2]) -> Json {
    scene(random, "separation", pair, &[])
}

pub(super) fn ordinary(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.5)];
    let pair = near_each_other(random, shapes, 1.0);
    ask(random, pair)
}

pub(super) fn rounded(random: &mut Random) -> Json {
    let radius = random.between(0.01, 0.8);
    let vertices = 3 + random.below(9);
    let half = [random.between(0.1, 1.0), random.between(0.1, 1.0)];
    let a = if random.once_in(2) {
        Shape::capsule(random, 1.0, radius)
    } else {
        Shape::polygon(random, vertices, half, radius)
    };
    let b = if random.once_in(3) { Shape::capsule(random, 1.0, radius) } else { Shape::Box(half, radius) };
    let pair = near_each_other(random, [a, b], 1.0);
    ask(random, pair)
}

pub(super) fn on_lattice(random: &mut Random) -> Json {
    let pair = [lattice::body(random, 3), lattice::body(random, 3)];
    ask(random, pair)
}

/// A shape twice at the same pose, or turned by a symmetry of it, or only moved.
pub(super) fn identical(random: &mut Random) -> Json {
    let shape = if random.once_in(2) { lattice::shape(random) } else { Shape::any(random, 1.0) };
    let position = [random.between(-9.0, 9.0), random.between(-9.0, 9.0)];
    let angle = random.between(-720.0, 720.0);
    let a = Draft::still(shape, position, angle);
    let mut b = a.clone();
    match random.below(3) {
        0 => {}
        1 => b.angle += random.one_of(&[90.0, 180.0, -270.0]),
        _ => b.position[0] += random.between(-1.0, 1.0),
    }
    ask(random, [a, b])
}

/// Edges from 1e-3 to 1e-17 rad off parallel; at any tilt, apart or inside.
pub(super) fn near_parallel(random: &mut Random) -> Json {
    let half = [random.between(0.5, 1.5), random.between(0.5, 1.5)];
    let tilt = if random.once_in(2) { 0.0 } else { random.between(-180.0, 180.0) };
    let off = sign(random) * random.magnitude(-17.0, -2.0);
    let a = Draft::still(Shape::Box(half, 0.0), [0.0, 0.0], tilt);
    let b = Draft::still(Shape::Box([half[1], half[0]], 0.0), direction(random, 0.0), tilt + off);
    let away = random.one_of(&[0.3, 1.9, 2.0, 2.5, 4.0]);
    let mut b = Draft { position: direction(random, away), ..b };
    if tilt == 0.0 && random.once_in(2) {
        b.position = [half[0] + half[1] + random.one_of(&[0.5, 0.0, -0.25]), random.between(-1.0, 1.0)];
    }
    b.angle += random.one_of(&[0.0, 90.0, 180.0]);
    if tilt == 0.0 && random.once_in(3) {
        b = turned_back(random, half, b.position);
    }
    ask(random, [a, b])
}

/// A needle: its length over its width is up to 1e10.
fn needle(random: &mut Random) -> Shape {
    let length = random.magnitude(-2.0, 4.0);
    let width = length * random.magnitude(-10.0, -2.0);
    match random.below(3) {
        0 => Shape::Box([length, width], 0.0),
        1 => Shape::Polygon(vec![[0.0, 0.0], [length, width], [length, 2.0 * width]], 0.0),
        _ => Shape::Polygon(vec![[-length, 0.0], [0.0, -width], [length, 0.0], [0.0, width]], 0.0),
    }
}

pub(super) fn sliver(random: &mut Random) -> Json {
    let a = needle(random);
    let b = if random.once_in(2) { needle(random) } else { Shape::any(random, 1.0) };
    let size = random.magnitude(-1.0, 3.0);
    let pair = near_each_other(random, [a, b], size);
    ask(random, pair)
}

/// B moved along the normal until s is about ± 10^−k, k from 2 to 18.
pub(super) fn near_touching(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let pair = near_each_other(random, shapes, 1.0);
    let gap = sign(random) * random.magnitude(-18.0, -2.0);
    let pair = moved_to(pair, gap);
    ask(random, pair)
}

/// A circle whose place is a sum of two doubles, so that s is down to 1e-33: only there the rounding of
/// double-doubles shows.
pub(super) fn hair(random: &mut Random) -> Json {
    let a = if random.once_in(2) { Shape::sharp(random, 1.0) } else { Shape::any(random, 1.0) };
    let radius = if random.once_in(2) { 0.0 } else { random.between(0.0, 1.0) };
    let [a, b] = near_each_other(random, [a, Shape::Circle(radius, [0.0, 0.0])], 1.0);
    let gap = sign(random) * random.magnitude(-34.0, -17.0);
    let [a, b] = moved_to([a, Draft { angle: 0.0, ..b }], gap);
    let pair = centred_to([a, b], radius, gap);
    let kind = if random.once_in(4) { "overlap" } else { "separation" };
    scene(random, kind, pair, &[])
}

/// The pair with the circle's centre moved from its body's origin along the normal until s is nearly `gap`.
fn centred_to([a, mut b]: [Draft; 2], radius: f64, gap: f64) -> [Draft; 2] {
    let mut center = [0.0, 0.0];
    for _ in 0..2 {
        b.shape = Shape::Circle(radius, center);
        let Some((n, s)) = measured(&[a.clone(), b.clone()]) else { break };
        center = nudged(center, n.times(Real::from(gap) - s));
    }
    b.shape = Shape::Circle(radius, center);
    [a, b]
}

pub(super) fn far(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let [mut a, mut b] = near_each_other(random, shapes, 1.0);
    let away = random.magnitude(4.0, 12.0);
    let [x, y] = direction(random, away);
    for body in [&mut a, &mut b] {
        body.position = [body.position[0] + x, body.position[1] + y];
    }
    let pair = if random.once_in(3) { moved_to([a, b], random.magnitude(-6.0, 0.0)) } else { [a, b] };
    ask(random, pair)
}

pub(super) fn mixed_sizes(random: &mut Random) -> Json {
    let sizes = [random.magnitude(-12.0, 12.0), random.magnitude(-12.0, 12.0)];
    let shapes = sizes.map(|size| Shape::any(random, size));
    let reach = if random.once_in(2) { sizes[0].max(sizes[1]) } else { sizes[0].min(sizes[1]) };
    let mut pair = near_each_other(random, shapes, reach);
    if random.once_in(2) {
        let gap = sign(random) * sizes[0].min(sizes[1]) * random.between(0.0, 1.0);
        pair = moved_to(pair, gap);
    }
    ask(random, pair)
}

/// Sizes from 1e-300 down to a few times the least positive double.
pub(super) fn denormal(random: &mut Random) -> Json {
    let size = random.magnitude(-318.0, -300.0);
    let shapes = [Shape::any(random, size), Shape::any(random, size)];
    let [mut a, mut b] = near_each_other(random, shapes, size);
    if random.once_in(2) {
        let half = [2.0, 4.0].map(|k| k * size);
        a = Draft::still(Shape::Box(half, 0.0), [0.0, 0.0], 0.0);
        b = Draft::still(Shape::Aabb([half[1], half[0]]), [random.between(0.0, 12.0) * size, size], 0.0);
    }
    if random.once_in(8) {
        // A hair of the least doubles beside bodies of ordinary size: exact touch but for 5e-324 or so.
        let off = random.one_of(&[5e-324, -5e-324, 1e-310, -1e-310]);
        a = Draft::still(Shape::Box([0.5, 0.5], 0.0), [-0.5, 0.0], 0.0);
        b = Draft::still(Shape::Aabb([0.25, 0.25]), [0.25, off], 0.0);
        if random.once_in(2) {
            b = Draft::still(Shape::Circle(0.0, [0.0, 0.0]), [off, 0.125], 0.0);
        }
    }
    ask(random, [a, b])
}

pub(super) fn turns(random: &mut Random) -> Json {
    let shapes = [Shape::sharp(random, 1.0), Shape::any(random, 1.0)];
    let [mut a, mut b] = near_each_other(random, shapes, 1.0);
    a.angle = sign(random) * random.magnitude(3.0, 15.0);
    if random.once_in(2) {
        b.angle = a.angle + random.one_of(&[0.0, 1e-9, 90.0, 360.0]);
    }
    ask(random, [a, b])
}

pub(super) fn many_vertices(random: &mut Random) -> Json {
    let mut polygon = |most: f64| {
        let target = random.magnitude(0.9, most);
        let vertices = (3..1000).find(|n| f64::from(*n) >= target).unwrap_or(1000);
        let half = [random.between(0.5, 1.0), random.between(0.5, 1.0)];
        Shape::polygon(random, usize::try_from(vertices).unwrap_or(3), half, 0.0)
    };
    let shapes = [polygon(3.0), polygon(2.0)];
    let mut pair = near_each_other(random, shapes, 1.0);
    if random.once_in(4) {
        pair = moved_to(pair, sign(random) * random.magnitude(-15.0, -3.0));
    }
    ask(random, pair)
}

pub(super) fn collinear(random: &mut Random) -> Json {
    let a =
        Draft::still(lattice::padded(random), [lattice::halves(random, 2), lattice::halves(random, 2)], 0.0);
    let shape = if random.once_in(2) { lattice::padded(random) } else { lattice::shape(random) };
    let mut b = Draft::still(shape, [lattice::halves(random, 4), lattice::halves(random, 4)], 0.0);
    if random.once_in(2) {
        b.angle = random.between(-180.0, 180.0);
    }
    ask(random, [a, b])
}

/// Points and segments: no interior, so that nothing is ever inside.
pub(super) fn flat(random: &mut Random) -> Json {
    let a = part_of(random);
    let b = if random.once_in(3) { Shape::any(random, 1.0) } else { part_of(random) };
    let mut pair = near_each_other(random, [a, b], 1.0);
    let placing = random.below(4);
    if placing < 2 {
        let lattice = [(); 2].map(|()| [lattice::halves(random, 2), lattice::halves(random, 2)]);
        for (body, position) in pair.iter_mut().zip(lattice) {
            (body.position, body.angle) = (position, random.one_of(&[0.0, 90.0, 180.0]));
        }
    } else if placing == 2 {
        pair = moved_to(pair, random.magnitude(-17.0, -3.0));
    }
    ask(random, pair)
}

fn part_of(random: &mut Random) -> Shape {
    match random.below(4) {
        0 | 1 => Shape::Circle(0.0, [0.0, 0.0]),
        2 => Shape::Capsule([[lattice::halves(random, 2), -1.0], [lattice::halves(random, 2), 1.0]], 0.0),
        _ => Shape::capsule(random, 1.0, 0.0),
    }
}

/// Circles: concentric, with a centre on a vertex or on an edge, nearly concentric.
pub(super) fn circles(random: &mut Random) -> Json {
    let radius = random.between(0.1, 2.0);
    let half = [lattice::positive(random, 2), lattice::positive(random, 2)];
    let place = [lattice::halves(random, 2), lattice::halves(random, 2)];
    let off = random.magnitude(-17.0, -1.0);
    let circle = Draft::still(Shape::Circle(radius, [0.0, 0.0]), place, 0.0);
    let other = match random.below(4) {
        0 => Draft::still(Shape::Circle(2.0 * radius, [0.0, 0.0]), place, 0.0),
        1 => Draft::still(Shape::Circle(radius, [0.0, 0.0]), [place[0] + off, place[1]], 0.0),
        2 => Draft::still(Shape::Box(half, 0.0), [place[0] + half[0], place[1] + half[1]], 0.0),
        _ => Draft::still(Shape::Box(half, 0.0), [place[0] + half[0], place[1]], 0.0),
    };
    ask(random, [other, circle])
}

/// Moving and turning, asked at a time in [0, 1].
pub(super) fn moment(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let [a, b] = near_each_other(random, shapes, 1.0);
    let mut motion = |body: Draft| {
        let speed = random.between(0.0, 3.0);
        let velocity = direction(random, speed);
        let spin = random.between(-720.0, 720.0);
        body.moving(velocity, spin)
    };
    let pair = [motion(a), motion(b)].map(without_spin_of_aabb);
    let time = random.unit();
    scene(random, "separation", pair, &[("time", Json::Number(time))])
}
