//! `[[panels]]`: spaces, moments and layers. Layers and their options stay words with their place; the
//! figure's table of layers judges them.

use std::ops::Range;

use super::checked::{Checked, as_list, as_number, as_text, check, short_enough, too_many};
use super::fields::{PANEL, ROOT};
use super::house_panels::as_json;
use super::limits::{MAX_ALL_LAYERS, MAX_LAYERS, MAX_OPTION_VALUES, MAX_PANELS};
use super::node::{Node, NodeValue, number};
use super::problem::{Fault, Problems};
use super::source::Source;
use super::{Detail, LayerSpec, Panel, Space, Spanned, Value, When};

/// Reads all panels; those that are wrong are told and left out.
pub(super) fn read(top: &Checked<'_>, names: &[Spanned<String>], p: &mut Problems) -> Vec<Panel> {
    let Some(node) = top.get("panels") else { return Vec::new() };
    let items = as_list(node).unwrap_or_default();
    if items.len() > MAX_PANELS {
        too_many("`panels`", MAX_PANELS, "panels", items.len(), &node.span, p);
        return Vec::new();
    }
    let layers = |item: &Node| item.get("layers").and_then(as_list).map_or(0, <[Node]>::len);
    let all = items.iter().map(layers).sum();
    if all > MAX_ALL_LAYERS {
        too_many("the layers of all panels", MAX_ALL_LAYERS, "layers", all, &node.span, p);
        return Vec::new();
    }
    items.iter().filter_map(|item| panel(item, names, p)).collect()
}

/// Reads panels from a text of the house, as a scene would write them; their place is `at`. None where the
/// text is not one.
pub(crate) fn of_text(text: &str, at: &Range<usize>) -> Vec<Panel> {
    let source = Source::new("", &as_json(text));
    let mut problems = Problems::default();
    let read =
        |root: Node| Some(read(&check(&root, "", "", ROOT.fields, &mut problems)?, &[], &mut problems));
    let mut panels = source.tree().ok().and_then(read).unwrap_or_default();
    for panel in &mut panels {
        panel.span = at.clone();
        let spans = panel
            .title
            .as_mut()
            .map(|t| &mut t.span)
            .into_iter()
            .chain(panel.caption.as_mut().map(|c| &mut c.span))
            .chain(panel.when.as_mut().map(|w| &mut w.span))
            .chain(panel.inset.as_mut().map(|i| &mut i.span));
        spans.for_each(|span| *span = at.clone());
        for layer in panel.layers.iter_mut().flatten() {
            layer.name.span = at.clone();
        }
    }
    panels
}

fn panel(node: &Node, names: &[Spanned<String>], p: &mut Problems) -> Option<Panel> {
    let table = check(node, "panels", PANEL.place, PANEL.fields, p)?;
    let space = space(&table, names, p);
    let when = when(&table, p);
    let view = rectangle(&table, "view", p);
    let inset = inset(&table, p);
    let inset_at = table.text("inset_at");
    if let Some(corner) = inset_at.as_ref().filter(|_| table.get("inset").is_none()) {
        let message = "`inset_at` applies to a panel with an `inset`".to_owned();
        let help = "leave it out, or add `inset = \"small\"`".to_owned();
        p.add(Fault::Conflict { message, help }, &corner.span);
    }
    let layers = table.get("layers").map(|node| layers(node, p));
    Some(Panel {
        title: table.text("title"),
        caption: table.text("caption"),
        space: space?,
        when,
        layers,
        view,
        inset,
        inset_at,
        columns: table.count("columns").map(|n| n.value),
        span: table.span.clone(),
    })
}

/// What a panel enlarges.
fn inset(table: &Checked<'_>, p: &mut Problems) -> Option<Spanned<Detail>> {
    if let Some(Spanned { span, .. }) = table.text("inset") {
        return Some(Spanned { value: Detail::Small, span });
    }
    let Spanned { value, span } = rectangle(table, "inset", p)?;
    Some(Spanned { value: Detail::Rectangle(value), span })
}

/// A rectangle by two opposite corners, of which the first is the lower left one.
fn rectangle(table: &Checked<'_>, key: &str, p: &mut Problems) -> Option<Spanned<[f64; 4]>> {
    let found = table.numbers::<4>(key);
    if let Some(Spanned { value: [x0, y0, x1, y1], span }) = &found
        && (x0 >= x1 || y0 >= y1)
    {
        let got = format!("[{}, {}, {}, {}]", number(*x0), number(*y0), number(*x1), number(*y1));
        let expected = "x0 < x1 and y0 < y1".to_owned();
        p.add(Fault::OutOfRange { key: key.to_owned(), expected, got }, span);
    }
    found
}

fn space(table: &Checked<'_>, names: &[Spanned<String>], p: &mut Problems) -> Option<Space> {
    let word = table.text("space");
    let frame = table.text("frame");
    let is_body = word.as_ref().is_some_and(|w| w.value == "body");
    match (is_body, frame) {
        (true, Some(frame)) => {
            let found = names.iter().position(|n| n.value == frame.value);
            if found.is_none() {
                let known = names.iter().map(|n| n.value.clone()).collect();
                p.add(Fault::UnknownBody { got: frame.value, known }, &frame.span);
            }
            found.map(Space::Body)
        }
        (true, None) => {
            let place = "a panel with `space = \"body\"`".to_owned();
            let all: Vec<String> = names.iter().map(|name| format!("\"{}\"", name.value)).collect();
            let expected = format!("the name of a shape: {}", all.join(" or "));
            let span = word.map_or(table.span.clone(), |w| w.span);
            p.add(Fault::MissingKey { key: "frame".to_owned(), place, expected }, &span);
            None
        }
        (false, Some(frame)) => {
            let message = "`frame` applies to `space = \"body\"` only".to_owned();
            let help = "leave it out, or add `space = \"body\"`".to_owned();
            p.add(Fault::Conflict { message, help }, &frame.span);
            None
        }
        (false, None) if word.is_some_and(|w| w.value == "configuration") => Some(Space::Configuration),
        (false, None) => Some(Space::World),
    }
}

fn when(table: &Checked<'_>, p: &mut Problems) -> Option<Spanned<When>> {
    let time = table.get("time").and_then(|node| {
        let when = match as_text(node).and_then(When::of_word) {
            Some(when) => when,
            None => When::Time(as_number(node)?),
        };
        Some(Spanned { value: when, span: node.span.clone() })
    });
    let step = table.count("step").map(|n| Spanned { value: When::Step(n.value), span: n.span });
    if let (Some(_), Some(step)) = (&time, &step) {
        let message = "a panel has a `time` or a `step`, not both".to_owned();
        let help = "keep one of the two".to_owned();
        p.add(Fault::Conflict { message, help }, &step.span);
    }
    time.or(step)
}

fn layers(node: &Node, p: &mut Problems) -> Vec<LayerSpec> {
    let items = as_list(node).unwrap_or_default();
    if items.len() > MAX_LAYERS {
        too_many("`layers`", MAX_LAYERS, "layers", items.len(), &node.span, p);
        return Vec::new();
    }
    items.iter().filter_map(|item| layer(item, p)).collect()
}

fn layer(node: &Node, p: &mut Problems) -> Option<LayerSpec> {
    if let Some(name) = as_text(node) {
        let name = Spanned { value: name.to_owned(), span: node.span.clone() };
        return Some(LayerSpec { name, options: Vec::new() });
    }
    let Some(entries) = node.entries() else {
        let expected = "a layer, by name or as a table { layer = \"…\", … }".to_owned();
        p.add(Fault::WrongType { key: "layers".to_owned(), expected, got: node.describe() }, &node.span);
        return None;
    };
    let mut name = None;
    let mut options = Vec::new();
    for (key, value) in entries {
        if key.value == "layer" {
            let Some(text) = as_text(value) else {
                let expected = "the name of a layer".to_owned();
                let fault = Fault::WrongType { key: "layer".to_owned(), expected, got: value.describe() };
                p.add(fault, &value.span);
                return None;
            };
            name = Some(Spanned { value: text.to_owned(), span: value.span.clone() });
        } else if let Some(option) = option(&key.value, value, p) {
            options.push((key.clone(), option));
        }
    }
    if name.is_none() {
        let expected = "the name of a layer".to_owned();
        let fault = Fault::MissingKey { key: "layer".to_owned(), place: "a layer".to_owned(), expected };
        p.add(fault, &node.span);
    }
    Some(LayerSpec { name: name?, options })
}

fn option(key: &str, node: &Node, p: &mut Problems) -> Option<Spanned<Value>> {
    let value = match &node.value {
        NodeValue::Bool(b) => Value::Bool(*b),
        NodeValue::Number(x) if !x.is_finite() => {
            p.add(Fault::NotFinite { key: key.to_owned(), got: number(*x) }, &node.span);
            return None;
        }
        NodeValue::Number(x) => Value::Number(*x),
        NodeValue::Text(text) if short_enough(text, key, &node.span, p) => Value::Text(text.clone()),
        NodeValue::Text(_) => return None,
        NodeValue::List(items) if items.len() > MAX_OPTION_VALUES => {
            too_many(&format!("`{key}`"), MAX_OPTION_VALUES, "values", items.len(), &node.span, p);
            return None;
        }
        NodeValue::List(items) => Value::List(items.iter().filter_map(|item| option(key, item, p)).collect()),
        NodeValue::Table(_) | NodeValue::Other(_) => {
            let expected = "true or false, a number, a text or a list".to_owned();
            p.add(Fault::WrongType { key: key.to_owned(), expected, got: node.describe() }, &node.span);
            return None;
        }
    };
    Some(Spanned { value, span: node.span.clone() })
}
