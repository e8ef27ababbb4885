//! Every kind of answer has its picture, with something in every panel, no row that nothing picks, no layer
//! in a row that nothing feeds, and hardly a fault.

use std::collections::{BTreeMap, BTreeSet};

use super::{Case, PICTURES, Picture};
use crate::collision::ALGORITHMS;
use crate::figure::layer::EXPECTED;
use crate::figure::runs::Runs;
use crate::figure::{draw, plan};
use crate::geometry::Side;
use crate::scene::{Explain, Scene, Severity, Source, as_json, open_text, panels_of_text};

/// Places of B that a motion of A by (3, 0) hits soon and late, misses and begins in; and the first again
/// with a radius, by which bodies overlap whose cores are apart.
const PLACES: [&str; 6] =
    ["[2.3, 0.25]", "[9, 0.25]", "[0.5, 0.25]", "[4.2, 0]", "[2.5, 3]", "[2.3, 0.25]\nradius = 0.6"];

/// Two bodies that an algorithm takes.
fn pair(algorithm: &str, place: &str, motion: &str) -> String {
    let (a, b) = match algorithm {
        "circles" => ("kind = 'circle'\nradius = 1", "kind = 'circle'\nradius = 0.7"),
        "extents" => ("kind = 'aabb'\nhalf_extents = [1, 1]", "kind = 'aabb'\nhalf_extents = [0.8, 0.5]"),
        "clamp" => ("kind = 'box'\nhalf_extents = [1, 1]", "kind = 'circle'\nradius = 0.8"),
        _ => (
            "kind = 'box'\nhalf_extents = [1, 0.8]\nangle_deg = 20",
            "kind = 'polygon'\nvertices = [[-1, 0], [0, -0.6], [1, 0.1], [0, 0.8]]",
        ),
    };
    format!("[shapes.crate]\n{a}\n{motion}\n[shapes.B]\n{b}\nposition = {place}\n")
}

/// Every question that every algorithm answers, of bodies at each place that move, turn or do both.
fn scenes() -> Vec<Scene> {
    let mut texts = BTreeSet::new();
    for algorithm in ALGORITHMS {
        for kind in algorithm.kinds {
            for place in PLACES {
                for motion in [
                    "velocity = [3, 0]",
                    "velocity = [3, 0.1]\nangular_velocity_deg = 40",
                    "angular_velocity_deg = 40",
                ] {
                    for of in ["'crate', 'B'", "'crate'", "'crate', 'B']\nmax_iterations = 1 #"] {
                        texts.insert(format!(
                            "{}[query]\nkind = '{}'\nalgorithm = '{}'\nof = [{of}]\n",
                            pair(algorithm.name, place, motion),
                            kind.word(),
                            algorithm.name,
                        ));
                    }
                }
            }
        }
    }
    let both =
        pair("", PLACES[0], "velocity = [3, 0]\nangular_velocity_deg = 40") + "angular_velocity_deg = -30\n";
    for asked in ["'motion-bound'", "'time-of-impact'\nalgorithm = 'conservative-advancement'"] {
        texts.insert(format!("{both}[query]\nkind = {asked}\nof = ['crate', 'B']\n"));
    }
    // Neither passes the other.
    let alike = both + "velocity = [3, 0]\n";
    texts.insert(format!("{alike}[query]\nkind = 'motion-bound'\nof = ['crate', 'B']\n"));
    texts.iter().filter_map(|text| Some(open_text("s.toml", text).ok()?.scene)).collect()
}

#[test]
fn the_last_step_that_a_panel_names_is_drawn_in_it() {
    for place in PLACES {
        let text = pair("gjk", place, "") + "[query]\nkind = 'separation'\nalgorithm = 'gjk'\n";
        let scene = open_text("s.toml", &format!("{text}of = ['crate', 'B']")).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawn: Vec<_> = plan.panels[1].layers.iter().map(|layer| layer.layer.name).collect();
        assert!(drawn.iter().any(|name| ["simplex", "polytope"].contains(name)), "{place}: {drawn:?}");
    }
}

/// The row that a scene's answer picks.
fn picked(scene: &Scene) -> &'static Picture {
    let run = Runs::default().own(scene, scene.query.time);
    PICTURES.iter().find(|picture| (picture.fits)(&Case { scene, run: &run })).unwrap()
}

#[test]
fn an_undecided_motion_is_shown_where_the_proof_ends() {
    // Half a turn leaves the blade where it was.
    let text = "shapes.blade = { kind = 'box', half_extents = [1, 0.1], angular_velocity_deg = 180 }
        shapes.ceiling = { kind = 'aabb', half_extents = [3, 0.2], position = [0, 1.204987562112089] }
        query = { kind = 'time-of-impact', of = ['blade', 'ceiling'] }";
    let scene = open_text("s.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "s");
    let ghost = figure.panels[0].placed.iter().find(|label| label.key == "A'").unwrap();
    let said: String = ghost.lines.iter().map(|(_, line)| line.markup.clone()).collect();
    assert!(said.contains("t = 0.468"), "{said}");
    assert!(figure.drawing.desc.contains("0.468"), "{}", figure.drawing.desc);
}

#[test]
fn a_miss_of_bodies_with_many_vertices_or_that_both_move_is_drawn_without_their_steps() {
    for (edges, spin, count) in [(60, 0, 1), (2048, 0, 0), (60, -100, 0)] {
        let text = format!(
            "shapes.A = {{ kind = 'regular-polygon', edges = {edges}, circumradius = 2, velocity = [3, 0],
                angular_velocity_deg = 40 }}
             shapes.B = {{ kind = 'regular-polygon', edges = {edges}, circumradius = 1, position = [6, 1],
                angular_velocity_deg = {spin} }}
             query = {{ kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let ghosts = plan.panels[0].layers.iter().filter(|layer| layer.layer.name == "ghosts");
        assert_eq!(ghosts.count(), count, "{edges}, {spin}");
    }
}

#[test]
fn every_answer_has_a_picture_and_every_row_and_layer_an_answer() {
    let mut fed: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    let (mut figures, mut faults) = (0.0, Vec::new());
    for scene in scenes() {
        let row = picked(&scene);
        let plan = plan(&scene).unwrap();
        assert_eq!(plan.panels.len(), panels_of_text(row.panels, &(0..0)).len(), "{}", row.name);
        for panel in &plan.panels {
            let sketched = panel.sketch(&panel.context(&scene, &plan.runs), plan.theme);
            assert!(sketched.extent.is_some() && !panel.layers.is_empty(), "{} {scene:?}", row.name);
            fed.entry(row.name).or_default().extend(panel.layers.iter().map(|l| l.layer.name.to_owned()));
        }
        let figure = draw(&plan, plan.theme, "s");
        let told = figure.warnings.iter().filter(|told| told.fault.severity() == Severity::Warning);
        assert_eq!(told.count(), figure.faults().len(), "{}: {:?}", row.name, figure.warnings);
        faults.extend(figure.faults().iter().map(|fault| format!("{}: {fault}", row.name)));
        figures += 1.0;
    }
    for row in PICTURES {
        let asked =
            panels_of_text(row.panels, &(0..0)).into_iter().filter_map(|panel| panel.layers).flatten();
        let asked: BTreeSet<String> = asked.map(|layer| layer.name.value).collect();
        assert_eq!(fed.get(row.name), Some(&asked), "{}", row.name);
    }
    let share = f64::from(u32::try_from(faults.len()).unwrap()) / figures;
    println!("{figures} figures, {} faults", faults.len());
    assert!(share < FAULTS, "{share} faults a figure: {faults:#?}");
}

/// Faults of labels a figure, at most: measured 0 to 2 on 320 figures.
const FAULTS: f64 = 0.02;

#[test]
fn a_panel_without_layers_has_those_of_its_space_and_the_names_of_the_scene() {
    let text =
        pair("closest-features", "[0.9, 0.25]", "") + "[query]\nkind = 'separation'\nof = ['B', 'crate']\n";
    let layers = |panels: &str| {
        let scene = open_text("s.toml", &format!("{text}{panels}")).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let panel = &plan.panels[0];
        let of = panel.layers.iter().find(|layer| layer.layer.name == "ghosts").map(|l| l.options.of(&[]));
        (panel.layers.iter().map(|l| l.layer.name).collect::<Vec<_>>(), of, plan.caption.lines())
    };
    let (names, of, caption) = layers("[[panels]]\nspace = 'body'\nframe = 'B'");
    assert_eq!((names, of, caption), (vec!["shapes", "ghosts", "separation"], Some(vec![Side::B]), 0));
    let (names, of, _) = layers("[[panels]]\nspace = 'configuration'");
    assert_eq!((names, of), (vec!["axes", "difference", "origin", "closest"], None));
    let (_, _, caption) = layers("");
    assert_eq!(caption, 1, "the answer in a sentence");
    let (_, _, caption) = layers("\n[canvas]\nwidth = 700");
    assert_eq!(caption, 1);
}

#[test]
fn a_lone_panel_of_a_contact_shows_its_points() {
    let text = "[shapes.A]\nkind = 'box'\nhalf_extents = [2, 1]\n[shapes.B]\nkind = 'box'\n\
        half_extents = [1, 1]\nposition = [0.5, 1.9]\n[query]\nkind = 'contact'\nalgorithm = 'clip'\n\
        of = ['A', 'B']\n[[panels]]\ntitle = 'Both'\n";
    let scene = open_text("s.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "contact");
    let keys: BTreeSet<&str> = figure.panels[0].placed.iter().map(|label| label.key).collect();
    assert!(["d_1", "d_2", "reference", "incident"].iter().all(|key| keys.contains(key)), "{keys:?}");
}

#[test]
fn a_label_that_only_another_answer_has_may_be_worded() {
    let text = pair("ray-cast", "[9, 0.25]", "velocity = [3, 0]") + "[query]\nkind = 'linear-sweep'\n";
    let words = |key: &str| format!("{text}of = ['crate', 'B']\n[labels]\n{key} = 'here'");
    assert!(plan(&open_text("s.toml", &words("contact")).unwrap().scene).is_ok());
    assert!(plan(&open_text("s.toml", &words("contct")).unwrap().scene).is_err());
}

#[test]
fn a_label_that_no_answer_of_the_algorithm_has_is_told() {
    let text =
        pair("closest-features", "[9, 0.25]", "") + "[query]\nkind = 'separation'\nof = ['crate', 'B']\n";
    let refused = |key: &str| {
        let text = format!("{text}[labels]\n{key} = {{ hide = true }}");
        plan(&open_text("s.toml", &text).unwrap().scene).err().map(|p| p[0].fault.help().unwrap_or_default())
    };
    // Those of clipping; and that of a push, which the bodies would have if they overlapped.
    let known = refused("incident").unwrap();
    assert!(known.contains("`pushed`") && !known.contains("`reference`"), "{known}");
    assert_eq!(refused("pushed"), None);
}

#[test]
fn the_panels_of_all_pictures_say_the_same_in_json_which_pages_read() {
    for picture in PICTURES {
        let read = |text: &str| Source::new("", text).json();
        assert_eq!(read(&as_json(picture.panels)), read(picture.panels), "{}", picture.name);
        assert!(read(picture.panels).is_some_and(|json| json.len() > 20));
    }
}

#[test]
fn bodies_that_only_touch_are_not_pushed_out() {
    let layers = |query: &str, x: &str| {
        let text = format!(
            "shapes.A = {{ kind = 'aabb', half_extents = [1, 1] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [{x}, 0.5] }}
            query = {{ kind = '{query}', of = ['A', 'B'] }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        plan.panels[0].layers.iter().map(|l| l.layer.name).collect::<Vec<_>>().join(" ")
    };
    for query in ["separation", "overlap"] {
        assert_eq!(layers(query, "2"), "shapes separation", "{query}");
        assert_eq!(layers(query, "1.5"), "shapes ghosts separation", "{query}");
    }
}

#[test]
fn what_someone_else_answered_stands_in_the_picture() {
    let labels = |expected: &str| -> Vec<&str> {
        let bodies = pair("minkowski", "[2.5, 3]", "velocity = [3, 0]");
        let text = format!("{bodies}[query]\nkind = 'separation'\nof = ['crate', 'B']\n{expected}");
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "s");
        figure.panels.iter().flat_map(|panel| &panel.placed).map(|label| label.key).collect()
    };
    let [without, with] = ["", "expected = { separation = 1.5 }"].map(labels);
    let is_it = |key: &&str| EXPECTED.labels.iter().any(|label| label.key == *key);
    assert!(with.len() == without.len() + 1 && with.iter().any(is_it), "{without:?} {with:?}");
}

#[test]
fn the_caption_says_how_far_off_what_was_expected_is() {
    let told = |of: &str, expected: &str| {
        let text = format!(
            "lang = '{of}'
            shapes.A = {{ kind = 'circle', radius = 1, velocity = [4, 0] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 2], position = [4, 0] }}
            query = {{ kind = 'linear-sweep', of = ['A', 'B'], expected = {{ {expected} }} }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let words = plan(&scene).unwrap().caption.words.unwrap();
        words[words.find(").").map_or(0, |end| end + 2)..].trim_start().to_owned()
    };
    assert_eq!(
        told("en", "outcome = 'miss'"),
        "What was expected is off: the outcome (expected: miss, found: hit)."
    );
    assert_eq!(
        told("en", "outcome = 'hit', time = 0.25, normal = [0, 1]"),
        "What was expected is off: the time by −0.25, the normal by 90°."
    );
    assert_eq!(
        told("en", "time = 0.5, outcome = 'hit', normal = [2, 0]"),
        "What was expected agrees with the answer."
    );
    assert_eq!(told("de", "time = 0.75"), "Das Erwartete liegt daneben: die Zeit um 0,25.");
}

#[test]
fn the_bound_of_two_bodies_that_turn_has_the_numbers_of_both() {
    let scene = "shapes.wheel = { kind = 'circle', radius = 1, center = [0.5, 0], velocity = [2, 0.5],
                angular_velocity_deg = 90 }
            shapes.bar = { kind = 'box', half_extents = [1.5, 0.1], position = [4, 0],
                angular_velocity_deg = -120 }
            query = { kind = 'motion-bound', of = ['wheel', 'bar'] }";
    let scene = open_text("s.toml", scene).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "s");
    let arcs = figure.panels.iter().map(|p| p.placed.iter().filter(|label| label.key == "L").count());
    assert_eq!(arcs.collect::<Vec<_>>(), [2, 0], "and the relative velocity");
}

#[test]
fn bodies_that_overlap_are_seen_however_fast_they_are() {
    for speed in [6.0, 60.0, 1e6] {
        let text = format!(
            "shapes.A = {{ kind = 'box', half_extents = [1, 0.5], velocity = [{speed:?}, -1] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [0.5, 0.5] }}
            query = {{ kind = 'time-of-impact', of = ['A', 'B'] }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "s");
        let frame = figure.panels[0].frame;
        assert!(2.0 * frame.scale > 0.15 * frame.panel.width(), "{speed}: {frame:?}");
    }
}
