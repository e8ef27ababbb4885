//! The findings as `JUnit` XML, which most CI systems show.

use std::fmt::Write;

use super::{Finding, escape};
use crate::scene::visible;

/// One test case a file; what is not identical failed.
///
/// ```
/// use tracefig::drift::report::{Finding, junit};
/// let bad = Finding::new("a.svg", "missing");
/// assert!(junit(&[bad]).contains(r#"tests="1" failures="1""#));
/// ```
#[must_use]
pub fn junit(findings: &[Finding]) -> String {
    let failures = findings.iter().filter(|f| f.is_bad()).count();
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let count = findings.len();
    // Writing to a text can't fail.
    let _ = writeln!(out, "<testsuite name=\"tracefig check\" tests=\"{count}\" failures=\"{failures}\">");
    for finding in findings {
        let name = escape(&visible(&finding.file));
        if finding.is_bad() {
            let _ = writeln!(
                out,
                "  <testcase classname=\"tracefig\" name=\"{name}\">\
                 <failure message=\"{}\">{}</failure></testcase>",
                finding.state,
                escape(&finding.details.iter().map(|d| visible(d)).collect::<Vec<_>>().join("\n"))
            );
        } else {
            let _ = writeln!(out, "  <testcase classname=\"tracefig\" name=\"{name}\"/>");
        }
    }
    out.push_str("</testsuite>\n");
    out
}
