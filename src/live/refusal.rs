//! Why a live figure can't be so, in a sentence for who drags it.

use std::fmt;

use serde_json::json;

use crate::figure::{self, Language, Row, rows};
use crate::output::OutputError;
use crate::scene::{Explain, Problem, Refused, Source};

/// What drags and numbers come to that can't be, by its code: a vertex across the line of its neighbours, a
/// size of nothing or less, a place far off. To who sees the picture it is said so.
const REASONS: [(&str, &str); 5] = [
    ("not-convex", "it would not be convex"),
    ("degenerate", "it would have no area"),
    ("negative-extent", TOO_SMALL),
    ("negative-radius", TOO_SMALL),
    ("off-page", "it would be too far away"),
];
/// Why a size can't be less than nothing.
const TOO_SMALL: &str = "it would be too small";

/// Why something can't be done with a live figure.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// No figure has been opened.
    Closed,
    /// The input is no JSON, or not the JSON that it should be.
    Malformed {
        /// What it should be.
        expected: &'static str,
        /// What is wrong with it.
        got: String,
    },
    /// A path of an edit leads to nothing that could be changed.
    NoPlace {
        /// The path as JSON.
        path: String,
    },
    /// The theme is none.
    Theme {
        /// Why not.
        reason: String,
    },
    /// What is asked for is no scene or no figure.
    Wrong {
        /// What would be wrong: a body by its name, or the scene.
        what: String,
        /// Why.
        why: String,
    },
    /// What is asked for is no scene or no figure, said in the scene's own language.
    Foreign {
        /// The sentence.
        said: String,
    },
    /// The picture can't be written.
    Output(OutputError),
}

/// What is said of the scenes that there can't be, as rows of a [`Language`]. Reasons are those of messages
/// about files, in English, but for those that drags and numbers meet.
pub(super) static WORDS: &[Row] = &rows([
    [
        "* can't be so: it would not be convex",
        "*",
        "* kann so nicht sein: nicht mehr konvex",
        "* ne peut pas être ainsi : ce ne serait plus convexe",
        "* no puede ser así: ya no sería convexo",
    ],
    [
        "* can't be so: it would be too small",
        "*",
        "* kann so nicht sein: zu klein",
        "* ne peut pas être ainsi : trop petit",
        "* no puede ser así: demasiado pequeño",
    ],
    [
        "* can't be so: it would have no area",
        "*",
        "* kann so nicht sein: ohne Fläche",
        "* ne peut pas être ainsi : sans surface",
        "* no puede ser así: sin área",
    ],
    [
        "the figure can't be so: it would be too far away",
        "*",
        "Das Bild kann so nicht sein: zu weit weg",
        "La figure ne peut pas être ainsi : trop loin",
        "La figura no puede ser así: demasiado lejos",
    ],
    [
        "the scene can't be so: *",
        "*",
        "Die Szene kann so nicht sein",
        "La scène ne peut pas être ainsi",
        "La escena no puede ser así",
    ],
    [
        "the figure can't be so: *",
        "*",
        "Das Bild kann so nicht sein",
        "La figure ne peut pas être ainsi",
        "La figura no puede ser así",
    ],
    ["* can't be so: *", "*", "* kann so nicht sein", "* ne peut pas être ainsi", "* no puede ser así"],
]);

impl Refusal {
    /// What a page is told of a call that was refused, as JSON.
    ///
    /// ```
    /// assert_eq!(tracefig::live::Refusal::panel("no \"B\""), r#"{"error":"no \"B\""}"#);
    /// ```
    #[must_use]
    pub fn panel(why: &str) -> String {
        json!({ "error": why }).to_string()
    }

    /// What is wrong with a scene.
    pub(super) fn of_scene(Refused { source, problems }: Refused) -> Self {
        Self::first(&source, &problems, "the scene")
    }

    /// What is wrong with a figure.
    pub(super) fn of_figure(source: &Source, problems: &[Problem<figure::Fault>]) -> Self {
        Self::first(source, problems, "the figure")
    }

    /// What is wrong in a language, where it is said to who drags.
    pub(super) fn in_language(self, language: Language) -> Self {
        if !matches!(self, Self::Wrong { .. }) {
            return self;
        }
        let english = self.to_string();
        let said = language.of_rows(WORDS, &english);
        if said == english { self } else { Self::Foreign { said } }
    }

    /// The first problem: a sentence says one thing.
    fn first<F: Explain>(source: &Source, problems: &[Problem<F>], what: &str) -> Self {
        let body = problems.first().and_then(|problem| body(source, problem));
        let why = problems.first().map(|problem| why(source, problem)).unwrap_or_default();
        Self::Wrong { what: body.unwrap_or_else(|| what.to_owned()), why }
    }
}

/// Why something can't be so, for who sees the picture and not the file.
fn why<F: Explain>(source: &Source, Problem { fault, span }: &Problem<F>) -> String {
    if let Some((_, why)) = REASONS.iter().find(|(code, _)| *code == fault.code()) {
        return (*why).to_owned();
    }
    // What would help stands behind a semicolon, and is for who writes the file.
    fault.told(source, span).split("; ").next().unwrap_or_default().to_owned()
}

/// The name of the body that a problem is about.
fn body<F>(source: &Source, problem: &Problem<F>) -> Option<String> {
    let pointer = source.pointer(&problem.span)?;
    let name = pointer.strip_prefix("/shapes/")?.split('/').next()?;
    Some(name.replace("~1", "/").replace("~0", "~"))
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Closed => f.write_str("no figure is open"),
            Self::Malformed { expected, got } => write!(f, "expected {expected}: {got}"),
            Self::NoPlace { path } => write!(f, "{path} leads nowhere in the scene"),
            Self::Theme { reason } => write!(f, "the theme can't be used: {reason}"),
            Self::Wrong { what, why } => write!(f, "{what} can't be so: {why}"),
            Self::Foreign { said } => f.write_str(said),
            Self::Output(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Refusal {}
