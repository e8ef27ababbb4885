//! Two bodies to be: beside each other, at a separation, flying at each other; and the scene that asks about
//! them.

use super::draft::{Draft, Shape, direction, nudged};
use crate::check::Setting;
use crate::float::Real;
use crate::json::Json;
use crate::point::Point;
use crate::random::Random;
use crate::scene::Scene;
use crate::separation::separation;

/// Word of the query for the first contact of bodies that do not turn.
pub(super) const SWEEP: &str = "linear-sweep";
/// Word of the query for the first contact of bodies that may turn.
pub(super) const IMPACT: &str = "time-of-impact";

/// A scene of two bodies and a question. One time in eight their names are swapped, and with them their
/// order in the file.
pub(super) fn scene(random: &mut Random, kind: &str, [a, b]: [Draft; 2], more: &[(&str, Json)]) -> Json {
    asked(random, kind, [a.json(), b.json()], more)
}

/// As [`scene`], of bodies as a scene writes them.
pub(super) fn asked(random: &mut Random, kind: &str, [a, b]: [Json; 2], more: &[(&str, Json)]) -> Json {
    let names = if random.once_in(8) { ["B", "A"] } else { ["A", "B"] };
    let of = names.map(|name| Json::Text(name.to_owned())).to_vec();
    let mut query = Json::object([("kind", Json::Text(kind.to_owned())), ("of", Json::List(of))]);
    for (key, value) in more {
        query.set(key, value.clone());
    }
    let mut shapes = vec![(names[0].to_owned(), a), (names[1].to_owned(), b)];
    shapes.sort_by(|x, y| x.0.cmp(&y.0));
    Json::object([("shapes", Json::Object(shapes)), ("query", query)])
}

/// Two bodies about their size apart, some overlapping.
pub(super) fn near_each_other(random: &mut Random, shapes: [Shape; 2], size: f64) -> [Draft; 2] {
    let away = size * random.between(0.0, 3.0);
    let position = [random.between(-size, size), random.between(-size, size)];
    let [x, y] = direction(random, away);
    let [a, b] = shapes;
    let angles = [random.between(-180.0, 180.0), random.between(-180.0, 180.0)];
    [Draft::still(a, position, angles[0]), Draft::still(b, [position[0] + x, position[1] + y], angles[1])]
}

/// The pair with B moved along the normal, so that the separation is `gap` but for the rounding of B's
/// position.
pub(super) fn moved_to([a, mut b]: [Draft; 2], gap: f64) -> [Draft; 2] {
    if let Some((n, s)) = measured(&[a.clone(), b.clone()]) {
        b.position = nudged(b.position, n.times(Real::from(gap) - s));
    }
    [a, b]
}

/// Normal and separation of a pair at t = 0.
pub(super) fn measured(pair: &[Draft; 2]) -> Option<(Point, Real)> {
    let text = scene(&mut Random::new(1), "separation", pair.clone(), &[]).to_string();
    let parsed = Scene::parse(&text).ok()?;
    let placed = Setting::of(&parsed).pair(&parsed.bodies, Real::ZERO);
    let exact = separation(&placed[0], &placed[1]);
    Some((exact.normal?, exact.separation))
}

/// Two bodies 2.5 to 6 sizes apart that fly at each other, aimed up to 1.5 sizes a unit of time aside.
pub(super) fn approaching(random: &mut Random, shapes: [Shape; 2], size: f64) -> [Draft; 2] {
    let away = size * random.between(2.5, 6.0);
    let [x, y] = direction(random, away);
    let speed = random.between(0.5, 2.0);
    let off = size * random.between(0.0, 1.5);
    let aside = direction(random, off);
    let [a, b] = shapes;
    let base = [random.between(-size, size), random.between(-size, size)];
    let angles = [random.between(-180.0, 180.0), random.between(-180.0, 180.0)];
    let share = random.unit();
    let v = [x * speed + aside[0], y * speed + aside[1]];
    let a = Draft::still(a, base, angles[0]).moving(v.map(|v| v * share), 0.0);
    let b = Draft::still(b, [base[0] + x, base[1] + y], angles[1]).moving(v.map(|v| v * (share - 1.0)), 0.0);
    [a, b].map(without_spin_of_aabb)
}

/// A pair with random spins, up to `most` degrees a unit of time either way; one time in three B does not
/// turn.
pub(super) fn spun(random: &mut Random, [mut a, mut b]: [Draft; 2], most: f64) -> [Draft; 2] {
    a.spin = random.between(-most, most);
    b.spin = if random.once_in(3) { 0.0 } else { random.between(-most, most) };
    [a, b].map(without_spin_of_aabb)
}

/// A pair carried off by a vector, both bodies alike.
pub(super) fn carried(mut pair: [Draft; 2], [x, y]: [f64; 2]) -> [Draft; 2] {
    for body in &mut pair {
        body.position = [body.position[0] + x, body.position[1] + y];
    }
    pair
}

/// The body as a scene may hold it: an AABB loses its angle and its spin.
pub(super) fn without_spin_of_aabb(mut body: Draft) -> Draft {
    if matches!(body.shape, Shape::Aabb(_)) {
        (body.spin, body.angle) = (0.0, 0.0);
    }
    body
}
