//! What a question gives: its bodies in words, every number exactly as the scene has it.
//!
//! Nobody can work out three digits from numbers that were rounded to three, so none is.

use std::fmt::Write;

use crate::geometry::shape::KINDS;
use crate::geometry::{Angle, Body, DVec2};
use crate::scene::Scene;

/// Vertices that are listed; more are on the picture only.
const MOST_VERTICES: usize = 12;

/// The bodies of a scene's question, a sentence each, as words.
pub(super) fn givens(scene: &Scene) -> String {
    let bodies: Vec<_> = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i)).collect();
    let mut text: Vec<String> = bodies.iter().map(|(name, body)| body_in_words(&name.value, body)).collect();
    if bodies.iter().any(|(_, body)| body.velocity != DVec2::ZERO || !body.spin.is_zero()) {
        text.push("The motion runs from t = 0 to t = 1.".to_owned());
    } else if scene.query.time != 0.0 {
        text.push(format!("The moment is t = {}.", number(scene.query.time)));
    }
    text.join(" ")
}

/// A body in a sentence: its kind, its size, where it is at t = 0, how it moves.
fn body_in_words(name: &str, body: &Body) -> String {
    let shape = &body.shape;
    let kind = KINDS.iter().find(|kind| kind.name == shape.kind).map_or(shape.kind, |kind| kind.in_words);
    let mut text = format!("{name} is {kind}");
    match (shape.half_extents, shape.vertices.len()) {
        (Some(h), _) => {
            let _ = write!(text, " of {} by {}", number(2.0 * h.x), number(2.0 * h.y));
        }
        (None, 2..=MOST_VERTICES) => {
            let vertices: Vec<String> = shape.vertices.iter().map(|&v| point(v)).collect();
            let _ = write!(text, " with the vertices {}", vertices.join(", "));
        }
        (None, count) if count > MOST_VERTICES => {
            let _ = write!(text, " of {count} vertices");
        }
        (None, _) => {}
    }
    if shape.radius > 0.0 {
        let _ = write!(text, " of radius {}", number(shape.radius));
    }
    let shifted = shape.vertices.len() > 1 && shape.half_extents.is_none();
    match (shifted, middle(body)) {
        (true, place) if place == DVec2::ZERO => {}
        (true, place) => {
            let _ = write!(text, ", moved by {}", point(place));
        }
        (false, place) => {
            let _ = write!(text, " at {}", point(place));
        }
    }
    text.push_str(&turned(body));
    if body.velocity != DVec2::ZERO {
        let _ = write!(text, ", moving by {}", point(body.velocity));
    }
    if !body.spin.is_zero() {
        let _ = write!(text, ", turning by {}", angle(body.spin));
    }
    text.push('.');
    text
}

/// Where the body is: of a circle or box the middle, else the origin.
fn middle(body: &Body) -> DVec2 {
    match body.shape.vertices[..] {
        // A circle may lie beside its body's origin.
        [center] if center != DVec2::ZERO => body.pose_at(0.0).point(center),
        _ => body.position,
    }
}

/// How a body is turned at the start, as ", turned by 30°"; empty where it is not.
fn turned(body: &Body) -> String {
    let mut text = String::new();
    if !body.angle.is_zero() {
        let _ = write!(text, ", turned by {}", angle(body.angle));
    }
    let (cos, sin) = (body.shape.matrix.cos, body.shape.matrix.sin);
    if !body.shape.is_as_written() {
        let _ = write!(text, ", turned by the angle of cosine {} and sine {}", number(cos), number(sin));
    }
    text
}

/// An angle as the scene has it.
fn angle(angle: Angle) -> String {
    match angle {
        Angle::Degrees(degrees) => format!("{}°", number(degrees)),
        Angle::Radians(radians) => format!("{} rad", number(radians)),
    }
}

/// A point as `(x, y)`.
fn point(p: DVec2) -> String {
    format!("({}, {})", number(p.x), number(p.y))
}

/// A number with all its digits and a real minus sign.
pub(super) fn number(x: f64) -> String {
    format!("{}", x + 0.0).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    fn given(shapes: &str) -> String {
        let text = format!("{shapes}\nquery = {{ kind = 'motion-bound', of = ['A'] }}");
        givens(&open_text("s.toml", &text).unwrap().scene)
    }

    #[test]
    fn every_number_is_given_as_the_scene_has_it() {
        assert_eq!(
            given("shapes.A = { kind = 'box', half_extents = [1, 0.625], position = [-0.125, 3] }"),
            "A is a box of 2 by 1.25 at (−0.125, 3)."
        );
        assert_eq!(
            given("shapes.A = { kind = 'circle', radius = 1.0625, velocity = [2, 0] }"),
            "A is a circle of radius 1.0625 at (0, 0), moving by (2, 0). The motion runs from t = 0 to t = 1."
        );
        let polygon = given(
            "shapes.A = { kind = 'polygon', vertices = [[0, 0], [3, 0], [0, 4]], rotation = [0.6, 0.8] }",
        );
        assert_eq!(
            polygon,
            "A is a convex polygon with the vertices (0, 0), (3, 0), (0, 4), turned by the angle of cosine \
             0.6 and sine 0.8."
        );
        assert!(given("shapes.A = { kind = 'aabb', half_extents = [1, 1] }").contains("of 2 by 2 at (0, 0)"));
    }
}
