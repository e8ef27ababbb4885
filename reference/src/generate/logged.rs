//! Pairs as an engine's log has them: every number a float of 32 bits, angles in radians or as the cosine and
//! sine that the engine worked with, polygons whose vertices were rounded after they were convex.

use super::draft::{Draft, Shape, direction, sign};
use super::pair::{IMPACT, SWEEP, approaching, moved_to, near_each_other, scene, spun, without_spin_of_aabb};
use crate::float::Real;
use crate::json::Json;
use crate::point::{Rotation, degrees_of, radians};
use crate::random::Random;

/// How far a matrix may have drifted from a rotation: c² + s² is within twice this of 1.
const DRIFT: f64 = 4e-4;

/// The float of 32 bits next to a number, as a double.
#[expect(clippy::cast_possible_truncation, reason = "the rounding is what it is for")]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// Every number of a value, rounded.
fn in_singles(json: &Json) -> Json {
    match json {
        Json::Number(x) => Json::Number(single(*x)),
        Json::List(items) => Json::List(items.iter().map(in_singles).collect()),
        other => other.clone(),
    }
}

/// Cosine and sine as an engine has them: of an angle in radians, rounded, after some steps without
/// normalizing.
fn matrix(random: &mut Random, angle: f64) -> Json {
    let turn = Rotation::of_degrees(degrees_of(Real::from(angle)));
    let drift = if random.once_in(4) { 1.0 + random.between(-DRIFT, DRIFT) } else { 1.0 };
    let rounded = |x: Real| {
        let x = x.to_f64() * drift;
        if random.clone().once_in(8) { x } else { single(x) }
    };
    Json::from_pair([rounded(turn.cos), rounded(turn.sin)])
}

/// A vertex in the middle of an edge, which rounding puts inside or outside of it.
fn with_middles(random: &mut Random, vertices: &Json) -> Json {
    let points: Vec<[f64; 2]> = vertices.list().iter().filter_map(Json::pair).collect();
    let mut more = Vec::new();
    for (k, &[x, y]) in points.iter().enumerate() {
        more.push(Json::from_pair([x, y]));
        let [u, v] = points[(k + 1) % points.len()];
        if random.once_in(3) {
            more.push(Json::from_pair([single(0.5 * (x + u)), single(0.5 * (y + v))]));
        }
    }
    Json::List(more)
}

/// A shape of a scene as a log has it.
fn logged_shape(random: &mut Random, shape: &Json) -> Json {
    let Json::Object(fields) = shape else { return shape.clone() };
    let mut json = Json::Object(Vec::new());
    let (mut angle, mut spin) = (None, None);
    for (key, value) in fields {
        match key.as_str() {
            "angle_deg" => angle = value.number(),
            "angular_velocity_deg" => spin = value.number(),
            "vertices" => {
                let rounded = in_singles(value);
                json.set(key, if random.once_in(2) { with_middles(random, &rounded) } else { rounded });
                json.set("hull", Json::Bool(true));
            }
            _ => json.set(key, in_singles(value)),
        }
    }
    let in_radians = |degrees: f64| radians(Real::from(degrees)).to_f64();
    if let Some(angle) = angle {
        let angle = single(in_radians(angle));
        match random.below(5) {
            0 | 1 => json.set("angle_rad", Json::Number(angle)),
            2 => json.set("angle_rad", Json::Number(angle + sign(random) * random.magnitude(1.0, 9.0))),
            _ => {
                let matrix = matrix(random, angle);
                json.set("rotation", matrix);
            }
        }
    }
    if let Some(spin) = spin {
        json.set("angular_velocity_rad", Json::Number(single(in_radians(spin))));
    }
    json
}

/// A scene as a log has it.
fn logged(random: &mut Random, kind: &str, pair: [Draft; 2], more: &[(&str, Json)]) -> Json {
    let mut json = scene(random, kind, pair, more);
    if let Some(Json::Object(shapes)) = json.get("shapes").cloned() {
        let shapes = shapes.iter().map(|(name, shape)| (name.clone(), logged_shape(random, shape))).collect();
        json.set("shapes", Json::Object(shapes));
    }
    json
}

fn shapes(random: &mut Random) -> [Shape; 2] {
    [Shape::any(random, 1.0), Shape::any(random, 1.5)]
}

pub(super) fn separation(random: &mut Random) -> Json {
    let shapes = shapes(random);
    let pair = near_each_other(random, shapes, 1.0);
    logged(random, "separation", pair, &[])
}

/// As a stack in a game: within some roundings of 32 bits of touching.
pub(super) fn resting(random: &mut Random) -> Json {
    let shapes = shapes(random);
    let pair = near_each_other(random, shapes, 1.0);
    let pair = moved_to(pair, sign(random) * random.magnitude(-8.0, -5.0));
    let kind = if random.once_in(3) { "overlap" } else { "separation" };
    logged(random, kind, pair, &[])
}

/// Two boxes turned alike, side by side: their edges are parallel exactly.
pub(super) fn stacked(random: &mut Random) -> Json {
    let half = [single(random.between(0.2, 1.0)), single(random.between(0.2, 1.0))];
    let angle = random.between(-180.0, 180.0);
    let a = Draft::still(Shape::Box(half, 0.0), [0.0, 0.0], angle);
    let b = Draft::still(Shape::Box([half[1], half[0]], 0.0), [0.0, 0.0], angle);
    let mut json = logged(random, "separation", [a, b], &[]);
    let turn = matrix(random, angle);
    let Some([c, s]) = turn.pair() else { return json };
    let mut shapes = json.get("shapes").cloned().unwrap_or(Json::Null);
    for name in ["A", "B"] {
        let Some(Json::Object(fields)) = shapes.get(name).cloned() else { continue };
        let mut shape = Json::Object(fields.into_iter().filter(|(key, _)| key != "angle_rad").collect());
        shape.set("rotation", turn.clone());
        if name == "B" {
            let up = if random.once_in(2) { half[1] + half[0] } else { random.between(0.0, 2.0) };
            let aside = single(random.between(-0.5, 0.5));
            shape.set("position", Json::from_pair([c * aside - s * up, s * aside + c * up]));
        }
        shapes.set(name, shape);
    }
    json.set("shapes", shapes);
    json
}

pub(super) fn bounds(random: &mut Random) -> Json {
    let shapes = shapes(random);
    let pair = near_each_other(random, shapes, 1.0);
    let pair = pair.map(|body| body.moving(direction(random, 1.0), 0.0));
    let pair = spun(random, pair, 500.0);
    logged(random, "bounds", pair, &[("time", Json::Number(random.clone().unit()))])
}

pub(super) fn motion_bound(random: &mut Random) -> Json {
    let shapes = shapes(random);
    let pair = near_each_other(random, shapes, 1.0);
    let pair = pair.map(|body| without_spin_of_aabb(body.moving(direction(random, 1.0), 0.0)));
    let pair = spun(random, pair, 500.0);
    logged(random, "motion-bound", pair, &[])
}

pub(super) fn sweep(random: &mut Random) -> Json {
    let shapes = shapes(random);
    let pair = approaching(random, shapes, 1.0);
    logged(random, SWEEP, pair, &[])
}

pub(super) fn impact(random: &mut Random) -> Json {
    let shapes = shapes(random);
    let pair = approaching(random, shapes, 1.0);
    let pair = spun(random, pair, 500.0);
    logged(random, IMPACT, pair, &[])
}
