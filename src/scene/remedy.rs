//! What would help against what is wrong with a scene: every message ends in a line that says it.

use crate::geometry::shape::{KINDS, Kind, ShapeError};

use super::elsewhere::elsewhere;
use super::problem::Fault;
use super::suggest::{nearest_or_all, quoted};

impl Fault {
    /// What would help: the nearest known word, or all that are known; `None` where nothing can be said but
    /// what helps against any fault of its kind.
    ///
    /// ```
    /// let fault = tracefig::scene::Fault::TurningBody { body: "A".to_owned() };
    /// assert_eq!(fault.help().as_deref(), Some("ask for a `time-of-impact`"));
    /// ```
    #[must_use]
    pub fn help(&self) -> Option<String> {
        match self {
            Self::UnknownKey { key, known, .. } => {
                elsewhere(key, known).or_else(|| nearest_or_all(key, known))
            }
            Self::ForeignKeys { instead, provided, .. } => {
                let all: Vec<String> =
                    instead.iter().map(|(key, value)| format!("{value} as `{key}`")).collect();
                let provided = provided.map(|so| format!(", if {so}")).unwrap_or_default();
                Some(format!("write {}{provided}", all.join(" and ")))
            }
            Self::UnknownWord { got, known, .. } | Self::UnknownBody { got, known } => {
                nearest_or_all(got, known)
            }
            Self::UnsuitedAlgorithm { suited, .. } if !suited.is_empty() => {
                Some(format!("these do: {}", quoted(suited)))
            }
            Self::Empty => Some("a scene needs at least [shapes.A] and [query]".to_owned()),
            Self::BlankLine => Some("each line of a stream is a scene as JSON".to_owned()),
            Self::NotUtf8 => Some("save it as UTF-8, not as UTF-16 or Latin-1".to_owned()),
            Self::TurningBody { .. } => Some("ask for a `time-of-impact`".to_owned()),
            Self::MissingKey { key, .. } if key == "query" => {
                Some("as: query = { kind = \"separation\", of = [\"A\", \"B\"] }".to_owned())
            }
            Self::MissingKey { key, .. } if key == "shapes" => {
                Some("as: shapes.A = { kind = \"circle\", radius = 1 }".to_owned())
            }
            Self::WrongType { key, .. } if key == "shapes" => Some(
                "each stands under its name, as: shapes.A = { kind = \"circle\", radius = 1 }".to_owned(),
            ),
            Self::WrongType { key, .. } if key == "scene" => {
                Some("a scene is one, as: shapes.A = { kind = \"circle\", radius = 1 }".to_owned())
            }
            Self::WrongType { key, expected, got }
                if got == "a table" && expected.starts_with("a list of") =>
            {
                Some(format!("each is a table of its own: [[{key}]]"))
            }
            Self::WrongType { key, expected, got }
                if expected == "a table" && got.starts_with("a list of") =>
            {
                Some(format!("there is one alone: [{key}]"))
            }
            Self::WrongCount { known, .. } if !known.is_empty() => {
                Some(format!("the scene has {}", quoted(known)))
            }
            Self::FixedAngle { kind, .. } => turning_kind(kind).map(|kind| format!("a `{kind}` may turn")),
            _ => None,
        }
    }

    /// What helps against any fault of its kind.
    pub(super) fn general(&self) -> String {
        let said = match self {
            Self::Unreadable { .. } => "look at the path, and at who may read it",
            Self::Syntax { message } if message.ends_with("trailing characters") => {
                "a file is one scene; `tracefig solve --jsonl < FILE` reads a scene a line, as `render` does"
            }
            Self::Syntax { .. } => "texts stand in quotes, lists in [ ], tables in { }",
            Self::DuplicateKey { .. } => "keep one of the two",
            Self::OverLimit { what, .. } if what == "a name" => {
                "call it by a shorter one; `[labels]` and texts of panels hold more"
            }
            Self::OverLimit { .. } => "leave some of it out, or make several scenes of it",
            Self::Endless { .. } => "look whether it is the file that was meant",
            Self::UnknownKey { .. } | Self::ForeignKeys { .. } | Self::UnknownWord { .. } => {
                "leave it out: none is known there"
            }
            Self::UnknownBody { .. } | Self::WrongCount { .. } => {
                "each body is a table of its own: [shapes.A]"
            }
            Self::NotFinite { got, .. } if got.contains("beyond") => "write one that a double has",
            Self::NotFinite { .. } => "write a number; what an engine answered with `nan` is left out",
            Self::UnsuitedAlgorithm { .. } => "without the key `algorithm` one is chosen that does",
            Self::UnsuitedShape { .. } => "ask it of another shape, or ask another question: `kind`",
            Self::MissingKey { key, .. } if key == "circumradius" => {
                "add how far its vertices are from its centre: `circumradius`; `radius` rounds it"
            }
            Self::MissingKey { key, expected, .. } => {
                let example = example(key, expected).filter(|example| example.starts_with('['));
                let so = example.map(|example| format!(", as {example}")).unwrap_or_default();
                return format!("add `{key}` there{so}");
            }
            Self::WrongType { key, expected, .. } => return written(key, expected),
            Self::OutOfRange { key, .. } if key == "shapes" => {
                "a shape is a table with its name: `[shapes.A]`"
            }
            Self::OutOfRange { key, .. } => {
                return format!("give `{key}` such a value, or leave it out where it need not be given");
            }
            Self::FixedAngle { .. } => "a `box` may turn",
            Self::Conflict { help, .. } => help,
            Self::Shape(error) => match of_shape(error) {
                Some(help) => help,
                None => return format!("`tracefig list shapes` has what `{}` may be", error.field),
            },
            Self::NotUtf8 | Self::Empty | Self::BlankLine | Self::TurningBody { .. } => "mend the file",
        };
        said.to_owned()
    }
}

/// What would help against values that make no shape; `None` where the message itself says it.
fn of_shape(error: &ShapeError) -> Option<&'static str> {
    Some(match (error.code, error.field) {
        ("not-finite", _) => "write a number: what an engine writes as `nan` or `inf` has none",
        ("too-large", _) => "measure in a larger unit: all of a scene by the same factor",
        ("negative-radius", _) => "with `radius = 0` a circle is a point, and corners are sharp",
        ("negative-extent", _) => "half-extents are half the width and half the height, both above 0",
        ("degenerate", "half_extents") => {
            "a `capsule` with `points = [[-1, 0], [1, 0]]` and `radius = 0` is a segment"
        }
        ("degenerate", "circumradius") => "a `circle` with `radius = 0` is a point",
        ("degenerate", _) => "a `capsule` with two `points` and `radius = 0` is a segment",
        ("wrong-count", "points") => {
            "a `capsule` has its two ends, as `points = [[-1, 0], [1, 0]]`; a `polygon` has `vertices`"
        }
        ("wrong-count", "edges") => "a `polygon` has as many `vertices` as are written",
        ("too-few-corners", _) => "two vertices are a `capsule` with `radius = 0`, one is a `circle`",
        ("not-simple", _) => "write the vertices in the order of the outline, each once",
        _ => return None,
    })
}

/// A value of the type that is expected, in TOML as in JSON.
fn example(key: &str, expected: &str) -> Option<&'static str> {
    let examples = [
        ("two numbers", "[1, 0.5]"),
        ("a number in [0, 1]", "0.5"),
        ("a number", "1.5"),
        ("a whole number", "3"),
        ("true or false", "true"),
        ("a text", "\"words\""),
        ("a list of points", "[[0, 0], [1, 0], [0, 1]]"),
        ("a list", "[\"A\", \"B\"]"),
    ];
    match key {
        "points" => Some("[[-1, 0], [1, 0]]"),
        "rotation" => Some("[0, 1], the cosine and the sine; degrees are `angle_deg`"),
        _ => examples.iter().find(|(kind, _)| expected.starts_with(kind)).map(|(_, example)| *example),
    }
}

/// How a value of the type that is expected is written.
fn written(key: &str, expected: &str) -> String {
    let key = key.rsplit('.').next().unwrap_or(key);
    let plain = |key: &str| key.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    match example(key, expected).filter(|_| plain(key)) {
        Some(example) => format!("`{key}` is written as {example}"),
        None => format!("`tracefig list` says what `{key}` may be"),
    }
}

/// A kind of shape that may turn and takes all that this kind takes.
fn turning_kind(fixed: &str) -> Option<&'static str> {
    let fixed = KINDS.iter().find(|kind| kind.name == fixed)?;
    let takes_all = |kind: &Kind| fixed.fields.iter().all(|f| kind.fields.iter().any(|g| g.name == f.name));
    KINDS.iter().find(|kind| kind.turns && takes_all(kind)).map(|kind| kind.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Explain;

    #[test]
    fn every_fault_of_a_scene_says_what_would_help() {
        let (key, text) = (|| "time".to_owned(), String::new);
        let known = Vec::new;
        let all = [
            Fault::Unreadable { reason: text() },
            Fault::NotUtf8,
            Fault::Empty,
            Fault::BlankLine,
            Fault::Syntax { message: text() },
            Fault::DuplicateKey { key: key() },
            Fault::OverLimit { what: text(), limit: 1, unit: "bytes", got: 2 },
            Fault::Endless { limit: 1, unit: "bytes" },
            Fault::UnknownKey { key: key(), place: text(), known: known() },
            Fault::ForeignKeys { keys: vec![key()], place: text(), instead: Vec::new(), provided: None },
            Fault::UnknownWord { what: "value", got: key(), known: known() },
            Fault::MissingKey { key: key(), place: text(), expected: text() },
            Fault::WrongType { key: key(), expected: "a number".to_owned(), got: text() },
            Fault::WrongType { key: key(), expected: "x0 < x1".to_owned(), got: text() },
            Fault::NotFinite { key: key(), got: text() },
            Fault::OutOfRange { key: key(), expected: text(), got: text() },
            Fault::Conflict { message: text(), help: key() },
            Fault::UnknownBody { got: key(), known: known() },
            Fault::TurningBody { body: key() },
        ];
        for fault in all {
            assert!(fault.remedy().is_some_and(|help| !help.is_empty()), "{fault:?}");
        }
        let conflict = Fault::Conflict { message: text(), help: key() };
        assert_eq!(conflict.remedy().as_deref(), Some("time"));
        let flat = crate::scene::open_text(
            "s.toml",
            "shapes.A = { kind = 'box', half_extents = [1, 0] }\nquery = { kind = 'bounds', of = ['A'] }",
        );
        let said = flat.unwrap_err().problems[0].fault.remedy().unwrap();
        assert!(said.contains("`capsule`"), "a box without a height: {said}");
        assert_eq!(written("radius", "a number of 0 or more"), "`radius` is written as 1.5");
        assert!(written("rotation", "two numbers").contains("`angle_deg`"));
        let lacking = |key: &str, expected: &str| {
            let (key, place, expected) = (key.to_owned(), text(), expected.to_owned());
            Fault::MissingKey { key, place, expected }.remedy().unwrap()
        };
        assert_eq!(lacking("of", "a list of names of shapes"), "add `of` there, as [\"A\", \"B\"]");
        assert_eq!(lacking("radius", "a number"), "add `radius` there");
        assert!(lacking("circumradius", "a number").contains("`radius` rounds it"));
    }
}
