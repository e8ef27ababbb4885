//! Bodies of the context that no panel reaches: who names a body and does not see it is told why.

use crate::geometry::DVec2;
use crate::scene::{NOTES, Scene, Space};

use super::fault::{Fault, Problem};
use super::layer::shows_context;
use super::panel::PanelPlan;
use super::runs::Runs;

/// A note for each body that the query is not about and that lies outside of every panel which would show
/// it; none where the scene gives a panel its view, and none of a figure that shows no such body at all.
pub(super) fn out_of_view(scene: &Scene, runs: &Runs, panels: &[PanelPlan]) -> Vec<Problem> {
    if !NOTES {
        return Vec::new();
    }
    let would = |panel: &&PanelPlan| {
        panel.source.space != Space::Configuration
            && panel.layers.iter().any(|planned| shows_context(planned.layer, &planned.options))
    };
    let would: Vec<&PanelPlan> = panels.iter().filter(would).collect();
    if would.is_empty() || panels.iter().any(|panel| panel.source.view.is_some()) {
        return Vec::new();
    }
    let others = (0..scene.shapes.len()).filter(|index| !scene.query.of.contains(index));
    let unseen = others.filter(|&index| !would.iter().any(|panel| reaches(panel, scene, runs, index)));
    let told = unseen
        .filter_map(|index| scene.shapes.get(index))
        .map(|(name, _)| Problem::new(Fault::OutOfView { name: name.value.clone() }, name.span.clone()));
    told.collect()
}

/// Whether a panel reaches the body of an index, by what bounds both.
fn reaches(panel: &PanelPlan, scene: &Scene, runs: &Runs, index: usize) -> bool {
    let context = panel.context(scene, runs);
    let Some((_, _, outline)) = context.bystanders().find(|(other, ..)| *other == index) else { return true };
    let on_page = |p: DVec2| panel.frame.page(p);
    let (mut lo, mut hi) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in outline.sampled().into_iter().map(on_page) {
        (lo, hi) = ([lo[0].min(p.x), lo[1].min(p.y)], [hi[0].max(p.x), hi[1].max(p.y)]);
    }
    let shown = panel.frame.panel;
    lo[0] <= shown.x1 && hi[0] >= shown.x0 && lo[1] <= shown.y1 && hi[1] >= shown.y0
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::{Explain, open_text};

    /// The notes of two bodies that are asked about and a house whose left wall is at x.
    fn notes(x: f64, panels: &str) -> Vec<String> {
        let text = format!(
            "shapes.car = {{ kind = 'box', half_extents = [1.1, 0.5], angle_deg = 10 }}
             shapes.dog = {{ kind = 'circle', radius = 0.3, position = [2, 0.3] }}
             shapes.house = {{ kind = 'box', half_extents = [1.5, 1.5], position = [{}, 1] }}
             query = {{ kind = 'separation', of = ['car', 'dog'] }}\n{panels}",
            x + 1.5
        );
        let scene = open_text("s", &text).unwrap().scene;
        let told = plan(&scene).unwrap().warnings;
        told.iter().filter(|p| p.fault.code() == "out-of-view").map(|p| p.fault.to_string()).collect()
    }

    #[test]
    fn a_body_of_the_context_is_drawn_or_told_to_be_far() {
        assert_eq!(notes(4.0, ""), [""; 0], "it is near");
        let far = ["`house` is not on the picture: it is far from the bodies of the query"];
        assert_eq!(notes(12.0, ""), far);
        assert_eq!(notes(12.0, "panels = [{ layers = ['shapes'] }]"), far);
        for panels in ["view = [-2, -2, 4, 2], layers = ['shapes']", "layers = ['separation']"] {
            assert_eq!(notes(12.0, &format!("panels = [{{ {panels} }}]")), [""; 0], "{panels}");
        }
    }
}
