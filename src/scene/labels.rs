//! `[labels]`: texts and places by label key. Which keys there are, the figure's plan knows.

use super::checked::{Checked, as_text, check, short_enough, too_many};
use super::fields::LABEL;
use super::limits::MAX_LABELS;
use super::node::{Node, NodeValue};
use super::problem::{Fault, Problems};
use super::{LabelOverride, LabelPlace, Spanned};

/// The words of the eight directions, counter-clockwise from east in steps of 45°: the one list of them.
pub(crate) const COMPASS: [&str; 8] = ["E", "NE", "N", "NW", "W", "SW", "S", "SE"];

/// Reads all labels; those that are wrong are told and left out.
pub(super) fn read(top: &Checked<'_>, p: &mut Problems) -> Vec<(Spanned<String>, LabelOverride)> {
    let Some(node) = top.get("labels") else { return Vec::new() };
    let entries = node.entries().unwrap_or_default();
    if entries.len() > MAX_LABELS {
        too_many("`labels`", MAX_LABELS, "labels", entries.len(), &node.span, p);
        return Vec::new();
    }
    entries.iter().filter_map(|(key, value)| Some((key.clone(), label(&key.value, value, p)?))).collect()
}

fn label(key: &str, node: &Node, p: &mut Problems) -> Option<LabelOverride> {
    match &node.value {
        NodeValue::Text(text) => short_enough(text, key, &node.span, p).then(|| LabelOverride {
            text: Some(Spanned { value: text.clone(), span: node.span.clone() }),
            ..LabelOverride::default()
        }),
        NodeValue::Table(_) => {
            let table = check(node, key, &format!("the label `{key}`"), LABEL.fields, p)?;
            let at = place(&table, p);
            Some(LabelOverride { text: table.text("text"), at, hide: table.switch("hide").unwrap_or(false) })
        }
        _ => {
            let expected = "a text, or a table { text, at, hide }".to_owned();
            p.add(Fault::WrongType { key: key.to_owned(), expected, got: node.describe() }, &node.span);
            None
        }
    }
}

fn place(table: &Checked<'_>, p: &mut Problems) -> Option<Spanned<LabelPlace>> {
    let node = table.get("at")?;
    let Some(word) = as_text(node) else {
        let Spanned { value: [x, y], span } = table.numbers::<2>("at")?;
        return Some(Spanned { value: LabelPlace::Offset(x, y), span });
    };
    let found = COMPASS.iter().zip(0..).find(|(name, _)| **name == word);
    if found.is_none() {
        let known = COMPASS.map(str::to_owned).to_vec();
        p.add(Fault::UnknownWord { what: "direction", got: word.to_owned(), known }, &node.span);
    }
    found.map(|(_, i)| Spanned { value: LabelPlace::Compass(i), span: node.span.clone() })
}
