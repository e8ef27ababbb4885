//! What `solve` says of an answer: JSON for programs, a few lines for people.
//!
//! Numbers are the shortest decimals that read back as the same double. A bound that is infinite, as the upper one
//! after a separating axis, is `null` in JSON.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use crate::collision::{Answer, Bounds, Impact, Outcome, Overlap, QueryKind, Separation};
use crate::geometry::{DVec2, Enclosure, Feature};

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
    match answer {
        Answer::Bounds(b) => bounds(b, &mut out),
        Answer::Overlap(Overlap { overlap, separation_bounds }) => {
            put(&mut out, "overlap", json!(overlap));
            put(&mut out, "separation_bounds", enclosure(*separation_bounds));
        }
        Answer::Separation(s) => {
            put(&mut out, "separation", float(s.separation));
            put(&mut out, "separation_bounds", enclosure(s.bounds));
            put(&mut out, "normal", point(s.normal));
            put(&mut out, "ties", json!(s.ties));
            witnesses(s, &mut out);
        }
        Answer::Impact(i) => impact(i, &mut out),
        Answer::MotionBound(m) => put(&mut out, "bound", float(m.bound)),
    }
    Value::Object(out)
}

fn put(out: &mut Map<String, Value>, key: &str, value: Value) {
    out.insert(key.to_owned(), value);
}

/// −0 is written as 0: the sign of a zero says nothing about a scene.
fn float(x: f64) -> Value {
    json!(x + 0.0)
}

fn point(p: DVec2) -> Value {
    json!([p.x + 0.0, p.y + 0.0])
}

fn enclosure(e: Enclosure) -> Value {
    json!([e.lo + 0.0, e.hi + 0.0])
}

fn feature(f: Feature) -> Value {
    match f {
        Feature::Vertex(i) => json!({ "vertex": i }),
        Feature::Edge(i) => json!({ "edge": i }),
    }
}

fn bounds(b: &Bounds, out: &mut Map<String, Value>) {
    put(out, "min", point(b.min));
    put(out, "max", point(b.max));
    put(out, "center", point(b.center));
    put(out, "half_extents", point(b.half_extents));
}

fn witnesses(s: &Separation, out: &mut Map<String, Value>) {
    put(out, "points", json!({ "A": point(s.points[0]), "B": point(s.points[1]) }));
    put(out, "features", json!({ "A": feature(s.features[0]), "B": feature(s.features[1]) }));
}

fn impact(i: &Impact, out: &mut Map<String, Value>) {
    match &i.outcome {
        Outcome::Hit { time, contact } => {
            put(out, "outcome", json!("hit"));
            put(out, "time", float(time.lo));
            put(out, "time_bounds", enclosure(*time));
            put(out, "separation", float(contact.separation));
            put(out, "separation_bounds", enclosure(contact.bounds));
            put(out, "tolerance", float(i.tolerance));
            put(out, "normal", point(contact.normal));
            witnesses(contact, out);
        }
        Outcome::Miss => {
            put(out, "outcome", json!("miss"));
            put(out, "tolerance", float(i.tolerance));
        }
        Outcome::Overlapping { contact } => {
            put(out, "outcome", json!("overlapping"));
            put(out, "separation", float(contact.separation));
            put(out, "separation_bounds", enclosure(contact.bounds));
            put(out, "tolerance", float(i.tolerance));
        }
        Outcome::Unresolved { reason, free_until } => {
            put(out, "outcome", json!("unresolved"));
            put(out, "reason", json!(reason.word()));
            put(out, "time_bounds", enclosure(Enclosure { lo: *free_until, hi: 1.0 }));
            put(out, "tolerance", float(i.tolerance));
        }
    }
    put(out, "iterations", json!(i.iterations));
}

/// The answer for people: a line for each part of it, the name of the part first.
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
