//! A body in words: its kind, its size, where it is at the start, how it moves.
//!
//! Every place is one that the scene has: a body with vertices of its own is told by them, as seen from its
//! origin, about which it turns.

use crate::geometry::shape::{Edges, KINDS};
use crate::geometry::{Body, DVec2, Rotation, Shape};

use crate::trace::Phrase;

use super::body_phrases::{
    ABOUT_ORIGIN, AT, FROM_TO, IS, MOVED, MOVING, OF_RADIUS, OF_SIZE, POINT, REGULAR, ROTATION, SEGMENT,
    SPANNING, TURNED, TURNING,
};
use super::number::Speech;

/// What has no size at all, and what has no width.
static WITHOUT_WIDTH: [&Phrase; 2] = [&POINT, &SEGMENT];

/// The kind of a body with its article.
pub(super) fn kind_in_words(body: &Body, speech: Speech) -> &'static str {
    let shape = &body.shape;
    let is_bare = shape.radius == 0.0 && shape.half_extents.is_none();
    let bare = shape.vertices.len().checked_sub(1).and_then(|more| WITHOUT_WIDTH.get(more));
    if let Some(kind) = bare.filter(|_| is_bare) {
        return speech.0.word(*kind);
    }
    let known = KINDS.iter().find(|kind| kind.name == shape.kind);
    known.map_or(shape.kind, |kind| speech.0.word(&kind.in_words))
}

/// A body in a sentence.
pub(super) fn body_in_words(name: &str, body: &Body, speech: Speech) -> String {
    let say = |phrase, value: String| speech.say(phrase, &[&value]);
    let mut text = speech.say(&IS, &[name, kind_in_words(body, speech)]) + &size(body, speech);
    if body.shape.radius > 0.0 {
        text += &say(&OF_RADIUS, speech.value(body.shape.radius));
    }
    text += &place(body, speech);
    if body.angle_at(0.0) != 0.0 {
        text += &say(&TURNED, speech.value(body.angle_at(0.0)) + "°");
    }
    if !body.shape.is_as_written() {
        let Rotation { cos, sin } = body.shape.matrix;
        text += &say(&ROTATION, speech.vector(DVec2::new(cos, sin)));
    }
    if body.velocity != DVec2::ZERO {
        text += &say(&MOVING, speech.vector(body.velocity));
    }
    if !body.spin.is_zero() {
        text += &say(&TURNING, speech.value(body.spin.degrees()) + "°");
        text += if is_centered(body) { "" } else { speech.0.word(&ABOUT_ORIGIN) };
    }
    text + "."
}

/// How large the core of a body is, in its own frame.
fn size(body: &Body, speech: Speech) -> String {
    let shape = &body.shape;
    let count = corners(shape).to_string();
    if let Some(h) = shape.half_extents {
        return speech.say(&OF_SIZE, &[&speech.value(2.0 * h.x), &speech.value(2.0 * h.y)]);
    }
    if let Some(circumradius) = shape.circumradius {
        return speech.say(&REGULAR, &[&count, &speech.value(circumradius)]);
    }
    match shape.vertices[..] {
        [] | [_] => String::new(),
        [from, to] => speech.say(&FROM_TO, &[&speech.point(from), &speech.point(to)]),
        [first, ..] => {
            let (least, most) =
                shape.vertices.iter().fold((first, first), |(least, most), &p| (least.min(p), most.max(p)));
            let [width, height] = (most - least).to_array().map(|x| speech.value(x));
            speech.say(&SPANNING, &[&count, &width, &height, &speech.point(least), &speech.point(most)])
        }
    }
}

/// How many vertices a shape has: those of the file, or of their hull where the shape is that.
pub(in crate::figure) fn corners(shape: &Shape) -> usize {
    if shape.edges == Edges::OfHull { shape.core.len() } else { shape.vertices.len() }
}

/// Whether the scene says of a body where its middle is, and that is its origin.
fn is_centered(body: &Body) -> bool {
    let shape = &body.shape;
    shape.half_extents.is_some() || shape.circumradius.is_some() || shape.vertices[..] == [DVec2::ZERO]
}

/// Where a body is at the start.
fn place(body: &Body, speech: Speech) -> String {
    let origin = body.pose_at(0.0).position;
    match body.shape.vertices[..] {
        _ if is_centered(body) => speech.say(&AT, &[&speech.point(origin)]),
        // A circle may lie beside its body's origin.
        [center] => speech.say(&AT, &[&speech.point(body.pose_at(0.0).point(center))]),
        _ if origin == DVec2::ZERO => String::new(),
        _ => speech.say(&MOVED, &[&speech.point(origin)]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    /// The sentence of a body with these keys.
    fn told(keys: &str) -> String {
        let text = format!("shapes.it = {{ {keys} }}\nquery = {{ kind = 'bounds', of = ['it'] }}");
        let scene = open_text("body.toml", &text).unwrap().scene;
        body_in_words("it", &scene.shapes[0].1, Speech::of(&scene))
    }

    #[test]
    fn a_body_is_told_by_the_places_that_the_scene_has() {
        for (keys, words) in [
            (
                "kind = 'capsule', points = [[0, 0], [3, 0]], radius = 0.1, position = [1, 1], \
                 angular_velocity_deg = 90",
                "a capsule from (0, 0) to (3, 0) of radius 0.1, as seen from its origin at (1, 1), turning \
                 by 90° about its origin",
            ),
            (
                "kind = 'regular-polygon', edges = 7, circumradius = 1.5, position = [0, 5]",
                "a regular polygon with 7 edges, circumradius 1.5 at (0, 5)",
            ),
            (
                "kind = 'polygon', vertices = [[-1, 0], [3, -1], [2, 2]], angle_deg = 30",
                "a convex polygon of 3 vertices, spanning 4 by 3 from (-1, -1) to (3, 2), turned by 30°",
            ),
            (
                "kind = 'polygon', hull = true, vertices = [[0, 0], [2, 0], [1, 1], [2, 2], [0, 2]]",
                "a convex polygon of 4 vertices, spanning 2 by 2 from (0, 0) to (2, 2)",
            ),
            (
                "kind = 'box', half_extents = [2, 1], rotation = [0.8, 0.6]",
                "a box of 4 by 2 at (0, 0), turned by 36.9° (rotation (0.8, 0.6))",
            ),
            ("kind = 'circle', radius = 0, position = [2, 1]", "a point at (2, 1)"),
            (
                "kind = 'circle', radius = 1, center = [2, 0], position = [1, 1]",
                "a circle of radius 1 at (3, 1)",
            ),
            ("kind = 'capsule', points = [[0, 0], [1, 0]], radius = 0", "a segment from (0, 0) to (1, 0)"),
            (
                "kind = 'box', half_extents = [1, 0.5], position = [1, 0], angular_velocity_deg = 9",
                "a box of 2 by 1 at (1, 0), turning by 9°",
            ),
        ] {
            assert_eq!(told(keys), format!("it is {}.", words.replace("(-1, -1)", "(−1, −1)")));
        }
    }
}
