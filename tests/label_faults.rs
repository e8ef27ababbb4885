//! Labels place themselves well on scenes that nobody has seen: random bodies, every query, every layer.
//!
//! A fault is an overlap with a label, a marker, an arrowhead or a foreign stroke, a dropped label, a label over its
//! panel's edge, or a leader line over 40 px. `TRACEFIG_SCENES=10000 cargo test --test label_faults -- --nocapture`
//! runs as many scenes as one likes and prints what went wrong; with `TRACEFIG_PICTURES=FOLDER` it also leaves their
//! pictures there, to be looked at.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]
#![expect(clippy::cast_precision_loss, reason = "counts of scenes and corners")]

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use tracefig::drawing::Drawing;
use tracefig::figure::layer::{LAYERS, Shows};
use tracefig::figure::{LabelFault, draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Scene, Source, read};

/// Scenes of a usual run; few enough for a debug build.
const SCENES: u64 = 100;
/// Faults a figure on average, at most.
const LIMIT: f64 = 0.05;

/// `SplitMix64` (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }

    /// A multiple of a quarter in [lo, hi].
    fn quarter(&mut self, lo: i32, hi: i32) -> f64 {
        let steps = u64::try_from((hi - lo) * 4 + 1).unwrap();
        f64::from(lo) + f64::from(u32::try_from(self.below(steps)).unwrap()) / 4.0
    }

    fn of<'w>(&mut self, words: &[&'w str]) -> &'w str {
        words[usize::try_from(self.below(words.len() as u64)).unwrap()]
    }
}

fn shape(r: &mut Random, name: &str, x: f64, moves: bool, turns: bool) -> String {
    let mut text = format!("[shapes.{name}]\n");
    let kind = r.of(&["circle", "box", "polygon", "capsule", "aabb"]);
    let kind = if turns && kind == "aabb" { "box" } else { kind };
    let _ = writeln!(text, "kind = \"{kind}\"");
    let _ = match kind {
        "circle" => writeln!(text, "radius = {}", r.quarter(1, 2)),
        "box" | "aabb" => writeln!(text, "half_extents = [{}, {}]", r.quarter(1, 3), r.quarter(1, 2)),
        "capsule" => writeln!(text, "points = [[-1, 0], [1, 0.5]]\nradius = {}", 0.25 + r.quarter(0, 1)),
        _ => {
            let n = 3 + r.below(5);
            let corners: Vec<String> = (0..n)
                .map(|k| {
                    let angle = std::f64::consts::TAU * (k as f64 + 0.3) / n as f64;
                    format!("[{:.2}, {:.2}]", 2.0 * libm::cos(angle), 1.5 * libm::sin(angle))
                })
                .collect();
            writeln!(text, "vertices = [{}]", corners.join(", "))
        }
    };
    let _ = writeln!(text, "position = [{x}, {}]", r.quarter(-2, 2));
    if kind != "aabb" && kind != "circle" {
        let _ = writeln!(text, "angle_deg = {}", 15 * r.below(24));
    }
    if moves {
        let toward = if x < 0.0 { 1.0 } else { -1.0 };
        let _ = writeln!(text, "velocity = [{}, {}]", toward * r.quarter(3, 8), r.quarter(-2, 2));
    }
    if turns {
        let _ = writeln!(text, "angular_velocity_deg = {}", 30 * r.below(7));
    }
    text
}

fn layers(r: &mut Random, configuration: bool) -> String {
    let fits = |shows: Shows| shows == Shows::Anywhere || (shows == Shows::Configuration) == configuration;
    let all: Vec<&str> = LAYERS
        .iter()
        .filter(|l| fits(l.shows) && !["note", "shapes"].contains(&l.name))
        .map(|l| l.name)
        .collect();
    let mut chosen: Vec<&str> =
        if configuration { vec!["axes", "difference", "origin"] } else { vec!["shapes"] };
    for _ in 0..=r.below(4) {
        let layer = r.of(&all);
        if !chosen.contains(&layer) {
            chosen.push(layer);
        }
    }
    chosen.iter().map(|l| format!("{l:?}")).collect::<Vec<_>>().join(", ")
}

fn scene_text(seed: u64) -> String {
    let mut r = Random(seed);
    let kind = r.of(&[
        "separation",
        "separation",
        "overlap",
        "bounds",
        "linear-sweep",
        "time-of-impact",
        "motion-bound",
    ]);
    let moves = ["linear-sweep", "time-of-impact", "motion-bound"].contains(&kind);
    let turns = ["time-of-impact", "motion-bound"].contains(&kind);
    let near = r.quarter(0, 4);
    let mut text = shape(&mut r, "A", -near - 0.5, moves, turns);
    text += &shape(&mut r, "B", near + 0.5, moves, turns);
    let of = if ["bounds", "motion-bound"].contains(&kind) { "[\"A\"]" } else { "[\"A\", \"B\"]" };
    let _ = write!(text, "[query]\nkind = \"{kind}\"\nof = {of}\n");
    let panels = 1 + r.below(3);
    for _ in 0..panels {
        let configuration = of.contains('B') && r.below(3) == 0;
        let space = if configuration { "configuration" } else { "world" };
        let _ =
            write!(text, "[[panels]]\nspace = \"{space}\"\nlayers = [{}]\n", layers(&mut r, configuration));
    }
    text
}

/// The scene without the layers that it can't feed; none where nothing is left to show.
fn fed(mut scene: Scene) -> Option<Scene> {
    let Err(problems) = plan(&scene).map(|_| ()) else { return Some(scene) };
    for panel in &mut scene.panels {
        panel.layers.retain(|l| problems.iter().all(|p| p.span != l.name.span));
    }
    let shown = scene.panels.iter().any(|p| !p.layers.is_empty());
    (shown && plan(&scene).is_ok()).then_some(scene)
}

fn leave_picture(seed: u64, drawing: &Drawing) {
    let Some(folder) = std::env::var_os("TRACEFIG_PICTURES") else { return };
    let Some(Writer::One(write)) = format("png").map(|f| f.write) else { return };
    let bytes = write(drawing, &Options { scale: 1.0, ..Options::default() }).unwrap();
    std::fs::write(Path::new(&folder).join(format!("{seed}.png")), bytes).unwrap();
}

fn word(fault: &LabelFault) -> String {
    let text = fault.to_string();
    let key = fault.label().0;
    format!("{key}: {}", text.replace(&format!("`{key}`"), "…"))
}

#[test]
fn labels_on_random_scenes_have_next_to_no_faults() {
    let scenes: u64 = std::env::var("TRACEFIG_SCENES").ok().and_then(|n| n.parse().ok()).unwrap_or(SCENES);
    let (mut figures, mut found, mut labels) = (0.0, 0.0, 0_usize);
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    for seed in 0..scenes {
        let text = scene_text(seed);
        let scene = read(&Source::new("random", &text)).unwrap_or_else(|p| panic!("{p:?}\n{text}"));
        let Some(scene) = fed(scene) else { continue };
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "random");
        leave_picture(seed, &figure.drawing);
        figures += 1.0;
        labels += figure.panels.iter().map(|p| p.placed.len()).sum::<usize>();
        for fault in figure.faults() {
            found += 1.0;
            let times = kinds.entry(word(&fault)).or_default();
            *times += 1;
            if *times <= 2 {
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
    let (_, scene) = committed().into_iter().find(|(name, _)| name == "frames-continuous").unwrap();
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
