//! `--variant`: the question and the key of scenes that are exercises.

use std::borrow::Cow;

use tracefig::figure::{Fault, exercise, plan};
use tracefig::scene::{Problem, Scene, SceneFile, Variant};

/// The variant of that word, for the command line.
pub(crate) fn variant(word: &str) -> Result<Variant, String> {
    let known = || Variant::OF_AN_EXERCISE.map(Variant::word).join(" or ");
    Variant::of_word(word).ok_or_else(|| format!("expected {}", known()))
}

/// Why a variant of a scene can't be drawn.
pub(crate) enum Unvaried {
    /// The scene is no exercise.
    NoExercise,
    /// The key, which a question must have, is wrong.
    Wrong(Vec<Problem<Fault>>),
}

/// What is drawn of a scene as a variant.
pub(crate) fn scene_of(file: &SceneFile, variant: Variant) -> Result<Cow<'_, Scene>, Unvaried> {
    let of = |variant| exercise::variant(&file.scene, variant).ok_or(Unvaried::NoExercise);
    match variant {
        Variant::Figure => Ok(Cow::Borrowed(&file.scene)),
        Variant::Key => of(variant).map(Cow::Owned),
        Variant::Question => {
            // Nobody is asked what has no answer.
            plan(&of(Variant::Key)?).map(|_| ()).map_err(Unvaried::Wrong)?;
            of(variant).map(Cow::Owned)
        }
    }
}
