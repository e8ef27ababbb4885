//! The heading of a page that shows a figure in steps.

use crate::trace::Hand;

use super::language::Language;
use super::plan::Plan;
use super::{steps, tongue};

/// What a figure is about without its answer: its title, else its question, whatever the scene says of the
/// step that asks it.
pub(super) fn heading(plan: &Plan) -> Option<String> {
    if cfg!(tracefig_page) {
        return None; // A page has one.
    }
    let (scene, runs) = (plan.scene, plan.runs.all());
    let called = plan.runs.called.names(scene);
    let asked = || steps::first((scene, tongue::voice(scene, &called, Hand::Words)), &runs).sentences;
    let question = || asked().into_iter().next().filter(|_| Language::of(scene).has_sentences());
    plan.title.clone().or_else(question)
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw_in_steps, plan};
    use crate::scene::open_text;

    #[test]
    fn what_a_scene_says_of_its_first_step_is_not_what_all_of_them_are_about() {
        let heading = |more: &str| {
            let text = format!(
                "{more}\nshapes.A = {{ kind = 'circle', radius = 1 }}
                query = {{ kind = 'bounds', of = ['A'] }}"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            draw_in_steps(&plan, plan.theme, "s").drawing.heading
        };
        let question = heading("");
        assert!(question.as_ref().is_some_and(|asked| asked.ends_with('?')), "{question:?}");
        assert_eq!(heading("steps = [{ title = 'First', text = 'A ball lies here.' }]"), question);
        assert_eq!(heading("title = 'A ball'"), Some("A ball".to_owned()));
    }
}
