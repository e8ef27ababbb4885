//! A frame around what another panel shows of the same space, enlarged.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Outline, Pen, Rank, Size, Sketch, Weight};
use crate::geometry::DVec2;
use crate::trace::phrase;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Opacity of the frame: it lies over what it shows.
const QUIET: f64 = 0.6;

pub(super) const LAYER: Layer = Layer {
    name: "enlarged",
    in_words: phrase(["enlarged", "Rahmen um ein Detail", "cadre d’un détail", "marco de un detalle"]),
    about: "a frame around what another panel shows enlarged",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[OptionSpec {
        name: "panel",
        takes: Takes::Counts,
        default: "the next panel of this space with a view",
        about: "which panel, from 1",
    }],
    labels: &[LabelKey { key: "enlarged", about: "the frame; only where a scene gives it a text" }],
    needs: "another panel of the same space with a `view`",
    fed: |context, options| Fed::by_the_scene(framed(context, options).is_some()),
    draw,
};

/// The rectangle that another panel shows, by its lower left and its upper right end, in the panel's own
/// coordinates.
fn framed(context: &Context, options: &Options) -> Option<[DVec2; 2]> {
    let all = &context.scene.panels;
    let view = |index: usize| {
        let panel = all.get(index).filter(|panel| panel.space == *context.space)?;
        panel.view.as_ref().map(|view| view.value)
    };
    let asked = options.counts("panel").and_then(|counts| counts.first().copied());
    let [x0, y0, x1, y1] = match asked {
        Some(number) => view(number.checked_sub(1)?)?,
        None => (1..all.len()).find_map(view)?,
    };
    Some([DVec2::new(x0, y0), DVec2::new(x1, y1)])
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    // An inset is a detail of the panel, in which the frame stands already.
    let Some([lo, hi]) = framed(context, options).filter(|_| sketch.has_numbers()) else { return };
    // Of a panel that frames itself the line lies within the view, which would cut it in half.
    let (least, most, pen) = (sketch.visible().0, sketch.visible().1, DVec2::splat(sketch.px(1.0)));
    let (lo, hi) = (lo.max(least + pen), hi.min(most - pen));
    let corners = [lo, DVec2::new(hi.x, lo.y), hi, DVec2::new(lo.x, hi.y)];
    let corners = corners.map(|p| context.frame().map_or(p, |pose| pose.point(p)));
    let role = options.role(Role::Muted);
    let outline = Outline::polygon(&corners);
    // Lines, and no area of which a label would say that it lies in it.
    sketch.part("around").weight(Weight::Background);
    for (i, &corner) in corners.iter().enumerate() {
        sketch.line(corner, corners[(i + 1) % corners.len()], Pen::dimension(role).opacity(QUIET));
    }
    let anchor = Anchor::inside(&outline);
    sketch.label(Label::new("enlarged", "", anchor, role).rank(Rank::Word).size(Size::Note));
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    /// A scene of two panels whose first one frames what the other shows.
    fn scene(second: &str) -> crate::scene::Scene {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            query = {{ kind = 'bounds', of = ['A'] }}
            panels = [{{ view = [-4, -2, 4, 2], layers = ['shapes', 'enlarged'] }}, {second}]"
        );
        open_text("enlarged", &text).unwrap().scene
    }

    #[test]
    fn the_frame_lies_around_what_the_other_panel_shows() {
        let scene = scene("{ view = [0, -0.5, 2, 1], layers = ['shapes'] }");
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "enlarged");
        let lines = paths(&figure.drawing.items, "around");
        let corners = lines.iter().map(|line| line.contour.bounds().unwrap());
        let bounds = corners.reduce(crate::drawing::Rect::union).unwrap();
        let page = |x, y| figure.panels[0].frame.page(DVec2::new(x, y));
        let (lower, upper) = (page(0.0, -0.5), page(2.0, 1.0));
        assert!((bounds.x0 - lower.x).abs() < 1e-9 && (bounds.y1 - lower.y).abs() < 1e-9);
        assert!((bounds.x1 - upper.x).abs() < 1e-9 && (bounds.y0 - upper.y).abs() < 1e-9);
    }

    #[test]
    fn a_panel_that_frames_itself_shows_the_whole_line() {
        let scene = scene("{ view = [0, -0.5, 2, 1], layers = [{ layer = 'enlarged', panel = 2 }] }");
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "enlarged");
        let panel = figure.panels[1].frame.panel;
        // The first panel has this frame too.
        let frames = paths(&figure.drawing.items, "around");
        assert_eq!(frames.len(), 8);
        for bounds in frames[4..].iter().map(|line| line.contour.bounds().unwrap()) {
            assert!(bounds.x0 > panel.x0 + 0.5 && bounds.x1 < panel.x1 - 0.5, "{bounds:?} in {panel:?}");
            assert!(bounds.y0 > panel.y0 + 0.5 && bounds.y1 < panel.y1 - 0.5, "{bounds:?} in {panel:?}");
        }
    }

    #[test]
    fn the_frame_stands_in_the_panel_and_not_in_its_inset() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            query = { kind = 'bounds', of = ['A'] }
            panels = [{ view = [-4, -2, 4, 2], layers = ['shapes', 'enlarged'],
                    inset = [0.6, -0.4, 1.4, 0.4] },
                { view = [0.9, -0.1, 1.1, 0.1], layers = ['shapes'] }]";
        let scene = open_text("enlarged", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "enlarged");
        assert_eq!((figure.insets.len(), paths(&figure.drawing.items, "around").len()), (1, 4));
    }

    #[test]
    fn a_panel_that_fits_its_own_view_has_no_frame() {
        assert!(plan(&scene("{ layers = ['shapes'] }")).is_err());
    }
}
