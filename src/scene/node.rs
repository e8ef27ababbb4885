//! The tree that TOML and JSON both become: values with their bytes in the source.

use std::ops::Range;

use super::Spanned;

/// A value and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) value: NodeValue,
    pub(crate) span: Range<usize>,
}

/// A value as a file can say it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NodeValue {
    Bool(bool),
    /// May be infinite or NaN; whoever reads it refuses that.
    Number(f64),
    Text(String),
    List(Vec<Node>),
    /// Entries in file order; keys differ.
    Table(Vec<(Spanned<String>, Node)>),
    /// What a scene never holds: a date, null.
    Other(&'static str),
}

impl Node {
    /// What it is, with its article, for messages.
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

    /// Its entries, where it is a table.
    pub(crate) fn entries(&self) -> Option<&[(Spanned<String>, Node)]> {
        match &self.value {
            NodeValue::Table(entries) => Some(entries),
            _ => None,
        }
    }

    /// The value under a key.
    pub(crate) fn get(&self, key: &str) -> Option<&Node> {
        self.entries()?.iter().find(|(k, _)| k.value == key).map(|(_, node)| node)
    }
}

/// A number for a message: short, and an infinity by its name.
pub(crate) fn number(x: f64) -> String {
    if x.is_nan() { "nan".to_owned() } else { format!("{x:?}").trim_end_matches(".0").to_owned() }
}
