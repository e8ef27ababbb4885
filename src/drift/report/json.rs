//! The findings as one JSON object.

use serde_json::{Map, Value, json};

use super::{Finding, tally};

/// Counts by state, then every file:
/// `{"identical": 2, …, "files": [{"file", "state", "details", "picture"}]}`.
///
/// ```
/// use tracefig::drift::report::{Finding, json};
/// let bad = Finding { file: "a.svg".into(), state: "missing", details: vec![], picture: None };
/// assert!(json(&[bad]).contains(r#""missing":1"#));
/// ```
#[must_use]
pub fn json(findings: &[Finding]) -> String {
    let mut out: Map<String, Value> =
        tally(findings).into_iter().map(|(state, count)| (state.to_owned(), json!(count))).collect();
    let files = findings.iter().map(|f| {
        let picture = f.picture.as_ref().map(|(path, _)| path);
        json!({ "file": f.file, "state": f.state, "details": f.details, "picture": picture })
    });
    out.insert("files".to_owned(), files.collect());
    Value::Object(out).to_string() + "\n"
}
