//! The findings as Markdown, for the step summary of a CI system.

use std::fmt::Write;

use super::{Finding, tally};

/// Counts, then a table of what is not identical.
///
/// ```
/// use tracefig::drift::report::{Finding, markdown};
/// let bad = Finding { file: "a.svg".into(), state: "missing", details: vec![], picture: None };
/// assert!(markdown(&[bad]).starts_with("### Figures: 1 missing\n"));
/// ```
#[must_use]
pub fn markdown(findings: &[Finding]) -> String {
    let counts: Vec<_> = tally(findings)
        .into_iter()
        .filter(|&(_, n)| n > 0)
        .map(|(state, n)| format!("{n} {state}"))
        .collect();
    let mut out = format!("### Figures: {}\n", counts.join(", "));
    let bad: Vec<_> = findings.iter().filter(|f| f.is_bad()).collect();
    if bad.is_empty() {
        return out;
    }
    out.push_str("\n| file | state | what differs |\n|---|---|---|\n");
    for finding in bad {
        let details = finding.details.join("<br>").replace('|', "\\|");
        let _ = writeln!(out, "| `{}` | {} | {details} |", finding.file, finding.state);
    }
    out
}
