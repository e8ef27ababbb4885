//! Panels that stay empty because their `view` lies beside all that they draw, and insets that enlarge
//! nothing of it.

use std::ops::Range;

use crate::geometry::DVec2;
use crate::scene::{Detail, Spanned};

use super::fault::{Fault, Problem};
use super::inset::is_beside;
use super::panel::PanelPlan;
use super::sketch::Sketched;

/// A warning for each panel whose `view`, and for each whose `inset`, holds nothing of what its layers drew;
/// grounds, as axes and grids, are there wherever one looks, and don't count.
pub(super) fn empty_views(panels: &[PanelPlan], sketched: &[Sketched]) -> Vec<Problem> {
    let told = |(panel, sketched): (&PanelPlan, &Sketched)| {
        let (view, inset) = (panel.source.view.as_ref(), panel.source.inset.as_ref());
        let (lo, hi) = sketched.extent?;
        if let Some(Spanned { span, .. }) = view.filter(|view| is_beside(view.value, (lo, hi))) {
            return Some(empty("view", (lo, hi), span));
        }
        // Of what is drawn, the panel shows what is in view.
        let (least, most) = sketched.frame.visible();
        let shown = (lo.max(least), hi.min(most));
        match inset {
            Some(Spanned { value: Detail::Rectangle(detail), span }) if is_beside(*detail, shown) => {
                Some(empty("inset", shown, span))
            }
            _ => None,
        }
    };
    panels.iter().zip(sketched).filter_map(told).collect()
}

/// What is said of a key of a panel, at its place, that holds nothing of what lies between two points.
fn empty(what: &'static str, (lo, hi): (DVec2, DVec2), span: &Range<usize>) -> Problem {
    let reach = [lo, hi].map(|corner| [corner.x, corner.y].map(shortened));
    Problem::new(Fault::EmptyView { what, reach }, span.clone())
}

/// A coordinate to a thousandth of its size or of a unit, as nobody needs more to find a view.
fn shortened(x: f64) -> f64 {
    let step = 1e3 / x.abs().max(1.0);
    let short = (x * step).round() / step;
    if short.is_finite() { short } else { x }
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, plan};
    use crate::scene::{Explain, Severity, open_text};

    #[test]
    fn a_view_that_holds_nothing_of_what_is_drawn_is_told() {
        let text = |view: &str| {
            format!(
                "shapes.a = {{ kind = 'box', half_extents = [1, 1] }}
                shapes.b = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                query = {{ kind = 'separation', of = ['a', 'b'] }}
                panels = [{{ view = {view}, layers = ['grid', 'shapes'] }}]"
            )
        };
        for (view, told) in [("[10, 10, 12, 11]", 1), ("[0.9, -0.2, 1.2, 0.2]", 0), ("[-2, 1.5, 6, 3]", 1)] {
            let scene = open_text("s", &text(view)).unwrap().scene;
            let warnings = plan(&scene).unwrap().warnings;
            assert_eq!(warnings.len(), told, "{view}: {warnings:?}");
            for warning in warnings {
                assert_eq!(
                    (warning.fault.code(), warning.fault.severity()),
                    ("empty-view", Severity::Warning)
                );
                assert!(warning.fault.to_string().ends_with("from (-1, -1) to (5, 1)"), "{}", warning.fault);
            }
        }
    }

    #[test]
    fn an_inset_of_nothing_is_told_and_left_out_where_it_lies_beside_the_panel() {
        let text = |inset: &str| {
            format!(
                "shapes.a = {{ kind = 'box', half_extents = [1, 1] }}
                shapes.b = {{ kind = 'circle', radius = 1, position = [4, 0] }}
                query = {{ kind = 'separation', of = ['a', 'b'] }}
                panels = [{{ view = [-2, -2, 3.5, 2], inset = {inset}, layers = ['grid', 'shapes'] }}]"
            )
        };
        for (inset, told, drawn) in [
            ("[10, 10, 10.2, 10.2]", true, 0),
            ("[10, 10, 19, 19]", true, 0),
            ("[1.2, 1.4, 1.4, 1.6]", true, 1),
            ("[0.9, -0.1, 1.1, 0.1]", false, 1),
        ] {
            let scene = open_text("s", &text(inset)).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let said: Vec<String> = plan.warnings.iter().map(|warning| warning.fault.to_string()).collect();
            assert_eq!(
                said.iter().any(|said| said.starts_with("the panel's `inset` is empty")),
                told,
                "{said:?}"
            );
            assert_eq!(draw(&plan, plan.theme, "s").insets.len(), drawn, "{inset}");
        }
    }
}
