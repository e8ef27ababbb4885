//! The tree that TOML and JSON both become: values with their bytes in the source.

use std::ops::Range;

use super::Spanned;

/// A value and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    /// The value.
    pub(crate) value: NodeValue,
    /// Bytes of the source.
    pub(crate) span: Range<usize>,
}

/// A value as a file can say it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NodeValue {
    /// A flag: `true` or `false`.
    Bool(bool),
    /// A number, infinite or NaN too; whoever reads it refuses those.
    Number(f64),
    /// A string.
    Text(String),
    /// Values in order.
    List(Vec<Node>),
    /// Values by key, in file order; no key stands twice.
    Table(Vec<(Spanned<String>, Node)>),
    /// What a scene never holds, in words with an article: "a date", "null".
    Other(&'static str),
}

impl Node {
    /// The value in words, as messages tell what they got: "a list of 3 values".
    pub(crate) fn describe(&self) -> String {
        /// Longer texts are cut in messages.
        const SHOWN: usize = 40;
        match &self.value {
            NodeValue::Bool(b) => b.to_string(),
            NodeValue::Number(x) => number(*x),
            NodeValue::Text(t) if t.chars().count() <= SHOWN => format!("the text \"{t}\""),
            NodeValue::Text(t) => format!("the text \"{}…\"", t.chars().take(SHOWN).collect::<String>()),
            NodeValue::List(items) => match items.len() {
                0 => "an empty list".to_owned(),
                1 => "a list of one value".to_owned(),
                n => format!("a list of {n} values"),
            },
            NodeValue::Table(_) => "a table".to_owned(),
            NodeValue::Other(what) => (*what).to_owned(),
        }
    }

    /// The entries of a table; `None` for any other value.
    pub(crate) fn entries(&self) -> Option<&[(Spanned<String>, Node)]> {
        match &self.value {
            NodeValue::Table(entries) => Some(entries),
            _ => None,
        }
    }

    /// The value under a key of a table.
    pub(crate) fn get(&self, key: &str) -> Option<&Node> {
        self.entries()?.iter().find(|(k, _)| k.value == key).map(|(_, node)| node)
    }
}

/// A number for a message: short, and an infinity by its name.
pub(crate) fn number(x: f64) -> String {
    if x.is_nan() { "nan".to_owned() } else { format!("{x:?}").trim_end_matches(".0").to_owned() }
}
