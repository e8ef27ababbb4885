//! A right answer of our own, in the form of `solve --jsonl`: the exact one, rounded to doubles.
//!
//! It is what the tests of the checker mutate, and what `generate` prints as `expected` if asked.

use crate::check::{Feature, Setting, turning};
use crate::closest::closest;
use crate::first_contact::{Motion, Passage};
use crate::float::Real;
use crate::json::Json;
use crate::placement::Placed;
use crate::point::Point;
use crate::scene::{Kind, Scene};
use crate::separation::{Exact, separation};

/// The line that a perfect solver prints for a separation.
#[must_use]
pub fn separation_line(scene: &Scene) -> Json {
    let setting = Setting::of(scene);
    let pair = setting.pair(&scene.bodies, Real::from(scene.time));
    let exact = separation(&pair[0], &pair[1]);
    let mut result = contact(&pair, &exact);
    let ties = exact
        .ways
        .iter()
        .filter(|way| exact.separation - way.separation <= exact.separation.abs().scaled(-200))
        .count();
    result.set("ties", Json::Number(f64::from(u32::try_from(ties).unwrap_or(u32::MAX))));
    let mut fields = Json::object([("kind", Json::Text("separation".to_owned()))]);
    if let (Json::Object(to), Json::Object(from)) = (&mut fields, result) {
        to.extend(from);
    }
    Json::object([("id", scene.id.clone()), ("result", fields)])
}

/// The line that a perfect solver prints for a sweep or a time of impact: `overlapping`, `miss`, or a `hit`
/// within two neighbouring doubles. A graze that 2⁻¹¹⁰ of time does not decide is called a hit.
#[must_use]
pub fn impact_line(scene: &Scene) -> Json {
    let setting = Setting::of(scene);
    let motion = Motion::of(&scene.bodies);
    let start = motion.separation(Real::ZERO);
    let word = |word: &str| Json::Text(word.to_owned());
    let mut result = Json::object([("kind", word(scene.kind.word()))]);
    let tolerance = if scene.kind == Kind::LinearSweep { 0.0 } else { setting.least_tolerance(scene) };
    if start.separation.signum() <= 0 {
        result.set("outcome", word("overlapping"));
        let contact = contact(&motion.pair(Real::ZERO), &start);
        for key in ["separation", "separation_bounds"] {
            result.set(key, contact.get(key).cloned().unwrap_or(Json::Null));
        }
    } else {
        match motion.first_within(Real::ZERO, Real::ZERO, Real::one()) {
            Passage::Clear => {
                result.set("outcome", word("miss"));
                result.set("closest", approach(scene, &setting, &motion));
            }
            Passage::Below { after, by } | Passage::Unsettled { after, until: by } => {
                let (free, met) = (below(after), above(by));
                result.set("outcome", word("hit"));
                result.set("time", Json::Number(free));
                result.set("time_bounds", Json::from_pair([free, met]));
                let free = Real::from(free);
                if let Json::Object(fields) = contact(&motion.pair(free), &motion.separation(free)) {
                    for (key, value) in fields {
                        result.set(&key, value);
                    }
                }
            }
        }
    }
    result.set("tolerance", Json::Number(tolerance));
    Json::object([("id", scene.id.clone()), ("result", result)])
}

/// How near a miss came.
fn approach(scene: &Scene, setting: &Setting, motion: &Motion) -> Json {
    let turned = turning(scene);
    let (time, s, least) = closest(motion, turned / 360.0);
    // Above what golden sections leave; a tenth of what may be left where a body turns.
    let margin = if turned == 0.0 { Real::power_of_two(-75) } else { Real::from(1e-10) };
    let lo = below((least - margin * Real::from(setting.scale)).max(Real::ZERO));
    let value = s.to_f64();
    Json::object([
        ("time", Json::Number(time)),
        ("separation", Json::Number(value)),
        ("separation_bounds", Json::from_pair([lo.min(value), above(s).max(value)])),
    ])
}

/// The largest double not above x ≥ 0.
fn below(x: Real) -> f64 {
    let near = x.to_f64();
    if Real::from(near) > x { near.next_down() } else { near }
}

/// The least double not below x.
fn above(x: Real) -> f64 {
    let near = x.to_f64();
    if Real::from(near) < x { near.next_up() } else { near }
}

/// Separation, bounds, normal, points and features.
#[must_use]
pub fn contact(pair: &[Placed; 2], exact: &Exact) -> Json {
    let first = exact.ways.iter().find(|way| way.separation == exact.separation).map(|way| way.normal);
    let n = exact.normal.or(first).unwrap_or(Point::of([1.0, 0.0]));
    let s = exact.separation;
    // Along the faces: the middle of the common span.
    let along = n.perp();
    let spans = [span(&pair[0], n, along), span(&pair[1], n.reversed(), along)];
    let middle = (spans[0].0.max(spans[1].0) + spans[0].1.min(spans[1].1)).scaled(-1);
    let supports = [support(&pair[0], n, along, middle), support(&pair[1], n.reversed(), along, middle)];
    let core_a = at(supports[0].1, along, middle);
    let point_a = core_a.plus(n.times(pair[0].radius));
    let point_b = point_a.plus(n.times(s));
    let value = s.to_f64();
    let [lo, hi] = [value.next_down(), value.next_up()].map(Real::from);
    let bounds = match Real::from(value).cmp(&s) {
        std::cmp::Ordering::Equal => [value, value],
        std::cmp::Ordering::Less => [value, hi.to_f64()],
        std::cmp::Ordering::Greater => [lo.to_f64(), value],
    };
    let pair_of = |p: Point| Json::from_pair([p.x.to_f64(), p.y.to_f64()]);
    let feature = |i: usize| match supports[i].0 {
        Feature::Vertex(k) => Json::object([("vertex", number(k))]),
        Feature::Edge(k) => Json::object([("edge", number(k))]),
    };
    Json::object([
        ("separation", Json::Number(value)),
        ("separation_bounds", Json::from_pair(bounds)),
        ("normal", pair_of(n)),
        ("points", Json::object([("A", pair_of(point_a)), ("B", pair_of(point_b))])),
        ("features", Json::object([("A", feature(0)), ("B", feature(1))])),
    ])
}

fn number(i: usize) -> Json {
    Json::Number(f64::from(u32::try_from(i).unwrap_or(u32::MAX)))
}

/// The point of a segment whose place along a direction is the wanted one.
fn at([from, to]: [Point; 2], along: Point, place: Real) -> Point {
    let (whole, part) = (to.minus(from).dot(along), place - from.dot(along));
    if whole.is_zero() { from } else { from.plus(to.minus(from).times(part.over(whole))) }
}

/// How far a normal may be off: that of cores 1e-20 apart keeps 2⁻³²⁰ · 1e20.
fn near_normal() -> Real {
    Real::power_of_two(-150)
}

/// The vertices that are farthest along a direction.
fn farthest(body: &Placed, direction: Point) -> impl Iterator<Item = usize> {
    let reach = body.core_points().map(|p| p.dot(direction)).max().unwrap_or(Real::ZERO);
    let size = body.core_points().map(|p| p.minus(body.vertices[0]).length()).max().unwrap_or(Real::ZERO);
    let tiny = size * near_normal();
    (0..body.vertices.len()).filter(move |i| reach - body.vertices[*i].dot(direction) <= tiny)
}

/// From where to where the edge that faces a direction reaches.
fn span(body: &Placed, direction: Point, along: Point) -> (Real, Real) {
    let mut places = farthest(body, direction).map(|i| body.vertices[i].dot(along));
    let first = places.next().unwrap_or(Real::ZERO);
    places.fold((first, first), |(lo, hi), place| (lo.min(place), hi.max(place)))
}

/// The feature that faces a direction, at a place along it, with its world ends: an edge of the file where
/// one is there, else the vertex that is nearest to the place, which rounding may have put beyond the edge.
fn support(body: &Placed, direction: Point, along: Point, place: Real) -> (Feature, [Point; 2]) {
    let on_face: Vec<usize> = farthest(body, direction).collect();
    for i in 0..body.vertices.len() {
        let Some([from, to]) = body.edge(i) else { continue };
        let ends = [from, to].map(|k| body.vertices[k]);
        let [x, y] = ends.map(|p| p.dot(along));
        let holds = x != y && x.min(y) <= place && place <= x.max(y);
        if holds && on_face.contains(&from) && on_face.contains(&to) {
            return (Feature::Edge(i), ends);
        }
    }
    let off = |i: &usize| (body.vertices[*i].dot(along) - place).abs();
    let i = on_face.into_iter().min_by_key(off).unwrap_or(0);
    (Feature::Vertex(i), [body.vertices[i]; 2])
}
