//! The findings as one JSON object.

use serde_json::{Map, Value, json};

use super::{Finding, Measured, tally};

/// Counts by state, then every file:
/// `{"identical": 2, …, "files": [{"file", "state", "details", "picture", "numbers"}]}`. The numbers are
/// `{"bytes": {"expected", "actual"}, "pixels": {"expected", "actual", "differ", "worst", "beyond", "box"},
/// "elements": [{"name", "box"}]}`, pixels null where none differ.
///
/// ```
/// use tracefig::drift::report::{Finding, json};
/// let bad = Finding::new("a.svg", "missing");
/// assert!(json(&[bad]).contains(r#""missing":1"#));
/// ```
#[must_use]
pub fn json(findings: &[Finding]) -> String {
    let mut out: Map<String, Value> =
        tally(findings).into_iter().map(|(state, count)| (state.to_owned(), json!(count))).collect();
    let files = findings.iter().map(|f| {
        let picture = f.picture.as_ref().map(|(path, _)| path);
        let numbers = f.measured.as_ref().map(Measured::json);
        let Finding { file, state, details, .. } = f;
        json!({ "file": file, "state": state, "details": details, "picture": picture, "numbers": numbers })
    });
    out.insert("files".to_owned(), files.collect());
    Value::Object(out).to_string() + "\n"
}
