//! A point or a vertex within a hair of another body's vertex: from 1e-8 off down to where only exponents
//! tell, and exactly on it.
//!
//! Offsets so small are kept by doubles only around 0: the vertices lie at their bodies' origins, which are
//! in one place, or a point's local center says what its position can't.

use super::draft::{Draft, Shape, direction};
use super::lattice;
use super::pair::scene;
use crate::json::Json;
use crate::placement::convex_core;
use crate::random::Random;

/// A convex shape with one of its vertices at its origin.
fn cornered(random: &mut Random, radius: f64) -> Shape {
    let half = [random.between(0.2, 1.0), random.between(0.2, 1.0)];
    let count = 3 + random.below(6);
    let whole = match random.below(4) {
        0 => lattice::hull(random).unwrap_or_else(|| vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]),
        1 => vec![[-half[0], -half[1]], [half[0], -half[1]], half, [-half[0], half[1]]],
        2 => return Shape::Capsule([[0.0, 0.0], [random.between(-1.0, 1.0), half[1]]], radius),
        _ => match Shape::polygon(random, count, half, 0.0) {
            Shape::Polygon(list, _) => list,
            _ => vec![[0.0, 0.0], half, [0.0, half[1]]],
        },
    };
    let [x, y] = whole[random.below(whole.len())];
    let moved: Vec<[f64; 2]> = whole.iter().map(|p| [p[0] - x, p[1] - y]).collect();
    let is_convex = convex_core(&moved).len() == moved.len();
    if is_convex { Shape::Polygon(moved, radius) } else { Shape::Capsule([[0.0, 0.0], half], radius) }
}

/// An angle of a body, in degrees.
fn angle(random: &mut Random) -> f64 {
    if random.once_in(4) { random.one_of(&[0.0, 45.0, 90.0, -180.0]) } else { random.between(-180.0, 180.0) }
}

/// Two bodies whose vertices are this far from each other.
fn pair(random: &mut Random, off: [f64; 2]) -> [Draft; 2] {
    let mut radius = || if random.once_in(6) { random.between(0.1, 1.0) } else { 0.0 };
    let radii = [radius(), radius()];
    let a = Draft::still(cornered(random, radii[0]), [0.0, 0.0], angle(random));
    if random.once_in(2) {
        return [a, Draft::still(cornered(random, radii[1]), off, angle(random))];
    }
    // The point's position is as near to a vertex as doubles come; its center says the rest.
    let place =
        if random.once_in(2) { [random.between(-1.0, 1.0), random.between(-1.0, 1.0)] } else { [0.0; 2] };
    let point = Draft::still(Shape::Circle(radii[1], off), place, 0.0);
    [Draft { position: place, ..a }, point]
}

/// At rest, in either order.
pub(super) fn at_rest(random: &mut Random) -> Json {
    let size = if random.once_in(16) { 0.0 } else { random.magnitude(-300.0, -8.0) };
    let size = if random.once_in(2) { size } else { random.magnitude(-36.0, -28.0) };
    let off = direction(random, size);
    let [a, b] = pair(random, off);
    let pair = if random.once_in(2) { [a, b] } else { [b, a] };
    scene(random, "separation", pair, &[])
}
