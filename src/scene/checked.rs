//! A table of the file, checked against its rows: unknown keys, missing keys, wrong types, numbers out of
//! range.
//!
//! What a [`Checked`] gives out has been checked; where a value was wrong, the problem is noted and the key
//! reads as if left out.

use std::ops::Range;

use crate::geometry::DVec2;

use super::fields::{ANY_NUMBER, Field};
use super::holds::Holds;
use super::limits::{MAX_NUMBER, MAX_TEXT, MAX_VERTICES};
use super::node::{Node, NodeValue, number};
use super::problem::{Fault, Problems};
use super::{Spanned, When};

/// A table and those of its values that are what their rows say.
pub(crate) struct Checked<'n> {
    /// Where the table stands.
    pub(crate) span: Range<usize>,
    /// The values that are what their rows say, by key.
    good: Vec<(&'static str, &'n Node)>,
}

/// Checks a table against its rows; `key` and `place` are how messages call it. `None` where it is no table.
pub(crate) fn check<'n>(
    node: &'n Node,
    key: &str,
    place: &str,
    rows: &[Field],
    p: &mut Problems,
) -> Option<Checked<'n>> {
    let Some(entries) = node.entries() else {
        let fault =
            Fault::WrongType { key: key.to_owned(), expected: "a table".to_owned(), got: node.describe() };
        p.add(fault, &node.span);
        return None;
    };
    let mut good = Vec::new();
    for (key, value) in entries {
        match rows.iter().find(|row| row.name == key.value) {
            None => {
                let known = rows.iter().map(|row| row.name.to_owned()).collect();
                p.add(
                    Fault::UnknownKey { key: key.value.clone(), place: place.to_owned(), known },
                    &key.span,
                );
            }
            Some(row) if holds(value, row, p) => good.push((row.name, value)),
            Some(_) => {}
        }
    }
    for row in rows.iter().filter(|row| row.required && node.get(row.name).is_none()) {
        let fault = Fault::MissingKey {
            key: row.name.to_owned(),
            place: place.to_owned(),
            expected: row.holds.expected(),
        };
        p.add(fault, &node.span);
    }
    Some(Checked { span: node.span.clone(), good })
}

impl<'n> Checked<'n> {
    /// The value of a key.
    pub(crate) fn get(&self, key: &str) -> Option<&'n Node> {
        self.good.iter().find(|(name, _)| *name == key).map(|&(_, node)| node)
    }

    /// The value of a key as a number.
    pub(crate) fn number(&self, key: &str) -> Option<Spanned<f64>> {
        let node = self.get(key)?;
        as_number(node).map(|value| Spanned { value, span: node.span.clone() })
    }

    /// The value of a key as a whole number, 0 or more.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "checked to be whole and in range"
    )]
    pub(crate) fn count(&self, key: &str) -> Option<Spanned<usize>> {
        self.number(key).map(|n| Spanned { value: n.value as usize, span: n.span })
    }

    /// The value of a key as a text.
    pub(crate) fn text(&self, key: &str) -> Option<Spanned<String>> {
        let node = self.get(key)?;
        as_text(node).map(|text| Spanned { value: text.to_owned(), span: node.span.clone() })
    }

    /// The values of a key that is one text or a list of texts; none where it is left out.
    pub(crate) fn texts(&self, key: &str) -> Vec<Spanned<String>> {
        self.get(key).and_then(texts).unwrap_or_default()
    }

    /// The value of a key as `[x, y]`.
    pub(crate) fn pair(&self, key: &str) -> Option<DVec2> {
        as_pair(self.get(key)?)
    }

    /// The value of a key as a list of `[x, y]`.
    pub(crate) fn points(&self, key: &str) -> Option<Vec<DVec2>> {
        as_list(self.get(key)?)?.iter().map(as_pair).collect()
    }

    /// The value of a key as true or false.
    pub(crate) fn switch(&self, key: &str) -> Option<bool> {
        match self.get(key)?.value {
            NodeValue::Bool(b) => Some(b),
            _ => None,
        }
    }

    /// The value of a key as a list of `N` numbers.
    pub(crate) fn numbers<const N: usize>(&self, key: &str) -> Option<Spanned<[f64; N]>> {
        let node = self.get(key)?;
        let numbers: Option<Vec<f64>> = as_list(node)?.iter().map(as_number).collect();
        Some(Spanned { value: numbers?.try_into().ok()?, span: node.span.clone() })
    }
}

/// The number that a value is.
pub(crate) fn as_number(node: &Node) -> Option<f64> {
    match node.value {
        NodeValue::Number(x) => Some(x),
        _ => None,
    }
}

/// The text that a value is.
pub(crate) fn as_text(node: &Node) -> Option<&str> {
    match &node.value {
        NodeValue::Text(t) => Some(t),
        _ => None,
    }
}

/// Red, green and blue of a value that is `#RRGGBB`.
pub(crate) fn as_rgb(node: &Node) -> Option<[u8; 3]> {
    let digits = as_text(node)?.strip_prefix('#')?;
    let hex = digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit());
    let [_, rgb @ ..] = u32::from_str_radix(digits, 16).ok().filter(|_| hex)?.to_be_bytes();
    Some(rgb)
}

/// The items of a value that is a list.
pub(crate) fn as_list(node: &Node) -> Option<&[Node]> {
    match &node.value {
        NodeValue::List(items) => Some(items),
        _ => None,
    }
}

/// The texts of a value that is one text or a list of texts, each with its place.
fn texts(node: &Node) -> Option<Vec<Spanned<String>>> {
    let items = as_list(node).unwrap_or(std::slice::from_ref(node));
    let text = |item: &Node| Some(Spanned { value: as_text(item)?.to_owned(), span: item.span.clone() });
    items.iter().map(text).collect()
}

/// The point that a list of two numbers is.
pub(super) fn as_pair(node: &Node) -> Option<DVec2> {
    match as_list(node)? {
        [x, y] => Some(DVec2::new(as_number(x)?, as_number(y)?)),
        _ => None,
    }
}

/// Whether a value is what its row says; notes what is wrong.
fn holds(node: &Node, row: &Field, p: &mut Problems) -> bool {
    let key = row.name;
    match row.holds {
        Holds::Text => match as_text(node) {
            Some(text) => short_enough(text, key, &node.span, p),
            None => wrong(node, row, p),
        },
        Holds::Word { what, known } => match as_text(node) {
            None => wrong(node, row, p),
            Some(word) => {
                let known = known();
                let found = known.iter().any(|k| k == word);
                if !found {
                    p.add(Fault::UnknownWord { what, got: word.to_owned(), known }, &node.span);
                }
                found
            }
        },
        Holds::Number { min, max } => in_range(node, row, min, max, p),
        Holds::NumberOr { min, max, word } => match &node.value {
            NodeValue::Number(_) => in_range(node, row, min, max, p),
            NodeValue::Text(text) if text == word => true,
            _ => wrong(node, row, p),
        },
        Holds::ColorOr(word) => match as_text(node) {
            Some(text) => text == word || as_rgb(node).is_some() || wrong(node, row, p),
            None => wrong(node, row, p),
        },
        Holds::Count { min, max } => whole(node, row, (min, max), p),
        Holds::Switch => matches!(node.value, NodeValue::Bool(_)) || wrong(node, row, p),
        Holds::Pair => numbers(node, row, 2, p),
        Holds::Rectangle => numbers(node, row, 4, p),
        Holds::RectangleOr(word) => match &node.value {
            NodeValue::List(_) => numbers(node, row, 4, p),
            NodeValue::Text(text) if text == word => true,
            _ => wrong(node, row, p),
        },
        Holds::Points => points(node, row, p),
        Holds::Names | Holds::Drags => match as_list(node) {
            Some(items) if items.iter().all(|i| as_text(i).is_some()) => true,
            _ => wrong(node, row, p),
        },
        Holds::Texts(_) => texts(node).is_some() || wrong(node, row, p),
        Holds::Moment => moment(node, row, p),
        Holds::LabelPlace => match &node.value {
            NodeValue::Text(_) => true,
            NodeValue::List(_) => numbers(node, row, 2, p),
            _ => wrong(node, row, p),
        },
        Holds::Layers | Holds::List(_) => as_list(node).is_some() || wrong(node, row, p),
        Holds::Tables(_) | Holds::Table => node.entries().is_some() || wrong(node, row, p),
        Holds::Anything => true,
    }
}

/// Whether a value is a time or the word for a moment; notes what is wrong.
fn moment(node: &Node, row: &Field, p: &mut Problems) -> bool {
    match &node.value {
        NodeValue::Number(_) => in_range(node, row, 0.0, 1.0, p),
        NodeValue::Text(word) if When::of_word(word).is_some() => true,
        NodeValue::Text(word) => {
            let known = When::WORDS.map(|(word, _)| word.to_owned()).to_vec();
            p.add(Fault::UnknownWord { what: "moment", got: word.clone(), known }, &node.span);
            false
        }
        _ => wrong(node, row, p),
    }
}

/// Notes that a value is of another type than its row says. Always false, for the tail of a check.
fn wrong(node: &Node, row: &Field, p: &mut Problems) -> bool {
    let expected = match row.holds {
        // Its range matters only to a number.
        Holds::Number { .. } => "a number".to_owned(),
        Holds::Count { .. } => "a whole number".to_owned(),
        _ => row.holds.expected(),
    };
    p.add(Fault::WrongType { key: row.name.to_owned(), expected, got: node.describe() }, &node.span);
    false
}

/// Notes that something has more than its limit.
pub(super) fn too_many(
    what: &str,
    limit: usize,
    unit: &'static str,
    got: usize,
    at: &Range<usize>,
    p: &mut Problems,
) {
    p.add(Fault::OverLimit { what: what.to_owned(), limit, unit, got }, at);
}

/// Whether a text is short enough to be typeset.
pub(crate) fn short_enough(text: &str, key: &str, span: &Range<usize>, p: &mut Problems) -> bool {
    let got = text.chars().count();
    if got > MAX_TEXT {
        too_many(&format!("`{key}`"), MAX_TEXT, "characters", got, span, p);
    }
    got <= MAX_TEXT
}

/// Whether a value is a finite number.
fn finite(node: &Node, row: &Field, p: &mut Problems) -> bool {
    match as_number(node) {
        Some(x) if x.is_finite() => true,
        Some(x) => {
            p.add(Fault::NotFinite { key: row.name.to_owned(), got: number(x) }, &node.span);
            false
        }
        None => wrong(node, row, p),
    }
}

/// Whether a value is a number from `min` to `max`.
fn in_range(node: &Node, row: &Field, min: f64, max: f64, p: &mut Problems) -> bool {
    if !finite(node, row, p) {
        return false;
    }
    let inside = as_number(node).is_some_and(|x| min <= x && x <= max);
    if !inside {
        out_of_range(node, row, p);
    }
    inside
}

/// Whether a value is a whole number from `min` to `max`.
#[expect(clippy::cast_precision_loss, reason = "the limits are far below 2⁵³")]
fn whole(node: &Node, row: &Field, (min, max): (usize, usize), p: &mut Problems) -> bool {
    if !finite(node, row, p) {
        return false;
    }
    let inside = as_number(node).is_some_and(|x| x.fract() == 0.0 && min as f64 <= x && x <= max as f64);
    if !inside {
        out_of_range(node, row, p);
    }
    inside
}

/// Notes that a number is beyond the range of its row.
fn out_of_range(node: &Node, row: &Field, p: &mut Problems) {
    let expected = match row.holds {
        Holds::Number { max: MAX_NUMBER, min } if min < 0.0 => format!("a number within ±{MAX_NUMBER:e}"),
        _ => row.holds.expected(),
    };
    p.add(Fault::OutOfRange { key: row.name.to_owned(), expected, got: node.describe() }, &node.span);
}

/// Whether a value is a list of `n` finite numbers.
fn numbers(node: &Node, row: &Field, n: usize, p: &mut Problems) -> bool {
    match as_list(node) {
        Some(items) if items.len() == n => {
            let row = Field { holds: ANY_NUMBER, ..*row };
            each(items, |item| in_range(item, &row, -MAX_NUMBER, MAX_NUMBER, p))
        }
        _ => wrong(node, row, p),
    }
}

/// Whether a value is a list of points, and not too long a one.
fn points(node: &Node, row: &Field, p: &mut Problems) -> bool {
    let Some(items) = as_list(node) else { return wrong(node, row, p) };
    if items.len() > MAX_VERTICES {
        too_many(&format!("`{}`", row.name), MAX_VERTICES, "points", items.len(), &node.span, p);
        return false;
    }
    if items.len() > 1 && items.iter().all(|item| as_number(item).is_some()) {
        let got = format!("{} numbers in one row", items.len());
        let expected = row.holds.expected();
        p.add(Fault::WrongType { key: row.name.to_owned(), expected, got }, &node.span);
        return false;
    }
    let row = Field { holds: Holds::Pair, ..*row };
    each(items, |item| numbers(item, &row, 2, p))
}

/// Whether all are good; unlike `all` it looks at each, so that everything wrong is told.
fn each(items: &[Node], mut is_good: impl FnMut(&Node) -> bool) -> bool {
    let wrong = items.iter().filter(|item| !is_good(item)).count();
    wrong == 0
}
