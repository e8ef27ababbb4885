//! The outcome of a check for people and for machines: a page, JSON, `JUnit`, a summary in Markdown.

mod html;
mod json;
mod junit;
mod markdown;

pub use html::{html, is_page};
pub use json::json;
pub use junit::junit;
pub use markdown::markdown;

use super::Measured;

/// What a check says of one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The file, as named on the command line.
    pub file: String,
    /// "identical", "changed", "stale", "missing", "orphan" or "error".
    pub state: &'static str,
    /// How it differs, line by line.
    pub details: Vec<String>,
    /// Where the image of on disk · difference · now was written, and its bytes.
    pub picture: Option<(String, Vec<u8>)>,
    /// The difference in numbers, where there are two files.
    pub measured: Option<Measured>,
}

impl Finding {
    /// A finding of which no more is known than the state of a file.
    ///
    /// ```
    /// use tracefig::drift::report::Finding;
    /// assert!(Finding::new("a.svg", "missing").details.is_empty());
    /// ```
    #[must_use]
    pub fn new(file: &str, state: &'static str) -> Self {
        Self { file: file.to_owned(), state, details: Vec::new(), picture: None, measured: None }
    }

    /// Whether the check failed for this file: whether it is anything but identical.
    ///
    /// ```
    /// use tracefig::drift::report::Finding;
    /// let finding = |state| Finding::new("a.svg", state);
    /// assert!(finding("stale").is_bad() && !finding("identical").is_bad());
    /// ```
    #[must_use]
    pub fn is_bad(&self) -> bool {
        self.state != "identical"
    }
}

/// How many findings have each state, every state once: identical, changed, stale, missing, orphan, error.
///
/// ```
/// use tracefig::drift::report::{Finding, tally};
/// let stale = Finding::new("a.svg", "stale");
/// assert_eq!(tally(&[stale])[2], ("stale", 1));
/// ```
#[must_use]
pub fn tally(findings: &[Finding]) -> Vec<(&'static str, usize)> {
    ["identical", "changed", "stale", "missing", "orphan", "error"]
        .into_iter()
        .map(|state| (state, findings.iter().filter(|f| f.state == state).count()))
        .collect()
}

/// What a writer does about findings, in a sentence; `None` where `check` has no option for any of them.
///
/// ```
/// use tracefig::drift::report::{Finding, advice};
/// let said = advice(&[Finding::new("a.svg", "missing"), Finding::new("b.svg", "stale")]).unwrap();
/// assert!(said.starts_with("`tracefig check --accept` writes what is stale or missing"));
/// assert_eq!(advice(&[Finding::new("a.svg", "identical")]), None);
/// ```
#[must_use]
pub fn advice(findings: &[Finding]) -> Option<String> {
    let is_there = |state: &&str| findings.iter().any(|f| f.state == *state);
    let differ: Vec<&str> = ["changed", "stale", "missing"].into_iter().filter(is_there).collect();
    let mut said = Vec::new();
    if let Some((last, others)) = differ.split_last() {
        let joined = if others.is_empty() { String::new() } else { others.join(", ") + " or " };
        said.push(format!("`tracefig check --accept` writes what is {joined}{last}"));
    }
    if is_there(&"orphan") {
        said.push("`tracefig check --prune` deletes orphans".to_owned());
    }
    (!said.is_empty()).then(|| said.join("; ") + "; give the same scenes and options")
}

/// A text with everything escaped that HTML or XML would take for markup.
fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\n' | '\t' => safe.push(c),
            c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn findings() -> Vec<Finding> {
        let finding = |file: &str, state, details: &[&str]| Finding {
            file: file.to_owned(),
            state,
            details: details.iter().map(|&d| d.to_owned()).collect(),
            picture: None,
            measured: None,
        };
        vec![
            finding("a.svg", "identical", &[]),
            Finding {
                picture: Some(("out/b.png".to_owned(), vec![1, 2, 3, 4])),
                ..finding("b.png", "changed", &["1 pixel"])
            },
            finding("<c>.svg", "missing", &["\u{1}&"]),
        ]
    }

    #[test]
    fn states_are_counted() {
        let counted = tally(&findings());
        assert_eq!(counted[..4], [("identical", 1), ("changed", 1), ("stale", 0), ("missing", 1)]);
    }

    #[test]
    fn the_xml_of_each_report_is_well_formed() {
        let text = junit(&findings());
        let document = roxmltree::Document::parse(&text).unwrap();
        let suite = document.root_element();
        assert_eq!((suite.attribute("tests"), suite.attribute("failures")), (Some("3"), Some("2")));
        assert_eq!(suite.descendants().filter(|n| n.has_tag_name("failure")).count(), 2);
        let page = html(&findings());
        assert!(page.contains("data:image/png;base64,AQIDBA==") && !page.contains("<c>"), "{page}");
        assert!(!page.contains("<script") && !page.contains("http"), "{page}");
        assert!(page.contains("<p><code>tracefig check --accept</code> writes what is changed or missing"));
    }

    #[test]
    fn json_and_markdown_say_the_same() {
        let value: serde_json::Value = serde_json::from_str(&json(&findings())).unwrap();
        assert_eq!((value["identical"].as_u64(), value["changed"].as_u64()), (Some(1), Some(1)));
        assert_eq!(value["files"][1]["picture"], "out/b.png");
        let text = markdown(&findings());
        assert!(text.contains("| `b.png` | changed | `1 pixel` |") && !text.contains("a.svg"), "{text}");
    }
}
