//! The labels of a frame after another one: who rests where it stood, and who must not.

use super::faults::{LabelFault, faults};
use super::solve::{Ground, Old, searched};
use super::weights::{TUNED, Weights};
use super::{Labelled, Sought};
use crate::scene::LabelPlace;

/// In how many frames a label that stands badly wherever it goes stays where it is, before all is tried
/// again, which takes as long as several frames.
const PATIENCE: usize = 8;

/// Places the labels of a panel.
pub(crate) fn place(sought: &[Sought], ground: &Ground) -> Labelled {
    place_by(&TUNED, sought, ground)
}

/// Places the labels of a panel by other numbers than the tuned ones.
///
/// Where labels that rest leave one no good place, those that stand badly forget where they stood, what room
/// they kept, and where the scene pins them; where that does not help, the others rest no longer, and each
/// only likes its old place better: what is pleasant to look at in a figure that moves is no reason for a
/// false picture. Who stands as badly wherever it goes does not go.
pub(super) fn place_by(weights: &Weights, sought: &[Sought], ground: &Ground) -> Labelled {
    let resting = |_: &Sought| Old::Comfortable;
    let Some(before) = ground.before else { return still(weights, sought, ground) };
    let weights = &weights.moving();
    // A scene pins by keys.
    let was_loose = |label: &Sought| before.placed.iter().any(|p| p.standing.loose && p.key == label.key);
    let mut sought = loosened(sought, &was_loose);
    let stuck = |key: &str| {
        before.placed.iter().filter(|p| p.key == key).map(|p| p.standing.stuck).max().unwrap_or(0)
    };
    let waits = |key: &str| (1..PATIENCE).contains(&stuck(key));
    if sought.iter().any(|label| waits(label.key)) {
        let old = |label: &Sought| if waits(label.key) { Old::Kept } else { Old::Comfortable };
        let kept = marked(searched(weights, &sought, ground, &old), &|key| stuck(key) + 1);
        if kept.placed.iter().all(|p| p.standing.stuck == 0 || waits(p.key)) {
            return kept;
        }
    }
    let mut best = searched(weights, &sought, ground, &resting);
    let mut wrong = faults(&best);
    for all in [false, true] {
        if wrong.is_empty() {
            return best;
        }
        let badly = |label: &Sought| stands_badly(label, &wrong);
        let freed = loosened(&sought, &badly);
        let others = if all { Old::Liked } else { Old::Comfortable };
        let old = |label: &Sought| if badly(label) { Old::Forgotten } else { others };
        let other = searched(weights, &freed, ground, &old);
        let still = faults(&other);
        if still.len() < wrong.len() {
            (best, wrong, sought) = (other, still, freed);
        }
    }
    let old = |label: &Sought| if stands_badly(label, &wrong) { Old::Kept } else { Old::Comfortable };
    let kept = searched(weights, &sought, ground, &old);
    marked(if faults(&kept).len() <= wrong.len() { kept } else { best }, &|_| 1)
}

/// Places the labels of a panel that nothing was drawn before: where the scene pins them, but where a
/// direction leads over the panel's edge and another one does not, since nobody reads what is cut off. An
/// offset in pixels is somebody's will.
fn still(weights: &Weights, sought: &[Sought], ground: &Ground) -> Labelled {
    let search = |sought: &[Sought]| searched(weights, sought, ground, &|_| Old::Comfortable);
    let pinned = search(sought);
    let is_led = |label: &Sought| matches!(label.pin, Some(LabelPlace::Compass(_)));
    if !sought.iter().any(is_led) {
        return pinned;
    }
    let wrong = faults(&pinned);
    let is_cut = |label: &Sought| {
        let over = |fault: &LabelFault| matches!(fault, LabelFault::OverEdge { .. });
        is_led(label) && wrong.iter().any(|fault| over(fault) && fault.is_of(label.key, &label.span))
    };
    if !sought.iter().any(is_cut) {
        return pinned;
    }
    let free = search(&loosened(sought, &is_cut));
    if faults(&free).len() < wrong.len() { free } else { pinned }
}

/// Notes of the labels at fault since when they are.
fn marked(mut labelled: Labelled, since: &dyn Fn(&str) -> usize) -> Labelled {
    let wrong = faults(&labelled);
    for label in &mut labelled.placed {
        let is_wrong = wrong.iter().any(|fault| fault.is_of(label.key, &label.span));
        label.standing.stuck = if is_wrong { since(label.key) } else { 0 };
    }
    labelled
}

/// Whether a label is at fault, alone or with another one.
fn stands_badly(label: &Sought, wrong: &[LabelFault]) -> bool {
    wrong.iter().any(|fault| fault.is_of(label.key, &label.span))
}

/// The labels, of which some need not stand where the scene pins them.
fn loosened(sought: &[Sought], which: &dyn Fn(&Sought) -> bool) -> Vec<Sought> {
    let loose = |s: &Sought| s.loose || s.pin.is_some() && which(s);
    sought.iter().map(|s| Sought { loose: loose(s), ..s.clone() }).collect()
}

#[cfg(test)]
mod tests {
    use super::PATIENCE;
    use crate::figure::{Figure, draw_after, plan};
    use crate::scene::open_text;

    /// A box whose name the scene pins at its upper right, and a disc that comes to lie there, with the
    /// frame before it.
    fn with_disc(x: f64, before: Option<&Figure>) -> Figure {
        let text = format!(
            r#"
            shapes.A = {{ kind = "box", half_extents = [1, 1] }}
            shapes.B = {{ kind = "circle", radius = 1, position = [{x}, 0.9] }}
            query = {{ kind = "separation", of = ["A", "B"] }}
            labels.O.at = "NE"
            panels = [{{ space = "world", view = [-3, -3, 7, 3], layers = ["shapes", "origin"] }}]
            "#
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw_after(&plan, plan.theme, "s", before)
    }

    /// Where the name of the origin stands, right and up of it.
    fn side(figure: &Figure) -> (bool, bool) {
        let panel = &figure.panels[0];
        let label = panel.placed.iter().find(|p| p.key == "O").unwrap();
        let (corner, center) = (panel.frame.panel, label.bounds.center());
        (center.x > corner.x0 + label.home.dx, center.y < corner.y0 + label.home.dy)
    }

    #[test]
    fn a_pinned_label_leaves_a_place_that_has_become_bad_and_does_not_go_back() {
        let apart = with_disc(5.0, None);
        assert_eq!((side(&apart), apart.faults().len()), ((true, true), 0));
        // The disc's outline runs by the origin, at the upper right of it.
        let near = |x: f64, before| with_disc(x, before);
        let still = near(0.9, None);
        assert!(!still.faults().is_empty(), "a still picture keeps to its scene");
        let moving = near(0.9, Some(&apart));
        assert!(moving.faults().is_empty() && side(&moving) != (true, true), "{:?}", moving.faults());
        let after = near(5.0, Some(&moving));
        assert_eq!(side(&after), side(&moving));
        assert_eq!(side(&near(5.0, None)), (true, true), "at rest it is where the scene pins it");
    }

    #[test]
    fn a_pinned_label_does_not_leave_its_panel() {
        let text = r#"
            shapes.A = { kind = "box", half_extents = [1, 1], position = [-2, 0] }
            query = { kind = "bounds", of = ["A"] }
            labels.O.at = "E"
            panels = [{ space = "world", view = [-4, -2, 0.05, 2], layers = ["shapes", "origin"] }]
        "#;
        let scene = open_text("s.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw_after(&plan, plan.theme, "s", None);
        let panel = &figure.panels[0];
        let label = panel.placed.iter().find(|p| p.key == "O").unwrap();
        assert!(figure.faults().is_empty() && label.bounds.x1 <= panel.frame.panel.x1, "{:?}", label.bounds);
    }

    /// EPA with B there, in which the depth's label stands badly wherever it goes.
    fn deep(x: f64, before: Option<&Figure>) -> Figure {
        let scene = include_str!("../../../figures/epa-steps.toml");
        let text = scene.replace("[query]", &format!("position = [{x}, -0.23]\n[query]"));
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw_after(&plan, plan.theme, "s", before)
    }

    #[test]
    fn a_label_that_stands_badly_wherever_it_goes_is_tried_again_after_some_frames() {
        let mut since = Vec::new();
        let mut before: Option<Figure> = None;
        for x in (0..20).map(|k| 0.66 + 0.001 * f64::from(k)) {
            let figure = deep(x, before.as_ref());
            let depth = |figure: &Figure| figure.panels[0].placed.iter().find(|p| p.key == "d").cloned();
            let now = depth(&figure).unwrap();
            let is_wrong = figure.faults().iter().any(|fault| fault.is_of(now.key, &now.span));
            assert_eq!(is_wrong && before.is_some(), now.standing.stuck > 0, "{x}: {:?}", figure.faults());
            if (2..=PATIENCE).contains(&now.standing.stuck) {
                let was = before.as_ref().and_then(depth).unwrap();
                let slid = (now.bounds.center() - was.bounds.center()).length();
                assert!(slid < 3.0, "{x}: by {slid} px");
            }
            since.push(now.standing.stuck);
            before = Some(figure);
        }
        let again = |k: usize| if k == 0 { 0 } else { 1 + (k - 1) % PATIENCE };
        assert_eq!(since, (0..20).map(again).collect::<Vec<_>>());
    }
}
