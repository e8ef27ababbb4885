//! Sentences of answers: of names, pushes, moments and bounds.

use super::*;
use crate::figure::runs::Runs;
use crate::scene::open_text;

#[test]
fn a_letter_is_in_italics_and_a_word_or_a_number_with_the_same_letters_is_not() {
    let said = |a: &str, b: &str| {
        let text = format!(
            "shapes.{a} = {{ kind = 'circle', radius = 1 }}
            shapes.{b} = {{ kind = 'circle', radius = 1, position = [4, 0] }}
            query = {{ kind = 'separation', of = ['{a}', '{b}'] }}"
        );
        let scene = open_text("sentence.toml", &text).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, 0.0);
        let told = Account::of(&scene, &runs, &run);
        (told.sentence(), told.caption(&runs.called)[1].clone())
    };
    let (words, markup) = said("A", "a");
    assert_eq!(words, "A and a are 2 apart along the normal (1, 0).");
    assert_eq!(markup, "$A$ and $a$ are 2 apart along the normal (1, 0).");
    assert_eq!(said("apart", "B").1, "apart and $B$ are 2 apart along the normal (1, 0).");
}

/// What is said of the bodies and the question of a scene.
fn said(scene: &str) -> String {
    let scene = open_text("sentence.toml", scene).unwrap().scene;
    let runs = Runs::default();
    let run = runs.own(&scene, 0.0);
    Account::of(&scene, &runs, &run).sentence()
}

#[test]
fn bodies_as_near_to_touching_as_their_numbers_are_rounded_are_said_to_be() {
    let circles = |x: &str| {
        said(&format!(
            "shapes.bolt = {{ kind = 'circle', radius = 1 }}
            shapes.nut = {{ kind = 'circle', radius = 0.5, position = [{x}, 0.9] }}
            query = {{ kind = 'separation', of = ['bolt', 'nut'] }}"
        ))
    };
    let by = "no more than the rounding of their numbers.";
    assert_eq!(circles("1.2"), format!("bolt and nut overlap by 2.22 × 10^−17, {by}"));
    assert!(
        circles("1.2000000000000002").starts_with("bolt and nut are ")
            && circles("1.2000000000000002").ends_with(by)
    );
    assert!(circles("1.20000000000001").contains(" along the normal "));
}

#[test]
fn a_way_as_near_as_its_numbers_are_rounded_is_said_to_be() {
    let past = |y: &str| {
        said(&format!(
            "shapes.ball = {{ kind = 'circle', radius = 0.3, position = [-2, {y}], velocity = [4, 0] }}
            shapes.box = {{ kind = 'box', half_extents = [0.8, 1] }}
            query = {{ kind = 'linear-sweep', of = ['ball', 'box'] }}"
        ))
    };
    let by = "5.55 × 10^−17 apart, no more than the rounding of their numbers.";
    assert!(past("1.3").ends_with(by), "{}", past("1.3"));
    assert!(past("1.4").ends_with("0.1 apart."), "{}", past("1.4"));
}

#[test]
fn edges_that_face_each_other_are_apart_edge_to_edge() {
    let book = |x: &str| {
        said(&format!(
            "shapes.shelf = {{ kind = 'box', half_extents = [2, 0.3] }}
            shapes.book = {{ kind = 'box', half_extents = [0.4, 0.7], position = [{x}, 1.4] }}
            query = {{ kind = 'separation', of = ['shelf', 'book'] }}"
        ))
    };
    assert_eq!(book("1.9"), "shelf and book are 0.4 apart along the normal (0, 1), edge to edge.");
    assert!(!book("2.9").contains("edge"), "{}", book("2.9"));
}

#[test]
fn a_touch_of_vertices_has_several_normals() {
    let boxes = |y: &str| {
        said(&format!(
            "shapes.a = {{ kind = 'box', half_extents = [1, 1] }}
            shapes.b = {{ kind = 'box', half_extents = [1, 1], position = [2, {y}] }}
            query = {{ kind = 'separation', of = ['a', 'b'] }}"
        ))
    };
    assert_eq!(boxes("2"), "a and b touch; (1, 0) is one of several normals.");
    assert_eq!(boxes("0.5"), "a and b touch.");
}

/// A box on the floor, 0.5 deep in it, in a question about both.
fn on_the_floor(query: &str) -> String {
    format!(
        "shapes.crate = {{ kind = 'aabb', half_extents = [1, 1], position = [0, 0.5] }}
        shapes.floor = {{ kind = 'aabb', half_extents = [4, 1], position = [0, -1] }}
        query = {{ {query} }}"
    )
}

#[test]
fn a_push_names_the_body_that_goes_and_where_to() {
    let pushed = |way: &str| format!("overlap; the shortest push that parts them moves {way}");
    let separation = said(&on_the_floor("kind = 'separation', of = ['crate', 'floor']"));
    assert_eq!(separation, format!("crate and floor {}.", pushed("floor by 0.5 along (0, −1)")));
    let overlap = said(&on_the_floor("kind = 'overlap', of = ['floor', 'crate']"));
    assert_eq!(overlap, format!("floor and crate {}.", pushed("crate by 0.5 along (0, 1)")));
    let swept = on_the_floor("kind = 'linear-sweep', of = ['floor', 'crate']");
    assert!(said(&swept).starts_with("floor and crate overlap from the start; "), "{}", said(&swept));
}

#[test]
fn a_contact_pushes_the_body_that_the_reference_edge_faces_along_the_normal_that_is_drawn() {
    for of in ["'crate', 'floor'", "'floor', 'crate'"] {
        let text = on_the_floor(&format!("kind = 'contact', of = [{of}]"));
        let scene = open_text("contact.toml", &text).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, 0.0);
        let drawn = run.events().find_map(|event| match event {
            Event::EdgesFaced { body, normal, .. } => Some((*body, Speech::ENGLISH.vector(*normal))),
            _ => None,
        });
        let (reference, normal) = drawn.unwrap();
        let pushed = scene.names().of(reference.other()).to_owned();
        let said = Account::of(&scene, &runs, &run).sentence();
        assert!(said.contains(&format!("moves {pushed} by 0.5 along {normal}. ")), "{of}: {said}");
        assert!(said.ends_with("There are two points of contact."), "{said}");
    }
}

#[test]
fn of_several_shortest_pushes_one_is_told_as_one_of_them() {
    for (vertices, pushes) in [
        ("[[-2, -1], [2, -1], [2, 1], [-2, 1]]", "one of the 2 shortest pushes that part them moves b"),
        ("[[2, 0], [0, 2], [-2, 0], [0, -2]]", "one of the 4 shortest pushes that part them moves b"),
        ("[[2, 0], [0, 2], [-2, -1]]", "the shortest push that parts them moves b"),
    ] {
        let said = said(&format!(
            "shapes.a = {{ kind = 'polygon', vertices = {vertices} }}
            shapes.b = {{ kind = 'circle', radius = 0.25 }}
            query = {{ kind = 'separation', of = ['a', 'b'] }}"
        ));
        assert!(said.starts_with(&format!("a and b overlap; {pushes} by ")), "{said}");
    }
    // Beside a vertex the edges that meet there are as near, as lines, and no way out.
    for place in ["[2.25, 1.25]", "[-2.25, 1.25]", "[0, 1.375]"] {
        let beside = said(&format!(
            "shapes.a = {{ kind = 'box', half_extents = [2, 1] }}
            shapes.b = {{ kind = 'circle', radius = 0.5, position = {place} }}
            query = {{ kind = 'separation', of = ['a', 'b'] }}"
        ));
        assert!(beside.contains("the shortest push that parts them"), "{beside}");
    }
    // The vertices of a pentagon are rounded, so that no two ways are exactly as long.
    let pentagon = said(
        "shapes.a = { kind = 'regular-polygon', edges = 5, circumradius = 2 }
        shapes.b = { kind = 'circle', radius = 0.25 }
        query = { kind = 'overlap', of = ['a', 'b'] }",
    );
    assert!(pentagon.contains("one of the 5 shortest pushes that part them"), "{pentagon}");
}

#[test]
fn undecided_bodies_that_overlap_in_the_end_are_said_to() {
    let far = |x: f64| {
        said(&format!(
            "shapes.a = {{ kind = 'box', half_extents = [1, 0.5], velocity = [{x}, 0],
                position = [-3, 0], angular_velocity_deg = 90 }}
            shapes.b = {{ kind = 'circle', radius = 1, position = [1.5, 0.5] }}
            query = {{ kind = 'time-of-impact', of = ['a', 'b'], max_iterations = 1,
                algorithm = 'conservative-advancement' }}"
        ))
    };
    let overlap = far(4.0);
    assert!(overlap.contains(" and overlap by 1 at t = 1; when they first touch is undecided"), "{overlap}");
    assert!(far(2.5).contains("; whether they touch is undecided"), "{}", far(2.5));
}

#[test]
fn a_verdict_says_how_far_apart_and_touching_is_not_overlapping() {
    let beside = |x: f64| {
        said(&format!(
            "shapes.a = {{ kind = 'circle', radius = 1 }}
            shapes.b = {{ kind = 'circle', radius = 1, position = [{x}, 0] }}
            query = {{ kind = 'overlap', of = ['a', 'b'] }}"
        ))
    };
    assert_eq!(beside(4.0), "a and b do not overlap: they are 2 apart.");
    assert_eq!(beside(2.0), "a and b touch.");
}

#[test]
fn concentric_circles_are_parted_in_any_direction() {
    let text = "shapes.a = { kind = 'circle', radius = 1 }
        shapes.b = { kind = 'circle', radius = 2 }
        query = { kind = 'separation', of = ['a', 'b'] }";
    assert!(said(text).ends_with(" moves b by 3 in any direction, as along (1, 0)."), "{}", said(text));
}

#[test]
fn a_bound_is_said_no_smaller_than_it_is() {
    let text = "shapes.a = { kind = 'box', half_extents = [3, 1], angular_velocity_deg = 111 }
        query = { kind = 'motion-bound', of = ['a'] }";
    // √10 · 111° = 6.1263…
    assert_eq!(said(text), "No point of a travels farther than 6.13.");
    // A velocity of √26 = 5.0990… and a turn of √2.5 · 120° = 3.3115….
    let text = "shapes.a = { kind = 'box', half_extents = [1.5, 0.5], velocity = [5, 1],
            angular_velocity_deg = 120 }
        query = { kind = 'motion-bound', of = ['a'] }";
    let expected =
        "No point of a travels farther than 8.411: 5.099 with the velocity and at most 3.312 with the turn.";
    assert_eq!(said(text), expected);
}

#[test]
fn a_motion_that_ends_while_the_bodies_come_nearer_is_said_to_end() {
    let passed = |velocity: &str| {
        said(&format!(
            "shapes.a = {{ kind = 'circle', radius = 1, velocity = {velocity} }}
            shapes.b = {{ kind = 'circle', radius = 1, position = [4, 3] }}
            query = {{ kind = 'linear-sweep', of = ['a', 'b'] }}"
        ))
    };
    let cases = [
        ("[1, 0]", "; the motion ends at t = 1 while they still come nearer, 2.24 apart."),
        ("[8, 0]", "; they come closest at t = 0.5, 1 apart."),
        ("[-8, 0]", "; they are closest at the start, 3 apart."),
    ];
    for (velocity, expected) in cases {
        let said = passed(velocity);
        assert_eq!(said, format!("a and b do not touch{expected}"), "{velocity}");
    }
}

#[test]
fn a_body_that_turns_and_comes_as_near_again_is_said_to() {
    let turning = |b: &str| {
        said(&format!(
            "shapes.a = {{ kind = 'circle', radius = 1 }}
            shapes.b = {{ position = [0, 2.7], {b} }}
            query = {{ kind = 'time-of-impact', of = ['a', 'b'] }}"
        ))
    };
    let again = turning("kind = 'box', half_extents = [1.4, 0.5], angular_velocity_deg = 360");
    assert!(again.contains("; they come closest more than once, as at t = 0."), "{again}");
    let disc = turning("kind = 'circle', radius = 1, angular_velocity_deg = 90");
    assert_eq!(disc, "a and b do not touch; they stay 0.7 apart.");
}

/// The first was told to come "closest at t = 0.650, 0 … 336 apart", which it does not.
#[test]
fn a_miss_whose_least_distance_is_not_proved_is_told_as_far_as_it_is() {
    let fast = "angular_velocity_deg";
    let text = |lang: &str| {
        said(&format!(
            "lang = '{lang}'
            shapes.a = {{ kind = 'box', half_extents = [1, 0.05], {fast} = 2000 }}
            shapes.b = {{ kind = 'box', half_extents = [1, 0.05], position = [30, 0], {fast} = -3000 }}
            query = {{ kind = 'time-of-impact', of = ['a', 'b'] }}"
        ))
    };
    let english = text("en");
    assert!(english.starts_with("a and b do not touch; they come as near as 28.0"), "{english}");
    assert!(english.ends_with(", and never nearer than 27.9."), "{english}");
    assert!(text("de").contains("; sie kommen sich bis auf 28,0"), "{}", text("de"));
}

#[test]
fn bodies_that_go_alike_stay_as_they_are() {
    let text = "shapes.a = { kind = 'circle', radius = 1, velocity = [1, 2] }
        shapes.b = { kind = 'circle', radius = 1, position = [4, 3], velocity = [1, 2] }
        query = { kind = 'time-of-impact', of = ['a', 'b'] }";
    assert_eq!(said(text), "a and b do not touch; they stay 3 apart.");
}

#[test]
fn a_later_moment_is_said_with_what_is_so_then() {
    let text = |kind: &str| {
        format!(
            "shapes.a = {{ kind = 'circle', radius = 1, velocity = [1, 0] }}
            shapes.b = {{ kind = 'circle', radius = 1, position = [4, 0] }}
            query = {{ kind = '{kind}', of = ['a', 'b'], time = 0.5 }}"
        )
    };
    let said = |kind: &str| {
        let scene = open_text("later.toml", &text(kind)).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, 0.5);
        let told = Account::of(&scene, &runs, &run);
        (told.sentence(), told.result())
    };
    let apart = "a and b are 1.5 apart along the normal (1, 0).";
    assert_eq!(said("separation"), (format!("At t = 0.5 {apart}"), format!("at t = 0.5 {apart}")));
    assert_eq!(said("overlap").0, "At t = 0.5 a and b do not overlap: they are 1.5 apart.");
}

#[test]
fn the_bound_of_two_bodies_is_of_their_ways_together() {
    let text = "shapes.a = { kind = 'circle', radius = 1, velocity = [3, 0] }
        shapes.b = { kind = 'circle', radius = 1, position = [4, 3], velocity = [-2, 0] }
        query = { kind = 'motion-bound', of = ['a', 'b'] }";
    assert_eq!(said(text), "No two points of a and b come nearer to each other by more than 5.");
    let text = "shapes.a = { kind = 'circle', radius = 1, velocity = [3, 0], angular_velocity_rad = 2 }
        shapes.b = { kind = 'circle', radius = 1, position = [4, 3], angular_velocity_rad = -1.5 }
        query = { kind = 'motion-bound', of = ['a', 'b'] }";
    let expected = "No two points of a and b come nearer to each other by more than 6.5: \
        3 with the velocities and at most 3.5 with the turns.";
    assert_eq!(said(text), expected);
}

#[test]
fn phrases_have_as_many_values_in_every_language() {
    assert_eq!(crate::trace::unlike(super::super::all_phrases()), [&[""; 4]; 0]);
}

#[test]
fn the_result_is_in_the_language_of_the_scene_with_its_numbers() {
    let text = |lang: &str, time: f64| {
        format!(
            "lang = '{lang}'
            shapes.a = {{ kind = 'circle', radius = 1, velocity = [1, 0] }}
            shapes.b = {{ kind = 'circle', radius = 1, position = [4.5, 0] }}
            query = {{ kind = 'separation', of = ['a', 'b'], time = {time} }}"
        )
    };
    let said = |lang: &str, time: f64| {
        let scene = open_text("lang.toml", &text(lang, time)).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, time);
        Account::of(&scene, &runs, &run).sentence()
    };
    assert_eq!(said("de", 0.0), "a und b sind 2,5 voneinander entfernt, entlang der Normalen (1; 0).");
    assert_eq!(said("fr", 0.5), "À t = 0,5 : a et b sont à une distance de 2 le long de la normale (1; 0).");
    assert_eq!(
        said("es-MX", 0.5),
        "En t = 0.5: a y b están a una distancia de 2 a lo largo de la normal (1, 0)."
    );
    assert_eq!(said("pl", 0.0), "a and b are 2.5 apart along the normal (1, 0).");
}

#[test]
fn bodies_that_pass_side_by_side_are_closest_for_a_while() {
    let passing = |shape: &str| {
        said(&format!(
            "shapes.dart = {{ kind = 'capsule', points = [[-0.5, 0], [0.5, 0]], radius = 0,
                position = [-4, 1.001], velocity = [9, 0] }}
            shapes.wall = {{ {shape} }}
            query = {{ kind = 'linear-sweep', of = ['dart', 'wall'] }}"
        ))
    };
    assert_eq!(
        passing("kind = 'box', half_extents = [1, 1]"),
        "dart and wall do not touch; they are closest from t = 0.278 to t = 0.611, 0.001 apart."
    );
    let round = passing("kind = 'circle', radius = 0.5, position = [0.5, 0]");
    assert!(round.contains("they are closest from t = 0.444 to t = 0.556, 0.501 apart"), "{round}");
    let point = passing("kind = 'polygon', vertices = [[0, 1], [-1, 0], [1, 0]]");
    assert!(point.contains("closest from t = 0.389 to t = 0.5, "), "{point}");
}
