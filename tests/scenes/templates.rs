//! A scene is a template that every line of a log is put through: how the answer turns out decides what a
//! layer draws, never whether the scene is right.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::collections::BTreeSet;

use tracefig::collision::ALGORITHMS;
use tracefig::drawing::Item;
use tracefig::figure::layer::{LAYERS, Layer, Shows};
use tracefig::figure::{Fault, Takes, draw, plan};
use tracefig::geometry::DVec2;
use tracefig::scene::{Explain, Scene, Severity, open_text};

/// Positions of B for which a motion of (3, 0) of A ends in different ways, and moments in different states.
const PLACES: [&str; 5] = ["[2.5, 0.25]", "[9, 0.25]", "[0.5, 0.25]", "[2, 0]", "[2.5, 1.5]"];

/// The two bodies of a scene that several algorithms take.
fn bodies(algorithm: &str, place: &str) -> String {
    let turns = ["swept-axis", "conservative-advancement"].contains(&algorithm);
    let spin = if turns { "angular_velocity_deg = 20\n" } else { "" };
    let (a, b) = match algorithm {
        "circles" => ("kind = 'circle'\nradius = 1", "kind = 'circle'\nradius = 1"),
        "extents" => ("kind = 'aabb'\nhalf_extents = [1, 1]", "kind = 'aabb'\nhalf_extents = [1, 0.5]"),
        "clamp" => ("kind = 'box'\nhalf_extents = [1, 1]", "kind = 'circle'\nradius = 1"),
        _ => (
            "kind = 'box'\nhalf_extents = [1, 1]",
            "kind = 'polygon'\nvertices = [[-1, 0], [0, -0.6], [1, 0], [0, 0.8]]",
        ),
    };
    format!("[shapes.A]\n{a}\nvelocity = [3, 0]\n{spin}[shapes.B]\n{b}\nposition = {place}\n{spin}")
}

/// A layer with each word of its options, and without any.
fn variants(layer: &Layer) -> Vec<String> {
    let mut all = vec![format!("'{}'", layer.name)];
    for option in layer.options {
        if let Takes::Word(words) | Takes::When(words) = option.takes {
            all.extend(
                words.iter().map(|w| format!("{{ layer = '{}', {} = '{w}' }}", layer.name, option.name)),
            );
        }
    }
    all
}

/// The codes that refuse a scene, and its notes.
fn told(scene: &Scene) -> (Vec<&'static str>, Vec<String>) {
    match plan(scene) {
        Ok(plan) => {
            let warnings = draw(&plan, plan.theme, "t").warnings;
            let notes = warnings.iter().filter(|w| w.fault.severity() == Severity::Note);
            (Vec::new(), notes.map(|w| w.fault.to_string()).collect())
        }
        Err(problems) => (problems.iter().map(|p| p.fault.code()).collect(), Vec::new()),
    }
}

#[test]
fn how_an_answer_turns_out_never_decides_whether_a_layer_may_stand_there() {
    let mut said = BTreeSet::new();
    for algorithm in ALGORITHMS {
        for kind in algorithm.kinds {
            for layer in LAYERS {
                let space = if layer.shows == Shows::Configuration { "configuration" } else { "world" };
                for variant in variants(layer) {
                    let outcomes: Vec<_> = PLACES
                        .iter()
                        .filter_map(|place| {
                            let text = format!(
                                "{}[query]\nkind = '{}'\nof = ['A', 'B']\nalgorithm = '{}'\n[[panels]]\n\
                                 space = '{space}'\nlayers = [{variant}]",
                                bodies(algorithm.name, place),
                                kind.word(),
                                algorithm.name
                            );
                            Some(told(&open_text("t.toml", &text).ok()?.scene))
                        })
                        .collect();
                    assert_eq!(outcomes.len(), PLACES.len(), "{} takes the pair", algorithm.name);
                    let first = &outcomes[0].0;
                    for (refused, notes) in &outcomes {
                        assert_eq!(refused, first, "{variant} of {} by {}", kind.word(), algorithm.name);
                        said.extend(notes.iter().cloned());
                    }
                }
            }
        }
    }
    for expected in
        ["`contact` draws nothing: the answer is a miss", "`ghosts` draws nothing: the answer is a miss"]
    {
        assert!(said.contains(expected), "{said:#?}");
    }
}

/// The notes of a sweep whose panel shows the hit, and the time that it shows.
fn panel_of_the_hit(place: &str) -> (Vec<String>, f64) {
    let text = format!(
        "{}[query]\nkind = 'linear-sweep'\nof = ['A', 'B']\n[[panels]]\ntime = 'hit'\n\
         layers = ['shapes', {{ layer = 'velocity', of = 'A', from = 'center' }}]",
        bodies("ray-cast", place)
    );
    let scene = open_text("t.toml", &text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "t");
    let notes = figure.warnings.iter().filter(|w| matches!(w.fault, Fault::OtherMoment { .. }));
    // A moves by 3 to the right: its name tells how far it is.
    let panel = &figure.panels[0];
    let name = |key: &str| panel.placed.iter().find(|p| p.key == key).unwrap().bounds.center();
    let x = |x: f64| panel.frame.page(DVec2::new(x, 0.0)).x;
    let moved = (name("A").x - x(0.0)) / (x(1.0) - x(0.0));
    (notes.map(|w| w.fault.to_string()).collect(), moved / 3.0)
}

#[test]
fn a_panel_of_the_hit_shows_how_near_a_miss_came_and_says_so() {
    let (notes, time) = panel_of_the_hit("[9, 0.25]");
    assert_eq!(notes, ["the panel shows the closest approach in place of the hit: the answer is a miss"]);
    assert!((time - 1.0).abs() < 0.15, "{time}");
    let (notes, time) = panel_of_the_hit("[2.5, 0.25]");
    assert_eq!(notes, Vec::<String>::new());
    assert!(time < 0.6, "{time}");
}

#[test]
fn a_step_that_was_not_needed_is_the_last_one_and_a_label_of_a_silent_layer_is_known() {
    let text = format!(
        "{}[query]\nkind = 'linear-sweep'\nof = ['A', 'B']\nalgorithm = 'ray-clipping'\n[[panels]]\n\
         space = 'configuration'\nstep = 50\nlayers = ['difference', 'advancement']\n[[panels]]\n\
         layers = ['shapes', 'contact']\n[labels]\ncontact = 'here'",
        bodies("ray-clipping", "[9, 0.25]")
    );
    let (refused, notes) = told(&open_text("t.toml", &text).unwrap().scene);
    assert_eq!(refused, Vec::<&str>::new());
    assert!(notes[0].starts_with("the panel shows step ") && notes[0].contains("in place of step 50"));
    assert_eq!(notes[1], "`contact` draws nothing: the answer is a miss");
}

#[test]
fn a_case_without_a_nearest_edge_is_the_reason_why_support_draws_nothing() {
    let text = "[shapes.A]\nkind = 'box'\nhalf_extents = [1, 1]\n[shapes.B]\nkind = 'box'\n\
                half_extents = [1, 1]\nposition = [3, 3]\n[query]\nkind = 'separation'\nof = ['A', 'B']\n\
                algorithm = 'minkowski'\n[[panels]]\nlayers = ['shapes', 'support']";
    let (refused, notes) = told(&open_text("t.toml", text).unwrap().scene);
    assert_eq!(refused, Vec::<&str>::new());
    let reason = "the bodies are closest at a vertex of each, so that no edge faces the other body";
    assert_eq!(notes, [format!("`support` draws nothing: {reason}")]);
}

#[test]
fn a_value_that_another_answer_has_is_a_dash_and_any_other_is_refused() {
    let texts = |place: &str, value: &str| {
        let text = format!(
            "caption = 'At {{={value}}}, $t = {{={value}}}$.'\n{}[query]\nkind = 'linear-sweep'\n\
             of = ['A', 'B']\n[[panels]]\nlayers = ['shapes']\n[labels]\nA = '{{={value}}}'",
            bodies("ray-cast", place)
        );
        let scene = open_text("t.toml", &text).unwrap().scene;
        let Ok(plan) = plan(&scene) else { return None };
        let figure = draw(&plan, plan.theme, "t");
        let notes: BTreeSet<_> = figure.warnings.iter().map(|w| w.fault.to_string()).collect();
        let caption = caption_of(&figure.drawing.items);
        Some((caption, notes.into_iter().collect::<Vec<_>>()))
    };
    let (caption, notes) = texts("[9, 0.25]", "time").unwrap();
    assert_eq!(caption, "At –, t = –.");
    assert_eq!(notes, ["a dash stands for `{=time}`: the answer is a miss"]);
    let (caption, notes) = texts("[2.5, 0.25]", "time").unwrap();
    assert!(!caption.contains('–') && notes.is_empty(), "{caption} {notes:?}");
    assert!(texts("[9, 0.25]", "D.x").is_none());
}

/// The words of the caption.
fn caption_of(items: &[Item]) -> String {
    let caption = items.iter().find_map(|item| match item {
        Item::Group(group) if group.name == "caption" => group.label.clone(),
        _ => None,
    });
    caption.unwrap()
}
