//! Which part of its space a panel shows.
//!
//! A panel with a `view` shows that rectangle, as large as it can be. The others show what they draw, with
//! room for labels: those of one space share one view, and all share one scale.

use crate::drawing::Rect;
use crate::geometry::{DVec2, Pose};
use crate::scene::{Panel, Problem, Scene, Space, Spanned};

use super::frame::{Extent, Frame, union};
use super::inset::Inset;
use super::limits::{MAX_POINTS, areas_within, within};
use super::page::{Layout, Page, Want, in_column, room};
use super::panel::PanelPlan;
use super::runs::Runs;
use super::sketch::{Outline, Sketched};
use super::theme::Theme;

/// How often a view is fitted again to what its layers drew in the view before: lines, heads and markers are
/// as large in page pixels in every view, so what they reach in world units depends on it. In the committed
/// figures, their views taken away, one more pass moves the corner of a panel by up to 17 page pixels after
/// two, where dimensions stand side by side (box-box), and by 5 elsewhere; a label has 40 of room.
const PASSES: usize = 2;
/// How often at most, where a panel without a `view` does not hold all that it draws: lines beside a small
/// drawing that take the most of its panel come near their places in more passes.
const MOST_PASSES: usize = 12;
/// Half the width and height of what is shown about a lone point, world units: wide and low, as it and its
/// labels are.
const NOTHING: DVec2 = DVec2::new(1.0, 0.3);
/// The room above a drawing that an inset takes which finds none beside it, page pixels.
const ABOVE: f64 = 100.0;

/// Gives every panel its frame on a page that suits what they show, and says what their layers draw there.
///
/// A view is known only once its layers have drawn, and they draw in a view: so a panel without a `view` is
/// sketched three times, in a first guess and in two better ones, of which the last stays; more often where
/// that cuts something off. Where every panel has a `view`, once. [`draw`](super::draw::draw) sketches it
/// again where another theme is asked for.
///
/// # Errors
///
/// When the panels draw more than a figure may show.
pub(super) fn fit(
    scene: &Scene,
    runs: &Runs,
    theme: &Theme,
    layout: &Layout,
    panels: &mut [PanelPlan],
) -> Result<(Vec<Sketched>, Page), Problem> {
    let guesses: Vec<Extent> = panels.iter().map(|panel| first_guess(scene, panel)).collect();
    let laid = |layout: &Layout, panels: &mut [PanelPlan], extents: &[Extent]| {
        let page = arrange(scene, layout, panels, extents);
        Ok((page, sketch(scene, runs, theme, panels)?))
    };
    let (mut page, mut sketched) = laid(layout, panels, &guesses)?;
    for pass in 0..MOST_PASSES {
        if pass >= PASSES && !panels.iter().zip(&sketched).any(is_cut) {
            break;
        }
        let extents = extents(panels, &sketched, &guesses);
        if extents.iter().all(Option::is_none) {
            break;
        }
        (page, sketched) = laid(layout, panels, &extents)?;
    }
    let before: Vec<(Extent, Frame)> = panels.iter().map(|panel| (panel.reach, panel.frame)).collect();
    if make_room(panels, &sketched) {
        // Side by side they would have half of the size and of the room that was made, and lack it again.
        let layout = &Layout { columns: Some(page.columns), ..*layout };
        let (higher, found) = laid(layout, panels, &extents(panels, &sketched, &guesses))?;
        let is_taken = |((panel, was), sketched): ((&PanelPlan, &(Extent, Frame)), &Sketched)| {
            panel.reach != was.0 && panel.inset(sketched, None).is_some()
        };
        if panels.iter().zip(&before).zip(&found).any(is_taken) {
            (page, sketched) = (higher, found);
        } else {
            // Room that nothing takes makes bodies small.
            for (panel, was) in panels.iter_mut().zip(before) {
                (panel.reach, panel.frame) = was;
            }
        }
    }
    for (panel, sketched) in panels.iter_mut().zip(&sketched) {
        panel.keep_inset((scene, runs), theme, sketched);
    }
    Ok((sketched, page))
}

/// Whether a panel that shows what it draws does not hold all of it. A chart fills its panel in any view.
fn is_cut((panel, sketched): (&PanelPlan, &Sketched)) -> bool {
    panel.source.view.is_none() && !panel.is_chart() && !sketched.frame.holds(sketched.extent)
}

/// Makes panels that lack room for an inset reach higher; whether one does.
fn make_room(panels: &mut [PanelPlan], sketched: &[Sketched]) -> bool {
    let mut higher = false;
    for (panel, sketched) in panels.iter_mut().zip(sketched) {
        let free = panel.source.view.is_none() && Inset::lacks_room(&panel.source, sketched);
        if let Some((lo, hi)) = sketched.extent.filter(|_| free) {
            let above = DVec2::new(0.0, ABOVE / panel.frame.scale);
            panel.reach = union(panel.reach, Some((lo, hi + above)));
            higher = true;
        }
    }
    higher
}

/// Lets all layers draw in the frames that the panels have now.
///
/// # Errors
///
/// When they draw more than a figure may show.
pub(super) fn sketch(
    scene: &Scene,
    runs: &Runs,
    theme: &Theme,
    panels: &[PanelPlan],
) -> Result<Vec<Sketched>, Problem> {
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
pub(super) fn pose(scene: &Scene, panel: &PanelPlan) -> Option<Pose> {
    match panel.source.space {
        Space::Body(i) => scene.shapes.get(i).map(|(_, body)| body.pose_at(panel.moment.time)),
        Space::World | Space::Configuration => None,
    }
}

/// The bodies at the panel's moment, for the world; something of their size about the origin for other
/// spaces. Nothing for a panel with a `view`.
fn first_guess(scene: &Scene, panel: &PanelPlan) -> Extent {
    if panel.source.view.is_some() {
        return None;
    }
    let pose = pose(scene, panel);
    let bodies = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i)).map(|(_, body)| body);
    let points = bodies.flat_map(|body| Outline::of_body(body, &body.pose_at(panel.moment.time)).sampled());
    let around = |all: Extent, p: DVec2| Some(all.map_or((p, p), |(lo, hi)| (lo.min(p), hi.max(p))));
    points
        .map(|p| pose.map_or(p, |pose| pose.inverse_point(p)))
        .fold(None, around)
        .or(Some((DVec2::NEG_ONE, DVec2::ONE)))
}

/// What each panel shows after it was drawn: what all panels of its space and width drew together, or a guess
/// where they drew nothing. A chart fills its panel: a wide one would make bodies beside it small.
fn extents(panels: &[PanelPlan], sketched: &[Sketched], guesses: &[Extent]) -> Vec<Extent> {
    let drawn = |panel: &PanelPlan| {
        let free = panels.iter().zip(sketched).filter(|(other, _)| other.source.view.is_none());
        let is_same =
            |other: &Panel| (&other.space, other.columns) == (&panel.source.space, panel.source.columns);
        let same = free.filter(|(other, _)| is_same(&other.source));
        same.map(|(other, s)| union(s.extent, other.reach)).fold(None, union)
    };
    panels
        .iter()
        .zip(guesses)
        .map(|(panel, guess)| guess.map(|guess| drawn(panel).unwrap_or(guess)))
        .collect()
}

/// Makes the page for what the panels show, and gives each its frame there: a `view` as large as its panel
/// allows; the others in one size, each about its own middle.
fn arrange(scene: &Scene, layout: &Layout, panels: &mut [PanelPlan], extents: &[Extent]) -> Page {
    let shown = panels.iter().zip(extents).map(|(panel, extent)| match &panel.source.view {
        Some(Spanned { value: [x0, y0, x1, y1], .. }) => (DVec2::new(*x0, *y0), DVec2::new(*x1, *y1)),
        None => extent.unwrap_or_default(),
    });
    let shown: Vec<(DVec2, DVec2)> = shown.collect();
    let want = |(panel, (lo, hi)): (&PanelPlan, &(DVec2, DVec2))| Want {
        width: hi.x - lo.x,
        height: hi.y - lo.y,
        room: panel.source.view.is_none(),
        columns: panel.source.columns.unwrap_or(1),
        lines: panel.caption.len(),
    };
    let wants: Vec<Want> = panels.iter().zip(&shown).map(want).collect();
    let page = layout.page(&wants);
    let column = in_column(&wants, page.columns);
    let letters = layout.measures.larger();
    for (i, (panel, cell)) in panels.iter_mut().zip(&page.cells).enumerate() {
        let width = column * wants[i].taken(page.columns);
        let (lo, hi) = if wants[i].room { as_wide(shown[i], width) } else { shown[i] };
        let (aside, above) = match panel.source.view {
            Some(_) => (0.0, 0.0),
            None => room((cell.width(), cell.height()), letters),
        };
        let inner =
            Rect { x0: cell.x0 + aside, y0: cell.y0 + above, x1: cell.x1 - aside, y1: cell.y1 - above };
        panel.frame = Frame { panel: *cell, ..Frame::fit(pose(scene, panel), lo, hi, inner) };
    }
    let free = || panels.iter().filter(|panel| panel.source.view.is_none());
    let scale = free().map(|panel| panel.frame.scale).fold(f64::INFINITY, f64::min);
    panels.iter_mut().filter(|panel| panel.source.view.is_none()).for_each(|panel| panel.frame.scale = scale);
    page
}

/// The extent about its middle, as wide as the widest. A point, or nothing, still has something about it.
fn as_wide((lo, hi): (DVec2, DVec2), width: f64) -> (DVec2, DVec2) {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * DVec2::new(width, hi.y - lo.y));
    let half = if half.max_element() > 0.0 { half } else { NOTHING };
    (middle - half, middle + half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::plan;
    use crate::scene::open;
    use std::path::Path;

    #[test]
    fn a_gap_too_small_to_be_seen_is_enlarged_on_a_wide_floor() {
        for (shape, gap) in
            [("radius = 0.5", 0.01), ("radius = 0.5", 0.001), ("half_extents = [0.5, 0.5]", 0.001)]
        {
            let kind = if shape.starts_with('r') { "circle" } else { "box" };
            let text = format!(
                "[shapes.floor]\nkind = 'aabb'\nhalf_extents = [10, 0.5]\nposition = [0, -0.5]\n\
                 [shapes.ball]\nkind = '{kind}'\n{shape}\nposition = [1, {}]\n\
                 [query]\nkind = 'separation'\nof = ['floor', 'ball']",
                0.5 + gap
            );
            let scene = crate::scene::open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let sketched = sketch(plan.scene, &plan.runs, plan.theme, &plan.panels).unwrap();
            let insets = plan.panels.iter().zip(&sketched).filter_map(|(panel, s)| panel.inset(s, None));
            assert_eq!(insets.count(), 2, "{text}");
        }
    }

    #[test]
    fn a_view_holds_lines_beside_a_drawing_that_take_the_most_of_its_panel() {
        for width in [240, 310, 620] {
            let text = format!(
                "shapes.A = {{ kind = 'aabb', half_extents = [1, 1] }}
                shapes.B = {{ kind = 'aabb', half_extents = [0.2, 0.2], position = [0.3, 0.1] }}
                query = {{ kind = 'overlap', of = ['A', 'B'], algorithm = 'extents' }}
                canvas = {{ width = {width} }}
                panels = [{{ layers = ['shapes', 'axis-gaps'] }}, {{ layers = ['shapes', 'separation'] }}]"
            );
            let scene = crate::scene::open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let sketched = sketch(plan.scene, &plan.runs, plan.theme, &plan.panels).unwrap();
            assert!(!plan.panels.iter().zip(&sketched).any(is_cut), "{width}");
            // The boxes are still seen: A is two units wide.
            assert!(plan.panels[0].frame.scale > 15.0, "{width}: {}", plan.panels[0].frame.scale);
        }
    }

    #[test]
    fn a_panel_of_two_columns_has_the_scale_of_the_others_and_is_drawn_as_full() {
        let text = |columns: &str| {
            format!(
                "shapes.A = {{ kind = 'circle', radius = 1 }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [9, 1] }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [
                    {{ space = 'configuration', layers = [{{ layer = 'difference', labels = false }}] }},
                    {{ space = 'configuration', layers = [{{ layer = 'difference', labels = false }}] }},
                    {{ layers = ['shapes', 'separation']{columns} }},
                ]"
            )
        };
        for (columns, wide) in [("", false), (", columns = 2", true)] {
            let scene = crate::scene::open_text("s.toml", &text(columns)).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let scales: Vec<f64> = plan.panels.iter().map(|panel| panel.frame.scale).collect();
            let panel = plan.panels[2].frame.panel;
            assert!(scales[0] == scales[1] && scales[1] == scales[2], "{scales:?}");
            // From A's left to B's right there are eleven units.
            assert_eq!(11.0 * scales[2] > 500.0, wide, "{scales:?}");
            assert!(11.0 * scales[2] > 0.6 * panel.width(), "{scales:?} {panel:?}");
        }
    }

    /// How far another pass would move the corners of a figure's panels, its views taken away, page pixels.
    fn moved(path: &Path) -> f64 {
        let mut scene = open(path).unwrap().scene;
        for panel in &mut scene.panels {
            panel.view = None;
            // A chart fills what a wide panel has, and its view changes with every pass.
            panel.columns = None;
            // What is enlarged is another panel's view.
            if let Some(layers) = &mut panel.layers {
                layers.retain(|layer| layer.name.value != "enlarged");
            }
        }
        scene.labels.retain(|(key, _)| key.value != "enlarged");
        let mut plan = plan(&scene).unwrap();
        let before: Vec<Frame> = plan.panels.iter().map(|panel| panel.frame).collect();
        let sketched = sketch(&scene, &plan.runs, plan.theme, &plan.panels).unwrap();
        let guesses: Vec<Extent> = plan.panels.iter().map(|panel| first_guess(&scene, panel)).collect();
        let extents = extents(&plan.panels, &sketched, &guesses);
        let layout = plan.layout;
        arrange(&scene, &layout, &mut plan.panels, &extents);
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
        let scenes: Vec<_> = paths.filter(|p| p.extension().is_some_and(|e| e == "toml")).collect();
        assert!(scenes.len() >= 19, "{scenes:?}");
        for path in scenes {
            let moved = moved(&path);
            assert!(moved < 20.0, "{}: {moved} px", path.display());
        }
    }
}
