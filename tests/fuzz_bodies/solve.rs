//! What the fuzz target `solve` holds of any line.

use std::collections::BTreeMap;

use serde_json::Value;
use serde_json::value::RawValue;

/// Any line to `solve --jsonl` gets one line of JSON: a result or an error, no `internal` one, with bounds in
/// order.
pub(crate) fn holds(text: &str) {
    let line = text.replace('\n', " ");
    let reply = tracefig::solve_jsonl_line(&line, 1).line;
    assert!(!reply.contains(['\n', '\r']), "{reply}");
    // An id is copied as it stands, also a number that no double holds.
    let json: Result<BTreeMap<String, Box<RawValue>>, _> = serde_json::from_str(&reply);
    assert!(json.is_ok(), "{json:?}: {line} gave {reply}");
    let Ok(json) = json else { return };
    let of = |key| json.get(key).and_then(|raw| serde_json::from_str::<Value>(raw.get()).ok());
    let (result, error) = (of("result"), of("error"));
    assert!(result.is_some() != error.is_some(), "{reply}");
    assert!(error.is_none_or(|e| e.get("code").and_then(Value::as_str) != Some("internal")), "{reply}");
    let Some(result) = result.as_ref().and_then(Value::as_object) else { return };
    for (name, bounds) in result.iter().filter(|(name, _)| name.ends_with("_bounds")) {
        let ends: Vec<f64> = bounds.as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
        assert!(matches!(ends[..], [low, high] if low <= high), "{name}: {reply}");
        let value = result.get(name.trim_end_matches("_bounds")).and_then(Value::as_f64);
        assert!(value.is_none_or(|v| ends[0] <= v && v <= ends[1]), "{name}: {reply}");
    }
}
