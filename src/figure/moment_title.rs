//! The titles of panels that show one space at several moments, where a scene gives its panels no words:
//! without them nobody sees which is before which.

use std::borrow::Cow;

use crate::scene::{Panel, Scene, Spanned, When};

use super::context::Moment;
use super::language::Language;
use super::text::number;

/// Gives a panel the title of its moment, where it is to have one.
pub(super) fn title_by_moment(scene: &Scene, panel: &mut Cow<'_, Panel>, moment: Moment) {
    if let Some(value) = moment_title(scene, panel, moment) {
        let span = panel.span.clone();
        panel.to_mut().title = Some(Spanned { value, span });
    }
}

/// The title of a panel by its moment, as markup; `None` where the panels of the scene have words of their
/// own or this one alone shows its space.
fn moment_title(scene: &Scene, panel: &Panel, moment: Moment) -> Option<String> {
    if scene.panels.iter().any(|panel| panel.title.is_some() || panel.caption.is_some()) {
        return None;
    }
    // "start" and 0 are one moment. So is what no panel says, unless it follows a clock.
    let mut bodies = scene.query.of.iter().filter_map(|&i| scene.shapes.get(i));
    let may_play = bodies.any(|(_, body)| body.moves());
    let when = |panel: &Panel| match panel.when.as_ref().map(|when| when.value) {
        None if !may_play => Some(When::Time(scene.query.time)),
        Some(When::Start) => Some(When::Time(0.0)),
        Some(When::End) => Some(When::Time(1.0)),
        when => when,
    };
    let mut others = scene.panels.iter().filter(|other| other.space == panel.space);
    others.find(|other| when(other) != when(panel))?;
    Some(match moment.step {
        Some(step) => Language::of(scene).words(&format!("Step {step}")),
        None => format!("$t = {}$", number(moment.time)),
    })
}

#[cfg(test)]
mod tests {
    use crate::figure::panel::PanelPlan;
    use crate::figure::plan;
    use crate::scene::open_text;

    /// The titles of the panels of a hit.
    fn titled(panels: &str) -> Vec<String> {
        let text = "shapes.A = { kind = 'box', half_extents = [1, 1], velocity = [4, 0] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [4, 0] }
            query = { kind = 'time-of-impact', algorithm = 'conservative-advancement', of = ['A', 'B'] }
            lang = 'de'";
        let scene = open_text("s.toml", &format!("{text}\n{panels}")).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let title =
            |panel: &PanelPlan| panel.source.title.as_ref().map_or("", |title| &title.value).to_owned();
        let titles: Vec<String> = plan.panels.iter().map(title).collect();
        assert!(
            plan.panels.iter().zip(&titles).all(|(panel, said)| panel.title.is_some() != said.is_empty())
        );
        titles
    }

    #[test]
    fn panels_that_differ_by_their_moment_alone_say_it() {
        let at = |when: &str| format!("[[panels]]\n{when}\nlayers = ['shapes']\n");
        let all = [at("time = 'start'"), at("time = 0.25"), at("time = 'hit'")].concat();
        assert_eq!(titled(&all), ["$t = 0$", "$t = 0.25$", "$t = 0.5$"]);
        let steps = [at("step = 1"), at("step = 2")].concat();
        assert_eq!(titled(&steps), ["Schritt 1", "Schritt 2"]);
        let elsewhere = "[[panels]]\nspace = 'configuration'\ntime = 0.25\nlayers = ['origin']\n".to_owned();
        assert_eq!(titled(&[at("time = 'start'"), elsewhere].concat()), ["", ""]);
        assert_eq!(titled(&[at("time = 0.25"), at("time = 0.25")].concat()), ["", ""]);
        assert_eq!(titled(&[at("time = 'start'"), at("time = 0")].concat()), ["", ""]);
        assert_eq!(titled(&[at(""), at("time = 'start'")].concat()), ["$t = 0$", "$t = 0$"], "one may play");
        assert_eq!(titled(&[at("time = 'end'"), at("time = 1")].concat()), ["", ""]);
        assert_eq!(titled(&[at("time = 0.25\ntitle = 'Now'"), at("time = 'hit'")].concat()), ["Now", ""]);
        assert_eq!(titled(&[at("time = 0.25\ncaption = 'Now'"), at("time = 'hit'")].concat()), ["", ""]);
    }
}
