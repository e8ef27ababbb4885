//! What a figure shows, for the tests of its layers: the texts of its labels and the lengths of its lines.

mod centers;
mod frames;
mod handles;
mod insets;
mod inside;
mod marks;
mod moments;
mod motion;
mod numbers;
mod reading;
mod steps;
mod ties;
mod turned_box;
mod words;

use std::collections::BTreeMap;

use crate::drawing::{Contour, Group, Item, Path, Point, Segment};
use crate::figure::Figure;
use crate::figure::panel::PanelPlan;
use crate::figure::sketch::{Request, Sketched};

/// The labels of all panels by their keys: the markup, and the last number in it (NaN where there is none).
pub(super) fn labels(figure: &Figure) -> BTreeMap<&'static str, (String, f64)> {
    let placed = figure.panels.iter().flat_map(|panel| &panel.placed);
    let text = |line: &(_, std::sync::Arc<crate::typeset::Line>)| line.1.markup.clone();
    placed
        .map(|label| {
            let markup = label.lines.iter().map(text).collect::<Vec<_>>().join(" ");
            let number = last_number(&markup);
            (label.key, (markup, number))
        })
        .collect()
}

/// The labels that a panel's layers ask for, line by line: the layer, the key, the markup.
pub(super) fn labels_of(sketched: Sketched, panel: &PanelPlan) -> Vec<(&'static str, &'static str, String)> {
    let label = |request: Request| {
        let (layer, key) = (panel.layers[request.layer].layer.name, request.label.key);
        request.label.lines.into_iter().map(move |line| (layer, key, line))
    };
    sketched.requests.into_iter().flat_map(label).collect()
}

/// The last number of a markup, with its power of ten; NaN where there is none.
pub(super) fn last_number(markup: &str) -> f64 {
    let plain = markup.replace('−', "-").replace(r" \times 10^{", "e").replace("10^{", "1e");
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '-' | '.' | 'e');
    let words: Vec<&str> = plain.split(|c: char| !numeric(c)).collect();
    words.iter().filter_map(|word| word.parse().ok()).next_back().unwrap_or(f64::NAN)
}

/// The lengths of the straight lines of the parts of a name, in the order drawn, page pixels.
pub(super) fn lines(figure: &Figure, part: &str) -> Vec<f64> {
    let ends = |path: &Path| match &path.contour {
        Contour::Segments(segments) => match segments[..] {
            [Segment::Move(p), Segment::Line(q)] => Some((q - p).length()),
            _ => None,
        },
        Contour::Circle { .. } => None,
    };
    paths(&figure.drawing.items, part).into_iter().filter_map(ends).collect()
}

/// The points that a path goes through.
pub(super) fn points(path: &Path) -> Vec<Point> {
    let Contour::Segments(segments) = &path.contour else { panic!("straight") };
    let point = |s: &Segment| match *s {
        Segment::Move(p) | Segment::Line(p) => Some(p),
        _ => None,
    };
    segments.iter().filter_map(point).collect()
}

/// The paths of the groups of a name, in the order drawn.
pub(super) fn paths<'d>(items: &'d [Item], name: &str) -> Vec<&'d Path> {
    let mut found = Vec::new();
    for item in items {
        if let Item::Group(Group { name: own, items, .. }) = item {
            found.extend(paths(items, name));
            found.extend(items.iter().filter_map(|item| match item {
                Item::Path(path) if own == name => Some(path),
                _ => None,
            }));
        }
    }
    found
}

#[test]
fn numbers_are_read_out_of_labels() {
    let cases = [("depth $= 2.63$", 2.63), (r"$d = 1.5 \times 10^{-7}$", 1.5e-7), ("$x_2 = -3$", -3.0)];
    for (markup, number) in cases {
        assert_eq!(last_number(markup), number, "{markup}");
    }
    assert!(last_number("$n$").is_nan());
}

/// Scenes of two bodies that are apart, sharp and round and to all sides of each other, with one panel: where
/// B is, its radius, and the text.
pub(super) fn apart(panel: &str) -> Vec<(&'static str, f64, String)> {
    let places = [("[5, 1]", 0.0), ("[4, -3.5]", 0.25), ("[-3, 5]", 1.0), ("[0.5, 4.5]", 0.5)];
    let scene = |(place, radius): (&'static str, f64)| {
        let text = format!(
            "shapes.A = {{ kind = 'polygon', vertices = [[-2, -1], [1, -2], [2, 0], [-1, 2]] }}
            shapes.B = {{ kind = 'box', half_extents = [1, 0.5], radius = {radius}, angle_deg = 25,
                position = {place} }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}
            panels = [{panel}]"
        );
        (place, radius, text)
    };
    places.map(scene).to_vec()
}
