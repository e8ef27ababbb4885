//! Scenes of random bodies, queries and layers, for counting what goes wrong with labels that nobody has
//! looked at.
//!
//! Whoever declares this module brings the names of the library into scope, from outside or from within.

use std::fmt::Write;

use tracefig_reference::random::Random;

use super::{LAYERS, Scene, Shows, plan};

/// A small count as a number.
fn number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap())
}

/// Letters of the scripts that the fonts have, each with the accents that its names are written with.
const SCRIPTS: [&str; 5] = [
    "abcdefghijklmnopqrstuvwxyz",
    "WMABCDEFGHIJKLNOPQRSTUVXYZ0123456789",
    "äöüßéèêñçåøæőůžščřłğışţ",
    "αβγδεζηθικλμνξοπρστυφχψωάέήίόύώ",
    "абвгдежзийклмнопрстуфхцчшщъыьэюя",
];
/// Letters of the longest name.
const LONGEST_NAME: usize = 24;

/// A name of one to 24 letters: one letter in a third of all cases, else one word or some.
fn name(r: &mut Random) -> String {
    if r.below(3) == 0 {
        return r.one_of(&["A", "B", "P", "q", "Ж", "ß"]).to_owned();
    }
    let letters: Vec<char> = r.one_of(&SCRIPTS).chars().collect();
    let (count, words) = (1 + r.below(LONGEST_NAME), r.below(3) > 0);
    let mut text = String::new();
    let mut since_space = 0;
    for i in 0..count {
        let breaks = words && since_space > 2 && i + 2 < count && r.below(4) == 0;
        since_space = if breaks { 0 } else { since_space + 1 };
        text.push(if breaks { ' ' } else { letters[r.below(letters.len())] });
    }
    text
}

/// Names of two bodies: in a quarter of all cases of one length, which are easily swapped.
fn names(r: &mut Random) -> [String; 2] {
    let a = name(r);
    let alike = format!("{}2", &a[..a.len() - a.chars().next_back().map_or(0, char::len_utf8)]);
    let b = if r.below(4) == 0 { alike } else { name(r) };
    let b = if a == b { format!("{b}2") } else { b };
    [a, b]
}

fn shape(r: &mut Random, name: &str, x: f64, moves: bool, turns: bool) -> String {
    let mut text = format!("[shapes.\"{name}\"]\n");
    let kind = r.one_of(&["circle", "box", "polygon", "capsule", "aabb"]);
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
                    let angle = std::f64::consts::TAU * (number(k) + 0.3) / number(n);
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
        let layer = r.one_of(&all);
        if !chosen.contains(&layer) {
            chosen.push(layer);
        }
    }
    chosen.iter().map(|l| format!("{l:?}")).collect::<Vec<_>>().join(", ")
}

/// The scene of a number: the same for the same tables of layers.
pub(crate) fn scene_text(seed: u64) -> String {
    let mut r = Random::new(seed);
    let kind = r.one_of(&[
        "separation",
        "contact",
        "overlap",
        "bounds",
        "linear-sweep",
        "time-of-impact",
        "motion-bound",
    ]);
    let moves = ["linear-sweep", "time-of-impact", "motion-bound"].contains(&kind);
    let turns = ["time-of-impact", "motion-bound"].contains(&kind);
    let near = r.quarter(0, 4);
    let [a, b] = names(&mut r);
    let mut text = shape(&mut r, &a, -near - 0.5, moves, turns);
    text += &shape(&mut r, &b, near + 0.5, moves, turns);
    let two = !["bounds", "motion-bound"].contains(&kind);
    let of = if two { format!("[\"{a}\", \"{b}\"]") } else { format!("[\"{a}\"]") };
    let _ = write!(text, "[query]\nkind = \"{kind}\"\nof = {of}\n");
    let panels = 1 + r.below(3);
    for _ in 0..panels {
        let configuration = two && r.below(3) == 0;
        let space = if configuration { "configuration" } else { "world" };
        let _ =
            write!(text, "[[panels]]\nspace = \"{space}\"\nlayers = [{}]\n", layers(&mut r, configuration));
    }
    text
}

/// The scene without the layers that it can't feed; none where nothing is left to show.
pub(crate) fn fed(mut scene: Scene) -> Option<Scene> {
    let Err(problems) = plan(&scene).map(|_| ()) else { return Some(scene) };
    for panel in &mut scene.panels {
        panel.layers.iter_mut().for_each(|l| l.retain(|l| problems.iter().all(|p| p.span != l.name.span)));
    }
    let shown = scene.panels.iter().any(|p| p.layers.iter().flatten().next().is_some());
    (shown && plan(&scene).is_ok()).then_some(scene)
}
