//! Words of steps that the fonts have no letters for.

use crate::scene::Scene;
use crate::typeset::{Style, as_markup, paragraph};

use super::fault::Problem;
use super::text::{bad_markup, with_powers};

/// What is wrong with what a scene says of its steps: letters that the fonts lack. On a page of their own a
/// browser would have them; but a scene that can be drawn can be drawn in every format.
pub(super) fn unset(scene: &Scene) -> Vec<Problem> {
    if cfg!(tracefig_page) {
        return Vec::new(); // A scene of a live page has been drawn already.
    }
    let mut problems = Vec::new();
    for words in &scene.steps {
        for said in [&words.title, &words.text].into_iter().flatten() {
            if let Err(error) = paragraph(&with_powers(&as_markup(said)), Style::regular(1.0)) {
                problems.push(bad_markup(error, said.clone(), &words.span));
            }
        }
    }
    problems
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::open_text;

    #[test]
    fn words_of_steps_that_cannot_be_set_are_told_where_they_stand() {
        let said = |words: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1 }}\nquery = {{ kind = 'bounds', of = ['A'] }}
                steps = [{{ until = 2 }}, {{ {words} }}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let problems = plan(&scene).err().unwrap_or_default();
            problems
                .iter()
                .map(|p| (p.fault.to_string(), text[p.span.clone()].to_owned()))
                .collect::<Vec<_>>()
        };
        assert_eq!(said("title = 'Łódź → $1 {a|', text = '‖v‖ ★'"), []);
        for words in ["title = 'Done ✗'", "text = '箱'"] {
            let problems = said(words);
            let [(fault, place)] = &problems[..] else { panic!("{words}: {problems:?}") };
            assert!(fault.contains("can't be typeset") && place.contains(words), "{fault}: {place}");
        }
    }
}
