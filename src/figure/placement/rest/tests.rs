//! Bodies of the committed figures are dragged by a pixel a frame, out and back, and jumps are counted.
//!
//! ```text
//! TRACEFIG_FRAMES=200 cargo test --release --lib placement::rest -- --nocapture
//! ```
//!
//! drags every body in six directions, so many frames each, and says what each figure does.
//! `TRACEFIG_FIGURE` is a part of the names of those that are dragged; `TRACEFIG_JUMPS` and `TRACEFIG_FAULTS`
//! tell each.

use std::collections::BTreeMap;
use std::path::Path;

use crate::drawing::{Offset, Point, Rect};
use crate::figure::{Figure, Labelled, draw, draw_after, plan};
use crate::geometry::DVec2;
use crate::scene::{Scene, open};

/// A label that moves farther than this from one frame to the next, on the page and as seen from what it
/// names, jumps: page pixels. An end that stays, while the text becomes longer, has not moved.
const JUMP: f64 = 8.0;
/// A label that is back after at most so many frames flickers.
const SOON: usize = 15;
/// The directions of the drags.
const WAYS: [(f64, f64); 6] = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (0.8, 0.6), (-0.8, -0.6)];
/// Frames of a drag of a usual run, in the first and fifth direction; few enough for a debug build.
const FRAMES: usize = 12;

/// Faults of labels in 100 frames of drags at most: bodies that lie where their figure has no room for them.
const MOST_FAULTS: f64 = 1.0;

/// The committed figures that have a body to drag.
fn committed() -> Vec<(String, Scene)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    let name = |p: &Path| p.file_stem().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|p| (name(p), open(p).unwrap().scene)).collect()
}

/// The box of each label and where what it names lies, by panel and key; several of a key in their order.
type Places = BTreeMap<(usize, &'static str), Vec<(Rect, Point)>>;

/// Where each label was when it moved, with the frame, and whether what it names leapt; by panel, key and
/// number.
type Left<'k> = BTreeMap<(usize, &'k str, usize), Vec<(usize, (Rect, Point), bool)>>;

fn places(figure: &Figure) -> Places {
    let mut all = Places::new();
    for (i, Labelled { frame, placed, .. }) in figure.panels.iter().chain(&figure.insets).enumerate() {
        for label in placed {
            let home = Point::new(frame.panel.x0, frame.panel.y0) + label.home;
            all.entry((i, label.key)).or_default().push((label.bounds, home));
        }
    }
    all
}

/// How far a label moved: on the page, or as seen from what it names, whichever is less.
fn leap((a, home_a): &(Rect, Point), (b, home_b): &(Rect, Point)) -> f64 {
    let least =
        |lo: f64, hi: f64| [lo, hi, 0.5 * (lo + hi)].map(f64::abs).into_iter().fold(f64::INFINITY, f64::min);
    let moved = |by: Offset| {
        let x = least(b.x0 - a.x0 - by.dx, b.x1 - a.x1 - by.dx);
        libm::hypot(x, least(b.y0 - a.y0 - by.dy, b.y1 - a.y1 - by.dy))
    };
    moved(Offset::default()).min(moved(*home_b - *home_a))
}

/// What drags did.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    /// Frames that could be drawn.
    frames: usize,
    /// Labels in all of them.
    labels: usize,
    /// Labels that jumped.
    jumps: usize,
    /// Labels that jumped and went back soon.
    flickers: usize,
    /// Labels that went where their thing went, and back with it: as a foot that leaps to another vertex.
    led: usize,
    /// Labels that jumped with their thing: the answer went to another edge or vertex.
    followed: usize,
    /// Faults of labels in all frames.
    faults: usize,
}

impl Count {
    fn add(&mut self, other: Self) {
        self.frames += other.frames;
        self.labels += other.labels;
        self.jumps += other.jumps;
        self.flickers += other.flickers;
        self.led += other.led;
        self.faults += other.faults;
        self.followed += other.followed;
    }

    #[expect(clippy::cast_precision_loss, reason = "counts of frames")]
    fn in_100_frames(&self, what: usize) -> f64 {
        100.0 * what as f64 / self.frames.max(1) as f64
    }
}

/// Drags a body of a scene out and back in a direction; `warm` whether labels rest.
fn drag(scene: &Scene, body: usize, way: (f64, f64), (frames, warm): (usize, bool)) -> Count {
    let mut count = Count::default();
    let start = scene.shapes[body].1.position;
    let scale = plan(scene).map_or(1.0, |plan| plan.panels[0].frame.scale);
    let (mut scene, mut last): (Scene, Option<Figure>) = (scene.clone(), None);
    let mut left = Left::new();
    for k in 0..frames {
        let off = u32::try_from(if k < frames / 2 { k } else { frames - k }).unwrap();
        scene.shapes[body].1.position = start + DVec2::new(way.0, way.1) * (f64::from(off) / scale);
        let Ok(plan) = plan(&scene) else {
            last = None;
            continue;
        };
        let now = draw_after(&plan, plan.theme, "drag", last.as_ref().filter(|_| warm));
        count.frames += 1;
        count.faults += now.faults().len();
        if std::env::var("TRACEFIG_FAULTS").is_ok() {
            let at = scene.shapes[body].1.position;
            now.faults().iter().for_each(|fault| println!("  {k} {fault}: body {body} by {}", at - start));
        }
        let then = last.as_ref().map(places).unwrap_or_default();
        for ((panel, key), here) in places(&now) {
            count.labels += here.len();
            let there = then.get(&(panel, key)).filter(|there| there.len() == here.len());
            for (i, (a, b)) in there.into_iter().flatten().zip(&here).enumerate() {
                if leap(a, b) > JUMP {
                    count.jumps += 1;
                    let follows = (b.1 - a.1).length() > JUMP;
                    count.followed += usize::from(follows);
                    let seen = left.entry((panel, key, i)).or_default();
                    let back = |(when, at, _): &&(usize, _, bool)| k - when <= SOON && leap(at, b) < JUMP;
                    if let Some((.., followed)) = seen.iter().rfind(back) {
                        count.flickers += usize::from(!(follows && *followed));
                        count.led += usize::from(follows && *followed);
                    }
                    seen.push((k - 1, *a, follows));
                    if std::env::var("TRACEFIG_JUMPS").is_ok() {
                        println!("  {k} {panel} {key} {:.0?} {:.0?} follows {follows}", a.0, b.0);
                    }
                }
            }
        }
        last = Some(now);
    }
    count
}

#[test]
fn labels_of_a_figure_that_is_dragged_rest() {
    let asked = std::env::var("TRACEFIG_FRAMES").ok().map(|count| count.parse().unwrap());
    let only = std::env::var("TRACEFIG_FIGURE").ok();
    let warm = std::env::var("TRACEFIG_COLD").is_err();
    let mut all = Count::default();
    for (name, scene) in committed() {
        if only.as_ref().is_some_and(|only| !name.contains(only)) {
            continue;
        }
        let mut sum = Count::default();
        let bodies = if asked.is_some() { 0..scene.shapes.len() } else { 0..1 };
        for body in bodies {
            for way in WAYS.into_iter().step_by(if asked.is_some() { 1 } else { 4 }) {
                sum.add(drag(&scene, body, way, (asked.unwrap_or(FRAMES), warm)));
            }
        }
        let said = [sum.jumps, sum.flickers, sum.faults].map(|n| sum.in_100_frames(n));
        println!("{name:24} {said:6.1?} in 100 frames, {} of {} frames", sum.jumps, sum.frames);
        all.add(sum);
    }
    let said = [all.jumps, all.flickers, all.faults].map(|n| all.in_100_frames(n));
    println!("{:24} {said:6.2?} in 100 frames: jumps, there and back, faults; {all:?}", "all");
    assert!(all.labels > 5 * all.frames, "{all:?}");
    // The goal is a tenth. The first frames of each drag are too few to tell one: of them one may go back.
    let most = if asked.is_some() { 0.1 } else { 0.2 };
    assert!(said[0] <= 5.0 && said[1] <= most, "jumps and flickers in 100 frames: {said:?}");
    assert!(said[2] <= MOST_FAULTS, "faults in 100 frames: {said:?}");
}

#[test]
fn a_figure_that_is_drawn_again_after_itself_is_the_same() {
    for (name, scene) in committed() {
        let plan = plan(&scene).unwrap();
        let first = draw(&plan, plan.theme, &name);
        let alone = draw_after(&plan, plan.theme, &name, None);
        let alone = Figure { drawing: alone.drawing.finished(), ..alone };
        assert_eq!(first, alone, "{name}");
        let again = draw_after(&plan, plan.theme, &name, Some(&first));
        for (a, b) in places(&first).into_iter().zip(places(&again)) {
            assert_eq!(a.0, b.0, "{name}");
            assert!(a.1.iter().zip(&b.1).all(|(p, q)| leap(p, q) < 1e-6), "{name}: {a:?} {b:?}");
        }
    }
}
