//! Narrow pages: panels stand side by side only where their longest labels fit in them.
//!
//! How many columns suit what panels show is known before their labels are; a page that ends with the drawing
//! may have fewer then, and be higher.

use std::sync::Arc;

use crate::scene::Scene;
use crate::typeset::Line;

use super::layer::is_key;
use super::page::Layout;
use super::panel::PanelPlan;
use super::placement::Cut;
use super::runs::Runs;
use super::sketch::{Request, Size, Sketched};
use super::text::Wording;

/// The share of a panel's width that a label may take: beside a line, it needs room on one side of it.
const SHARE: f64 = 0.85;

/// The columns in which the labels of panels fit that stand side by side without being asked to; `None` where
/// they do as they stand.
pub(super) fn columns(
    (scene, runs): (&Scene, &Runs),
    layout: &Layout,
    panels: &[PanelPlan],
    sketched: &[Sketched],
) -> Option<usize> {
    let [first, second, ..] = panels else { return None };
    let (cell, beside) = (first.frame.panel, second.frame.panel);
    if layout.columns.is_some() || layout.measures.height.is_some() || cell.y0 != beside.y0 {
        return None;
    }
    let all = panels.iter().zip(sketched).map(|(panel, own)| widest((scene, runs), layout, panel, own));
    let widest = all.fold(0.0, f64::max);
    if widest <= SHARE * cell.width() {
        return None;
    }
    let now = panels.iter().filter(|panel| panel.frame.panel.y0 == cell.y0).count();
    let (gap, last) = (beside.x0 - cell.x1, panels.get(now - 1)?.frame.panel.x1);
    let width = |columns: u32| (last - cell.x0 + gap) / f64::from(columns) - gap;
    // A last row with one panel of many is none.
    let even = |columns: &u32| panels.len().is_multiple_of(usize::try_from(*columns).unwrap_or(1));
    let fewer = (1..u32::try_from(now).unwrap_or(1)).rev().filter(even);
    let fits = fewer.into_iter().find(|columns| widest <= SHARE * width(*columns)).unwrap_or(1);
    usize::try_from(fits).ok()
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
