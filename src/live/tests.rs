//! Drags and random edits of every committed figure.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tracefig_reference::random::Random;

use super::Live;
use crate::drawing::Point;
use crate::figure::{draw, plan};
use crate::geometry::DVec2;
use crate::output::found_words;
use crate::scene::open;

/// The scenes of all committed figures.
fn figures() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "toml"));
    paths.sort();
    assert!(paths.len() >= 19);
    paths
}

/// A figure, opened.
fn opened(path: &Path) -> Live {
    let request = json!({ "scene": open(path).unwrap().json_value() });
    Live::open(&request.to_string()).unwrap()
}

/// A count that a run may be asked for.
fn asked(variable: &str, usual: usize) -> usize {
    std::env::var(variable).map_or(usual, |text| text.parse().unwrap())
}

#[test]
fn a_figure_at_rest_has_the_bytes_of_its_file() {
    for path in figures().iter().step_by(6) {
        let written = std::fs::read_to_string(path.with_extension("svg")).unwrap();
        let id = written.split("<title id=\"").nth(1).unwrap().split("-title").next().unwrap();
        // As the text of its file, or as JSON.
        let file = open(path).unwrap();
        let json = file.json_value();
        for scene in [Value::String(file.source.text), json] {
            let mut live = Live::open(&json!({ "scene": scene, "id": id }).to_string()).unwrap();
            assert!(live.draw().unwrap().svg == written, "{}", path.display());
        }
    }
}

/// The last body put on a grid over the first panel: of so many places of a row and of a column.
fn drags(path: &Path, places: u32) -> (usize, Vec<String>) {
    let file = open(path).unwrap();
    let figure = plan(&file.scene).map(|plan| draw(&plan, plan.theme, "f")).unwrap();
    let frame = figure.panels[0].frame;
    let (origin, x, y) = (frame.page(DVec2::ZERO), frame.page(DVec2::X), frame.page(DVec2::Y));
    let world = |p: Point| {
        let [a, b] = [x, y].map(|end| DVec2::new(end.x - origin.x, end.y - origin.y));
        let p = DVec2::new(p.x - origin.x, p.y - origin.y);
        DVec2::new(p.perp_dot(b), a.perp_dot(p)) / a.perp_dot(b)
    };
    let at = |i: u32, from: f64, to: f64| from + (to - from) * f64::from(i) / f64::from(places - 1);
    let panel = frame.panel;
    let (mut live, mut count, mut refused) = (opened(path), 0, Vec::new());
    live.plan().unwrap();
    for (i, j) in (0..places).flat_map(|i| (0..places).map(move |j| (i, j))) {
        let to = world(Point::new(at(i, panel.x0, panel.x1), at(j, panel.y0, panel.y1)));
        let edit = json!([[["shapes", file.scene.shapes.len() - 1, "position"], [to.x, to.y]]]);
        count += 1;
        let drawn = live.set(&edit.to_string()).and_then(|()| live.plan().map(drop));
        refused.extend(drawn.err().map(|why| format!("{}: {why}", path.display())));
    }
    (count, refused)
}

#[test]
fn bodies_may_be_dragged_anywhere_over_their_panel() {
    // TRACEFIG_PLACES=13 asks all that the README tells of.
    let places = u32::try_from(asked("TRACEFIG_PLACES", 4)).unwrap();
    let (mut count, mut refused) = (0, Vec::new());
    for path in figures() {
        let (of_figure, refused_of_figure) = drags(&path, places);
        count += of_figure;
        refused.extend(refused_of_figure);
    }
    println!("{} of {count} places refused", refused.len());
    assert!(refused.len() * 200 < count, "{} of {count}: {refused:#?}", refused.len());
}

#[test]
fn an_edit_that_makes_no_scene_says_why_and_changes_nothing() {
    let mut live = opened(&figures()[0]);
    let before = live.scene();
    let mut refused = |edit: Value| live.set(&edit.to_string()).unwrap_err().to_string();
    let polygon = json!({"kind": "polygon", "vertices": [[0, 0], [2, 0], [1, 0.5], [1, 2]]});
    let said = refused(json!([[["shapes", "A"], polygon]]));
    assert_eq!(said, "A can't be so: it would not be convex");
    // The first edit is fine and is not made either.
    let said = refused(json!([[["shapes", 1, "position"], [5, 5]], [["query", "time"], 7]]));
    assert!(said.starts_with("the scene can't be so: "), "{said}");
    assert_eq!(live.scene(), before);
}

/// All paths that lead to a number of a scene.
fn numbers(value: &Value, path: &[Value], found: &mut Vec<Vec<Value>>) {
    let mut inside = |step: Value, value: &Value| numbers(value, &[path, &[step]].concat(), found);
    match value {
        Value::Number(_) => found.push(path.to_vec()),
        Value::Array(items) => items.iter().enumerate().for_each(|(i, item)| inside(i.into(), item)),
        Value::Object(entries) => {
            entries.iter().for_each(|(key, value)| inside(key.as_str().into(), value));
        }
        _ => {}
    }
}

/// A value that is far from what a scene has, or near.
fn value(r: &mut Random) -> Value {
    let x = r.between(-1.0, 1.0);
    match r.below(12) {
        0 => json!(0),
        1 => json!(x * 1e-300),
        2 => json!(x * 1e300),
        3 => json!(x * 1e9),
        4 => Value::Null,
        5 => json!([x, x]),
        _ => json!(x * 5.0),
    }
}

#[test]
fn random_edits_never_end_in_a_panic() {
    // TRACEFIG_EDITS=1000000 is the long run.
    let count = asked("TRACEFIG_EDITS", 400);
    let figures = figures();
    let mut r = Random::new(18);
    let (mut made, mut drawn) = (0, 0);
    for path in &figures {
        let mut live = opened(path);
        let mut paths = Vec::new();
        numbers(&serde_json::from_str(&live.scene()).unwrap(), &[], &mut paths);
        for i in 0..count.div_ceil(figures.len()) {
            let edits: Vec<Value> =
                (0..=r.below(2)).map(|_| json!([paths[r.below(paths.len())], value(&mut r)])).collect();
            made += usize::from(live.set(&Value::Array(edits).to_string()).is_ok());
            if i % 8 == 0 {
                drawn += usize::from(live.draw().is_ok());
            }
            if i % 64 == 63 {
                live = opened(path);
            }
        }
    }
    println!("{made} of {count} edits made a scene, of which {drawn} were drawn");
    assert!(made * 4 > count && drawn * 40 > count, "{made} made and {drawn} drawn of {count}");
}

#[test]
fn handles_are_called_in_the_language_of_the_scene() {
    let names = |lang: &str| {
        let mut scene = open(&figures()[0]).unwrap().json_value();
        scene["lang"] = lang.into();
        scene["live"] = json!({ "drag": ["A.position", "A.vertices", "B.radius"] });
        scene["shapes"]["B"] = json!({ "kind": "circle", "radius": 1, "position": [3, 1] });
        let panel = Live::open(&json!({ "scene": scene }).to_string()).unwrap().draw().unwrap().panel;
        let panel: Value = serde_json::from_str(&panel).unwrap();
        let handles = panel["handles"].as_array().unwrap().iter();
        let mut names: Vec<_> = handles.map(|handle| handle["name"].as_str().unwrap().to_owned()).collect();
        names.retain(|name| name.ends_with('A') || name.ends_with('B'));
        names.dedup();
        names
    };
    let english = names("en");
    assert!(english.contains(&"position of A".to_owned()) && english.len() > 2, "{english:?}");
    assert_eq!(names("zh"), english);
    for lang in ["de", "fr-CH", "es"] {
        let (own, foreign) = (names(lang), english.iter());
        assert!(own.iter().zip(foreign).all(|(own, english)| own != english), "{own:?}");
        assert_eq!(own.len(), english.len());
    }
    assert!(names("de").contains(&"Lage von A".to_owned()));
}

#[test]
fn a_refused_drag_is_told_in_the_language_of_the_scene() {
    let said = |lang: &str, edit: Value| {
        let mut scene = open(&figures()[0]).unwrap().json_value();
        scene["lang"] = lang.into();
        let mut live = Live::open(&json!({ "scene": scene }).to_string()).unwrap();
        live.set(&edit.to_string()).and_then(|()| live.draw().map(drop)).unwrap_err().to_string()
    };
    let far = || json!([[["shapes", 0, "position"], [1e9, 0]]]);
    assert_eq!(said("en", far()), "the figure can't be so: it would be too far away");
    assert_eq!(said("fr", far()), "La figure ne peut pas être ainsi : trop loin");
    let polygon = json!({"kind": "polygon", "vertices": [[0, 0], [2, 0], [1, 0.5], [1, 2]]});
    let hollow = || json!([[["shapes", "A"], polygon.clone()]]);
    assert_eq!(said("zh", hollow()), "A can't be so: it would not be convex");
    assert_eq!(said("de-AT", hollow()), "A kann so nicht sein: nicht mehr konvex");
    for (radius, why) in [(-1.0, "it would be too small"), (0.0, "it would have no area")] {
        let small =
            json!([[["shapes", "A"], { "kind": "regular-polygon", "edges": 5, "circumradius": radius }]]);
        assert_eq!(said("en", small), format!("A can't be so: {why}"));
    }
    let flat = json!([[["shapes", "A"], { "kind": "box", "half_extents": [0, 1] }]]);
    assert_eq!(said("es", flat), "A no puede ser así: sin área");
    for lang in ["de", "fr", "es"] {
        for edit in [hollow(), json!([[["query", "time"], 7]]), json!([[["shapes", "A", "kind"], "box"]])] {
            assert!(!said(lang, edit.clone()).contains("can't"), "{lang}: {edit}");
        }
    }
}

/// What a sum of numbers and of their quotients comes to, with brackets in brackets; `None` where it is none.
fn sum(words: &str) -> Option<f64> {
    let plain = words.replace(['$', ' '], "").replace('−', "-");
    let mut rest = plain.as_str();
    let all = terms(&mut rest)?;
    rest.is_empty().then_some(all)
}

/// Takes terms with signs between them off the front of a text.
fn terms(rest: &mut &str) -> Option<f64> {
    let mut all = factors(rest)?;
    while let Some(sign) = rest.chars().next().filter(|c| "+-".contains(*c)) {
        *rest = &rest[1..];
        all += if sign == '+' { factors(rest)? } else { -factors(rest)? };
    }
    Some(all)
}

/// Takes a number or a bracket, and what it is divided by, off the front of a text.
fn factors(rest: &mut &str) -> Option<f64> {
    let mut all = factor(rest)?;
    while let Some(after) = rest.strip_prefix('/') {
        *rest = after;
        all /= factor(rest)?;
    }
    Some(all)
}

/// Takes a number, signed or not, or a bracket off the front of a text.
fn factor(rest: &mut &str) -> Option<f64> {
    if let Some(after) = rest.strip_prefix('(') {
        *rest = after;
        let all = terms(rest)?;
        *rest = rest.strip_prefix(')')?;
        return Some(all);
    }
    let signed = usize::from(rest.starts_with('-'));
    let end =
        rest[signed..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(rest.len(), |at| at + signed);
    let (number, after) = rest.split_at(end);
    *rest = after;
    number.parse().ok()
}

#[test]
fn a_sum_is_read_with_its_brackets() {
    for (words, value) in [("7.5 - (3 + 2.5)", 2.0), ("4.5 / (5 + 1.5 + 2.5)", 0.5), ("$1 − (−2)$", 3.0)]
    {
        assert_eq!(sum(words), Some(value), "{words}");
    }
    for none in ["", "t", "2 - ", "(1, 2)", "7.5 -"] {
        assert_eq!(sum(none), None, "{none}");
    }
}

#[test]
fn sums_that_a_figure_says_are_right_wherever_a_body_is_and_moves() {
    let mut said = 0;
    for path in figures() {
        for (place, velocity) in [
            ([0.0, 0.0], [0.0, 0.0]),
            ([0.3, -0.2], [0.0, 0.0]),
            ([-0.1, 0.15], [0.0, 0.0]),
            ([0.0, 0.0], [-1.0, -0.5]),
            ([0.05, 0.1], [0.5, -0.25]),
        ] {
            let mut scene = open(&path).unwrap().scene;
            let body = &mut scene.shapes[0].1;
            body.position += DVec2::from(place);
            if body.velocity != DVec2::ZERO {
                body.velocity += DVec2::from(velocity);
            }
            let Ok(plan) = plan(&scene) else { continue };
            let figure = draw(&plan, plan.theme, "f");
            let words = found_words(&figure.drawing, None);
            for line in words.split('>').filter_map(|line| line.split('<').next()) {
                let parts: Vec<Option<f64>> = line.split(" = ").map(sum).collect();
                for pair in parts.windows(2) {
                    let &[Some(a), Some(b)] = pair else { continue };
                    said += 1;
                    eprintln!("{line}");
                    // Numbers have three digits at least.
                    assert!((a - b).abs() <= 0.01 * a.abs().max(b.abs()), "{}: {line}", path.display());
                }
            }
        }
    }
    assert!(said > 10, "{said}");
}

#[test]
fn a_body_that_is_dragged_out_of_all_space_is_drawn_or_refused() {
    for path in figures() {
        let mut live = opened(&path);
        for far in [[0.0, -7e299], [1e17, 0.0]] {
            let edit = json!([[["shapes", 0, "position"], far]]);
            // Without an end it would take all memory.
            let _ = live.set(&edit.to_string()).and_then(|()| live.draw().map(drop));
        }
    }
}
