//! What can be wrong with a scene, each with a stable code, a place, and the words that help to mend it.
//!
//! A [`Problem`] keeps fields and not sentences: what was expected, what was got, which words are known
//! there. The figure's plan reports with the same type, so that a layer that does not exist and a radius
//! below zero look alike.

use std::fmt;
use std::ops::Range;

use crate::geometry::shape::ShapeError;
use crate::geometry::sort_by;

use super::codes;

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The file can't be read.
    Unreadable {
        /// The system's words.
        reason: String,
    },
    /// The bytes are not UTF-8.
    NotUtf8,
    /// The text holds nothing but blanks and comments.
    Empty,
    /// A line of a stream holds nothing but blanks.
    BlankLine,
    /// The text is not TOML, or not JSON.
    Syntax {
        /// The parser's words.
        message: String,
    },
    /// A key stands twice.
    DuplicateKey {
        /// The key.
        key: String,
    },
    /// Something is too large.
    OverLimit {
        /// What it is, as "the file".
        what: String,
        /// The limit.
        limit: usize,
        /// What the limit counts, as "bytes".
        unit: &'static str,
        /// What the scene has.
        got: usize,
    },
    /// A stream that goes on beyond what is read of it.
    Endless {
        /// The limit.
        limit: usize,
        /// What the limit counts, as "bytes".
        unit: &'static str,
    },
    /// A key that means nothing here.
    UnknownKey {
        /// The key.
        key: String,
        /// The table it stands in, as "a circle".
        place: String,
        /// The keys of that table.
        known: Vec<String>,
    },
    /// Keys by which other tools say what others say here.
    ForeignKeys {
        /// The keys, one or two.
        keys: Vec<String>,
        /// The table they stand in, as "an aabb".
        place: String,
        /// The keys that say it here, each with the value that it has then.
        instead: Vec<(String, String)>,
        /// What they have to mean for that, where others mean several things by them.
        provided: Option<&'static str>,
    },
    /// A word that is none of those known.
    UnknownWord {
        /// What it should be, as "algorithm".
        what: &'static str,
        /// The word that stands there.
        got: String,
        /// Every word that may stand there.
        known: Vec<String>,
    },
    /// A key is missing.
    MissingKey {
        /// The key.
        key: String,
        /// The table that lacks it.
        place: String,
        /// What it holds.
        expected: String,
    },
    /// A value of another type.
    WrongType {
        /// The key it stands under.
        key: String,
        /// What was expected.
        expected: String,
        /// What was found.
        got: String,
    },
    /// An infinity, or not a number.
    NotFinite {
        /// The key it stands under.
        key: String,
        /// The number as written.
        got: String,
    },
    /// A number that its key does not allow.
    OutOfRange {
        /// The key it stands under.
        key: String,
        /// What was expected.
        expected: String,
        /// The number as written.
        got: String,
    },
    /// Keys that exclude each other.
    Conflict {
        /// The whole sentence.
        message: String,
        /// What would help.
        help: String,
    },
    /// A shape that the scene doesn't have.
    UnknownBody {
        /// The name that stands there.
        got: String,
        /// Names of the shapes that there are.
        known: Vec<String>,
    },
    /// Too many or too few shapes in `of`.
    WrongCount {
        /// The query's kind.
        kind: &'static str,
        /// What it takes.
        expected: &'static str,
        /// How many names stand there.
        got: usize,
        /// Names of the shapes that there are.
        known: Vec<String>,
    },
    /// A sweep of a turning body.
    TurningBody {
        /// Name of the shape that turns.
        body: String,
    },
    /// An angle on a shape that does not turn.
    FixedAngle {
        /// The kind of shape.
        kind: &'static str,
        /// The key of the angle, the spin or the matrix.
        key: &'static str,
        /// What it would have to be.
        expected: &'static str,
        /// The angle as written.
        got: String,
    },
    /// An algorithm that doesn't take this query.
    UnsuitedAlgorithm {
        /// Name of the algorithm.
        algorithm: &'static str,
        /// Why not.
        reason: String,
        /// Names of the algorithms that take it.
        suited: Vec<String>,
    },
    /// A shape that the query can't be asked of.
    UnsuitedShape {
        /// Name of the shape in the scene.
        body: String,
        /// Why not.
        reason: String,
    },
    /// Values that do not make a shape.
    Shape(ShapeError),
}

/// What is wrong, and where: bytes of the source text.
///
/// `F` is what the reader of scenes can find wrong, or what the plan of a figure can.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem<F = Fault> {
    /// What is wrong.
    pub fault: F,
    /// Where it is, in bytes of the source.
    pub span: Range<usize>,
}

impl<F> Problem<F> {
    /// A fault at a place.
    ///
    /// ```
    /// use tracefig::scene::{Fault, Problem};
    /// let known = vec!["shapes".to_owned(), "ghosts".to_owned()];
    /// let fault = Fault::UnknownWord { what: "layer", got: "gohsts".to_owned(), known };
    /// let problem = Problem::new(fault, 10..18);
    /// assert_eq!(problem.fault.code(), "unknown-word");
    /// assert_eq!(problem.fault.help().as_deref(), Some("did you mean `ghosts`?"));
    /// ```
    #[must_use]
    pub fn new(fault: F, span: Range<usize>) -> Self {
        Self { fault, span }
    }
}

impl Fault {
    /// The stable word for programs, one of [`ERRORS`](super::ERRORS).
    ///
    /// ```
    /// assert_eq!(tracefig::scene::Fault::NotUtf8.code(), "not-utf8");
    /// ```
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Unreadable { .. } => codes::UNREADABLE.code,
            Self::NotUtf8 => codes::NOT_UTF8.code,
            Self::Empty | Self::BlankLine => codes::EMPTY.code,
            Self::Syntax { .. } => codes::SYNTAX.code,
            Self::DuplicateKey { .. } => codes::DUPLICATE_KEY.code,
            Self::OverLimit { .. } | Self::Endless { .. } => codes::OVER_LIMIT.code,
            Self::UnknownKey { .. } | Self::ForeignKeys { .. } => codes::UNKNOWN_KEY.code,
            Self::UnknownWord { .. } => codes::UNKNOWN_WORD.code,
            Self::MissingKey { .. } => codes::MISSING_KEY.code,
            Self::WrongType { .. } => codes::WRONG_TYPE.code,
            Self::NotFinite { .. } => codes::NOT_FINITE.code,
            Self::OutOfRange { .. } => codes::OUT_OF_RANGE.code,
            Self::Conflict { .. } => codes::CONFLICT.code,
            Self::UnknownBody { .. } => codes::UNKNOWN_BODY.code,
            Self::WrongCount { .. } => codes::WRONG_COUNT.code,
            Self::TurningBody { .. } => codes::TURNING_BODY.code,
            Self::FixedAngle { .. } => codes::FIXED_ANGLE.code,
            Self::UnsuitedAlgorithm { .. } => codes::UNSUITED_ALGORITHM.code,
            Self::UnsuitedShape { .. } => codes::UNSUITED_SHAPE.code,
            Self::Shape(error) => error.code,
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable { reason } => write!(f, "can't read the scene: {reason}"),
            Self::NotUtf8 => f.write_str("expected UTF-8 text, got other bytes"),
            Self::Empty => f.write_str("expected a scene, got an empty file"),
            Self::BlankLine => f.write_str("expected a scene, got a blank line"),
            Self::Syntax { message } | Self::Conflict { message, .. } => f.write_str(message),
            Self::DuplicateKey { key } => write!(f, "the key `{key}` stands twice"),
            Self::OverLimit { what, limit, unit, got } => {
                write!(f, "{what}: expected at most {limit} {unit}, got {got}")
            }
            Self::Endless { limit, unit } => write!(f, "the file: expected at most {limit} {unit}, got more"),
            Self::UnknownKey { key, place, .. } => write!(f, "unknown key `{key}` in {place}"),
            Self::ForeignKeys { keys, place, .. } => {
                let many = if keys.len() > 1 { "s" } else { "" };
                write!(f, "unknown key{many} `{}` in {place}", keys.join("` and `"))
            }
            Self::UnknownWord { what, got, .. } => write!(f, "unknown {what} `{got}`"),
            Self::MissingKey { key, place, expected } => {
                write!(f, "{place} lacks `{key}`: expected {expected}")
            }
            Self::WrongType { key, expected, got } | Self::OutOfRange { key, expected, got } => {
                write!(f, "`{key}`: expected {expected}, got {got}")
            }
            Self::NotFinite { key, got } => write!(f, "`{key}`: expected a finite number, got {got}"),
            Self::UnknownBody { got, .. } => write!(f, "the scene has no shape `{got}`"),
            Self::WrongCount { kind, expected, got, .. } => {
                write!(f, "`of`: a `{kind}` query is of {expected}, got {got}")
            }
            Self::TurningBody { body } => {
                write!(f, "a `linear-sweep` is of shapes that do not turn, but `{body}` does")
            }
            Self::FixedAngle { kind, key, expected, got } => {
                write!(f, "`{key}`: an `{kind}` does not turn: expected {expected}, got {got}")
            }
            Self::UnsuitedAlgorithm { algorithm, reason, .. } => {
                write!(f, "the algorithm `{algorithm}` does not take this query: {reason}")
            }
            Self::UnsuitedShape { body, reason } => {
                write!(f, "the query can't be asked of `{body}`: {reason}")
            }
            Self::Shape(error) => error.fmt(f),
        }
    }
}

/// Problems as they are found.
#[derive(Debug, Default)]
pub(crate) struct Problems {
    /// At most [`MAX_PROBLEMS`], in the order in which they were found.
    found: Vec<Problem>,
}

/// How many problems of a file are kept: a file with more is no scene, and nobody reads on.
pub(crate) const MAX_PROBLEMS: usize = 50;

impl Problems {
    /// Notes a fault at a place.
    pub(crate) fn add(&mut self, fault: Fault, span: &Range<usize>) {
        if !self.is_full() {
            self.found.push(Problem::new(fault, span.clone()));
        }
    }

    /// Whether no more are noted: what it takes to say one may be saved.
    pub(crate) fn is_full(&self) -> bool {
        self.found.len() >= MAX_PROBLEMS
    }

    /// Whether nothing is wrong so far.
    pub(crate) fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// How many problems were noted so far.
    pub(crate) fn len(&self) -> usize {
        self.found.len()
    }

    /// Names the body in the keys of the problems from a number on, which stand in no text that would show
    /// it; those that are then the same are told once.
    pub(crate) fn of_body(&mut self, from: usize, name: &str) {
        for problem in self.found.iter_mut().skip(from) {
            if let Fault::WrongType { key, .. }
            | Fault::OutOfRange { key, .. }
            | Fault::NotFinite { key, .. } = &mut problem.fault
            {
                *key = format!("{name}.{key}");
            }
        }
        // By what they say, which a page has the code for anyway.
        self.found.dedup_by(|p, q| p.span == q.span && p.fault.to_string() == q.fault.to_string());
    }

    /// The problems in the order of the file.
    pub(crate) fn into_sorted(mut self) -> Vec<Problem> {
        sort_by(&mut self.found, |p, q| (p.span.start, p.span.end).cmp(&(q.span.start, q.span.end)));
        self.found
    }
}
