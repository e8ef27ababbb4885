//! Which part of its space a panel shows.
//!
//! A panel with a `view` shows that rectangle, as large as it can be. The others show what they draw, with
//! room for labels: those of one space share one view, and all share one scale.

use crate::drawing::Rect;
use crate::geometry::{DVec2, Pose};
use crate::scene::{Problem, Scene, Space};

use super::frame::Frame;
use super::limits::{MAX_POINTS, areas_within, within};
use super::page::Page;
use super::panel::PanelPlan;
use super::runs::Runs;
use super::sketch::{Outline, Sketched};
use super::theme::Theme;

/// Room for labels around what a panel without a `view` draws, page pixels; less in small panels.
const ROOM: f64 = 40.0;
/// The share of a small panel's shorter side that this room may take at each side.
const ROOM_SHARE: f64 = 0.12;
/// How often a view is fitted again to what its layers drew in the view before: lines, heads and markers are
/// as large in page pixels in every view, so what they reach in world units depends on it. In the committed
/// figures, their views taken away, one more pass moves the corner of a panel by up to 26 page pixels after
/// one pass, 5 after two, 1 after three; a label has 40 of room.
const PASSES: usize = 2;

/// Gives every panel its frame, and says what its layers draw there.
///
/// A view is known only once its layers have drawn, and they draw in a view: so a panel without a `view` is
/// sketched three times, in a first guess and in two better ones, of which the last stays. Where every panel
/// has a `view`, once. [`draw`](super::draw::draw) sketches it again, in the theme that is asked for.
///
/// # Errors
///
/// When the panels draw more than a figure may show.
pub(super) fn fit(
    scene: &Scene,
    runs: &Runs,
    theme: &Theme,
    page: &Page,
    panels: &mut [PanelPlan],
) -> Result<Vec<Sketched>, Problem> {
    for (panel, cell) in panels.iter_mut().zip(&page.cells) {
        let pose = pose(scene, panel);
        panel.frame = match &panel.source.view {
            Some(view) => {
                let [x0, y0, x1, y1] = view.value;
                Frame::fit(pose, DVec2::new(x0, y0), DVec2::new(x1, y1), *cell)
            }
            None => first_guess(scene, panel, pose, cell),
        };
    }
    let mut sketched = sketch(scene, runs, theme, panels)?;
    for _ in 0..PASSES {
        let extents: Vec<_> = panels
            .iter()
            .zip(&sketched)
            .map(|(panel, sketched)| sketched.extent.filter(|_| panel.source.view.is_none()))
            .collect();
        if extents.iter().all(Option::is_none) {
            break;
        }
        share(panels, &extents, page);
        sketched = sketch(scene, runs, theme, panels)?;
    }
    Ok(sketched)
}

/// Lets all layers draw in the frames that the panels have now.
///
/// # Errors
///
/// When they draw more than a figure may show.
fn sketch(scene: &Scene, runs: &Runs, theme: &Theme, panels: &[PanelPlan]) -> Result<Vec<Sketched>, Problem> {
    let (mut points, mut painted) = (0_usize, 0.0);
    let mut all = Vec::with_capacity(panels.len());
    for panel in panels {
        let sketched = panel.sketch(&panel.context(scene, runs), theme);
        points = points.saturating_add(sketched.points);
        painted += sketched.painted;
        within("the lines of the figure", "points", points, MAX_POINTS, &panel.source.span)?;
        areas_within(painted, &panel.source.span)?;
        all.push(sketched);
    }
    Ok(all)
}

/// The pose of the body in whose frame a panel shows; `None` for other panels.
fn pose(scene: &Scene, panel: &PanelPlan) -> Option<Pose> {
    match panel.source.space {
        Space::Body(i) => scene.shapes.get(i).map(|(_, body)| body.pose_at(panel.moment.time)),
        Space::World | Space::Configuration => None,
    }
}

/// The bodies at the panel's moment, for the world; something of their size about the origin for other
/// spaces.
fn first_guess(scene: &Scene, panel: &PanelPlan, pose: Option<Pose>, cell: &Rect) -> Frame {
    let bodies = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i)).map(|(_, body)| body);
    let points = bodies.flat_map(|body| Outline::of_body(body, &body.pose_at(panel.moment.time)).sampled());
    let (lo, hi) = points
        .map(|p| pose.map_or(p, |pose| pose.inverse_point(p)))
        .fold(None, |all: Option<(DVec2, DVec2)>, p| {
            Some(all.map_or((p, p), |(lo, hi)| (lo.min(p), hi.max(p))))
        })
        .unwrap_or((DVec2::NEG_ONE, DVec2::ONE));
    padded(pose, lo, hi, cell)
}

/// The frame of a panel that shows the rectangle from `lo` to `hi`, with room for labels around it.
fn padded(pose: Option<Pose>, lo: DVec2, hi: DVec2, cell: &Rect) -> Frame {
    let room = ROOM.min(ROOM_SHARE * cell.width().min(cell.height()));
    // A point, or nothing, still has a view about it.
    let (lo, hi) = if (hi - lo).max_element() > 0.0 { (lo, hi) } else { (lo - DVec2::ONE, hi + DVec2::ONE) };
    Frame { panel: *cell, ..Frame::fit(pose, lo, hi, cell.grown(-room)) }
}

/// Fits the panels anew to what they drew. Those of one space share their extent; all share the larger size,
/// each about its own middle.
fn share(panels: &mut [PanelPlan], extents: &[Option<(DVec2, DVec2)>], page: &Page) {
    let shared: Vec<Option<(DVec2, DVec2)>> = panels
        .iter()
        .map(|panel| {
            let same =
                panels.iter().zip(extents).filter(|(other, _)| other.source.space == panel.source.space);
            same.filter_map(|(_, extent)| *extent).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
        })
        .collect();
    let size = shared
        .iter()
        .zip(extents)
        .filter(|(_, e)| e.is_some())
        .filter_map(|(s, _)| *s)
        .map(|(lo, hi)| hi - lo);
    let Some(size) = size.reduce(DVec2::max) else { return };
    for ((panel, cell), (shared, extent)) in
        panels.iter_mut().zip(&page.cells).zip(shared.iter().zip(extents))
    {
        if let (Some((lo, hi)), Some(_)) = (shared, extent) {
            let middle = 0.5 * (*lo + *hi);
            panel.frame = padded(panel.frame.pose, middle - 0.5 * size, middle + 0.5 * size, cell);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::plan;
    use crate::scene::open;
    use std::path::Path;

    /// How far another pass would move the corners of a figure's panels, its views taken away, page pixels.
    fn moved(path: &Path) -> f64 {
        let mut scene = open(path).unwrap().scene;
        scene.panels.iter_mut().for_each(|panel| panel.view = None);
        let mut plan = plan(&scene).unwrap();
        let before: Vec<Frame> = plan.panels.iter().map(|panel| panel.frame).collect();
        let sketched = sketch(&scene, &plan.runs, plan.theme, &plan.panels).unwrap();
        let extents: Vec<_> = plan
            .panels
            .iter()
            .zip(&sketched)
            .map(|(panel, sketched)| sketched.extent.filter(|_| panel.source.view.is_none()))
            .collect();
        share(&mut plan.panels, &extents, &plan.page);
        let corner = |frame: &Frame, now: &Frame| {
            let half = 0.5 * DVec2::new(frame.panel.width(), frame.panel.height()) / frame.scale;
            let p = frame.center + half;
            let p = frame.pose.map_or(p, |pose| pose.point(p));
            (frame.page(p) - now.page(p)).length()
        };
        before.iter().zip(&plan.panels).map(|(frame, panel)| corner(frame, &panel.frame)).fold(0.0, f64::max)
    }

    #[test]
    fn another_pass_would_hardly_move_a_view() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
        let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        for path in paths.filter(|p| p.extension().is_some_and(|e| e == "toml")) {
            let moved = moved(&path);
            assert!(moved < 0.25 * ROOM, "{}: {moved} px", path.display());
        }
    }
}
