//! What a scene says, as one text that is the same however its file is written.
//!
//! Comments, blanks, the order of keys, TOML or JSON, `1` or `1.0` are how a file is written. The order of
//! shapes and labels is not: those stand above others that come later. What is not read, as the `id`, is left
//! out, and so is what a reader may move: no picture shows it.

use std::fmt::Write;

use super::fields::ROOT;
use super::holds::Holds;
use super::live;
use super::node::{Node, NodeValue};
use crate::geometry::sort_by;

/// Whether the order of a table's entries says something.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Order {
    /// Keys of one thing, which may be written in any order.
    Free,
    /// Things by name, the first before the second.
    Kept,
}

/// The values of a scene's tree, keys in order.
pub(super) fn meaning(root: &Node) -> String {
    let mut text = String::new();
    for (key, node) in sorted(root) {
        if key == live::KEY {
            continue;
        }
        match ROOT.fields.iter().find(|row| row.name == key).map(|row| row.holds) {
            Some(Holds::Anything) => {}
            Some(Holds::Tables(_)) => entry(key, node, Order::Kept, &mut text),
            _ => entry(key, node, Order::Free, &mut text),
        }
    }
    text
}

/// The entries of a table by key.
fn sorted(node: &Node) -> Vec<(&str, &Node)> {
    let mut entries = in_order(node);
    sort_by(&mut entries, |(a, _), (b, _)| a.cmp(b));
    entries
}

/// The entries of a table as they are written.
fn in_order(node: &Node) -> Vec<(&str, &Node)> {
    node.entries().into_iter().flatten().map(|(key, node)| (key.value.as_str(), node)).collect()
}

/// Adds a key and its value.
fn entry(key: &str, node: &Node, order: Order, text: &mut String) {
    // Writing to a text can't fail.
    let _ = write!(text, "{key:?}=");
    value(node, order, text);
    text.push(',');
}

/// Adds a value.
fn value(node: &Node, order: Order, text: &mut String) {
    match &node.value {
        NodeValue::Bool(flag) => text.push_str(&flag.to_string()),
        // −0 is 0.
        NodeValue::Number(number) => {
            let _ = write!(text, "{:?}", number + 0.0);
        }
        NodeValue::Text(words) => {
            let _ = write!(text, "{words:?}");
        }
        NodeValue::Other(what) => text.push_str(what),
        NodeValue::List(items) => {
            text.push('[');
            for item in items {
                value(item, Order::Free, text);
                text.push(',');
            }
            text.push(']');
        }
        NodeValue::Table(_) => {
            let entries = if order == Order::Kept { in_order(node) } else { sorted(node) };
            text.push('{');
            for (key, node) in entries {
                entry(key, node, Order::Free, text);
            }
            text.push('}');
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::open_text;

    const SCENE: &str = "title = 'x'\n[shapes.A]\nkind = 'circle'\nradius = 2\nposition = [1, 0]\n\
                         [shapes.B]\nkind = 'circle'\nradius = 1\n\
                         [query]\nkind = 'separation'\nof = ['A', 'B']\n";

    fn meaning(text: &str) -> String {
        open_text("s.toml", text).unwrap().meaning
    }

    #[test]
    fn how_a_scene_is_written_is_not_what_it_says() {
        let same = [
            format!("# a comment\n\n{SCENE}# another\n"),
            SCENE.replace("kind = 'circle'\nradius = 2", "radius = 2.0 # wide\nkind = \"circle\""),
            SCENE.replace("[1, 0]", "[\n 1.0,\n -0.0, ]"),
            format!("id = 7\nexpected = {{ separation = 1 }}\n{SCENE}"),
            r#"{"title": "x", "query": {"of": ["A", "B"], "kind": "separation"},
                "shapes": {"A": {"kind": "circle", "radius": 2, "position": [1, 0]},
                           "B": {"kind": "circle", "radius": 1e0}}}"#
                .to_owned(),
        ];
        for other in same {
            assert_eq!(meaning(&other), meaning(SCENE), "{other}");
        }
    }

    #[test]
    fn what_a_scene_says_otherwise_is_another_meaning() {
        let (a, b) = SCENE.split_once("[shapes.B]").unwrap();
        let (b, query) = b.split_once("[query]").unwrap();
        let (title, a) = a.split_once("[shapes.A]").unwrap();
        let swapped = format!("{title}[shapes.B]{b}[shapes.A]{a}[query]{query}");
        let others = [
            swapped,
            SCENE.replace("radius = 2", "radius = 2.0000000000000004"),
            SCENE.replace("['A', 'B']", "['B', 'A']"),
            SCENE.replace("title = 'x'", "title = 'x,'"),
            SCENE.replace("title = 'x'", "title = 'x'\ncaption = ''"),
            format!("{SCENE}[canvas]\nwidth = 900\n"),
        ];
        for other in others {
            assert_ne!(meaning(&other), meaning(SCENE), "{other}");
        }
    }
}
