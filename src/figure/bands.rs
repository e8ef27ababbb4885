//! What matters fills the panel: the free bands above and below it, as a share of a row of panels.
//!
//! Counted is what layers draw about their subject, with labels; no axes and grids. Panels of one space
//! share a view, so it is what they show together that fills each of them; and the panels of a row are as
//! high as the highest one asks for, so it is the row that has to be full.

use super::placement::Labelled;
use super::plan::Plan;
use super::sketch::{Cover, Weight};

/// The share of a row of panels that a free band may take.
pub(super) const A_FIFTH: f64 = 0.2;
/// The share that it may take where no label finds its place otherwise: one that is struck through is worse.
pub(super) const A_QUARTER: f64 = 0.25;
/// The height up to which a panel is as low as it may be, page pixels: what it shows may be flatter.
const LOWEST: f64 = 100.0;

/// The largest free band, as a share of its row of panels.
pub(super) fn widest(plan: &Plan, panels: &[Labelled], insets: &[Labelled]) -> f64 {
    bands(plan, panels, insets).into_iter().fold(0.0, f64::max)
}

/// The upper and the lower end of what a panel and its inset show, page pixels; none where that is nothing.
fn shown(panel: &Labelled, insets: &[Labelled]) -> Option<(f64, f64)> {
    let subject = panel.obstacles.iter().filter(|o| o.weight != Weight::Background);
    let covers = subject.map(|o| match o.cover {
        Cover::Stroke { from, to, half } => (from.y.min(to.y) - half, from.y.max(to.y) + half),
        Cover::Marker { at, radius } | Cover::Head { at, radius } => (at.y - radius, at.y + radius),
    });
    let labels = panel.placed.iter().map(|label| (label.bounds.y0, label.bounds.y1));
    let cell = panel.frame.panel;
    let own = insets.iter().map(|inset| inset.frame.panel).filter(|rect| cell.union(*rect) == cell);
    covers
        .chain(labels)
        .chain(own.map(|rect| (rect.y0, rect.y1)))
        .reduce(|(top, bottom), (y0, y1)| (top.min(y0), bottom.max(y1)))
}

/// The larger free band of each row of panels, as a share of the row.
fn bands(plan: &Plan, panels: &[Labelled], insets: &[Labelled]) -> Vec<f64> {
    // From each panel's upper edge down to the first and the last thing that it shows.
    let within = |panel: &Labelled| {
        shown(panel, insets).map(|(y0, y1)| (y0 - panel.frame.panel.y0, y1 - panel.frame.panel.y0))
    };
    let own: Vec<_> = panels.iter().map(within).collect();
    let sources: Vec<_> = plan.panels.iter().map(|panel| &panel.source).collect();
    let same = |i: usize, j: usize| {
        i == j
            || (sources[i].view.is_none()
                && sources[j].view.is_none()
                && sources[i].space == sources[j].space)
    };
    let mut rows: Vec<(f64, f64, f64, f64)> = Vec::new();
    for (i, panel) in panels.iter().enumerate() {
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::figure::{draw, plan, random_scenes};
    use crate::scene::{Scene, Source, open, read};

    /// How many random scenes are looked at where nobody says.
    const SCENES: u64 = 120;

    /// The larger free band of each row of panels of a scene.
    fn bands_of(scene: &Scene) -> Vec<f64> {
        let plan = plan(scene).unwrap();
        let figure = draw(&plan, plan.theme, "f");
        bands(&plan, &figure.panels, &figure.insets)
    }

    /// What of some scenes has a free band that is too large.
    fn emptier(most: f64, scenes: impl Iterator<Item = (String, Scene)>) -> Vec<String> {
        let worst = |scene: &Scene| bands_of(scene).into_iter().fold(0.0, f64::max);
        scenes
            .map(|(name, scene)| (worst(&scene), name))
            .filter(|(band, _)| *band > most)
            .map(|(band, name)| format!("{name}: {:.0} %", 100.0 * band))
            .collect()
    }

    #[test]
    fn no_committed_figure_has_a_free_band_of_more_than_a_fifth() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
        let mut paths: Vec<_> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.retain(|path| path.extension().is_some_and(|end| end == "toml"));
        paths.sort();
        assert!(paths.len() > 15);
        let scenes = paths.iter().map(|path| (path.display().to_string(), open(path).unwrap().scene));
        assert_eq!(emptier(A_FIFTH, scenes), [""; 0]);
    }

    #[test]
    fn a_random_scene_has_no_free_band_of_more_than_a_fifth_but_for_its_labels() {
        let scene = |seed| read(&Source::new("random", &random_scenes::scene_text(seed))).unwrap();
        let fed = |seed| Some((format!("scene {seed}"), random_scenes::fed(scene(seed))?));
        let asked = std::env::var("TRACEFIG_SCENES").ok().and_then(|n| n.parse().ok()).unwrap_or(SCENES);
        let scenes = || (0..asked).filter_map(fed);
        assert_eq!(emptier(A_QUARTER, scenes()), [""; 0]);
        let found = emptier(A_FIFTH, scenes());
        // One in a hundred.
        assert!(found.len() as u64 <= asked.div_ceil(100), "{found:?}");
    }

    #[test]
    fn a_view_that_leaves_half_of_a_panel_free_is_found() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }\n\
                    panels = [{ view = [-2, -3, 2, 3], layers = ['shapes'] }]\n";
        let bands = bands_of(&read(&Source::new("high", text)).unwrap());
        assert!((bands[0] - 1.0 / 3.0).abs() < 0.01, "{bands:?}");
    }
}
