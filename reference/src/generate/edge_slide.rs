//! Cases of bodies that slide along a turned edge of the other one, and come nearer by next to nothing.
//!
//! With an edge along the unit vector e and its normal n, the relative velocity is
//!
//! v = speed (±e − share n), share = 0 or 10^−16 to 10^−6.
//!
//! The time of contact is a gap over the closing speed −n · v, in which n and v cancel but for the share: an
//! error term that is nothing beside the speed is all of the answer here.

use super::draft::{Draft, Shape, sign};
use super::pair::{IMPACT, SWEEP, asked};
use crate::float::Real;
use crate::json::Json;
use crate::placement::{Placed, convex_core};
use crate::point::{Point, Rotation, degrees_of, radians};
use crate::random::Random;
use crate::scene::Body;

/// How a scene may write an angle.
#[derive(Clone, Copy)]
enum Form {
    Degrees,
    Radians,
    Matrix,
}

const FORMS: [Form; 4] = [Form::Degrees, Form::Degrees, Form::Radians, Form::Matrix];

/// A body as a scene writes it, its angle in a form.
fn written(body: &Draft, form: Form) -> Json {
    let turned = body.json().get("angle_deg").and_then(Json::number);
    let (Some(angle), Form::Radians | Form::Matrix) = (turned, form) else { return body.json() };
    let mut json = Draft { angle: 0.0, ..body.clone() }.json();
    let angle = radians(Real::from(angle)).to_f64();
    match form {
        Form::Matrix => {
            let turn = Rotation::of_degrees(degrees_of(Real::from(angle)));
            json.set("rotation", Json::from_pair([turn.cos.to_f64(), turn.sin.to_f64()]));
        }
        _ => json.set("angle_rad", Json::Number(angle)),
    }
    json
}

/// The body at t = 0.
fn placed(json: &Json) -> Option<Placed> {
    let body = Body::read(json).ok()?;
    Some(Placed::at(&body, &convex_core(&body.vertices), Real::ZERO))
}

/// A body with edges, of about a size; half of them are round.
fn wall(random: &mut Random, size: f64) -> Shape {
    let half = [size * random.between(0.2, 1.0), size * random.between(0.2, 1.0)];
    let radius = if random.once_in(2) { 0.0 } else { size * random.between(0.01, 0.3) };
    if random.once_in(2) {
        return Shape::Box(half, radius);
    }
    let vertices = 3 + random.below(9);
    Shape::polygon(random, vertices, half, radius)
}

/// The way of the slider past the wall, and where it would touch.
struct Slide {
    /// Relative velocity.
    velocity: Point,
    /// Normal of the edge, out of the wall.
    normal: Point,
    /// Place on the wall's edge, its radius left out.
    at: Point,
}

/// A slide along any edge of the wall, `reach` long.
fn slide(random: &mut Random, wall: &Placed, reach: f64) -> Option<Slide> {
    let core: Vec<Point> = wall.core_points().collect();
    let k = random.below(core.len());
    let edge = core.get((k + 1) % core.len())?.minus(*core.get(k)?);
    let at = core[k].plus(edge.times(Real::from(random.between(0.05, 0.95))));
    let (e, normal) = (edge.unit(), edge.unit().perp().reversed());
    let way = sign(random);
    let speed = reach * random.between(0.1, 3.0);
    // Parts with the edge one time in eight.
    let closes = if random.once_in(8) { -1.0 } else { 1.0 };
    let share = if random.once_in(8) { 0.0 } else { closes * random.magnitude(-16.0, -6.0) };
    let across = normal.times(Real::from(share));
    let velocity = e.times(Real::from(way)).minus(across).times(Real::from(speed));
    Some(Slide { velocity, normal, at })
}

/// A vector in doubles.
fn rounded(p: Point) -> [f64; 2] {
    [p.x.to_f64(), p.y.to_f64()]
}

/// The slider, so that at a time within the motion or a little later its lowest point is on the edge, give or
/// take a gap.
fn set_on_its_way(random: &mut Random, slider: &mut Json, wall: &Placed, slide: &Slide) -> Option<()> {
    let body = placed(slider)?;
    let height = |p: &Point| p.dot(slide.normal);
    let lowest = body.core_points().reduce(|p, q| if height(&q) < height(&p) { q } else { p })?;
    let speed = slide.velocity.length().to_f64();
    let gap = match random.below(3) {
        0 => speed * random.magnitude(-16.0, -6.0),
        _ => 0.0,
    };
    let time = if random.once_in(8) { 0.0 } else { random.between(0.0, 1.2) };
    let above = slide.normal.times(body.radius + wall.radius + Real::from(gap));
    let touching = slide.at.plus(above).minus(lowest);
    slider.set("position", Json::from_pair(rounded(touching.minus(slide.velocity.times(Real::from(time))))));
    Some(())
}

/// A pair of 0.1 to 100, each.
fn pair(random: &mut Random) -> Option<[Json; 2]> {
    let sizes = [random.magnitude(-1.0, 2.0), random.magnitude(-1.0, 2.0)];
    let position = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)].map(|x| x * sizes[0]);
    let forms = [random.one_of(&FORMS), random.one_of(&FORMS)];
    let angles = [random.between(-180.0, 180.0), random.between(-180.0, 180.0)];
    // Turned alike, boxes lie flat on each other.
    let [form, angle] = if random.once_in(3) { [0, 0] } else { [1, 1] };
    let mut a = written(&Draft::still(wall(random, sizes[0]), position, angles[0]), forms[0]);
    let shape = Shape::any(random, sizes[1]);
    let mut b = written(&Draft::still(shape, [0.0, 0.0], angles[angle]), forms[form]);
    let still = placed(&a)?;
    let slide = slide(random, &still, sizes[0].max(sizes[1]))?;
    set_on_its_way(random, &mut b, &still, &slide)?;
    // Either moves, or both.
    let share = random.one_of(&[0.0, 0.0, 1.0, random.clone().unit()]);
    for (body, share) in [(&mut a, share - 1.0), (&mut b, share)] {
        if share != 0.0 {
            body.set("velocity", Json::from_pair(rounded(slide.velocity.times(Real::from(share)))));
        }
    }
    Some(if random.once_in(2) { [a, b] } else { [b, a] })
}

pub(super) fn edge_slide(random: &mut Random) -> Json {
    let kind = if random.once_in(4) { IMPACT } else { SWEEP };
    match pair(random) {
        Some(pair) => asked(random, kind, pair, &[]),
        None => super::passing::sliding(random),
    }
}
