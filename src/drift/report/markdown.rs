//! The findings as Markdown, for the step summary of a CI system.

use std::fmt::Write;

use super::{Finding, advice, tally};
use crate::scene::visible;

/// Counts, then a table of what is not identical.
///
/// ```
/// use tracefig::drift::report::{Finding, markdown};
/// let bad = Finding::new("a.svg", "missing");
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
        let details: Vec<String> = finding.details.iter().map(|line| code(line)).collect();
        let (file, state) = (code(&finding.file), finding.state);
        let _ = writeln!(out, "| {file} | {state} | {} |", details.join("<br>"));
    }
    if let Some(advice) = advice(findings) {
        let _ = writeln!(out, "\n{advice}");
    }
    out
}

/// A text as code within a row of a table: nothing in it is Markdown or HTML, and a line break does not end
/// the row. Code ends with as many backticks as it began, so more than are in the text keep it whole
/// (*`CommonMark` 0.31*, section 6.1); tables take out the `\` before a `|` in code, too (*GitHub Flavored
/// Markdown*, section 4.10).
fn code(text: &str) -> String {
    let text = visible(text).replace('|', "\\|");
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    // A blank at both ends keeps a backtick, or a blank, at an end apart from the fence, and is taken away.
    let pad = if text.starts_with(['`', ' ']) || text.ends_with(['`', ' ']) { " " } else { "" };
    format!("{fence}{pad}{text}{pad}{fence}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_and_no_detail_leaves_its_cell() {
        let bad = Finding {
            file: "a`\n| `fine.svg` | identical |\n![p](https://e.example).svg".to_owned(),
            state: "changed",
            details: vec!["title: reads `x`` ![](https://e.example) <img src=x>`, was `|`".to_owned()],
            picture: None,
            measured: None,
        };
        let text = markdown(&[bad]);
        assert_eq!(text.lines().count(), 7, "{text}");
        let row = text.lines().nth(4).unwrap();
        let file = "``a`␊\\| `fine.svg` \\| identical \\|␊![p](https://e.example).svg``";
        let detail = "``` title: reads `x`` ![](https://e.example) <img src=x>`, was `\\|` ```";
        assert_eq!(row, format!("| {file} | changed | {detail} |"));
    }

    #[test]
    fn code_has_more_backticks_around_it_than_in_it() {
        let cases = [("a", "`a`"), ("", "``"), ("`", "`` ` ``"), (" a", "`  a `"), ("a``b", "```a``b```")];
        for (text, expected) in cases {
            assert_eq!(code(text), expected);
        }
    }
}
