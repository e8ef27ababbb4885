//! What texts of a whole figure speak of: its headline, its caption, its alternative text.
//!
//! A panel may show another moment than the one that the question is about. Texts of the whole figure are of
//! that question, where a panel shows its moment; where none does they are of what the first panel shows.

use crate::scene::Scene;

use super::panel::PanelPlan;
use super::question::is_of_a_moment;

/// The panel whose moment texts of the whole figure are of: the first that shows the moment of the question,
/// else the first.
pub(super) fn of_the_whole<'p, 's>(scene: &Scene, panels: &'p [PanelPlan<'s>]) -> Option<&'p PanelPlan<'s>> {
    let is_asked = |panel: &&PanelPlan| panel.moment.time == scene.query.time;
    let shown = panels.iter().find(|panel| is_of_a_moment(scene.query.kind) && is_asked(panel));
    shown.or_else(|| panels.first())
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    /// The headline and the title of a figure of a circle that comes to a box, with these panels.
    fn said(panels: &str) -> [String; 2] {
        let text = format!(
            "headline = '{{=separation}}'
            shapes.A = {{ kind = 'circle', radius = 1, position = [-6, 0], velocity = [8, 0] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 1] }}
            query = {{ kind = 'separation', of = ['A', 'B'], time = 0.25 }}
            panels = [{panels}]"
        );
        let scene = open_text("whole", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let title = draw(&plan, plan.theme, "whole").drawing.title;
        [plan.headline.words.clone().unwrap(), title]
    }

    #[test]
    fn texts_of_the_whole_figure_are_of_the_moment_of_the_question_where_a_panel_shows_it() {
        let start = "{ time = 'start', layers = ['shapes'] }";
        let asked = "{ layers = ['shapes'] }";
        let [headline, title] = said(&format!("{start}, {asked}"));
        assert_eq!(headline, "2");
        assert!(title.contains("2 apart"), "{title}");
        assert_eq!(said(&format!("{asked}, {start}"))[0], "2");
        let [headline, title] = said(start);
        assert_eq!(headline, "4", "what is seen");
        assert!(title.contains("4 apart"), "{title}");
    }
}
