//! The caption of a variant, and what is wrong with an exercise.

use crate::figure::fault::{Fault, Problem};
use crate::figure::layer::{LAYERS, find, is_key};
use crate::figure::page::Measures;
use crate::figure::runs::Runs;
use crate::figure::text::{Across, paragraphs, plain, values};
use crate::scene::{self, Exercise, Scene, Variant};

use super::answers::{answers, lacking, question, solved, steps, task, there};
use super::askable::{all, askable};
use super::phrases::{MORE, Words};

/// What stands below the panels of a variant; `None` on a figure, which has the scene's own caption.
pub(crate) fn caption(
    scene: &Scene,
    runs: &Runs,
    measures: &Measures,
    problems: &mut Vec<Problem>,
) -> Option<Across> {
    let exercise = of_a_sheet(scene)?;
    check(scene, runs, exercise, problems);
    let (head, way) = match scene.variant {
        Variant::Figure => return None,
        Variant::Question => (question(scene, runs, exercise), Vec::new()),
        Variant::Key => {
            let way = steps(scene, runs);
            let numbered = (1..).zip(way).map(|(k, sentence)| format!("{k}. {sentence}"));
            (solved(scene, runs, exercise), numbered.collect())
        }
    };
    let more = |left: usize| Words::of(scene).say(&MORE, &[&left.to_string()]);
    paragraphs(measures, &head, &way, more)
        .map_err(|error| {
            let span = exercise.task.as_ref().map_or(&scene.query.span, |task| &task.span);
            let fault = Fault::BadMarkup { markup: head.join(" "), reason: error.to_string() };
            problems.push(Problem::new(fault, span.clone()));
        })
        .ok()
}

/// The words of a question for those who do not see it; `None` for other variants.
pub(crate) fn spoken(scene: &Scene, runs: &Runs) -> Option<String> {
    let exercise = of_a_sheet(scene).filter(|_| scene.variant == Variant::Question)?;
    // A blank has no sound.
    Some(task(scene, runs, exercise).iter().map(|text| plain(text)).collect::<Vec<_>>().join(" "))
}

/// The exercise of a scene; what lives on a page is the figure, which asks nothing.
fn of_a_sheet(scene: &Scene) -> Option<&Exercise> {
    if cfg!(tracefig_page) { None } else { scene.exercise.as_ref() }
}

/// Tells what an exercise asks for and hides that there is not. That this answer lacks what is asked for is
/// known where the answer is.
fn check(scene: &Scene, runs: &Runs, exercise: &Exercise, problems: &mut Vec<Problem>) {
    let kind = scene.query.kind;
    for name in exercise.ask.iter().filter(|name| askable(&name.value, kind).is_none()) {
        if values().any(|(value, _)| value == name.value) {
            let message = format!("`{}` is a value of texts, and none that an exercise asks for", name.value);
            let help = format!("ask for what is to be found: {}", there(scene, runs));
            problems.push(Problem::new(scene::Fault::Conflict { message, help }.into(), name.span.clone()));
            continue;
        }
        let known = all().filter(|row| (row.of)(kind)).map(|row| row.name.to_owned()).collect();
        let fault = scene::Fault::UnknownWord { what: "value to ask for", got: name.value.clone(), known };
        problems.push(Problem::new(fault.into(), name.span.clone()));
    }
    for name in exercise.hide.iter().filter(|name| find(&name.value).is_none() && !is_key(&name.value)) {
        let keys = LAYERS.iter().flat_map(|layer| layer.labels).map(|label| label.key);
        let known = LAYERS.iter().map(|layer| layer.name).chain(keys).map(str::to_owned).collect();
        let fault = scene::Fault::UnknownWord { what: "layer or label", got: name.value.clone(), known };
        problems.push(Problem::new(fault.into(), name.span.clone()));
    }
    if scene.variant != Variant::Key {
        return;
    }
    let found = answers(scene, runs, exercise);
    let is_lacking = |name: &&scene::Spanned<String>| {
        askable(&name.value, kind).is_some() && found.iter().all(|asked| asked.name != name.value)
    };
    for name in exercise.ask.iter().filter(is_lacking) {
        let why = lacking(scene, runs, &name.value);
        let message = format!(
            "the exercise asks for `{}`, which this scene does not have: {why}; it has {}",
            name.value,
            there(scene, runs)
        );
        let help = format!("leave `{}` out of `ask`, or ask for what it has", name.value);
        problems.push(Problem::new(scene::Fault::Conflict { message, help }.into(), name.span.clone()));
    }
}
