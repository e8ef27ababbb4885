//! Which question or algorithm has a value that an answer lacks: the same bodies are asked in other ways.

use crate::collision::{ALGORITHMS, Algorithm, QUERIES, Question};
use crate::figure::context::Context;
use crate::scene::{Scene, SceneQuery};

use super::values::{VALUES, value_of};

/// Steps after which a way of asking is given up: a value that it has shows in the first ones.
const MOST_STEPS: usize = 8;

/// What is said where no question has a value.
pub(crate) const NO_OTHER: &str = "no other question about these bodies has it";

/// What has a value of that name for the bodies of a context, in words; `None` where no answer has it.
pub(crate) fn givers(name: &str, context: &Context) -> Option<String> {
    VALUES.iter().find(|value| value.name == name)?;
    let scene = context.scene;
    let own = |question: &&Question| question.kind == scene.query.kind;
    let all = || ALGORITHMS.iter();
    let same = QUERIES.iter().find(own)?;
    if let Some(algorithm) = all().find(|algorithm| has(name, context, (same, algorithm))) {
        return Some(format!("algorithm `{}` gives it", algorithm.name));
    }
    let others = QUERIES.iter().filter(|question| !own(question));
    let has_it = |question: &&Question| all().any(|algorithm| has(name, context, (question, algorithm)));
    let words: Vec<String> = others.filter(has_it).map(|found| format!("`{}`", found.word)).collect();
    Some(match words.as_slice() {
        [] => NO_OTHER.to_owned(),
        [one] => format!("a query of the kind {one} has it"),
        _ => format!("queries of the kinds {} have it", words.join(", ")),
    })
}

/// Whether an algorithm that is asked a question has a value.
fn has(name: &str, context: &Context, (question, algorithm): (&Question, &'static Algorithm)) -> bool {
    let scene = context.scene;
    let max_iterations = scene.query.max_iterations.min(MOST_STEPS);
    let query = SceneQuery { kind: question.kind, algorithm, max_iterations, ..scene.query.clone() };
    let asked = Scene { query, ..scene.clone() };
    if !algorithm.takes(&asked.query_of_bodies()) {
        return false;
    }
    context.where_asked(&asked, |context| value_of(name, context).is_some())
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::{Explain, open_text};

    /// What is said of a value in a caption of two circles.
    fn said(value: &str, query: &str) -> String {
        let text = format!(
            "caption = '{{={value}}}'
            shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [3, 0] }}
            query = {{ of = ['A', 'B'], {query} }}"
        );
        let scene = open_text("givers.toml", &text).unwrap().scene;
        let problems = plan(&scene).map(|_| ()).unwrap_err();
        format!("{}; {}", problems[0].fault, problems[0].fault.remedy().unwrap_or_default())
    }

    #[test]
    fn a_value_of_another_answer_is_told_with_what_gives_it() {
        let gjk = "kind = 'separation', algorithm = 'gjk'";
        assert_eq!(
            said("centers", gjk),
            "this answer has no `centers`: algorithm `circles` gives it; leave `{=centers}` out of the text, \
             or ask a question that has it"
        );
        let swept = said("iterations", gjk);
        assert!(swept.starts_with("this answer has no `iterations`: queries of the kinds `"), "{swept}");
        assert!(swept.contains("`time-of-impact`"), "{swept}");
        let none = "no other question about these bodies has it; leave `{=V.x}` out of the text";
        assert!(said("V.x", gjk).ends_with(none), "{}", said("V.x", gjk));
        assert!(said("centres", gjk).contains("unknown value"), "a word that means nothing");
    }
}
