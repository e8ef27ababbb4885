//! What `solve` says of an answer: JSON for programs, a few lines for people.
//!
//! Numbers are the shortest decimals that read back as the same double. A bound that is infinite, as the
//! upper one after a separating axis, is `null` in JSON.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use crate::collision::answer::{Part, Parts};
use crate::collision::{Answer, QueryKind};
use crate::geometry::{Enclosure, Feature, MOST_EPS, Names, Side, read};

use super::node::number;

/// The key of the body that a feature belongs to, by its letter.
const BODY: &str = "body";

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
    out.extend(fields(answer.parts()));
    Value::Object(out)
}

/// Parts of an answer as an object.
pub(super) fn object(parts: Parts) -> Value {
    Value::Object(fields(parts).collect())
}

fn fields(parts: Parts) -> impl Iterator<Item = (String, Value)> {
    parts.into_iter().map(|(name, part)| (name.to_owned(), value(part)))
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
        Part::Lengths([a, b]) => json!({ "A": a, "B": b }),
        Part::Features([a, b]) => json!({ "A": feature(a), "B": feature(b) }),
        Part::Owned(side, f) => {
            let mut owned = json!({ BODY: side.letter() });
            if let (Value::Object(to), Value::Object(from)) = (&mut owned, feature(f)) {
                to.extend(from);
            }
            owned
        }
        Part::Each(things) => Value::Array(things.into_iter().map(object).collect()),
    }
}

fn feature(f: Feature) -> Value {
    match f {
        Feature::Vertex(i) => json!({ "vertex": i }),
        Feature::Edge(i) => json!({ "edge": i }),
    }
}

/// The answer for people: a line for each part of it, the name of the part first. World units; bodies are
/// called `names`.
///
/// ```
/// use tracefig::collision::{Answer, MotionBound, QueryKind};
/// use tracefig::geometry::Names;
/// let answer = Answer::MotionBound(MotionBound { bound: 1.5 });
/// let text = tracefig::scene::answer_text(QueryKind::MotionBound, &answer, &Names::default());
/// assert_eq!(text.split_whitespace().collect::<Vec<_>>(), ["bound", "1.5"]);
/// ```
#[must_use]
pub fn answer_text(kind: QueryKind, answer: &Answer, names: &Names) -> String {
    lines(&answer_json(kind, answer), names)
}

/// The `result` of a query for people.
pub(super) fn lines(result: &Value, names: &Names) -> String {
    let Value::Object(fields) = result else { return String::new() };
    let mut lines = String::new();
    for (key, value) in fields.iter().filter(|(key, _)| *key != "kind") {
        let mut line = |name: &str, value: &Value| {
            // Writing to a text can't fail.
            let _ = writeln!(lines, "  {:<18} {}", name.replace('_', " "), part(key, value, names));
        };
        match value {
            Value::Array(things) if things.iter().all(Value::is_object) => {
                let one = key.strip_suffix('s').unwrap_or(key);
                (1..).zip(things).for_each(|(k, thing)| line(&format!("{one} {k}"), thing));
            }
            _ if key == "off" => line(key, &to_few_digits(value)),
            _ => line(key, value),
        }
    }
    lines
}

/// The end of a key whose numbers are in units of S ε.
const IN_EPS: &str = "_in_eps";

/// The largest size of a number, or of several.
fn largest(value: &Value) -> f64 {
    match value {
        Value::Object(entries) => entries.values().map(largest).fold(0.0, f64::max),
        other => other.as_f64().unwrap_or(0.0).abs(),
    }
}

/// A value whose numbers have three digits: of how far another answer is off only the size matters. In units
/// of S ε it is left out where that is beyond any rounding.
fn to_few_digits(value: &Value) -> Value {
    match value {
        Value::Object(entries) => {
            let is_rounding = |key: &str, value: &Value| !key.ends_with(IN_EPS) || largest(value) <= MOST_EPS;
            let told = entries.iter().filter(|(key, value)| is_rounding(key, value));
            told.map(|(key, value)| (key.clone(), to_few_digits(value))).collect()
        }
        Value::Number(x) => {
            let x = x.as_f64().unwrap_or(f64::NAN);
            let few = format!("{x:.2e}");
            let plain = read(&few).filter(|x| *x == 0.0 || (1e-4..1e7).contains(&x.abs()));
            Value::String(plain.map_or(few, number))
        }
        other => other.clone(),
    }
}

/// Bounds as an interval, all else by its type.
fn part(key: &str, value: &Value, names: &Names) -> String {
    match value {
        Value::Array(ends) if key.ends_with("_bounds") => match ends.as_slice() {
            [lo, Value::Null] => format!("[{}, inf)", words(lo, names)),
            [lo, hi] => format!("[{}, {}]", words(lo, names), words(hi, names)),
            _ => words(value, names),
        },
        _ => words(value, names),
    }
}

fn words(value: &Value, names: &Names) -> String {
    match value {
        Value::Null => "unknown".to_owned(),
        Value::Bool(true) => "yes".to_owned(),
        Value::Bool(false) => "no".to_owned(),
        Value::Number(n) => n.as_f64().map_or_else(|| n.to_string(), number),
        Value::String(s) => s.clone(),
        Value::Array(items) => {
            format!("({})", items.iter().map(|item| words(item, names)).collect::<Vec<_>>().join(", "))
        }
        Value::Object(entries) if entries.contains_key(BODY) => {
            let entry = |(key, value): (&String, &Value)| match value {
                Value::String(letter) if key == BODY => whose(letter, names),
                _ => format!("{key} {}", words(value, names)),
            };
            entries.iter().map(entry).collect::<Vec<_>>().join(" ")
        }
        Value::Object(entries) => {
            let entry = |(key, value): (&String, &Value)| {
                format!("{} {}", whose(key, names), part(key, value, names))
            };
            entries.iter().map(entry).collect::<Vec<_>>().join(", ")
        }
    }
}

/// A key of an object for people: the body's name in the place of the letter that stands for it.
fn whose(key: &str, names: &Names) -> String {
    let side = Side::BOTH.into_iter().find(|side| side.letter() == key);
    side.map_or_else(|| key.replace('_', " "), |side| names.quoted(side))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{open_text, solve};

    #[test]
    fn people_read_the_names_of_the_scene_and_programs_the_letters() {
        let text = r#"
            shapes.bullet = { kind = "circle", radius = 1 }
            shapes."the wall" = { kind = "box", half_extents = [1, 1], position = [4, 0] }
            query = { kind = "separation", of = ["bullet", "the wall"] }
        "#;
        let scene = open_text("s.toml", text).unwrap().scene;
        let answer = solve(&scene);
        let told = answer_text(scene.query.kind, &answer, &scene.names());
        assert!(told.contains(r#"bullet (1, 0), "the wall" (3, 0)"#), "{told}");
        assert!(told.contains(r#"bullet vertex 0, "the wall" edge 3"#), "{told}");
        assert!(answer_json(scene.query.kind, &answer)["points"]["A"].is_array());
        let off = |separation: f64, in_eps: f64| {
            let off = json!({"off": {"separation": separation, "separation_in_eps": in_eps}});
            lines(&off, &Names::default()).trim().to_owned()
        };
        assert_eq!(off(-6e-7, -2.702e9), "off                separation -6.00e-7, separation in eps -2.70e9");
        assert_eq!(off(-0.6, -2.702e15), "off                separation -0.6", "which is no rounding");
    }
}
