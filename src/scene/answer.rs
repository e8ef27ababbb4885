//! What `solve` says of an answer: JSON for programs, a few lines for people.
//!
//! Numbers are the shortest decimals that read back as the same double. A bound that is infinite, as the
//! upper one after a separating axis, is `null` in JSON.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use crate::collision::answer::Part;
use crate::collision::{Answer, QueryKind};
use crate::geometry::{Enclosure, Feature};

use super::node::number;

/// The `result` of a query, in the order of fields of the format.
///
/// ```
/// use tracefig::collision::{Answer, MotionBound, QueryKind};
/// let answer = Answer::MotionBound(MotionBound { bound: 1.5 });
/// let json = tracefig::scene::answer_json(QueryKind::MotionBound, &answer);
/// assert_eq!(json.to_string(), r#"{"kind":"motion-bound","bound":1.5}"#);
/// ```
#[must_use]
pub fn answer_json(kind: QueryKind, answer: &Answer) -> Value {
    let mut out = Map::new();
    out.insert("kind".to_owned(), json!(kind.word()));
    out.extend(answer.parts().into_iter().map(|(name, part)| (name.to_owned(), value(part))));
    Value::Object(out)
}

/// A part of an answer as JSON. −0 is written as 0: the sign of a zero says nothing about a scene.
fn value(part: Part) -> Value {
    match part {
        Part::Word(word) => json!(word),
        Part::Verdict(verdict) => json!(verdict),
        Part::Count(n) => json!(n),
        Part::Number(x) => json!(x + 0.0),
        Part::Interval(Enclosure { lo, hi }) => json!([lo + 0.0, hi + 0.0]),
        Part::Point(p) => json!([p.x + 0.0, p.y + 0.0]),
        Part::Points([a, b]) => json!({ "A": value(Part::Point(a)), "B": value(Part::Point(b)) }),
        Part::Features([a, b]) => json!({ "A": feature(a), "B": feature(b) }),
    }
}

fn feature(f: Feature) -> Value {
    match f {
        Feature::Vertex(i) => json!({ "vertex": i }),
        Feature::Edge(i) => json!({ "edge": i }),
    }
}

/// The answer for people: a line for each part of it, the name of the part first. World units.
///
/// ```
/// use tracefig::collision::{Answer, MotionBound, QueryKind};
/// let answer = Answer::MotionBound(MotionBound { bound: 1.5 });
/// let text = tracefig::scene::answer_text(QueryKind::MotionBound, &answer);
/// assert_eq!(text.split_whitespace().collect::<Vec<_>>(), ["bound", "1.5"]);
/// ```
#[must_use]
pub fn answer_text(kind: QueryKind, answer: &Answer) -> String {
    let Value::Object(fields) = answer_json(kind, answer) else { return String::new() };
    let mut lines = String::new();
    for (key, value) in fields.iter().filter(|(key, _)| *key != "kind") {
        // Writing to a text can't fail.
        let _ = writeln!(lines, "  {:<18} {}", key.replace('_', " "), part(key, value));
    }
    lines
}

/// Bounds as an interval, all else by its type.
fn part(key: &str, value: &Value) -> String {
    match value {
        Value::Array(ends) if key.ends_with("_bounds") => match ends.as_slice() {
            [lo, Value::Null] => format!("[{}, inf)", words(lo)),
            [lo, hi] => format!("[{}, {}]", words(lo), words(hi)),
            _ => words(value),
        },
        _ => words(value),
    }
}

fn words(value: &Value) -> String {
    match value {
        Value::Null => "unknown".to_owned(),
        Value::Bool(true) => "yes".to_owned(),
        Value::Bool(false) => "no".to_owned(),
        Value::Number(n) => n.as_f64().map_or_else(|| n.to_string(), number),
        Value::String(s) => s.clone(),
        Value::Array(items) => format!("({})", items.iter().map(words).collect::<Vec<_>>().join(", ")),
        Value::Object(entries) => {
            entries.iter().map(|(k, v)| format!("{k} {}", words(v))).collect::<Vec<_>>().join(", ")
        }
    }
}
