//! JSON to the common tree.
//!
//! `serde_json` has no spans. Its `RawValue` borrows from the text, though, and where a slice lies in the
//! text is its span: so keys, numbers and texts are read as raw values. What the parser comes to next begins
//! after the last of them, beyond blanks, a comma or a colon; so a list and an object know their span, too,
//! and all is read in one pass.

use std::collections::BTreeSet;
use std::fmt;
use std::ops::Range;

use serde::de::{Deserialize, DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

use super::Spanned;
use super::limits::MAX_NESTING;
use super::node::{Node, NodeValue};
use super::problem::{Fault, Problem};
use crate::geometry::read;

/// Reads a JSON text.
pub(super) fn parse(text: &str) -> Result<Node, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut walk = Walk { text, at: 0, problems: &mut problems };
    let mut parser = serde_json::Deserializer::from_str(text);
    let node = Next { walk: &mut walk, depth: 0 }.deserialize(&mut parser);
    let node = node.and_then(|node| parser.end().map(|()| node)).map_err(|e| vec![syntax(&e, text)])?;
    if problems.is_empty() { Ok(node) } else { Err(problems) }
}

/// A tree as JSON.
pub(super) fn value(node: &Node) -> serde_json::Value {
    match &node.value {
        NodeValue::Bool(flag) => (*flag).into(),
        NodeValue::Number(number) => (*number).into(),
        NodeValue::Text(text) => text.as_str().into(),
        NodeValue::List(items) => items.iter().map(value).collect(),
        NodeValue::Table(entries) => {
            entries.iter().map(|(key, node)| (key.value.clone(), value(node))).collect()
        }
        NodeValue::Other(_) => serde_json::Value::Null,
    }
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
    let mut message = words.split(" at line ").next().unwrap_or_default().to_owned();
    // As Python and JavaScript write what is no number.
    let written = text[at..].trim_start_matches('-');
    if ["NaN", "nan", "Infinity", "inf"].iter().any(|word| written.starts_with(word)) {
        message += ": JSON has no NaN and no infinity";
    }
    Problem::new(Fault::Syntax { message: format!("not JSON: {message}") }, at..at)
}

/// A walk through the text, value by value as the parser comes to them.
struct Walk<'t, 'p> {
    /// The whole text, into which spans point.
    text: &'t str,
    /// The byte after the last token that is known.
    at: usize,
    /// What was wrong so far.
    problems: &'p mut Vec<Problem>,
}

/// A value that the parser is about to read, so many levels deep.
struct Next<'w, 't, 'p> {
    /// The walk that comes to it.
    walk: &'w mut Walk<'t, 'p>,
    /// How many lists and objects hold it.
    depth: usize,
}

/// The items of a list or the entries of an object, so many levels deep.
struct Inside<'w, 't, 'p>(Next<'w, 't, 'p>);

impl<'t> Walk<'t, '_> {
    fn span(&self, raw: &RawValue) -> Range<usize> {
        let start = raw.get().as_ptr().addr() - self.text.as_ptr().addr();
        start..start + raw.get().len()
    }

    /// Where the next value begins, and its first byte: beyond blanks and one comma or colon.
    fn ahead(&self) -> (usize, Option<u8>) {
        let rest = self.text.as_bytes().get(self.at..).unwrap_or_default();
        let skipped = rest.iter().take_while(|byte| b" \t\r\n,:".contains(byte)).count();
        (self.at + skipped, rest.get(skipped).copied())
    }

    /// A value without values in it.
    fn leaf(&mut self, raw: &'t RawValue) -> Node {
        let span = self.span(raw);
        self.at = span.end;
        let text = raw.get();
        let value = match text.as_bytes().first() {
            Some(b'"') => unquoted(raw).map(NodeValue::Text),
            Some(b't' | b'f') => Ok(NodeValue::Bool(text == "true")),
            Some(b'n') => Ok(NodeValue::Other("null")),
            // The grammar has been checked: what can't be read is too large.
            first => {
                let beyond = if first == Some(&b'-') { f64::NEG_INFINITY } else { f64::INFINITY };
                Ok(NodeValue::Number(read(text).unwrap_or(beyond)))
            }
        };
        let value = value.unwrap_or_else(|error| {
            // Only a lone surrogate can still fail here.
            self.problems.push(Problem::new(broken(&error), span.clone()));
            NodeValue::Other("a broken text")
        });
        Node { value, span }
    }

    /// A list or an object that is too deep, which is passed over.
    fn too_deep(&mut self, raw: &'t RawValue, depth: usize) -> Node {
        let span = self.span(raw);
        self.at = span.end;
        let fault =
            Fault::OverLimit { what: "nesting".to_owned(), limit: MAX_NESTING, unit: "levels", got: depth };
        self.problems.push(Problem::new(fault, span.start..span.start + 1));
        Node { value: NodeValue::Other("a nested value"), span }
    }
}

/// What a text between quotes says; most have no escapes, and are what they look like.
fn unquoted(raw: &RawValue) -> Result<String, serde_json::Error> {
    let text = raw.get();
    match text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
        Some(plain) if !plain.contains('\\') => Ok(plain.to_owned()),
        _ => serde_json::from_str(text),
    }
}

/// How many entries of an object are looked through for a key; of more there is a set.
const FEW: usize = 16;

/// The keys that an object has so far.
#[derive(Default)]
struct Keys(BTreeSet<String>);

impl Keys {
    /// Whether an object of some entries has none of a key. It is asked once for each key, which becomes an
    /// entry if it is new.
    fn is_new(&mut self, key: &str, entries: &[(Spanned<String>, Node)]) -> bool {
        // A page has read its own scene from where it was read before.
        if cfg!(tracefig_page) || entries.len() < FEW {
            return entries.iter().all(|(known, _)| known.value != key);
        }
        if self.0.is_empty() {
            self.0.extend(entries.iter().map(|(known, _)| known.value.clone()));
        }
        self.0.insert(key.to_owned())
    }
}

/// A text that is no text, in the words of `serde_json` without the place that they end in.
fn broken(error: &serde_json::Error) -> Fault {
    let message = error.to_string();
    let message = message.split(" at line ").next().unwrap_or_default();
    Fault::Syntax { message: format!("not JSON: {message}") }
}

impl<'de> DeserializeSeed<'de> for Next<'_, 'de, '_> {
    type Value = Node;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Node, D::Error> {
        let Self { walk, depth } = self;
        let (start, first) = walk.ahead();
        let is_nest = matches!(first, Some(b'{' | b'['));
        if !is_nest || depth > MAX_NESTING {
            let raw = <&RawValue>::deserialize(deserializer)?;
            return Ok(if is_nest { walk.too_deep(raw, depth) } else { walk.leaf(raw) });
        }
        walk.at = start + 1;
        let value = deserializer.deserialize_any(Inside(Next { walk, depth: depth + 1 }))?;
        // The parser has found the bracket that ends it.
        walk.at = walk.ahead().0 + 1;
        Ok(Node { value, span: start..walk.at })
    }
}

impl<'de> Visitor<'de> for Inside<'_, 'de, '_> {
    type Value = NodeValue;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list or an object")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<NodeValue, A::Error> {
        let Next { walk, depth } = self.0;
        let mut items = Vec::new();
        while let Some(item) = list.next_element_seed(Next { walk: &mut *walk, depth })? {
            items.push(item);
        }
        Ok(NodeValue::List(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<NodeValue, A::Error> {
        let Next { walk, depth } = self.0;
        let mut keys = Keys::default();
        let mut entries = Vec::new();
        while let Some(raw) = map.next_key::<&RawValue>()? {
            let span = walk.span(raw);
            walk.at = span.end;
            let key = unquoted(raw).unwrap_or_else(|error| {
                walk.problems.push(Problem::new(broken(&error), span.clone()));
                raw.get().to_owned()
            });
            let node = map.next_value_seed(Next { walk: &mut *walk, depth })?;
            if keys.is_new(&key, &entries) {
                entries.push((Spanned { value: key, span }, node));
            } else {
                walk.problems.push(Problem::new(Fault::DuplicateKey { key }, span));
            }
        }
        Ok(NodeValue::Table(entries))
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
        for count in [FEW - 1, FEW, FEW + 1, 3 * FEW] {
            for twin in [0, count / 2, count - 1] {
                let keys = (0..count).chain([twin, count]).map(|i| format!("\"k{i}\": {i}"));
                let text = format!("{{{}}}", keys.collect::<Vec<_>>().join(","));
                let problems = parse(&text).unwrap_err();
                let [problem] = &problems[..] else { panic!("{problems:?}") };
                assert_eq!(problem.fault, Fault::DuplicateKey { key: format!("k{twin}") });
            }
        }
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
