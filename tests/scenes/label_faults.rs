//! Labels place themselves well on scenes that nobody has seen: random bodies, every query, every layer.
//!
//! A fault is an overlap with a label, a marker, an arrowhead or a foreign stroke, a dropped label, a label
//! over its panel's edge, a leader line over 40 px or under a label, or a label that stands as near to another
//! thing that it could name as to its own, or nearer, without a leader line.
//!
//! `TRACEFIG_SCENES=10000 cargo test --test scenes label_faults -- --nocapture` runs as many scenes as one
//! likes, from that of `TRACEFIG_SEED` on, and prints what went wrong; with `TRACEFIG_PICTURES=FOLDER` it prints
//! every fault, and leaves the scene and the picture there, to be looked at: of every figure with one, and of
//! the first twenty.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]
#![expect(clippy::cast_precision_loss, reason = "counts of scenes and vertices")]

#[path = "../random_scenes/mod.rs"]
pub(crate) mod random_scenes;

use std::collections::BTreeMap;
use std::path::Path;

use tracefig::drawing::Drawing;
use tracefig::figure::layer::{LAYERS, Shows};
use tracefig::figure::{LabelFault, draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Scene, Source, read};

use random_scenes::{fed, scene_text};

/// Scenes of a usual run; few enough for a debug build.
const SCENES: u64 = 100;
/// Faults a figure on average, at most. Of 10,000 scenes it is 0.01, of the usual run 0.03: long names on a
/// grid, or where bodies that pass through each other leave no part free. The usual scenes are others with
/// each new layer. None may be two names at each other's things.
const LIMIT: f64 = 0.05;

fn leave_picture(seed: u64, text: &str, drawing: &Drawing) {
    let Some(folder) = std::env::var_os("TRACEFIG_PICTURES") else { return };
    let Some(Writer::One(write)) = format("png").map(|f| f.write) else { return };
    let bytes = write(drawing, &Options { scale: 1.0, ..Options::default() }).unwrap();
    std::fs::write(Path::new(&folder).join(format!("{seed}.png")), bytes).unwrap();
    std::fs::write(Path::new(&folder).join(format!("{seed}.toml")), text).unwrap();
}

fn word(fault: &LabelFault) -> String {
    let text = fault.to_string();
    let key = fault.label().0;
    format!("{key}: {}", text.replace(&format!("`{key}`"), "…"))
}

#[test]
fn labels_on_random_scenes_have_next_to_no_faults() {
    let scenes: u64 = std::env::var("TRACEFIG_SCENES").ok().and_then(|n| n.parse().ok()).unwrap_or(SCENES);
    let first: u64 = std::env::var("TRACEFIG_SEED").ok().and_then(|n| n.parse().ok()).unwrap_or(0);
    let (mut figures, mut found, mut labels) = (0.0, 0.0, 0_usize);
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    let most_told = if std::env::var_os("TRACEFIG_PICTURES").is_some() { usize::MAX } else { 2 };
    for seed in first..first + scenes {
        let text = scene_text(seed);
        let scene = read(&Source::new("random", &text)).unwrap_or_else(|p| panic!("{p:?}\n{text}"));
        let Some(scene) = fed(scene) else { continue };
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "random");
        if seed < first + 20 || !figure.faults().is_empty() {
            leave_picture(seed, &text, &figure.drawing);
        }
        figures += 1.0;
        labels += figure.panels.iter().map(|p| p.placed.len()).sum::<usize>();
        for fault in figure.faults() {
            assert!(!matches!(fault, LabelFault::Swapped { .. }), "seed {seed}: {fault}\n{text}");
            found += 1.0;
            let times = kinds.entry(word(&fault)).or_default();
            *times += 1;
            if *times <= most_told {
                println!("seed {seed}: {fault}");
            }
        }
    }
    println!("{figures} figures, {labels} labels, {found} faults: {:.4} a figure", found / figures);
    println!("{kinds:#?}");
    assert!(figures > 0.8 * scenes as f64, "only {figures} of {scenes} scenes show anything");
    assert!(found / figures < LIMIT, "{:.3} faults a figure", found / figures);
}

/// The committed figures, by name.
fn committed() -> Vec<(String, Scene)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    let name = |p: &Path| p.file_stem().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|p| (name(p), tracefig::open(p).unwrap().scene)).collect()
}

#[test]
fn labels_on_the_committed_figures_have_no_fault_at_all() {
    let mut found = Vec::new();
    for (name, scene) in committed() {
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, &name);
        found.extend(figure.faults().iter().map(|fault| format!("{name}: {fault}")));
        assert!(figure.panels.iter().any(|p| !p.placed.is_empty()), "{name} has no labels");
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_pinned_label_stands_where_the_scene_says_and_a_hidden_one_nowhere() {
    let text = |labels: &str| {
        format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}\nquery = {{ kind = 'bounds', of = ['A'] }}\n{labels}\n\
             panels = [{{ space = 'world', layers = ['shapes', 'origin'] }}]"
        )
    };
    let places = |labels: &str| {
        let scene = read(&Source::new("pins", &text(labels))).unwrap();
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "pins");
        let panel = &figure.panels[0];
        let origin = panel.frame.page(tracefig::geometry::DVec2::ZERO);
        let found = panel.placed.iter().find(|p| p.key == "O").map(|p| p.bounds.center() - origin);
        (found, panel.placed.len())
    };
    let (pinned, _) = places("labels = { O = { at = [50, -30] } }");
    let pinned = pinned.unwrap();
    assert!((pinned.dx - 50.0).abs() < 1e-9 && (pinned.dy + 30.0).abs() < 1e-9, "{pinned:?}");
    for (word, sx, sy) in [("W", -1.0, 0.0), ("SE", 1.0, 1.0), ("N", 0.0, -1.0)] {
        let (found, _) = places(&format!("labels = {{ O = {{ at = '{word}' }} }}"));
        let found = found.unwrap();
        let sign = |x: f64| if x.abs() < 0.5 { 0.0 } else { x.signum() };
        assert_eq!((sign(found.dx), sign(found.dy)), (sx, sy), "{word}: {found:?}");
    }
    assert_eq!(places("labels = { O = { hide = true } }"), (None, 1));
}

#[test]
fn the_panels_of_a_series_keep_the_places_of_their_labels() {
    let text = "shapes.A = { kind = 'circle', radius = 1, position = [-2.25, 3.25], velocity = [4.5, -6.5] }
        shapes.B = { kind = 'polygon', vertices = [[-5.1, -3.05], [4.5, -0.25], [4.9, 1.95], [-4.7, -0.85]] }
        query = { kind = 'linear-sweep', of = ['A', 'B'] }
        panels = [
            { time = 0.5, view = [-5.2, -4.45, 5.1, 4.6], layers = ['shapes'] },
            { time = 1, view = [-5.2, -4.45, 5.1, 4.6], layers = ['shapes'] },
        ]";
    let scene = read(&Source::new("series", text)).unwrap();
    let plan = plan(&scene).unwrap();
    let figure = draw(&plan, plan.theme, "series");
    let place = |panel: usize| {
        let panel = &figure.panels[panel];
        let b = panel.placed.iter().find(|p| p.key == "B").unwrap();
        (b.bounds.x0 - panel.frame.panel.x0, b.bounds.y0 - panel.frame.panel.y0)
    };
    let (first, second) = (place(0), place(1));
    assert!((first.0 - second.0).abs() + (first.1 - second.1).abs() < 1e-6, "{first:?} {second:?}");
}

#[test]
fn the_same_scene_gives_the_same_drawing() {
    for (name, scene) in committed() {
        let (one, two) = (plan(&scene).unwrap(), plan(&scene).unwrap());
        assert_eq!(draw(&one, one.theme, &name).drawing, draw(&two, two.theme, &name).drawing, "{name}");
    }
}
