//! What a program may ask of an exercise whose key is planned: its numbers, and the way to them.

use crate::figure::plan::Plan;
use crate::figure::text::plain;
use crate::scene::Scene;

use super::answers::{Asked, answers, steps, task as paragraphs};
use super::phrases::{SOLUTION, Words};

/// The numbers that an exercise asks for, in its order; none where the scene is no exercise.
///
/// ```
/// use tracefig::{figure::{exercise::asked, plan}, scene::open_text};
/// let text = "exercise.ask = 'd'\nshapes.A = { kind = 'circle', radius = 1 }\n\
///     shapes.B = { kind = 'circle', radius = 1, position = [3, 0] }\n\
///     query = { kind = 'separation', of = ['A', 'B'] }";
/// let scene = open_text("s.toml", text)?.scene;
/// let asked = asked(&plan(&scene).unwrap());
/// assert_eq!((asked[0].name, asked[0].value(), asked[0].unit.as_str()), ("d", 1.0, "units"));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn asked(plan: &Plan<'_>) -> Vec<Asked> {
    plan.scene.exercise.as_ref().map(|exercise| answers(plan.scene, &plan.runs, exercise)).unwrap_or_default()
}

/// What is given and what is to be done, in plain words; empty where the scene is no exercise.
///
/// ```
/// use tracefig::{figure::{exercise::task, plan}, scene::open_text};
/// let text = "exercise.ask = 'h.x'\nshapes.A = { kind = 'circle', radius = 1 }\n\
///     query = { kind = 'bounds', of = ['A'] }";
/// let scene = open_text("s.toml", text)?.scene;
/// assert!(task(&plan(&scene).unwrap()).ends_with("Find half the width of the bounding box of A."));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn task(plan: &Plan<'_>) -> String {
    let Some(exercise) = &plan.scene.exercise else { return String::new() };
    paragraphs(plan.scene, &plan.runs, exercise).iter().map(|text| plain(text)).collect::<Vec<_>>().join(" ")
}

/// What is given and that one of its numbers is to be found, in plain words: for a question of its own. An
/// exercise that says itself what to do says all of it.
///
/// ```
/// use tracefig::{figure::{exercise::{asked, task_of}, plan}, scene::open_text};
/// let text = "exercise.ask = ['h.x', 'h.y']\nshapes.A = { kind = 'circle', radius = 1 }\n\
///     query = { kind = 'bounds', of = ['A'] }";
/// let scene = open_text("s.toml", text)?.scene;
/// let plan = plan(&scene).unwrap();
/// assert!(task_of(&plan, &asked(&plan)[1]).ends_with("Find half the height of the bounding box of A."));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn task_of(plan: &Plan<'_>, number: &Asked) -> String {
    let Some(exercise) = &plan.scene.exercise else { return String::new() };
    let mut one = exercise.clone();
    one.ask.retain(|name| name.value == number.name);
    paragraphs(plan.scene, &plan.runs, &one).iter().map(|text| plain(text)).collect::<Vec<_>>().join(" ")
}

/// Which number is to be typed, and in which unit, in plain words.
///
/// ```
/// use tracefig::{figure::{exercise::{asked, to_enter}, plan}, scene::open_text};
/// let text = "exercise.ask = 'h.x'\nlang = 'de'\nshapes.A = { kind = 'circle', radius = 1 }\n\
///     query = { kind = 'bounds', of = ['A'] }";
/// let scene = open_text("s.toml", text)?.scene;
/// let plan = plan(&scene).unwrap();
/// assert_eq!(
///     to_enter(&plan, &asked(&plan)[0]),
///     "Gib h_x ein (die halbe Breite der Bounding-Box von A) in Einheiten, auf drei Ziffern."
/// );
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn to_enter(plan: &Plan<'_>, number: &Asked) -> String {
    plain(&number.to_enter(Words::of(plan.scene)))
}

/// A number with its bounds as the key has it ([`Asked::line`]), in the language of the scene and in plain
/// words.
///
/// ```
/// use tracefig::{figure::{exercise::{answer_in_words, asked}, plan}, scene::open_text};
/// let text = "exercise.ask = 'h.x'\nlang = 'fr'\nshapes.A = { kind = 'circle', radius = 2.5 }\n\
///     query = { kind = 'bounds', of = ['A'] }";
/// let scene = open_text("s.toml", text)?.scene;
/// let plan = plan(&scene).unwrap();
/// assert_eq!(answer_in_words(&plan, &asked(&plan)[0]), "Réponse : h_x = 2,5 unités.");
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn answer_in_words(plan: &Plan<'_>, number: &Asked) -> String {
    plain(&number.line_in(Words::of(plan.scene)))
}

/// The sentences of the trace, in plain words: the way to the answer.
///
/// ```
/// use tracefig::{figure::{exercise::way, plan}, scene::open_text};
/// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
/// let scene = open_text("s.toml", text)?.scene;
/// assert!(way(&plan(&scene).unwrap()).last().unwrap().starts_with("The box of A runs from"));
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn way(plan: &Plan<'_>) -> Vec<String> {
    steps(plan.scene, &plan.runs).iter().map(|text| plain(text)).collect()
}

/// What a page calls a key that is folded away behind its question, in the scene's language.
///
/// ```
/// use tracefig::{figure::exercise::solution, scene::open_text};
/// let text = "lang = 'de'\nshapes.A = { kind = 'circle', radius = 1 }\n\
///     query = { kind = 'bounds', of = ['A'] }";
/// assert_eq!(solution(&open_text("s.toml", text)?.scene), "Lösung");
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn solution(scene: &Scene) -> &'static str {
    Words::of(scene).word(&SOLUTION)
}
