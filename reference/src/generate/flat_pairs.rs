//! Points and segments on one line or on parallel ones, with and without a radius: B ⊖ A is a segment or a
//! point, of which no edge faces a motion along it.

use super::draft::{Draft, Shape};
use super::lattice;
use super::pair::{IMPACT, SWEEP, scene};
use crate::json::Json;
use crate::random::Random;

/// Directions of lines that doubles hold: multiples of them are exactly on one line.
const LINES: [[f64; 2]; 7] =
    [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 2.0], [2.0, -1.0], [3.0, 1.0], [-5.0, 3.0]];

/// A point or a segment along a line: its ends are multiples of ½ of the line's direction.
fn part(random: &mut Random, [x, y]: [f64; 2], radius: f64) -> Shape {
    let mut end = || lattice::halves(random, 3);
    let (from, to) = (end(), end());
    if from == to || random.once_in(6) {
        return Shape::Circle(radius, [from * x, from * y]);
    }
    Shape::Capsule([[from * x, from * y], [to * x, to * y]], radius)
}

/// Two of them and where the second's line is: on the first's, or beside it.
fn pair(random: &mut Random) -> ([Draft; 2], [f64; 2]) {
    let line = random.one_of(&LINES);
    let aside = if random.once_in(4) { lattice::halves(random, 1) } else { 0.0 };
    let away = lattice::halves(random, 9);
    let [x, y] = line;
    let place = [away * x - aside * y, away * y + aside * x];
    let mut radius = || if random.once_in(4) { lattice::positive(random, 1) } else { 0.0 };
    let radii = [radius(), radius()];
    let [a, b] = radii.map(|radius| part(random, line, radius));
    // Turned, they are on one line only as far as doubles hold its points.
    let angle = if random.once_in(4) { random.between(-180.0, 180.0) } else { 0.0 };
    ([Draft::still(a, [0.0, 0.0], angle), Draft::still(b, place, angle)], line)
}

/// At rest: ties, touches and overlaps along the line.
pub(super) fn at_rest(random: &mut Random) -> Json {
    let (pair, _) = pair(random);
    let kind = if random.once_in(3) { "overlap" } else { "separation" };
    scene(random, kind, pair, &[])
}

/// Moving along the line, seldom across it or not at all.
pub(super) fn moving(random: &mut Random) -> Json {
    let ([a, b], [x, y]) = pair(random);
    let mut velocity = || {
        let speed = lattice::halves(random, 6);
        match random.below(8) {
            0 => [speed, lattice::halves(random, 6)],
            1 => [-speed * y, speed * x],
            _ => [speed * x, speed * y],
        }
    };
    let (v, w) = (velocity(), velocity());
    let w = if random.once_in(2) { [0.0, 0.0] } else { w };
    let kind = if random.once_in(3) { IMPACT } else { SWEEP };
    scene(random, kind, [a.moving(v, 0.0), b.moving(w, 0.0)], &[])
}
