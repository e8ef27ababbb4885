//! `--variant` and `--seed`: the question and the key of scenes that are exercises, with other bodies.

use std::borrow::Cow;
use std::str::FromStr;

use tracefig::figure::exercise::{Found, TooFew, search};
use tracefig::figure::{Fault, exercise, plan};
use tracefig::scene::{Problem, Scene, SceneFile, Variant};

/// The largest number of a variant: more than classes have heads.
const MOST_SEEDS: usize = 1_000;

/// The variant of that word, for the command line.
pub(crate) fn variant(word: &str) -> Result<Variant, String> {
    let known = || Variant::OF_AN_EXERCISE.map(Variant::word).join(" or ");
    Variant::of_word(word).ok_or_else(|| format!("expected {}", known()))
}

/// Numbers of variants, from the first to the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Seeds {
    /// The first, from 1.
    from: usize,
    /// The last, not below the first.
    to: usize,
}

impl FromStr for Seeds {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (from, to) = text.split_once("..").unwrap_or((text, text));
        let number = |text: &str| text.parse::<usize>().ok().filter(|n| (1..=MOST_SEEDS).contains(n));
        match (number(from), number(to)) {
            (Some(from), Some(to)) if from <= to => Ok(Self { from, to }),
            _ => Err(format!("expected a number from 1 to {MOST_SEEDS}, or two as 1..30")),
        }
    }
}

impl Seeds {
    /// All numbers, each once, in order; the scene itself where there are none.
    pub(crate) fn all(seeds: &[Self]) -> Vec<Option<usize>> {
        let mut all: Vec<_> = seeds.iter().flat_map(|seeds| (seeds.from..=seeds.to).map(Some)).collect();
        all.sort_unstable();
        all.dedup();
        if all.is_empty() { vec![None] } else { all }
    }
}

/// Why a variant of a scene can't be drawn.
pub(crate) enum Unvaried {
    /// The scene is no exercise.
    NoExercise,
    /// The key, which a question must have, is wrong.
    Wrong(Vec<Problem<Fault>>),
    /// Fewer variants have a short answer than were asked for.
    TooFew {
        /// How many have.
        found: usize,
        /// How many were asked for.
        asked: usize,
        /// Whether a body of the question turns.
        turns: bool,
    },
}

impl Unvaried {
    /// What is wrong with the scene of that name, in a line.
    pub(crate) fn message(&self, name: &str) -> String {
        match self {
            Self::NoExercise => format!("error: {name} is no exercise: it lacks `[exercise]`\n"),
            Self::Wrong(_) => format!("error: {name} has no key\n"),
            Self::TooFew { found, asked, turns } => {
                let why = if *turns {
                    "what depends on how far a body turns hardly ever has one; without `--seed` the scene \
                     itself is asked"
                } else {
                    "a `rotation` whose numbers are short, as [0.6, 0.8], and places in halves have more"
                };
                format!(
                    "error: {name}: {found} of {asked} variants have an answer of three digits at most; \
                     {why}\n"
                )
            }
        }
    }
}

/// The variants of a scene with other bodies, up to the number `most`; none without it.
pub(crate) fn varied(file: &SceneFile, most: Option<usize>) -> Result<Vec<Found>, Unvaried> {
    let Some(asked) = most else { return Ok(Vec::new()) };
    if file.scene.exercise.is_none() {
        return Err(Unvaried::NoExercise);
    }
    // What is wrong with the exercise itself is told as it is without other bodies.
    scene_of(file, Variant::Question)?;
    let turns = file.scene.query().of.iter().any(|&i| !file.scene.shapes()[i].1.spin.is_zero());
    search(&file.template(), asked).map_err(|TooFew { found }| Unvaried::TooFew { found, asked, turns })
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
