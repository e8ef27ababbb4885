//! Narrow pages: panels stand side by side only where their longest labels fit in them.
//!
//! How many columns suit what panels show is known before their labels are; a page that ends with the drawing
//! may have fewer then, and be higher.

use std::sync::Arc;

use crate::scene::Scene;
use crate::typeset::Line;

use super::layer::is_key;
use super::page::{Layout, Page};
use super::panel::PanelPlan;
use super::placement::Cut;
use super::runs::Runs;
use super::sketch::{Request, Size, Sketched};
use super::text::Wording;

/// The share of a panel's width that a label may take: beside a line, it needs room on one side of it.
const SHARE: f64 = 0.85;

/// The columns in which the labels of panels fit that stand in more without being asked to; `None` where they
/// do as they stand.
pub(super) fn columns(
    (scene, runs): (&Scene, &Runs),
    layout: &Layout,
    panels: &[PanelPlan],
    (sketched, page): &(Vec<Sketched>, Page),
) -> Option<usize> {
    if layout.columns.is_some() || layout.measures.height.is_some() || page.columns < 2 {
        return None;
    }
    let widest = |(panel, own)| widest((scene, runs), layout, panel, own);
    let widest: Vec<f64> = panels.iter().zip(sketched).map(widest).collect();
    let fit = |widths: &[f64]| widest.iter().zip(widths).all(|(label, width)| *label <= SHARE * width);
    let now: Vec<f64> = page.cells.iter().map(|cell| cell.width()).collect();
    if fit(&now) {
        return None;
    }
    let asked: Vec<usize> = panels.iter().map(|panel| panel.source.columns.unwrap_or(1)).collect();
    // A last row with one panel of many is none.
    let fewer = layout.fewer(&asked, page.columns).find(|(_, widths)| fit(widths));
    Some(fewer.map_or(1, |(columns, _)| columns))
}

/// The width of the widest label of a panel, page pixels, each broken as it may be.
fn widest((scene, runs): (&Scene, &Runs), layout: &Layout, panel: &PanelPlan, sketched: &Sketched) -> f64 {
    let context = &panel.context(scene, runs);
    let type_size = &|size: Size| layout.measures.size(size.kind());
    let wording = Wording { context, type_size, is_key, marked: false };
    // A text that can't be set is told with the others.
    let set =
        |request: &Request| wording.set(request, panel.span_of(request), &mut Vec::new()).ok().flatten();
    let sought = sketched.requests.iter().filter_map(set);
    let width = |lines: &[_]| lines.iter().map(|line: &Arc<Line>| line.width).fold(0.0, f64::max);
    // What is broken elsewhere than at a space is broken for want of room.
    let least = sought.map(|label| {
        let folds = label.folds.iter().filter(|fold| fold.cut == Cut::AtSpaces);
        folds.map(|fold| width(&fold.lines)).fold(width(&label.lines), f64::min)
    });
    least.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn panels_whose_labels_are_wider_than_they_stand_one_above_the_other() {
        let text = |width: u32, more: &str| {
            format!(
                "lang = 'de'
                shapes.Topf = {{ kind = 'box', half_extents = [2, 1], angle_deg = 20 }}
                shapes.Deckel = {{ kind = 'box', half_extents = [1, 1], position = [2, 1.5], angle_deg = 50 }}
                query = {{ kind = 'overlap', of = ['Topf', 'Deckel'], algorithm = 'separating-axes' }}
                panels = [
                    {{ layers = ['shapes', {{ layer = 'projection', axis = 1, values = true }}] }},
                    {{ layers = ['shapes', {{ layer = 'projection', axis = 2, values = true }}] }},
                ]
                canvas = {{ width = {width}{more} }}"
            )
        };
        for (width, more, side_by_side) in
            [(480, "", false), (960, "", true), (480, ", columns = 2", true), (480, ", height = 400", true)]
        {
            let scene = open_text("narrow", &text(width, more)).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let cells =
                draw(&plan, plan.theme, "narrow").panels.iter().map(|p| p.frame.panel).collect::<Vec<_>>();
            assert_eq!(cells[0].y0 == cells[1].y0, side_by_side, "{width}{more}: {cells:?}");
        }
    }
}
