//! `[shapes.NAME]`: a shape of one of the kinds of [`KINDS`], its pose and its motion.

use std::ops::Range;

use crate::geometry::shape::{FieldType, FieldValue, KINDS, Kind};
use crate::geometry::{Angle, Body, DVec2, Rotation, Shape};

use super::Spanned;
use super::checked::{Checked, as_list, as_text, check};
use super::fields::{BODY, shape_rows};
use super::node::{Node, number};
use super::problem::{Fault, Problems};
use super::suggest::is_meant;

/// A shape as read: its name is known to the query even where the rest of it is wrong.
pub(super) struct Read {
    /// The shape's key in `[shapes]`.
    pub(super) name: Spanned<String>,
    /// The body; `None` where something about it is wrong, which has been noted.
    pub(super) body: Option<Body>,
}

/// Longest name of a shape, in characters: it is written on the shape, where twice as many run over its
/// edges.
const MAX_NAME: usize = 40;

/// Reads one shape, and notes what is wrong with it.
pub(super) fn read(name: &Spanned<String>, node: &Node, p: &mut Problems) -> Read {
    short_name(name, p);
    let before = p.len();
    let body = body(name, node, p).filter(|_| p.len() == before);
    Read { name: name.clone(), body }
}

/// Notes a name that is too long to be written on its shape, or of no letter at all.
pub(super) fn short_name(name: &Spanned<String>, p: &mut Problems) {
    let length = name.value.chars().count();
    if length == 0 {
        let (key, expected) = ("shapes".to_owned(), "a name of at least one letter".to_owned());
        p.add(Fault::OutOfRange { key, expected, got: "\"\"".to_owned() }, &name.span);
    }
    if length > MAX_NAME {
        let fault =
            Fault::OverLimit { what: "a name".to_owned(), limit: MAX_NAME, unit: "characters", got: length };
        p.add(fault, &name.span);
    }
}

/// The keys of an angle at t = 0, in degrees and in radians.
pub(super) const ANGLES: [&str; 2] = ["angle_deg", "angle_rad"];

/// The key of cosine and sine at t = 0, instead of an angle.
pub(super) const MATRIX: &str = "rotation";

/// The keys of an angular velocity, in degrees and in radians.
pub(super) const SPINS: [&str; 2] = ["angular_velocity_deg", "angular_velocity_rad"];

fn body(name: &Spanned<String>, node: &Node, p: &mut Problems) -> Option<Body> {
    let Some(kind) =
        node.get("kind").and_then(as_text).and_then(|word| KINDS.iter().find(|k| k.name == word))
    else {
        without_kind(name, node, p);
        return None;
    };
    let place = with_article(kind.name);
    #[cfg(not(tracefig_page))]
    let ours = super::foreign::translated(kind, &place, node, p);
    #[cfg(tracefig_page)]
    let ours: Option<Node> = None;
    let table = check(ours.as_ref().unwrap_or(node), &name.value, &place, &shape_rows(kind), p)?;
    if !kind.turns {
        unturned(kind, &table, p);
    }
    only_one(&table, &[ANGLES[0], ANGLES[1], MATRIX], p);
    only_one(&table, &SPINS, p);
    let shape = shape(kind, &table, p)?;
    let shape = multiplied(shape, &table, p)?;
    Some(Body {
        shape,
        position: table.pair("position").unwrap_or(DVec2::ZERO),
        angle: angle(&table, ANGLES),
        velocity: table.pair("velocity").unwrap_or(DVec2::ZERO),
        spin: angle(&table, SPINS),
    })
}

/// Notes what turns a kind of shape that does not turn.
pub(super) fn unturned(kind: &Kind, table: &Checked<'_>, p: &mut Problems) {
    for key in ANGLES.into_iter().chain(SPINS) {
        if let Some(angle) = table.number(key).filter(|angle| angle.value != 0.0) {
            let got = number(angle.value);
            p.add(Fault::FixedAngle { kind: kind.name, key, expected: "0", got }, &angle.span);
        }
    }
    if let (Some(matrix), Some(node)) = (table.pair(MATRIX), table.get(MATRIX))
        && matrix != DVec2::X
    {
        let got = format!("[{}, {}]", number(matrix.x), number(matrix.y));
        let fault = Fault::FixedAngle { kind: kind.name, key: MATRIX, expected: "[1, 0]", got };
        p.add(fault, &node.span);
    }
}

/// The shape with the matrix that the file gives.
fn multiplied(shape: Shape, table: &Checked<'_>, p: &mut Problems) -> Option<Shape> {
    let (Some(DVec2 { x: cos, y: sin }), Some(node)) = (table.pair(MATRIX), table.get(MATRIX)) else {
        return Some(shape);
    };
    shape.multiplied(Rotation { cos, sin }).map_err(|error| p.add(Fault::Shape(error), &node.span)).ok()
}

/// The angle that is written in degrees or in radians.
fn angle(table: &Checked<'_>, keys: [&'static str; 2]) -> Angle {
    let [degrees, radians] = keys.map(|key| table.number(key));
    radians.map_or_else(
        || degrees.map_or(Angle::ZERO, |degrees| Angle::Degrees(degrees.value)),
        |radians| Angle::Radians(radians.value),
    )
}

/// Notes the keys, of those that say one thing in several ways, that are there beside the first of them.
fn only_one(table: &Checked<'_>, keys: &[&'static str], p: &mut Problems) {
    let mut written = keys.iter().filter_map(|key| table.get(key).map(|node| (key, node)));
    let Some((first, _)) = written.next() else { return };
    for (other, node) in written {
        let what = if SPINS.contains(first) { "how fast it turns" } else { "how it is turned" };
        let message = format!("`{first}` and `{other}` both say {what}: expected one of them, got both");
        let help = format!("leave out `{first}` or `{other}`");
        p.add(Fault::Conflict { message, help }, &node.span);
    }
}

/// Without a kind the other keys can't be judged; what the kind itself lacks is told.
fn without_kind(name: &Spanned<String>, node: &Node, p: &mut Problems) {
    let kind_row = &BODY.fields[..1];
    match node.entries().map(|entries| entries.iter().find(|(key, _)| key.value == "kind")) {
        Some(Some(entry)) => {
            let kind_only =
                Node { value: super::node::NodeValue::Table(vec![entry.clone()]), span: node.span.clone() };
            check(&kind_only, &name.value, BODY.place, kind_row, p);
        }
        Some(None) => {
            if let Some(key) = otherwise_named(node) {
                let (place, known) = (BODY.place.to_owned(), vec!["kind".to_owned()]);
                p.add(Fault::UnknownKey { key: key.value.clone(), place, known }, &key.span);
                return;
            }
            let place = format!("the shape `{}`", name.value);
            let fault =
                Fault::MissingKey { key: "kind".to_owned(), place, expected: kind_row[0].holds.expected() };
            p.add(fault, &node.span);
        }
        None => {
            check(node, &name.value, BODY.place, kind_row, p);
        }
    }
}

/// The key by which a shape without a kind says it, in the words of other tools.
fn otherwise_named(node: &Node) -> Option<&Spanned<String>> {
    let known = ["kind".to_owned()];
    let (key, _) = node.entries()?.iter().find(|(key, _)| is_meant(&key.value, &known))?;
    Some(key)
}

/// A kind as messages call it: "a circle", "an aabb".
pub(super) fn with_article(kind: &str) -> String {
    let article = if kind.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("{article} {kind}")
}

fn shape(kind: &Kind, table: &Checked<'_>, p: &mut Problems) -> Option<Shape> {
    let wanted = |name: &str| table.get(name).is_some();
    if !kind.fields.iter().all(|f| wanted(f.name) || !f.required) {
        return None;
    }
    let values: Vec<Option<FieldValue>> = kind
        .fields
        .iter()
        .map(|f| match f.holds {
            FieldType::Length => table.number(f.name).map(|n| FieldValue::Number(n.value)),
            FieldType::Count { .. } => table.count(f.name).map(|n| FieldValue::Count(n.value)),
            FieldType::Point | FieldType::Extents => table.pair(f.name).map(FieldValue::Point),
            FieldType::Points { .. } => table.points(f.name).map(FieldValue::Points),
            FieldType::Switch => table.switch(f.name).map(FieldValue::Switch),
        })
        .collect();
    match (kind.build)(&values) {
        Ok(shape) => Some(shape),
        Err(error) => {
            let span = element_span(table, error.field, error.element);
            p.add(Fault::Shape(error), &span);
            None
        }
    }
}

/// Where the vertex at fault stands, or the field, or the whole shape.
fn element_span(table: &Checked<'_>, field: &str, element: Option<usize>) -> Range<usize> {
    let Some(node) = table.get(field) else { return table.span.clone() };
    let item = element.and_then(|i| as_list(node)?.get(i));
    item.unwrap_or(node).span.clone()
}
