//! `[exercise]`: what a class is asked of a scene, and what the question must not show. Which values there
//! are to ask for, and which layers and labels to hide, the figure knows.

use super::Spanned;
use super::checked::{Checked, check, too_many};
use super::fields::EXERCISE;
use super::limits::{MAX_ASKED, MAX_LABELS};
use super::problem::{Fault, Problems};

/// What makes a scene an exercise.
#[derive(Clone, Debug, PartialEq)]
pub struct Exercise {
    /// Names of the values that are asked for; at least one.
    pub ask: Vec<Spanned<String>>,
    /// Layers and labels that the question leaves out, besides those that show the answer.
    pub hide: Vec<Spanned<String>>,
    /// What is to be done, as markup; `None` takes a sentence of ours.
    pub task: Option<Spanned<String>>,
    /// The unit of lengths, as markup.
    pub length_unit: Option<Spanned<String>>,
    /// The unit of times, as markup.
    pub time_unit: Option<Spanned<String>>,
}

/// What is drawn of an exercise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Variant {
    /// The figure of the scene, exercise or not.
    #[default]
    Figure,
    /// What the class gets: what is given, what is asked, a blank.
    Question,
    /// What the teacher gets: the figure with the answer, its bounds and the way to it.
    Key,
}

impl Variant {
    /// The variants of an exercise, in the order in which they are handed out.
    pub const OF_AN_EXERCISE: [Self; 2] = [Self::Question, Self::Key];

    /// The word for it on the command line and in names of files; that of a figure stands in neither.
    ///
    /// ```
    /// use tracefig::scene::Variant;
    /// assert_eq!(Variant::OF_AN_EXERCISE.map(Variant::word), ["question", "key"]);
    /// ```
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Figure => "figure",
            Self::Question => "question",
            Self::Key => "key",
        }
    }

    /// The variant of that word.
    ///
    /// ```
    /// use tracefig::scene::Variant;
    /// assert_eq!((Variant::of_word("key"), Variant::of_word("keys")), (Some(Variant::Key), None));
    /// ```
    #[must_use]
    pub fn of_word(word: &str) -> Option<Self> {
        Self::OF_AN_EXERCISE.into_iter().find(|variant| variant.word() == word)
    }
}

/// Reads what makes a scene an exercise; what is wrong is told.
pub(super) fn read(top: &Checked<'_>, p: &mut Problems) -> Option<Exercise> {
    let table = check(top.get("exercise")?, "exercise", EXERCISE.place, EXERCISE.fields, p)?;
    let (ask, hide) = (table.texts("ask"), table.texts("hide"));
    let at = table.get("ask")?;
    if ask.is_empty() || ask.len() > MAX_ASKED {
        let expected = format!("1 to {MAX_ASKED} names of values");
        p.add(Fault::WrongType { key: "ask".to_owned(), expected, got: at.describe() }, &at.span);
    }
    if hide.len() > MAX_LABELS {
        let span = table.get("hide").map_or(&table.span, |node| &node.span);
        too_many("`hide`", MAX_LABELS, "names", hide.len(), span, p);
    }
    let text = |key: &str| table.text(key);
    let (task, length_unit, time_unit) = (text("task"), text("length_unit"), text("time_unit"));
    Some(Exercise { ask, hide, task, length_unit, time_unit })
}

#[cfg(test)]
mod tests {
    use crate::scene::open_text;

    const SCENE: &str =
        "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }\n";

    #[test]
    fn one_value_or_several_are_asked_for_and_none_is_refused() {
        let asked = |exercise: &str| {
            let file = open_text("s.toml", &format!("{SCENE}exercise = {exercise}"));
            file.map(|file| file.scene.exercise.unwrap().ask.len()).map_err(|refused| refused.to_string())
        };
        assert_eq!(asked("{ ask = 'h.x' }"), Ok(1));
        assert_eq!(asked("{ ask = ['h.x', 'h.y'], hide = 'bounds' }"), Ok(2));
        assert!(asked("{ ask = [] }").unwrap_err().contains("expected 1 to 8 names of values, got an empty"));
        assert!(asked("{ ask = 3 }").unwrap_err().contains("a text or a list of texts"));
        assert!(asked("{ hide = 'bounds' }").unwrap_err().contains("lacks `ask`"));
    }
}
