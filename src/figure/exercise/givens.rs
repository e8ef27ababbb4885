//! What a question gives: its bodies in words, every number exactly as the scene has it.
//!
//! Nobody can work out three digits from numbers that were rounded to three, so none is.

use crate::figure::describe::body::corners;
use crate::figure::describe::body_phrases::{
    AND, AT, FROM_TO, IS, MOVED, OF_RADIUS, OF_SIZE, POINT, SEGMENT,
};
use crate::geometry::shape::KINDS;
use crate::geometry::{Angle, Body, DVec2, Names, Side};
use crate::scene::{Scene, Spanned};

use super::phrases::{
    DOES, HULL_OF, MOMENT, MOTION, MOVES, OF_VERTICES, REGULAR, TURNED_BY_SINE, TURNED_LEFT, TURNED_RIGHT,
    TURNS_LEFT, TURNS_RIGHT, WITH_VERTICES, Words,
};

/// Vertices that are listed; more are on the picture only.
const MOST_VERTICES: usize = 12;

/// The bodies of a scene's question, a sentence each, as words; they are called `names`.
pub(super) fn givens(scene: &Scene, names: &Names) -> String {
    let words = Words::of(scene);
    let bodies: Vec<_> = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i)).collect();
    let in_words =
        |(side, (_, body)): (Side, &&(Spanned<String>, Body))| body_in_words(names.of(side), body, words);
    let mut text: Vec<String> = Side::BOTH.into_iter().zip(&bodies).map(in_words).collect();
    if bodies.iter().any(|(_, body)| body.moves()) {
        text.push(words.word(&MOTION).to_owned());
    } else if scene.query.time != 0.0 {
        text.push(words.say(&MOMENT, &[&words.number(scene.query.time)]));
    }
    text.join(" ")
}

/// A body in a sentence: its kind, its size, where it is at t = 0, how it moves.
fn body_in_words(name: &str, body: &Body, words: Words) -> String {
    let shape = &body.shape;
    let is_bare = shape.radius == 0.0 && shape.half_extents.is_none();
    let kind = match shape.vertices.len() {
        1 if is_bare => words.word(&POINT),
        2 if is_bare => words.word(&SEGMENT),
        _ => {
            let kind = KINDS.iter().find(|kind| kind.name == shape.kind);
            kind.map_or(shape.kind, |kind| words.word(&kind.in_words))
        }
    };
    let mut text = words.say(&IS, &[name, kind]);
    text.push_str(&core(body, words));
    if shape.radius > 0.0 {
        text.push_str(&words.say(&OF_RADIUS, &[&words.number(shape.radius)]));
    }
    let is_of_points = shape.half_extents.is_none() && shape.circumradius.is_none();
    let shifted = shape.vertices.len() > 1 && is_of_points;
    match (shifted, middle(body)) {
        (true, place) if place == DVec2::ZERO => {}
        (true, place) => text.push_str(&words.say(&MOVED, &[&words.point(place)])),
        (false, place) => text.push_str(&words.say(&AT, &[&words.point(place)])),
    }
    text.push_str(&turned(body, words));
    text.push('.');
    if let Some(does) = motion(body, words) {
        text.push(' ');
        text.push_str(&words.say(&DOES, &[name, &does]));
    }
    text
}

/// What a body does that moves; `None` where it rests.
fn motion(body: &Body, words: Words) -> Option<String> {
    let moves = (body.velocity != DVec2::ZERO).then(|| words.say(&MOVES, &[&words.point(body.velocity)]));
    let turns = (!body.spin.is_zero()).then(|| {
        let phrase = if body.spin.degrees() < 0.0 { &TURNS_RIGHT } else { &TURNS_LEFT };
        words.say(phrase, &[&size(body.spin, words)])
    });
    match (moves, turns) {
        (Some(moves), Some(turns)) => Some(words.say(&AND, &[&moves, &turns])),
        (moves, turns) => moves.or(turns),
    }
}

/// How large a body is without its radius: half-extents, circumradius or vertices.
fn core(body: &Body, words: Words) -> String {
    let shape = &body.shape;
    if let Some(h) = shape.half_extents {
        return words.say(&OF_SIZE, &[&words.number(2.0 * h.x), &words.number(2.0 * h.y)]);
    }
    if let Some(circumradius) = shape.circumradius {
        return words.say(&REGULAR, &[&shape.vertices.len().to_string(), &words.number(circumradius)]);
    }
    match shape.vertices[..] {
        [] | [_] => String::new(),
        [from, to] => words.say(&FROM_TO, &[&words.point(from), &words.point(to)]),
        _ if shape.vertices.len() <= MOST_VERTICES => {
            let vertices: Vec<String> = shape.vertices.iter().map(|&v| words.point(v)).collect();
            let phrase = if shape.is_in_order() { &WITH_VERTICES } else { &HULL_OF };
            words.say(phrase, &[&vertices.join(words.tongue.between())])
        }
        _ => words.say(&OF_VERTICES, &[&corners(shape).to_string()]),
    }
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
fn turned(body: &Body, words: Words) -> String {
    let mut text = String::new();
    if !body.angle.is_zero() {
        let phrase = if body.angle.degrees() < 0.0 { &TURNED_RIGHT } else { &TURNED_LEFT };
        text.push_str(&words.say(phrase, &[&size(body.angle, words)]));
    }
    let [cos, sin] = [body.shape.matrix.cos, body.shape.matrix.sin].map(|x| words.number(x));
    if !body.shape.is_as_written() {
        text.push_str(&words.say(&TURNED_BY_SINE, &[&cos, &sin]));
    }
    text
}

/// An angle as the scene has it, without its sign.
fn size(angle: Angle, words: Words) -> String {
    match angle {
        Angle::Degrees(degrees) => format!("{}°", words.number(degrees.abs())),
        Angle::Radians(radians) => format!("{} rad", words.number(radians.abs())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    fn given(shapes: &str) -> String {
        let text = format!("{shapes}\nquery = {{ kind = 'motion-bound', of = ['A'] }}");
        let scene = open_text("s.toml", &text).unwrap().scene;
        givens(&scene, &scene.names())
    }

    #[test]
    fn every_number_is_given_as_the_scene_has_it() {
        assert_eq!(
            given("shapes.A = { kind = 'box', half_extents = [1, 0.625], position = [-0.125, 3] }"),
            "A is a box of 2 by 1.25 at (−0.125, 3)."
        );
        assert_eq!(
            given("shapes.A = { kind = 'circle', radius = 1.0625, velocity = [2, 0] }"),
            "A is a circle of radius 1.0625 at (0, 0). A moves by (2, 0). The motion runs from t = 0 to \
             t = 1."
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
        let moving =
            "shapes.A = { kind = 'box', half_extents = [1, 0.25], velocity = [2.5, 0], angle_deg = 30 }";
        assert_eq!(
            given(
                "shapes.A = { kind = 'regular-polygon', edges = 5, circumradius = 1.25, position = [1, 0] }"
            ),
            "A is a regular polygon with 5 edges and circumradius 1.25, the lowest edge level, at (1, 0)."
        );
        let capsule = "kind = 'capsule', points = [[0, 0], [2, 0]], position = [1, 3], velocity = [6, -1]";
        let told = given(&format!("shapes.A = {{ {capsule}, radius = 0 }}"));
        assert!(
            told.starts_with(
                "A is a segment from (0, 0) to (2, 0), as seen from its origin at (1, 3). A moves by (6, −1)."
            ),
            "{told}"
        );
        for (lang, said) in [
            (
                "de",
                "A ist ein Rechteck von 2 mal 0,5 bei (0; 0), um 30° gegen den Uhrzeigersinn gedreht. \
                    A bewegt sich um (2,5; 0). \
                    Die Bewegung geht von t = 0 bis t = 1.",
            ),
            (
                "de-CH",
                "A ist ein Rechteck von 2 mal 0.5 bei (0, 0), um 30° gegen den Uhrzeigersinn gedreht. \
                       A bewegt sich um (2.5, 0). \
                       Die Bewegung geht von t = 0 bis t = 1.",
            ),
            (
                "fr",
                "A est un rectangle de 2 sur 0,5 en (0; 0), avec une rotation de 30° dans le sens \
                    antihoraire. A se déplace de (2,5; 0). Le mouvement va de t = 0 à t = 1.",
            ),
            (
                "ja",
                "A is a box of 2 by 0.5 at (0, 0), turned by 30° counter-clockwise. A moves by (2.5, 0). The \
                    motion runs from t = 0 to t = 1.",
            ),
        ] {
            assert_eq!(given(&format!("lang = '{lang}'\n{moving}")), said);
        }
    }

    #[test]
    fn what_is_said_of_a_turned_body_holds_for_every_kind_of_it() {
        let capsule = "kind = 'capsule', points = [[0, 0], [2, 0]], radius = 1, angle_deg = 30";
        let said = |lang: &str| given(&format!("lang = '{lang}'\nshapes.A = {{ {capsule} }}"));
        assert!(
            said("fr").ends_with(", avec une rotation de 30° dans le sens antihoraire."),
            "{}",
            said("fr")
        );
        assert!(said("es").ends_with(", con un giro antihorario de 30°."), "{}", said("es"));
    }

    #[test]
    fn a_hull_is_given_by_all_its_points_and_called_a_hull() {
        let vertices = "[[0, 0], [2, 0], [1, 1], [2, 2], [0, 2]]";
        let hull = given(&format!("shapes.A = {{ kind = 'polygon', hull = true, vertices = {vertices} }}"));
        let points = "(0, 0), (2, 0), (1, 1), (2, 2), (0, 2)";
        assert_eq!(hull, format!("A is a convex polygon, the convex hull of {points}."));
        let square = "[[0, 0], [2, 0], [2, 2], [0, 2]]";
        let told = given(&format!("shapes.A = {{ kind = 'polygon', hull = true, vertices = {square} }}"));
        assert_eq!(told, "A is a convex polygon with the vertices (0, 0), (2, 0), (2, 2), (0, 2).");
    }
}
