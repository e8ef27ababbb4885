//! JSON to the common tree.
//!
//! `serde_json` has no spans. Its `RawValue` borrows from the text, though, and where a slice lies in the
//! text is its span: so each level is read as raw values and each of these again, which costs one pass for
//! each level of nesting.

use std::fmt;
use std::ops::Range;

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

use super::Spanned;
use super::limits::MAX_NESTING;
use super::node::{Node, NodeValue};
use super::problem::{Fault, Problem};

/// Reads a JSON text.
pub(super) fn parse(text: &str) -> Result<Node, Vec<Problem>> {
    let raw: &RawValue = serde_json::from_str(text).map_err(|e| vec![syntax(&e, text)])?;
    let mut problems = Vec::new();
    let node = Walk { text, problems: &mut problems }.node(raw, 0);
    if problems.is_empty() { Ok(node) } else { Err(problems) }
}

/// The JSON pointer (RFC 6901) of the innermost value or key at a byte.
pub(super) fn pointer(root: &Node, at: usize) -> String {
    let mut path = String::new();
    let mut node = root;
    loop {
        let next = match &node.value {
            NodeValue::Table(entries) => entries.iter().find_map(|(key, value)| {
                (key.span.start <= at && at < value.span.end).then(|| (escape(&key.value), value))
            }),
            NodeValue::List(items) => {
                items.iter().enumerate().find_map(|(i, v)| v.span.contains(&at).then(|| (i.to_string(), v)))
            }
            _ => None,
        };
        let Some((step, inner)) = next else { return path };
        path.push('/');
        path.push_str(&step);
        node = inner;
    }
}

/// A key as a step of a JSON pointer.
fn escape(key: &str) -> String {
    key.replace('~', "~0").replace('/', "~1")
}

/// What `serde_json` complains about, at its place.
fn syntax(error: &serde_json::Error, text: &str) -> Problem {
    let start: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    let mut at = (start + error.column().saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    // The words end in " at line 1 column 5", which is said otherwise.
    let words = error.to_string();
    let message = words.split(" at line ").next().unwrap_or_default().to_owned();
    Problem::new(Fault::Syntax { message: format!("not JSON: {message}") }, at..at)
}

/// A walk through raw values, level by level.
struct Walk<'t, 'p> {
    /// The whole text, into which spans point.
    text: &'t str,
    /// What was wrong so far.
    problems: &'p mut Vec<Problem>,
}

impl<'t> Walk<'t, '_> {
    fn span(&self, raw: &RawValue) -> Range<usize> {
        let start = raw.get().as_ptr().addr() - self.text.as_ptr().addr();
        start..start + raw.get().len()
    }

    fn node(&mut self, raw: &'t RawValue, depth: usize) -> Node {
        let span = self.span(raw);
        let text = raw.get();
        if depth > MAX_NESTING {
            let fault = Fault::OverLimit {
                what: "nesting".to_owned(),
                limit: MAX_NESTING,
                unit: "levels",
                got: depth,
            };
            self.problems.push(Problem::new(fault, span.start..span.start + 1));
            return Node { value: NodeValue::Other("a nested value"), span };
        }
        let value = match text.as_bytes().first() {
            Some(b'{') => self.table(text, depth),
            Some(b'[') => self.list(text, depth),
            Some(b'"') => serde_json::from_str(text).map(NodeValue::Text),
            Some(b't' | b'f') => Ok(NodeValue::Bool(text == "true")),
            Some(b'n') => Ok(NodeValue::Other("null")),
            // The grammar has been checked; `f64::from_str` rounds to nearest, and overflows to an infinity.
            _ => Ok(NodeValue::Number(text.parse().unwrap_or(f64::NAN))),
        };
        let value = value.unwrap_or_else(|error| {
            // Only a lone surrogate can still fail here.
            let message = error.to_string();
            let message = message.split(" at line ").next().unwrap_or_default();
            self.problems
                .push(Problem::new(Fault::Syntax { message: format!("not JSON: {message}") }, span.clone()));
            NodeValue::Other("a broken text")
        });
        Node { value, span }
    }

    fn list(&mut self, text: &'t str, depth: usize) -> serde_json::Result<NodeValue> {
        let items: Vec<&RawValue> = serde_json::from_str(text)?;
        Ok(NodeValue::List(items.into_iter().map(|item| self.node(item, depth + 1)).collect()))
    }

    fn table(&mut self, text: &'t str, depth: usize) -> serde_json::Result<NodeValue> {
        let Entries(raw) = serde_json::from_str(text)?;
        let mut keys = std::collections::BTreeSet::new();
        let mut entries = Vec::with_capacity(raw.len());
        for (key, value) in raw {
            let span = self.span(key);
            let key: String = serde_json::from_str(key.get())?;
            if keys.insert(key.clone()) {
                let node = self.node(value, depth + 1);
                entries.push((Spanned { value: key, span }, node));
            } else {
                self.problems.push(Problem::new(Fault::DuplicateKey { key }, span));
            }
        }
        Ok(NodeValue::Table(entries))
    }
}

/// The entries of an object, in order; a key that stands twice is here twice.
struct Entries<'t>(Vec<(&'t RawValue, &'t RawValue)>);

impl<'de: 't, 't> Deserialize<'de> for Entries<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Each;
        impl<'de> Visitor<'de> for Each {
            type Value = Entries<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry::<&RawValue, &RawValue>()? {
                    entries.push(entry);
                }
                Ok(Entries(entries))
            }
        }
        deserializer.deserialize_map(Each)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_knows_its_bytes() {
        let text = r#" {"a" : [1, -2.5e3], "b\n": {"c": "x"}} "#;
        let root = parse(text).unwrap();
        let a = root.get("a").unwrap();
        assert_eq!(&text[a.span.clone()], "[1, -2.5e3]");
        let NodeValue::List(items) = &a.value else { panic!("a list") };
        assert_eq!(items[1].value, NodeValue::Number(-2500.0));
        assert_eq!(&text[items[1].span.clone()], "-2.5e3");
        let (key, inner) = &root.entries().unwrap()[1];
        assert_eq!((key.value.as_str(), &text[key.span.clone()]), ("b\n", r#""b\n""#));
        assert_eq!(inner.get("c").unwrap().value, NodeValue::Text("x".to_owned()));
    }

    #[test]
    fn a_pointer_leads_to_the_innermost_value() {
        let text = r#"{"shapes": {"a/b": {"vertices": [[0, 0], [1, "x"]]}}}"#;
        let root = parse(text).unwrap();
        assert_eq!(pointer(&root, text.find("\"x\"").unwrap()), "/shapes/a~1b/vertices/1/1");
        assert_eq!(pointer(&root, text.find("\"vertices\"").unwrap()), "/shapes/a~1b/vertices");
        assert_eq!(pointer(&root, 0), "");
    }

    #[test]
    fn broken_json_points_at_the_break() {
        let problems = parse("{\n  \"a\": 1,\n  b: 2}").unwrap_err();
        assert_eq!(problems[0].fault.code(), "syntax");
        assert_eq!(problems[0].span.start, 14);
    }

    #[test]
    fn twin_keys_are_an_error() {
        let problems = parse(r#"{"a": 1, "b": 2, "a": 3}"#).unwrap_err();
        assert_eq!(problems[0].fault, Fault::DuplicateKey { key: "a".to_owned() });
        assert_eq!(problems[0].span, 17..20);
    }

    #[test]
    fn deep_nesting_is_an_error_and_not_a_crash() {
        let text = format!("{}{}", "[".repeat(200_000), "]".repeat(200_000));
        assert_eq!(parse(&text).unwrap_err()[0].fault.code(), "over-limit");
    }

    #[test]
    fn numbers_are_read_to_the_nearest_double() {
        let text =
            "[0.1, 1e-320, 123456789012345678901234567890, 9007199254740993, 2.2250738585072011e-308, 1e999]";
        let NodeValue::List(items) = parse(text).unwrap().value else { panic!("a list") };
        let got: Vec<_> = items.iter().map(|i| i.value.clone()).collect();
        let want = [
            0.1,
            1e-320,
            123_456_789_012_345_680_000_000_000_000.0,
            9_007_199_254_740_992.0,
            2.225_073_858_507_201e-308,
        ];
        for (got, want) in got.iter().zip(want) {
            assert_eq!(*got, NodeValue::Number(want));
        }
        assert_eq!(got[5], NodeValue::Number(f64::INFINITY));
    }
}
