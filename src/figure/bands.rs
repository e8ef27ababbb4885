//! What matters fills the panel: the free bands above and below it, measured on every committed figure and
//! on random scenes.
//!
//! Counted is what layers draw about their subject, with labels; no axes and grids. Panels of one space
//! share a view, so it is what they show together that fills each of them; and the panels of a row are as
//! high as the highest one asks for, so it is the row that has to be full.

use std::path::Path;

use super::placement::Labelled;
use super::sketch::{Cover, Weight};
use super::{draw, plan, random_scenes};
use crate::scene::{Scene, Source, open, read};

/// The share of a panel that a free band may take.
const SHARE: f64 = 0.2;
/// The height up to which a panel is as low as it may be, page pixels: what it shows may be flatter.
const LOWEST: f64 = 100.0;
/// How many random scenes are looked at.
const SCENES: u64 = 120;

/// The upper and the lower end of what a panel shows, page pixels; none where it shows nothing.
fn shown(panel: &Labelled) -> Option<(f64, f64)> {
    let subject = panel.obstacles.iter().filter(|o| o.weight != Weight::Background);
    let covers = subject.map(|o| match o.cover {
        Cover::Stroke { from, to, half } => (from.y.min(to.y) - half, from.y.max(to.y) + half),
        Cover::Marker { at, radius } | Cover::Head { at, radius } => (at.y - radius, at.y + radius),
    });
    let labels = panel.placed.iter().map(|label| (label.bounds.y0, label.bounds.y1));
    covers.chain(labels).reduce(|(top, bottom), (y0, y1)| (top.min(y0), bottom.max(y1)))
}

/// The larger free band of each row of panels, as a share of the row.
fn bands(scene: &Scene) -> Vec<f64> {
    let plan = plan(scene).unwrap();
    let figure = draw(&plan, plan.theme, "f");
    // From each panel's upper edge down to the first and the last thing that it shows.
    let within = |panel: &Labelled| {
        shown(panel).map(|(y0, y1)| (y0 - panel.frame.panel.y0, y1 - panel.frame.panel.y0))
    };
    let own: Vec<_> = figure.panels.iter().map(within).collect();
    let sources: Vec<_> = plan.panels.iter().map(|panel| &panel.source).collect();
    let same = |i: usize, j: usize| {
        i == j
            || (sources[i].view.is_none()
                && sources[j].view.is_none()
                && sources[i].space == sources[j].space)
    };
    let mut rows: Vec<(f64, f64, f64, f64)> = Vec::new();
    for (i, panel) in figure.panels.iter().enumerate() {
        let cell = panel.frame.panel;
        let series = (0..own.len()).filter(|&j| same(i, j)).filter_map(|j| own[j]);
        let Some((top, bottom)) = series.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))) else { continue };
        match rows.iter_mut().find(|row| row.0 == cell.y0) {
            Some(row) => (row.2, row.3) = (row.2.min(top), row.3.max(bottom)),
            None => rows.push((cell.y0, cell.height(), top, bottom)),
        }
    }
    rows.retain(|&(_, height, ..)| height > LOWEST);
    rows.iter().map(|&(_, height, top, bottom)| top.max(height - bottom) / height).collect()
}

/// What of some scenes has a free band that is too large.
fn empty(scenes: impl Iterator<Item = (String, Scene)>) -> Vec<String> {
    let worst = |scene: &Scene| bands(scene).into_iter().fold(0.0, f64::max);
    scenes
        .map(|(name, scene)| (worst(&scene), name))
        .filter(|(band, _)| *band > SHARE)
        .map(|(band, name)| format!("{name}: {:.0} %", 100.0 * band))
        .collect()
}

#[test]
fn no_committed_figure_has_a_free_band_of_more_than_a_fifth() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "toml"));
    paths.sort();
    assert!(paths.len() > 15);
    let scenes = paths.iter().map(|path| (path.display().to_string(), open(path).unwrap().scene));
    assert_eq!(empty(scenes), [""; 0]);
}

#[test]
fn hardly_a_random_scene_has_a_panel_with_a_free_band_of_more_than_a_fifth() {
    let scene = |seed| read(&Source::new("random", &random_scenes::scene_text(seed))).unwrap();
    let fed = |seed| Some((format!("scene {seed}"), random_scenes::fed(scene(seed))?));
    let scenes: Vec<_> = (0..SCENES).filter_map(fed).collect();
    assert!(scenes.len() > 60, "{}", scenes.len());
    // A drawing that was made smaller for names of twenty letters may leave a quarter.
    let found = empty(scenes.into_iter());
    assert!(found.len() <= 1, "{found:?}");
}

#[test]
fn a_view_that_leaves_half_of_a_panel_free_is_found() {
    let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }\n\
                panels = [{ view = [-2, -3, 2, 3], layers = ['shapes'] }]\n";
    let bands = bands(&read(&Source::new("high", text)).unwrap());
    assert!((bands[0] - 1.0 / 3.0).abs() < 0.01, "{bands:?}");
}
