//! What moved, in words: the answer and the shown events of two stamps, number by number.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::{Map, Value};

use super::shown::{Told, events};

/// Lines that are said at most; the rest is counted. A reader takes in a screen, of which a figure gets half.
const MAX_LINES: usize = 12;

/// What an event tells of, where its name does not say it well.
const NOUNS: [(&str, &str); 14] = [
    ("advanced", "step"),
    ("axis-swept", "swept axis"),
    ("axis-tested", "axis"),
    ("candidate-improved", "best candidate"),
    ("circles-compared", "circles"),
    ("clamped", "clamped point"),
    ("closest-approach-found", "closest approach"),
    ("difference-edge-found", "difference edge"),
    ("expectation-compared", "what was expected"),
    ("extents-compared", "extents"),
    ("motion-bounded", "motion bound"),
    ("penetration-measured", "penetration"),
    ("ray-clipped", "ray"),
    ("support-found", "support vertex"),
];

/// Differences of the answer and of the events, the answer first: `separation: 1.42 → 1.37`.
pub(super) fn moved(old: &Value, new: &Value) -> Vec<String> {
    let mut lines = Vec::new();
    for key in ["algorithm", "answer"] {
        let path = if key == "answer" { "" } else { key };
        let mut found = Vec::new();
        differences(path, &old[key], &new[key], &mut found);
        lines.extend(found.iter().map(|d| format!("{}: {} → {}", d.path, d.old, d.new)));
    }
    // Traces of two formats can't be held against each other.
    let key = "tracefig_figure";
    if old[key] == new[key] && old["trace"].is_array() && new["trace"].is_array() {
        of_events(&subjects(&old["trace"]), &subjects(&new["trace"]), &mut lines);
    }
    for (key, words) in [("events", "events in all"), ("shown", "events shown")] {
        if old[key] != new[key] && !old[key].is_null() && !new[key].is_null() {
            lines.push(format!("{words}: {} → {}", old[key], new[key]));
        }
    }
    limited(lines, MAX_LINES)
}

/// The first lines, and how many more there are.
pub(super) fn limited(mut lines: Vec<String>, most: usize) -> Vec<String> {
    let more = lines.len().saturating_sub(most);
    // A single one takes as much room as its count.
    if more > 1 {
        lines.truncate(most);
        lines.push(format!("and {more} more differences"));
    }
    lines
}

/// An event with what it tells of, in words that no other event of the same trace has.
struct Subject {
    /// What it is, as "difference edge 3 of B at t = 0.5".
    words: String,
    /// The numbers and words of the event, by name.
    fields: Map<String, Value>,
}

/// Events with what they tell of; the moment is said where it is not the start.
fn subjects(trace: &Value) -> Vec<Subject> {
    let (mut when, mut all) = (String::new(), Vec::<Subject>::new());
    // How many events so far have the same words before they are numbered.
    let mut counts = BTreeMap::<String, usize>::new();
    for told in events(trace) {
        if told.event == "started" {
            let time = told.fields.get("at").and_then(|at| at["time"].as_f64()).unwrap_or(0.0);
            when = if time == 0.0 { String::new() } else { format!(" at t = {}", number(time)) };
        }
        let mut words = subject(&told) + &when;
        let count = counts.entry(words.clone()).or_default();
        *count += 1;
        if *count > 1 {
            let _ = write!(words, " ({count})");
        }
        all.push(Subject { words, fields: told.fields });
    }
    all
}

/// What an event tells of: "difference edge 3 of B", "support vertex of A", "step 2".
fn subject(told: &Told) -> String {
    let noun = NOUNS.iter().find(|(event, _)| *event == told.event);
    let mut words = noun.map_or_else(|| told.event.replace('-', " "), |(_, noun)| (*noun).to_owned());
    let (field, text) = (|key| told.fields.get(key), |value: &Value| value.as_str().map(str::to_owned));
    if told.event == "started" {
        return format!("start of {}", field("algorithm").and_then(text).unwrap_or_default());
    }
    // Writing to a text can't fail.
    if let Some(number) = field("step").and_then(Value::as_u64) {
        let _ = write!(words, " {number}");
    }
    if let Some(edge) = field("edge") {
        let _ = write!(words, " {edge}");
    }
    if let Some([body, feature]) = field("source").and_then(|s| s.as_array()).map(Vec::as_slice) {
        let _ = write!(words, " of {} of {}", shown(feature), shown(body));
    }
    if let Some(body) = ["body", "of", "source"].into_iter().find_map(|key| field(key).and_then(text)) {
        let _ = write!(words, " of {body}");
    }
    words
}

/// Adds a line for each event that is new, gone or has other numbers.
fn of_events(old: &[Subject], new: &[Subject], lines: &mut Vec<String>) {
    let (before, after) = (by_words(old), by_words(new));
    for event in new {
        let Some(before) = before.get(event.words.as_str()) else {
            lines.push(format!("{}: new", event.words));
            continue;
        };
        let mut found = Vec::new();
        let fields = |s: &Subject| Value::Object(s.fields.clone());
        differences("", &fields(before), &fields(event), &mut found);
        if !found.is_empty() {
            let each =
                found.iter().map(|d| format!("{} {} → {}", d.path, d.old, d.new).trim_start().to_owned());
            lines.push(format!("{}: {}", event.words, each.collect::<Vec<_>>().join("; ")));
        }
    }
    for event in old.iter().filter(|s| !after.contains_key(s.words.as_str())) {
        lines.push(format!("{}: gone", event.words));
    }
}

/// Events by their words.
fn by_words(all: &[Subject]) -> BTreeMap<&str, &Subject> {
    // Of two with the same words, as a file by hand may have, the first.
    all.iter().rev().map(|s| (s.words.as_str(), s)).collect()
}

/// A value that is another one now.
struct Difference {
    /// Where it stands, as "features B".
    path: String,
    /// What it was, as a reader would write it.
    old: String,
    /// What it is now.
    new: String,
}

/// Adds every innermost value that differs, with its path.
fn differences(path: &str, old: &Value, new: &Value, found: &mut Vec<Difference>) {
    let inner = |key: &str| match (path, key) {
        ("", "vertices") => String::new(),
        (_, "index") => path.to_owned(),
        ("", _) => key.replace('_', " "),
        _ => format!("{path} {}", key.replace('_', " ")),
    };
    match (old, new) {
        (Value::Object(a), Value::Object(b)) if a.len() != 1 || b.len() != 1 || a.keys().eq(b.keys()) => {
            for (key, value) in b {
                differences(&inner(key), a.get(key).unwrap_or(&Value::Null), value, found);
            }
            for (key, value) in a.iter().filter(|(key, _)| !b.contains_key(*key)) {
                differences(&inner(key), value, &Value::Null, found);
            }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() && !is_point(a) => {
            for (i, (a, b)) in a.iter().zip(b).enumerate() {
                let path = if new.as_array().is_some_and(|n| n.len() == 1) {
                    path.to_owned()
                } else {
                    inner(&(i + 1).to_string())
                };
                differences(&path, a, b, found);
            }
        }
        (old, new) if old != new => {
            let (mut a, mut b) = (shown(old), shown(new));
            if a == b {
                (a, b) = (old.to_string(), new.to_string());
            }
            found.push(Difference { path: path.to_owned(), old: a, new: b });
        }
        _ => {}
    }
}

/// Whether a list is a point or an interval, which is said as a whole.
fn is_point(items: &[Value]) -> bool {
    items.len() <= 4 && items.iter().all(Value::is_number)
}

/// A value as a reader would write it; numbers in six digits.
fn shown(value: &Value) -> String {
    match value {
        Value::Null => "none".to_owned(),
        Value::String(s) => s.clone(),
        Value::Number(n) if n.is_f64() => n.as_f64().map_or_else(|| n.to_string(), number),
        Value::Array(items) => format!("({})", items.iter().map(shown).collect::<Vec<_>>().join(", ")),
        Value::Object(fields) => {
            fields.iter().map(|(key, value)| format!("{key} {}", shown(value))).collect::<Vec<_>>().join(", ")
        }
        other => other.to_string(),
    }
}

/// A number in six digits.
fn number(v: f64) -> String {
    let short: f64 = format!("{v:.5e}").parse().unwrap_or(v);
    serde_json::json!(short).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_answer_comes_first_and_an_event_says_of_whom_it_tells() {
        let support = |index| json!([["support-found", ["body", "vertices"], ["B", [{"index": index}]]]]);
        let old = json!({"answer": {"separation": 1.42}, "trace": support(2)});
        let new = json!({"answer": {"separation": 1.37}, "trace": support(0)});
        assert_eq!(moved(&old, &new), ["separation: 1.42 → 1.37", "support vertex of B: 2 → 0"]);
    }

    #[test]
    fn the_same_says_nothing() {
        let facts = json!({"answer": {"a": [1, 2]}, "trace": [["e", ["x"], [1]]], "events": 3, "shown": 1});
        assert!(moved(&facts, &facts).is_empty());
    }

    #[test]
    fn points_are_said_whole_and_what_is_gone_is_none() {
        let old = json!({"answer": {"normal": [1.0, 0.0], "outcome": "hit", "time": 0.5}});
        let new = json!({"answer": {"normal": [0.0, 1.0], "outcome": "miss"}});
        let want = ["normal: (1.0, 0.0) → (0.0, 1.0)", "outcome: hit → miss", "time: 0.5 → none"];
        assert_eq!(moved(&old, &new), want);
    }

    #[test]
    fn another_feature_is_said_as_one_thing() {
        let facts = |b: Value| json!({"answer": {"features": {"A": {"edge": 1}, "B": b}}});
        let said = moved(&facts(json!({"edge": 2})), &facts(json!({"vertex": 3})));
        assert_eq!(said, ["features B: edge 2 → vertex 3"]);
    }

    #[test]
    fn an_edge_is_found_again_though_another_was_added_before_it() {
        let head = ["source", "edge", "distance"];
        let old = json!({"trace": [["difference-edge-found", head, ["A", 0, 1.5], ["B", 3, 2.0]]]});
        let new =
            json!({"trace": [["difference-edge-found", head, ["A", 1, 9], ["A", 0, 1.5], ["B", 3, 2.25]]]});
        let want = ["difference edge 1 of A: new", "difference edge 3 of B: distance 2.0 → 2.25"];
        assert_eq!(moved(&old, &new), want);
        assert_eq!(moved(&new, &old)[1], "difference edge 1 of A: gone");
    }

    #[test]
    fn the_same_event_at_another_moment_is_another_one() {
        let trace = |d: f64| {
            json!({"trace": [["advanced", ["step", "separation"], [0, 1]],
                ["started", ["algorithm", "at"], ["minkowski", {"time": 0.25}]],
                ["difference-rounded", ["radius"], [d]]]})
        };
        assert_eq!(moved(&trace(1.0), &trace(2.0)), ["difference rounded at t = 0.25: radius 1.0 → 2.0"]);
    }

    #[test]
    fn a_last_digit_is_said_whole() {
        let answer = |s: f64| json!({"answer": {"separation": s}});
        let said = moved(&answer(0.1), &answer(0.100_000_000_000_000_02));
        assert_eq!(said, ["separation: 0.1 → 0.10000000000000002"]);
    }

    #[test]
    fn events_of_one_name_are_numbered_in_no_time() {
        let trace = |x: f64| {
            let rows = (0..30_000).map(|_| json!([x]));
            let table: Vec<Value> = [json!("e"), json!(["x"])].into_iter().chain(rows).collect();
            json!({"trace": [table]})
        };
        let words = moved(&trace(1.0), &trace(2.0));
        assert_eq!(words[..2], ["e: x 1.0 → 2.0", "e (2): x 1.0 → 2.0"]);
        assert_eq!(words.last().unwrap(), "and 29988 more differences");
    }

    #[test]
    fn one_difference_more_is_told_rather_than_counted() {
        let lines = |count: usize| limited((0..count).map(|i| i.to_string()).collect(), 3).join(" ");
        assert_eq!([lines(3), lines(4)], ["0 1 2", "0 1 2 3"]);
        assert_eq!(lines(5), "0 1 2 and 2 more differences");
    }

    #[test]
    fn many_differences_are_counted() {
        let trace = |x: i32| {
            let rows = (0..40).map(|i| json!([i, i * x]));
            let table: Vec<Value> = [json!("e"), json!(["step", "x"])].into_iter().chain(rows).collect();
            json!({"trace": [table]})
        };
        let words = moved(&trace(1), &trace(2));
        assert_eq!((words.len(), words[12].as_str()), (13, "and 27 more differences"));
    }
}
