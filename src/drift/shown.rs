//! The events that a figure shows, as tables: what its metadata keeps of the trace.
//!
//! Events of one kind that follow one another share a table,
//! `["difference-edge-found", ["source", "edge", …], ["A", 0, …], ["B", 2, …]]`: the name, the fields, then a
//! row for each. A later table of the same kind has null for the fields. Numbers have six digits, which is
//! more than a picture shows, so a figure does not drift when an algorithm's last bit does.

use serde_json::{Map, Value, json};

use crate::trace::Event;

/// An event that was shown.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Told {
    /// Name of the kind of event, as "difference-edge-found".
    pub(super) event: String,
    /// What it says, by name of the field.
    pub(super) fields: Map<String, Value>,
}

/// The tables as JSON, as many rows as fit into `room` bytes, and how many rows they are.
pub(super) fn tables(events: &[&Event], room: usize) -> (String, usize) {
    let (mut out, mut rows) = (String::from("["), 0);
    // The kinds so far, each with its fields, and the one whose table is open.
    let mut known: Vec<(String, Vec<String>)> = Vec::new();
    let mut open = None;
    for event in events {
        // An event without a form in JSON, which none is, is left out.
        let Ok(Value::Object(mut fields)) = serde_json::to_value(event) else { continue };
        let name =
            fields.shift_remove("event").and_then(|n| Some(n.as_str()?.to_owned())).unwrap_or_default();
        let head = (name, fields.keys().cloned().collect::<Vec<_>>());
        let row = Value::Array(fields.into_iter().map(|(_, value)| rounded(value)).collect());
        let row = serde_json::to_string(&row).unwrap_or_default();
        let kind = known.iter().position(|k| *k == head);
        let (end, begin) = if open.is_some() && open == kind {
            ("", String::new())
        } else {
            let fields = if kind.is_some() { Value::Null } else { json!(head.1) };
            (if open.is_some() { "]," } else { "" }, format!("[{},{fields}", json!(head.0)))
        };
        if out.len() + end.len() + begin.len() + row.len() + "]]".len() + 1 > room {
            break;
        }
        for part in [end, &begin, ",", &row] {
            out.push_str(part);
        }
        open = kind.or(Some(known.len()));
        if kind.is_none() {
            known.push(head);
        }
        rows += 1;
    }
    out.push_str(if open.is_some() { "]]" } else { "]" });
    (out, rows)
}

/// A value with its numbers in six digits, whole ones without a point.
fn rounded(value: Value) -> Value {
    match value {
        Value::Number(n) if n.is_f64() => match n.as_f64().and_then(six_digits) {
            #[expect(clippy::cast_possible_truncation, reason = "whole and below 10⁶")]
            Some(v) if v.fract() == 0.0 && v.abs() < 1e6 => json!(v as i64),
            Some(v) => json!(v),
            None => Value::Number(n),
        },
        Value::Array(items) => items.into_iter().map(rounded).collect(),
        Value::Object(fields) => fields.into_iter().map(|(key, value)| (key, rounded(value))).collect(),
        other => other,
    }
}

fn six_digits(v: f64) -> Option<f64> {
    // By what reads JSON, as a page has no other reader of decimals.
    serde_json::from_str(&format!("{v:.5e}")).ok()
}

/// The events that tables hold; what is no table is passed over.
pub(super) fn events(trace: &Value) -> Vec<Told> {
    let (mut all, mut known) = (Vec::new(), Map::new());
    for table in trace.as_array().into_iter().flatten() {
        let Some([event, names, rows @ ..]) = table.as_array().map(Vec::as_slice) else { continue };
        let Some(event) = event.as_str() else { continue };
        if names.is_array() {
            known.insert(event.to_owned(), names.clone());
        }
        let Some(names) = known.get(event).and_then(Value::as_array) else { continue };
        for row in rows.iter().filter_map(Value::as_array) {
            let names = names.iter().map(|name| name.as_str().unwrap_or_default().to_owned());
            let fields = names.zip(row.iter().cloned()).collect();
            all.push(Told { event: event.to_owned(), fields });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::Moment;

    fn started(time: f64) -> Event {
        Event::Started { algorithm: "minkowski", at: Moment { time, angle_a: 30.0, angle_b: -0.0 } }
    }

    #[test]
    fn what_is_written_is_read_again_to_six_digits() {
        let finished = Event::Finished { outcome: "apart" };
        let all = [started(0.1 + 0.2), started(1.0 / 3.0), finished, started(1.0)];
        let (text, rows) = tables(&all.iter().collect::<Vec<_>>(), 1000);
        let head = r#"["started",["algorithm","at"]"#;
        let row = |t: &str| format!(r#"["minkowski",{{"time":{t},"angle_a":30,"angle_b":0}}]"#);
        let end = r#"["finished",["outcome"],["apart"]]"#;
        let again = format!(r#"["started",null,{}]"#, row("1"));
        assert_eq!(text, format!("[{head},{},{}],{end},{again}]", row("0.3"), row("0.333333")));
        let read = events(&serde_json::from_str(&text).unwrap());
        assert_eq!((rows, read.len(), read[3].event.as_str()), (4, 4, "started"));
        assert_eq!(read[3].fields["at"]["time"], 1);
        assert_eq!(read[1].fields["at"]["time"], 0.333_333);
    }

    #[test]
    fn rows_that_do_not_fit_are_left_out() {
        let all = [started(0.0), started(0.5), started(1.0)];
        let all: Vec<&Event> = all.iter().collect();
        let whole = tables(&all, 1000).0.len();
        assert_eq!(tables(&all, whole).1, 3);
        let (text, rows) = tables(&all, whole - 1);
        assert_eq!(rows, 2);
        assert_eq!(events(&serde_json::from_str(&text).unwrap()).len(), 2);
        assert_eq!(tables(&all, 10), ("[]".to_owned(), 0));
    }
}
