//! Panels that stay empty because their `view` lies beside all that they draw.

use super::fault::{Fault, Problem};
use super::panel::PanelPlan;
use super::sketch::Sketched;

/// A warning for each panel whose `view` holds nothing of what its layers drew; grounds, as axes and grids,
/// are there wherever one looks, and don't count.
pub(super) fn empty_views(panels: &[PanelPlan], sketched: &[Sketched]) -> Vec<Problem> {
    let told = |(panel, sketched): (&PanelPlan, &Sketched)| {
        let view = panel.source.view.as_ref()?;
        let ([x0, y0, x1, y1], (lo, hi)) = (view.value, sketched.extent?);
        let is_beside = hi.x < x0 || lo.x > x1 || hi.y < y0 || lo.y > y1;
        let reach = [lo, hi].map(|corner| [corner.x, corner.y].map(shortened));
        is_beside.then(|| Problem::new(Fault::EmptyView { reach }, view.span.clone()))
    };
    panels.iter().zip(sketched).filter_map(told).collect()
}

/// A coordinate to a thousandth of its size or of a unit, as nobody needs more to find a view.
fn shortened(x: f64) -> f64 {
    let step = 1e3 / x.abs().max(1.0);
    let short = (x * step).round() / step;
    if short.is_finite() { short } else { x }
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
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
}
