//! What moved, in words: the answer and the trace of two stamps, number by number.

use serde_json::Value;

/// Lines at most; the rest is counted.
const MAX_LINES: usize = 8;

/// Differences of the answer and of the events, the answer first: `separation: 1.42 → 1.37`.
///
/// ```
/// use serde_json::json;
/// let old = json!({"answer": {"separation": 1.42}, "trace": [{"event": "support-found", "vertices": [{"index": 2}]}]});
/// let new = json!({"answer": {"separation": 1.37}, "trace": [{"event": "support-found", "vertices": [{"index": 0}]}]});
/// let words = tracefig::drift::moved(&old, &new);
/// assert_eq!(words, ["separation: 1.42 → 1.37", "event 1, support found: vertices 0 index: 2 → 0"]);
/// ```
#[must_use]
pub fn moved(old: &Value, new: &Value) -> Vec<String> {
    let mut lines = Vec::new();
    differences("algorithm", &old["algorithm"], &new["algorithm"], &mut lines);
    differences("", &old["answer"], &new["answer"], &mut lines);
    if let (Some(a), Some(b)) = (old["trace"].as_array(), new["trace"].as_array()) {
        for (i, (a, b)) in a.iter().zip(b).enumerate() {
            let name = b["event"].as_str().unwrap_or_default().replace('-', " ");
            let from = lines.len();
            differences("", a, b, &mut lines);
            for line in &mut lines[from..] {
                *line = format!("event {}, {name}: {line}", i + 1);
            }
        }
    }
    differences("events", &old["events"], &new["events"], &mut lines);
    let more = lines.len().saturating_sub(MAX_LINES);
    if more > 0 {
        lines.truncate(MAX_LINES);
        lines.push(format!("and {more} more differences"));
    }
    lines
}

fn differences(path: &str, old: &Value, new: &Value, lines: &mut Vec<String>) {
    let inner = |key: &str| {
        if path.is_empty() { key.replace('_', " ") } else { format!("{path} {}", key.replace('_', " ")) }
    };
    match (old, new) {
        (Value::Object(a), Value::Object(b)) => {
            for (key, value) in b {
                differences(&inner(key), a.get(key).unwrap_or(&Value::Null), value, lines);
            }
            for (key, value) in a.iter().filter(|(key, _)| !b.contains_key(*key)) {
                differences(&inner(key), value, &Value::Null, lines);
            }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() && !is_short(a) => {
            for (i, (a, b)) in a.iter().zip(b).enumerate() {
                differences(&inner(&i.to_string()), a, b, lines);
            }
        }
        (old, new) if old != new => lines.push(format!("{path}: {} → {}", words(old), words(new))),
        _ => {}
    }
}

/// A point, an interval: said as a whole.
fn is_short(items: &[Value]) -> bool {
    items.len() <= 4 && items.iter().all(Value::is_number)
}

fn words(value: &Value) -> String {
    match value {
        Value::Null => "none".to_owned(),
        Value::String(s) => s.clone(),
        Value::Array(items) => format!("({})", items.iter().map(words).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_same_says_nothing() {
        let facts = json!({"answer": {"a": [1, 2]}, "trace": [], "events": 3});
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
    fn many_differences_are_counted() {
        let trace = |x: i32| (0..40).map(|i| json!({"event": "e", "x": i * x})).collect::<Vec<_>>();
        let words = moved(&json!({"trace": trace(1)}), &json!({"trace": trace(2)}));
        assert_eq!((words.len(), words[8].as_str()), (9, "and 31 more differences"));
    }
}
