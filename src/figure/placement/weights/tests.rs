//! What goes wrong at twice and at half of each number: labels are placed again by the numbers that differ in
//! one.

use std::path::Path;

use crate::drawing::Rect;
use crate::figure::drawn_panel::{Sheet, earlier, sought};
use crate::figure::placement::moving::place_by;
use crate::figure::placement::solve::Ground;
use crate::figure::placement::{Labelled, Sought, faults, things};
use crate::figure::plan::{Plan, plan};
use crate::figure::random_scenes;
use crate::figure::sketch::Sketched;
use crate::scene::{Source, open, read};

use super::{Costs, Places, Search, TUNED, Weights};

/// A label that is nearer than this to where it was, page pixels, has not moved.
const STILL: f64 = 0.01;

/// A number, a count or a list of numbers that can be multiplied.
pub(super) trait Scale {
    /// Multiplies by `by`; a count is at least 1.
    fn scale(&mut self, by: f64);
}

impl Scale for f64 {
    fn scale(&mut self, by: f64) {
        *self *= by;
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small counts")]
#[expect(clippy::cast_precision_loss, reason = "small counts")]
impl Scale for usize {
    fn scale(&mut self, by: f64) {
        *self = ((*self as f64 * by) as usize).max(1);
    }
}

impl<const N: usize> Scale for [f64; N] {
    fn scale(&mut self, by: f64) {
        for x in self.iter_mut() {
            *x *= by;
        }
    }
}

/// The panels of a figure, ready for their labels.
struct Case {
    /// For each panel what its layers drew, and the labels that seek their places there.
    panels: Vec<(Sketched, Vec<Sought>)>,
    /// For each panel those before it whose labels stand where its own should stand too.
    series: Vec<Vec<usize>>,
}

impl Case {
    fn of(plan: &Plan) -> Self {
        let panels: Vec<_> = (0..plan.panels.len())
            .map(|i| sought(Sheet { plan, theme: plan.theme, share: 1.0 }, i, None).0)
            .collect();
        let series = (0..panels.len()).map(|i| earlier(plan, i).collect()).collect();
        Self { panels, series }
    }

    /// The labels by some numbers.
    fn placed(&self, weights: &Weights) -> Vec<Labelled> {
        let mut all: Vec<Labelled> = Vec::new();
        for ((sketched, sought), series) in self.panels.iter().zip(&self.series) {
            let before = series.iter().map(|&i| &all[i]);
            let before: Vec<(Rect, _)> =
                before.flat_map(|l| l.placed.iter().map(|p| (l.frame.panel, p.clone()))).collect();
            let Sketched { frame, obstacles, requests, unnamed, .. } = sketched;
            let things = &things(requests, unnamed, obstacles, frame);
            let panels = self.panels.len();
            let ground = Ground { frame, obstacles, things, earlier: &before, before: None, panels };
            all.push(place_by(weights, sought, &ground));
        }
        all
    }
}

/// The committed figures.
fn committed() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    paths.iter().map(|p| Case::of(&plan(&open(p).unwrap().scene).unwrap())).collect()
}

/// The random scenes of `count` seeds that show anything.
fn random(count: u64) -> Vec<Case> {
    let scene = |seed| read(&Source::new("random", &random_scenes::scene_text(seed))).unwrap();
    (0..count)
        .filter_map(|seed| random_scenes::fed(scene(seed)))
        .map(|s| Case::of(&plan(&s).unwrap()))
        .collect()
}

/// What the survey counts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Count {
    /// What a reader trips over.
    faults: usize,
    /// Labels that stand elsewhere than by the tuned numbers.
    moved: usize,
}

/// Faults by some numbers, and how many labels stand elsewhere than `tuned`.
fn count(cases: &[Case], tuned: &[Vec<Labelled>], weights: &Weights) -> Count {
    let mut count = Count::default();
    for (case, tuned) in cases.iter().zip(tuned) {
        for (now, then) in case.placed(weights).iter().zip(tuned) {
            count.faults += faults(now).len();
            let still = |p: &crate::figure::Placed| {
                let same = then.placed.iter().filter(|q| q.key == p.key && q.part == p.part);
                same.into_iter().any(|q| (q.bounds.center() - p.bounds.center()).length() < STILL)
            };
            count.moved += now.placed.iter().filter(|p| !still(p)).count();
        }
    }
    count
}

/// What multiplies one number.
type Turn = Box<dyn Fn(&mut Weights, f64)>;

/// Every number by name, with what multiplies it.
fn knobs() -> Vec<(&'static str, Turn)> {
    let mut all: Vec<(&str, Turn)> = Vec::new();
    for &(name, turn) in Places::KNOBS {
        all.push((name, Box::new(move |w, by| turn(&mut w.places, by))));
    }
    for &(name, turn) in Costs::KNOBS {
        all.push((name, Box::new(move |w, by| turn(&mut w.costs, by))));
    }
    for &(name, turn) in Search::KNOBS {
        all.push((name, Box::new(move |w, by| turn(&mut w.search, by))));
    }
    all
}

/// The tuned numbers on the figures; with `TRACEFIG_SCENES` every number at twice and at half, on so many
/// random scenes too, which takes minutes.
#[test]
fn the_tuned_numbers_leave_no_fault_in_the_figures() {
    let scenes = std::env::var("TRACEFIG_SCENES").map_or(0, |count| count.parse().unwrap());
    let sets = [committed(), random(scenes)];
    let tuned = sets.each_ref().map(|cases| cases.iter().map(|c| c.placed(&TUNED)).collect::<Vec<_>>());
    let counts = |weights: &Weights| [0, 1].map(|i| count(&sets[i], &tuned[i], weights));
    let as_tuned = counts(&TUNED);
    for (i, what) in ["figures", "random scenes"].into_iter().enumerate() {
        let labels = tuned[i].iter().flatten().map(|l| l.placed.len()).sum::<usize>();
        println!("{} {what}, {labels} labels, {} faults as tuned", sets[i].len(), as_tuned[i].faults);
    }
    for (name, turn) in knobs().into_iter().filter(|_| scenes > 0) {
        for by in [2.0, 0.5] {
            let mut weights = TUNED.clone();
            turn(&mut weights, by);
            let [figures, random] = counts(&weights);
            let said = |c: Count| format!("{:>4} faults {:>5} moved", c.faults, c.moved);
            println!("{name:16} {by:>5}   figures {}   random {}", said(figures), said(random));
        }
    }
    assert_eq!(as_tuned[0], Count::default(), "the tuned numbers are those of the figures");
}

#[test]
fn a_number_that_is_multiplied_moves_labels_and_the_tuned_ones_move_none() {
    let cases = committed();
    let tuned: Vec<_> = cases.iter().map(|c| c.placed(&TUNED)).collect();
    assert!(count(&cases, &tuned, &TUNED) == Count::default());
    let mut weights = TUNED.clone();
    weights.places.gap.scale(2.0);
    weights.search.cheapest.scale(0.5);
    assert_eq!(weights.search.cheapest, 6);
    assert!(count(&cases, &tuned, &weights).moved > 0);
}
