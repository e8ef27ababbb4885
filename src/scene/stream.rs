//! `solve --jsonl`: a scene a line in, an answer a line out.

use std::borrow::Cow;
use std::fmt::Write;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use serde::de::IgnoredAny;
use serde_json::json;

use super::explain::{Explain, help_in};
use super::limits::MAX_FILE_BYTES;
use super::node::{Node, NodeValue};
use super::open::checked;
use super::problem::{Fault, Problem};
use super::source::Source;
use super::visible::brief;
use super::{Refused, Scene, SceneFile, Solution, codes, read};
use crate::collision::Answer;

/// The `id` of a line without one, as JSON.
const NO_ID: &str = "null";

/// The reply to a line of a stream.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reply {
    /// One line of JSON, without its line break.
    pub line: String,
    /// Whether the scene was answered; else the line tells what is wrong.
    pub solved: bool,
    /// What came of it in a word or two: the kind of the query with its outcome or verdict, where it has one
    /// (`linear-sweep hit`), or the code of the error.
    pub outcome: String,
    /// Where the line says its number.
    number: Option<Range<usize>>,
}

impl Reply {
    /// The reply without the number of a refused line, which depends on where a stream was cut.
    ///
    /// ```
    /// let reply = tracefig::scene::solve_jsonl_line(r#"{"id": 7, "shapes": {}}"#, 3);
    /// assert!(reply.numberless().starts_with(r#"{"id":7,"error":{"code":"missing-key""#));
    /// ```
    #[must_use]
    pub fn numberless(&self) -> Cow<'_, str> {
        match self.number.clone() {
            Some(span) => [&self.line[..span.start], &self.line[span.end..]].concat().into(),
            None => self.line.as_str().into(),
        }
    }
}

/// Answers a scene by its algorithm, in world units.
///
/// ```
/// use tracefig::{collision::Answer, scene};
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
/// let Answer::Bounds(bounds) = scene::solve(&scene::open_text("s.toml", text)?.scene) else { panic!() };
/// assert_eq!(bounds.half_extents.x, 2.0);
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn solve(scene: &Scene) -> Answer {
    scene.query.algorithm.ask(&scene.query_of_bodies())
}

/// Answers one line of a JSONL stream; `line` counts from 1.
///
/// ```
/// let reply = tracefig::scene::solve_jsonl_line(r#"{"id": 7, "shapes": {}}"#, 3);
/// assert!(reply.line.starts_with(r#"{"id":7,"line":3,"error":{"code":"missing-key","message":"#));
/// assert!(reply.line.contains("the scene lacks `query`: expected an object"));
/// assert!(!reply.solved);
/// ```
#[must_use]
pub fn solve_jsonl_line(text: &str, line: usize) -> Reply {
    let source = Source::json_line("<stdin>", text.trim_end_matches(['\r', '\n']), line);
    let mut id = NO_ID.to_owned();
    let answered = held(&source).and_then(|()| source.tree()).and_then(|root: Node| {
        if let Some(text) = read::id_span(&root).and_then(|span| source.text.get(span)) {
            // Between the parts of a list or an object, either is a blank, and would end our line.
            id = text.replace(['\r', '\n'], " ");
        }
        read::from_tree(&root)
    });
    match answered {
        // A bug must not cost the rest of the stream its answers.
        Ok(scene) => match catch_unwind(AssertUnwindSafe(|| Solution::of(&scene))) {
            Ok(solution) => Reply {
                line: answered_line(&id, &solution),
                solved: true,
                outcome: solution.outcome(),
                number: None,
            },
            Err(_) => refuse(&id, line, codes::INTERNAL.code, "a bug of tracefig; please report it"),
        },
        Err(problems) => {
            let (code, message) = first_error(&problems, &source);
            if id == NO_ID {
                id = begun_id(&source.text).unwrap_or(id);
            }
            refuse(&id, line, code, &message)
        }
    }
}

/// The `id` that a line begins with that is no JSON farther on, as where an engine writes `NaN`.
fn begun_id(text: &str) -> Option<String> {
    let value =
        ["{", "\"id\"", ":"].into_iter().try_fold(text, |text, part| text.trim_start().strip_prefix(part))?;
    let mut values = serde_json::Deserializer::from_str(value).into_iter::<IgnoredAny>();
    values.next()?.ok()?;
    value.get(..values.byte_offset()).map(|id| id.trim_start().replace(['\r', '\n'], " "))
}

/// The line that answers a scene.
fn answered_line(id: &str, solution: &Solution) -> String {
    // Half of the time of `to_string`, which passes every piece through a formatter.
    let result = serde_json::to_string(&solution.json()).unwrap_or_default();
    ["{\"id\":", id, ",\"result\":", &result, "}"].concat()
}

/// Reads a line of a JSONL stream as a file is read; `line` counts from 1.
///
/// # Errors
/// All problems of the line, which messages quote with its number.
///
/// ```
/// use tracefig::scene::{Ink, open_jsonl_line};
/// let refused = open_jsonl_line(r#"{"shapes": {}}"#, 3).unwrap_err();
/// assert!(refused.render(Ink::Plain).contains(" --> <stdin>:3:1"));
/// ```
pub fn open_jsonl_line(text: &str, line: usize) -> Result<SceneFile, Box<Refused>> {
    let source = Source::json_line("<stdin>", text, line);
    checked(source, |source| held(source).and_then(|()| source.tree()))
}

/// The `id` of a line of a JSONL stream as a name: a text as it is, a number as it is written; `None` for
/// any other, and where the line is no JSON.
///
/// ```
/// use tracefig::scene::jsonl_name;
/// assert_eq!(jsonl_name(r#"{"id": "pair \u0031"}"#).as_deref(), Some("pair \u{31}"));
/// assert_eq!(jsonl_name(r#"{"id": 1.50}"#).as_deref(), Some("1.50"));
/// assert_eq!(jsonl_name(r#"{"id": [1]}"#), None);
/// ```
#[must_use]
pub fn jsonl_name(text: &str) -> Option<String> {
    let source = Source::json_line("", text, 1);
    let root = held(&source).and_then(|()| source.tree()).ok()?;
    let id = root.get("id")?;
    match &id.value {
        NodeValue::Text(name) => Some(name.clone()),
        NodeValue::Number(_) => source.text.get(id.span.clone()).map(str::to_owned),
        _ => None,
    }
}

/// The message's matter of a line that is not UTF-8, to be told as that of a file; `line` counts from 1.
///
/// ```
/// use tracefig::scene::{Ink, refused_bytes};
/// assert!(refused_bytes(3).render(Ink::Plain).starts_with("error[not-utf8]"));
/// ```
#[must_use]
pub fn refused_bytes(line: usize) -> Refused {
    refused(Fault::NotUtf8, line)
}

/// The message's matter of a line of more bytes than a scene may have, to be told as that of a file; `line`
/// counts from 1.
///
/// ```
/// use tracefig::scene::{Ink, refused_length};
/// assert!(refused_length(3, 5_000_000).render(Ink::Plain).starts_with("error[over-limit]"));
/// ```
#[must_use]
pub fn refused_length(line: usize, bytes: usize) -> Refused {
    refused(too_long(bytes), line)
}

fn refused(fault: Fault, line: usize) -> Refused {
    Refused { source: Source::json_line("<stdin>", "", line), problems: vec![Problem::new(fault, 0..0)] }
}

/// The reply to a line that is not UTF-8; `line` counts from 1.
///
/// ```
/// let reply = tracefig::scene::refuse_jsonl_line(3);
/// assert!(reply.line.starts_with(r#"{"id":null,"line":3,"error":{"code":"not-utf8""#));
/// ```
#[must_use]
pub fn refuse_jsonl_line(line: usize) -> Reply {
    refuse("null", line, Fault::NotUtf8.code(), &Fault::NotUtf8.to_string())
}

/// The reply to a line of more than [`MAX_FILE_BYTES`], `bytes` of them, which need not be kept to be
/// refused; `line` counts from 1.
///
/// ```
/// let reply = tracefig::scene::refuse_long_jsonl_line(3, 5_000_000);
/// assert!(reply.line.starts_with(r#"{"id":null,"line":3,"error":{"code":"over-limit""#));
/// assert!(reply.line.ends_with("at most 4194304 bytes, got 5000000\"}}"));
/// ```
#[must_use]
pub fn refuse_long_jsonl_line(line: usize, bytes: usize) -> Reply {
    let fault = too_long(bytes);
    refuse("null", line, fault.code(), &fault.to_string())
}

fn refuse(id: &str, line: usize, code: &str, message: &str) -> Reply {
    let error = json!({ "code": code, "message": message });
    let (before, number) = (format!("{{\"id\":{id},"), format!("\"line\":{line},"));
    let span = before.len()..before.len() + number.len();
    let line = format!("{before}{number}\"error\":{error}}}");
    Reply { line, solved: false, outcome: code.to_owned(), number: Some(span) }
}

fn held(source: &Source) -> Result<(), Vec<Problem>> {
    let got = source.text.len();
    if got <= MAX_FILE_BYTES { Ok(()) } else { Err(vec![Problem::new(too_long(got), 0..0)]) }
}

fn too_long(got: usize) -> Fault {
    Fault::OverLimit { what: "the line".to_owned(), limit: MAX_FILE_BYTES, unit: "bytes", got }
}

/// Whether a key that is not known may be what another fault lacks: it stands in the same table.
fn is_cause(fault: &Fault, lacking: &Fault) -> bool {
    match (fault, lacking) {
        (Fault::UnknownKey { place, .. }, Fault::MissingKey { place: of, .. }) => place == of,
        _ => false,
    }
}

/// The code of the first problem; its message, with the JSON pointer to it, or with the column in a line that
/// is no tree of values, and how many more there are.
fn first_error(problems: &[Problem], source: &Source) -> (&'static str, String) {
    let Some(first) = problems.first() else { return (codes::INTERNAL.code, String::new()) };
    let mut message = match source.pointer(&first.span) {
        Some(pointer) if !pointer.is_empty() => {
            format!("{pointer}: {}", first.fault.told(source, &first.span))
        }
        None if !first.span.is_empty() || first.span.start > 0 => {
            let column = source.place(first.span.start).column;
            format!("column {column}: {}", first.fault.told(source, &first.span))
        }
        _ => first.fault.told(source, &first.span),
    };
    if let Some(help) = help_in(source.syntax, first.fault.help()) {
        message.push_str("; ");
        message.push_str(&help);
    }
    // What is missing may be there under a name that is not known: that is the cause.
    let cause = problems.iter().find(|problem| is_cause(&problem.fault, &first.fault));
    if let Some(cause) = cause {
        let help = cause.fault.help().map(|help| format!(", {help}")).unwrap_or_default();
        let _ = write!(message, "; {}{help}", cause.fault);
    }
    let told = 1 + usize::from(cause.is_some());
    if problems.len() > told {
        let _ = write!(message, " (and {} more)", problems.len() - told);
    }
    (first.fault.code(), brief(&message))
}
