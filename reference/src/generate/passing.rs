//! Cases of bodies that pass each other: how near a miss came is asked.

use super::draft::{Draft, Shape, direction, sign};
use super::lattice;
use super::pair::{IMPACT, SWEEP, measured, moved_to, near_each_other, scene, spun};
use crate::float::Real;
use crate::json::Json;
use crate::point::{Point, Rotation};
use crate::random::Random;

/// A pair at a gap of 10^−9 to 1, with its normal; None where rounding leaves none.
fn beside(random: &mut Random) -> Option<([Draft; 2], Point)> {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let pair = near_each_other(random, shapes, 1.0);
    let gap = random.magnitude(-9.0, 0.0);
    let pair = moved_to(pair, gap);
    let (normal, _) = measured(&pair)?;
    Some((pair, normal))
}

/// Closest at the start, as the bodies part; at the end, as they close in; or in between, as one passes the
/// other by 10^−9 to 1.
pub(super) fn passing(random: &mut Random) -> Json {
    let kind = if random.once_in(3) { IMPACT } else { SWEEP };
    let Some(([a, b], n)) = beside(random) else { return sliding(random) };
    let (along, aside) = (random.between(0.1, 3.0), random.between(-3.0, 3.0));
    let mix = |along: f64, aside: f64| {
        let v = n.times(Real::from(along)).plus(n.perp().times(Real::from(aside)));
        [v.x.to_f64(), v.y.to_f64()]
    };
    let pair = match random.below(3) {
        0 => [a, b.moving(mix(along, aside), 0.0)],
        1 => {
            // Closer to where they stand from elsewhere.
            let v = mix(-along, aside);
            let position = [b.position[0] - v[0], b.position[1] - v[1]];
            [a, Draft { position, ..b }.moving(v, 0.0)]
        }
        _ => {
            let (v, t) = (mix(0.0, aside), random.unit());
            let position = [b.position[0] - t * v[0], b.position[1] - t * v[1]];
            [a, Draft { position, ..b }.moving(v, 0.0)]
        }
    };
    scene(random, kind, pair, &[])
}

/// Boxes with parallel edges that slide along each other, 10^−9 to 1 apart, or rest so.
pub(super) fn sliding(random: &mut Random) -> Json {
    let angle = if random.once_in(2) { 0.0 } else { random.between(-180.0, 180.0) };
    let turn = Rotation::of_degrees(Real::from(angle));
    let world = |x: f64, y: f64| {
        let p = Point::of([x, y]).turned(turn);
        [p.x.to_f64(), p.y.to_f64()]
    };
    let halves = [0, 1].map(|_| [lattice::positive(random, 3), lattice::positive(random, 3)]);
    let height = halves[0][1] + halves[1][1] + random.magnitude(-9.0, 0.0);
    let speed = if random.once_in(4) { 0.0 } else { random.between(-12.0, 12.0) };
    let start = world(random.between(-4.0, 4.0), height);
    let a = Draft::still(Shape::Box(halves[0], 0.0), [0.0, 0.0], angle);
    let b = Draft::still(Shape::Box(halves[1], 0.0), start, angle).moving(world(speed, 0.0), 0.0);
    let kind = if random.once_in(2) { SWEEP } else { IMPACT };
    scene(random, kind, [a, b], &[])
}

/// Bodies that turn up to five times each beside each other, and hardly move.
pub(super) fn turning_beside(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let away = random.between(2.0, 4.0);
    let place = direction(random, away);
    let [a, b] = shapes;
    let speed = random.between(0.0, 1.0);
    let angles = [random.between(-180.0, 180.0), random.between(-180.0, 180.0)];
    let a = Draft::still(a, [0.0, 0.0], angles[0]).moving(direction(random, speed), 0.0);
    let b = Draft::still(b, place, angles[1]);
    let most = random.one_of(&[90.0, 360.0, 1800.0]);
    let mut pair = spun(random, [a, b], most);
    if random.once_in(6) {
        // Alike, or as gears that mesh.
        pair[1].spin = sign(random) * pair[0].spin;
    }
    if matches!(pair[1].shape, Shape::Aabb(_)) {
        pair[1].spin = 0.0;
    }
    scene(random, IMPACT, pair, &[])
}
