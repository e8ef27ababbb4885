//! The other questions without a search in time: overlap, bounds, motion bound.

use super::draft::{Draft, Shape, direction, sign, turned_back};
use super::lattice;
use super::pair::{moved_to, near_each_other, scene, without_spin_of_aabb};
use crate::json::Json;
use crate::random::Random;

/// Overlap: ordinary, on the lattice, nearly touching.
pub(super) fn overlap(random: &mut Random) -> Json {
    let shapes = [Shape::any(random, 1.0), Shape::any(random, 1.0)];
    let mut pair = near_each_other(random, shapes, 1.0);
    match random.below(3) {
        0 => pair = [lattice::body(random, 2), lattice::body(random, 2)],
        1 => pair = moved_to(pair, sign(random) * random.magnitude(-18.0, -3.0)),
        _ => {}
    }
    scene(random, "overlap", pair, &[])
}

/// A star: every other vertex drawn in.
fn star(random: &mut Random) -> Shape {
    let Shape::Polygon(list, _) = Shape::polygon(random, 12, [2.0, 1.5], 0.0) else {
        return Shape::Aabb([1.0, 1.0]);
    };
    let vertices =
        list.iter().enumerate().map(|(i, [x, y])| if i % 2 == 0 { [*x, *y] } else { [x / 2.0, y / 2.0] });
    Shape::Outline(vertices.collect())
}

/// Bounds of one body or two, at a time, some of them far away.
pub(super) fn bounds(random: &mut Random) -> Json {
    let body = |random: &mut Random| {
        let shape = if random.once_in(4) { star(random) } else { Shape::any(random, 1.0) };
        let away = random.magnitude(-1.0, 9.0);
        // Nearly along the axes two vertices reach nearly as far: which of them does must not be guessed.
        let nearly = random.one_of(&[0.0, 90.0, 180.0]) + sign(random) * random.magnitude(-15.0, -4.0);
        let angle = if random.once_in(3) { nearly } else { random.between(-1e4, 1e4) };
        let mut draft = Draft::still(shape, direction(random, away), angle);
        if random.once_in(4) {
            let half = [random.between(0.5, 1.5), random.between(0.5, 1.5)];
            let near = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
            draft = turned_back(random, half, near);
        }
        let draft = draft.moving(direction(random, 1.0), random.between(-360.0, 360.0));
        without_spin_of_aabb(draft)
    };
    let pair = [body(random), body(random)];
    let mut json = scene(random, "bounds", pair, &[("time", Json::Number(random.clone().unit()))]);
    if random.once_in(2) {
        only_first(&mut json);
    }
    json
}

/// Motion bound of one body or of two.
pub(super) fn motion_bound(random: &mut Random) -> Json {
    let body = |random: &mut Random| {
        let size = random.magnitude(-3.0, 3.0);
        let spin = random.one_of(&[0.0, 60.0, -360.0, 18_000.0]) * random.between(0.5, 1.5);
        let speed = random.one_of(&[0.0, 1.0, 100.0]);
        let velocity = direction(random, speed);
        without_spin_of_aabb(Draft::still(Shape::any(random, size), [0.0, 0.0], 0.0).moving(velocity, spin))
    };
    let pair = [body(random), body(random)];
    let mut json = scene(random, "motion-bound", pair, &[]);
    if random.once_in(2) {
        only_first(&mut json);
    }
    json
}

/// Asks the question of the first body alone.
fn only_first(json: &mut Json) {
    let Some(mut query) = json.get("query").cloned() else { return };
    let first = query.get("of").and_then(|of| of.list().first().cloned());
    query.set("of", Json::List(first.into_iter().collect()));
    json.set("query", query);
}
