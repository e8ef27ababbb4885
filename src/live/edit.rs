//! Changes of a scene's JSON, by paths of keys and numbers.

use serde_json::{Map, Value};

use super::refusal::Refusal;

/// What edits look like, for messages.
const EXPECTED: &str = "a list of [path, value], where a path is a list of keys and numbers";

/// Makes all edits in a scene; after an error it is half edited.
pub(super) fn apply(scene: &mut Value, edits: &str) -> Result<(), Refusal> {
    let malformed = |got: String| Refusal::Malformed { expected: EXPECTED, got };
    let written = serde_json::from_str(edits).map_err(|error| malformed(error.to_string()))?;
    let Value::Array(edits) = written else { return Err(malformed(written.to_string())) };
    edits.into_iter().try_for_each(|edit| match edit.as_array().map(Vec::as_slice) {
        Some([Value::Array(path), value]) => set(scene, path, value.clone()),
        _ => Err(malformed(edit.to_string())),
    })
}

/// Sets what a path leads to.
fn set(scene: &mut Value, path: &[Value], value: Value) -> Result<(), Refusal> {
    let nowhere = || Refusal::NoPlace { path: Value::Array(path.to_vec()).to_string() };
    let (last, way) = path.split_last().ok_or_else(nowhere)?;
    let inner = way.iter().try_fold(scene, |at, step| entered(at, step)).ok_or_else(nowhere)?;
    match (inner, last) {
        (Value::Object(entries), Value::String(key)) if value.is_null() => {
            entries.shift_remove(key);
        }
        (Value::Object(entries), Value::String(key)) => {
            entries.insert(key.clone(), value);
        }
        (inner, last) => *entered(inner, last).ok_or_else(nowhere)? = value,
    }
    Ok(())
}

/// What a key or a number leads to.
fn entered<'v>(at: &'v mut Value, step: &Value) -> Option<&'v mut Value> {
    let number = step.as_u64().and_then(|number| usize::try_from(number).ok());
    match (at, step) {
        (Value::Object(entries), Value::String(key)) => entries.get_mut(key),
        (Value::Object(entries), _) => nth(entries, number?),
        (Value::Array(items), _) => items.get_mut(number?),
        _ => None,
    }
}

/// The entry of a table by its number, from 0.
fn nth(entries: &mut Map<String, Value>, number: usize) -> Option<&mut Value> {
    entries.values_mut().nth(number)
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::apply;

    fn edited(edits: &str) -> Result<Value, String> {
        let mut scene = json!({"shapes": {"B": {"vertices": [[0, 0], [1, 0]]}, "A": {"radius": 1}}});
        apply(&mut scene, edits).map(|()| scene).map_err(|refusal| refusal.to_string())
    }

    #[test]
    fn a_path_leads_by_keys_and_numbers_and_a_key_may_be_new() {
        let edits = r#"[[["shapes", 0, "vertices", 1], [3, 4]], [["shapes", "A", "position"], [5, 6]]]"#;
        let wanted =
            json!({"shapes": {"B": {"vertices": [[0, 0], [3, 4]]}, "A": {"radius": 1, "position": [5, 6]}}});
        assert_eq!(edited(edits).unwrap(), wanted);
    }

    #[test]
    fn nothing_takes_a_key_away_and_keeps_the_order_of_the_others() {
        let scene = edited(r#"[[["shapes", "B", "vertices"], null], [["shapes", "C"], {}]]"#).unwrap();
        assert_eq!(scene.to_string(), r#"{"shapes":{"B":{},"A":{"radius":1},"C":{}}}"#);
    }

    #[test]
    fn a_path_that_leads_nowhere_is_told() {
        for path in
            [r#"["shapes", 2, "radius"]"#, r#"["shapes", 0, "vertices", 2]"#, "[]", r#"["shapes", -1]"#]
        {
            let said = edited(&format!("[[{path}, 1]]")).unwrap_err();
            assert!(said.ends_with("leads nowhere in the scene"), "{said}");
        }
        assert!(edited("{}").unwrap_err().starts_with("expected a list of [path, value]"));
    }
}
