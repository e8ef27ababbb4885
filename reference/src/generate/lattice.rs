//! Shapes on small integers and halves: exact touches, exact ties, parallel faces, vertices of 180° and
//! doubled ones.

use super::draft::{Draft, Shape};
use crate::placement::convex_core;
use crate::random::Random;

/// A multiple of ½ in [−n, n].
pub(super) fn halves(random: &mut Random, n: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let value = random.below(4 * n + 1) as f64 / 2.0 - n as f64;
    value
}

/// A multiple of ½ in [½, n].
pub(super) fn positive(random: &mut Random, n: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let value = (1 + random.below(2 * n)) as f64 / 2.0;
    value
}

/// The hull of some lattice points, counter-clockwise; None where it is flat.
pub(super) fn hull(random: &mut Random) -> Option<Vec<[f64; 2]>> {
    let points: Vec<[f64; 2]> =
        (0..3 + random.below(6)).map(|_| [halves(random, 3), halves(random, 3)]).collect();
    let core = convex_core(&points);
    (core.len() > 2).then(|| core.into_iter().map(|i| points[i]).collect())
}

/// A shape on the lattice.
pub(super) fn shape(random: &mut Random) -> Shape {
    let half = [positive(random, 2), positive(random, 2)];
    let radius = if random.once_in(3) { positive(random, 1) } else { 0.0 };
    match random.below(6) {
        0 => Shape::Circle(positive(random, 2), [0.0, 0.0]),
        1 => Shape::Aabb(half),
        2 => Shape::Box(half, radius),
        3 => Shape::Capsule([[halves(random, 2), -1.0], [halves(random, 2), 1.0]], radius),
        _ => hull(random).map_or(Shape::Box(half, radius), |mut list| {
            if random.once_in(2) {
                list.reverse();
            }
            Shape::Polygon(list, radius)
        }),
    }
}

/// A body on the lattice, turned by a multiple of 90°.
pub(super) fn body(random: &mut Random, reach: usize) -> Draft {
    let position = [halves(random, reach), halves(random, reach)];
    let angle = random.one_of(&[0.0, 0.0, 90.0, 180.0, -90.0, 360.0, 36_000_000.0]);
    Draft::still(shape(random), position, angle)
}

/// Lattice polygons with vertices of 180° and doubled vertices put in, either winding.
pub(super) fn padded(random: &mut Random) -> Shape {
    let list = hull(random).unwrap_or_else(|| vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]);
    let mut padded = Vec::new();
    for (i, p) in list.iter().enumerate() {
        let q = list[(i + 1) % list.len()];
        padded.push(*p);
        if random.once_in(3) {
            padded.push(*p);
        }
        if random.once_in(2) {
            padded.push([p[0] + (q[0] - p[0]) / 4.0, p[1] + (q[1] - p[1]) / 4.0]);
        }
        if random.once_in(2) {
            padded.push([f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])]);
        }
    }
    if random.once_in(2) {
        padded.reverse();
    }
    Shape::Polygon(padded, 0.0)
}
