//! Layers of which a panel shows nothing, though the answer has what they draw: nothing of it is left, or all
//! of it lies beside the view.

use crate::scene::{NOTES, Scene};

use super::empty_view::empty_views;
use super::fault::{Fault, Problem};
use super::idle_option::idle;
use super::inset::is_beside;
use super::panel::{LayerPlan, PanelPlan};
use super::runs::Runs;
use super::sketch::{Anchor, Sketched};
use super::theme::Theme;

/// What the case is where a layer with options draws nothing, and where one without.
const LEFT: [&str; 2] = ["with its options nothing of it is seen", "nothing of it is there at this moment"];

/// What is to be said of layers that show nothing, and of options that make no difference, but not to a page;
/// `told` are the notes so far.
pub(super) fn noted(
    (scene, runs, theme): (&Scene, &Runs, &Theme),
    panels: &[PanelPlan],
    sketched: &[Sketched],
    told: &[Problem],
) -> Vec<Problem> {
    if !NOTES {
        return Vec::new();
    }
    let mut notes = unseen(scene, panels, sketched);
    let idle = idle((scene, runs, theme), panels, sketched, &[told, &notes].concat());
    notes.extend(idle);
    notes
}

/// A warning for each panel that stays empty, and of others a note for each layer that the scene asks for and
/// that its panel does not show.
fn unseen(scene: &Scene, panels: &[PanelPlan], sketched: &[Sketched]) -> Vec<Problem> {
    let asked = |planned: &&LayerPlan| {
        let written = scene.panels.iter().flat_map(|panel| panel.layers.iter().flatten());
        written.into_iter().any(|spec| spec.name.span == planned.span)
    };
    let of_panel = |(panel, sketched): (&PanelPlan, &Sketched)| {
        let all = panel.layers.iter().enumerate().map(|(index, planned)| (planned, seen(sketched, index)));
        let all: Vec<(&LayerPlan, Seen)> = all.collect();
        let view = panel.source.view.as_ref().zip(sketched.extent);
        let is_empty = view.is_some_and(|(view, extent)| is_beside(view.value, extent));
        let told = all.into_iter().filter(|(planned, _)| !is_empty && asked(planned));
        told.filter_map(|(planned, seen)| {
            let layer = planned.layer.name;
            let fault = match seen {
                Seen::Yes => return None,
                Seen::Beside => Fault::LayerOutOfView { layer },
                Seen::Nothing => {
                    let why = LEFT[usize::from(planned.options.is_bare())];
                    Fault::NothingToDraw { layer, why }
                }
            };
            Some(Problem::new(fault, planned.span.clone()))
        })
        .collect::<Vec<_>>()
    };
    let layers = panels.iter().zip(sketched).flat_map(of_panel);
    empty_views(panels, sketched).into_iter().chain(layers).collect()
}

/// What a panel shows of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Seen {
    /// Something.
    Yes,
    /// Nothing: what it draws lies beside the panel.
    Beside,
    /// Nothing: it draws nothing.
    Nothing,
}

/// What a panel shows of the layer of an index.
fn seen(sketched: &Sketched, index: usize) -> Seen {
    let requests = || sketched.requests.iter().filter(|request| request.layer == index);
    let Some(group) = sketched.layers.get(index) else { return Seen::Yes };
    match group.extent() {
        // Words at a corner are there wherever one looks.
        _ if requests().any(|request| matches!(request.label.anchor, Anchor::Corner(_))) => Seen::Yes,
        None if requests().next().is_some() => Seen::Yes,
        None => Seen::Nothing,
        Some(extent) if extent.intersection(sketched.frame.panel).is_some() => Seen::Yes,
        Some(_) => Seen::Beside,
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::{Explain, open_text};

    /// The notes of a panel.
    fn notes(panel: &str) -> Vec<String> {
        let text = format!(
            "shapes.car = {{ kind = 'box', half_extents = [1, 0.5], velocity = [1, 0] }}
             shapes.dog = {{ kind = 'polygon', vertices = [[0, 0], [1, 1], [0.3, 2]], position = [4, 0] }}
             query = {{ kind = 'separation', of = ['car', 'dog'] }}\n[[panels]]\n{panel}"
        );
        let scene = open_text("s", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        plan.warnings.iter().map(|p| format!("{}: {}", p.fault.code(), p.fault)).collect()
    }

    #[test]
    fn a_layer_that_shows_nothing_is_told() {
        let seen = "layers = ['shapes', 'separation', 'normal']\n";
        assert_eq!(notes(seen), [""; 0]);
        let beside = ["out-of-view: what `separation` draws lies beside the panel's `view`"];
        assert_eq!(notes("view = [3.5, 0.5, 6, 2]\nlayers = ['shapes', 'separation']"), beside);
        let lines = ["not-in-answer: `axes` draws nothing: with its options nothing of it is seen"];
        assert_eq!(notes("layers = ['shapes', { layer = 'axes', lines = false }]"), lines);
        let support = "space = 'configuration'\nlayers = ['difference', 'support']";
        let parts = ["not-in-answer: `support` draws nothing: no edges face each other"];
        assert_eq!(notes(support), parts);
        assert_eq!(notes(""), [""; 0], "what nobody asked for");
    }
}
