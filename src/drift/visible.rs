//! What moved that a reader sees, in words: two drawings, element by element.
//!
//! Elements are the innermost named groups, and are found again by their names. The same change of several
//! elements is one line: another theme is a line for each colour, not for each stroke.

use std::collections::BTreeMap;

use super::moved::limited;
use super::text;
use crate::drawing::{Color, Contour, Drawing, Group, Item, Paint, Path, Point, Segment};

/// Lines that are said at most; the rest is counted. They stand below those of [`moved`](super::moved).
const MAX_LINES: usize = 12;

/// Names of elements that a line has at most; the rest is counted. Six fill a line of a terminal.
const MAX_NAMES: usize = 6;

/// How far a point may lie from where it was and still count as unmoved, in page pixels: numbers in a file
/// are rounded to hundredths, by 0.005 each, in a point of two additions. At half, rounding is told as a
/// move; at twice, a move that shows in two pixels is not.
const ROUNDED: f64 = 0.015;

/// Differences of what two drawings show: `body-B: moved by (12, 0) px`.
pub(super) fn seen(old: &Drawing, new: &Drawing) -> Vec<String> {
    let mut changes = Changes::default();
    let size = |d: &Drawing| format!("{} × {} px", d.width, d.height);
    if size(old) != size(new) {
        changes.add(format!("{} → {}", size(old), size(new)), "page");
    }
    match (old.is_transparent(), new.is_transparent()) {
        (false, false) => changes.color("", &old.background, &new.background, "page"),
        (true, false) => changes.add("a background, where there was none".to_owned(), "page"),
        (false, true) => changes.add("no background any more".to_owned(), "page"),
        (true, true) => {}
    }
    let (mut before, mut after) = (Vec::new(), Vec::new());
    elements(&old.items, "", &mut before);
    elements(&new.items, "", &mut after);
    let (names_before, names_after) = (by_name(&before), by_name(&after));
    for element in &after {
        match names_before.get(element.name.as_str()) {
            None => changes.add("new".to_owned(), &element.name),
            Some(known) => compare(known, element, &mut changes),
        }
    }
    for element in before.iter().filter(|e| !names_after.contains_key(e.name.as_str())) {
        changes.add("gone".to_owned(), &element.name);
    }
    let mut lines = Vec::new();
    let lang = |drawing: &Drawing| drawing.lang.clone().unwrap_or_default();
    lines.extend(words("language", &lang(old), &lang(new)));
    lines.extend(words("title", &old.title, &new.title));
    lines.extend(changes.lines());
    lines.extend(words("description", &old.desc, &new.desc));
    limited(lines, MAX_LINES)
}

/// A named group with what stands in it and in no inner one.
struct Element<'d> {
    /// The group's name, and the panel that it is in.
    name: String,
    /// Accessible name.
    label: Option<&'d str>,
    /// Opacity of the group as a whole.
    opacity: f64,
    /// What is drawn in it, in painting order.
    paths: Vec<&'d Path>,
}

/// Elements by their names.
fn by_name<'e, 'd>(all: &'e [Element<'d>]) -> BTreeMap<&'e str, &'e Element<'d>> {
    // Of two with one name, as a file by hand may have, the first.
    all.iter().rev().map(|e| (e.name.as_str(), e)).collect()
}

fn elements<'d>(items: &'d [Item], within: &str, found: &mut Vec<Element<'d>>) {
    for item in items {
        let Item::Group(group) = item else { continue };
        let is_panel = group.name.starts_with("panel-");
        let name = if within.is_empty() { group.name.clone() } else { format!("{} in {within}", group.name) };
        let paths =
            group.items.iter().filter_map(|i| if let Item::Path(path) = i { Some(path) } else { None });
        let paths: Vec<&Path> = paths.collect();
        let Group { label, opacity, .. } = group;
        if !paths.is_empty() || label.is_some() {
            found.push(Element { name, label: label.as_deref(), opacity: *opacity, paths });
        }
        elements(&group.items, if is_panel { &group.name } else { within }, found);
    }
}

fn compare(old: &Element, new: &Element, changes: &mut Changes) {
    let name = new.name.as_str();
    if let Some(line) = words("", old.label.unwrap_or_default(), new.label.unwrap_or_default()) {
        changes.add(line, name);
    }
    if old.opacity != new.opacity {
        changes.add(format!("opacity {} → {}", old.opacity, new.opacity), name);
    }
    for (a, b) in old.paths.iter().zip(&new.paths) {
        paints(a, b, name, changes);
    }
    if let Some(what) = places(&old.paths, &new.paths) {
        changes.add(what, name);
    }
}

fn paints(old: &Path, new: &Path, name: &str, changes: &mut Changes) {
    let of = |path: &Path| {
        let stroke = path.stroke.as_ref();
        let pattern = path.pattern.as_ref().map(|p| p.paint);
        [("fill", path.fill), ("line", stroke.map(|s| s.paint)), ("pattern", pattern)]
    };
    for ((what, a), (_, b)) in of(old).into_iter().zip(of(new)) {
        match (a, b) {
            (Some(a), Some(b)) => changes.color(what, &a, &b, name),
            (None, None) => {}
            (a, _) => changes.add(format!("{what} {}", if a.is_some() { "gone" } else { "new" }), name),
        }
    }
    if let (Some(a), Some(b)) = (&old.stroke, &new.stroke) {
        if a.width != b.width {
            changes.add(format!("line of {} → {} px", decimals(a.width), decimals(b.width)), name);
        }
        if a.dash != b.dash || a.cap != b.cap {
            changes.add("other dashes".to_owned(), name);
        }
    }
}

/// How the points of an element's paths moved.
fn places(old: &[&Path], new: &[&Path]) -> Option<String> {
    let of = |paths: &[&Path]| {
        let mut kinds = String::new();
        let points: Vec<Point> = paths.iter().flat_map(|path| points(&path.contour, &mut kinds)).collect();
        (kinds, points)
    };
    let ((old_kinds, old), (new_kinds, new)) = (of(old), of(new));
    if old_kinds != new_kinds {
        return Some("other lines or letters".to_owned());
    }
    let delta = |(a, b): (&Point, &Point)| Point::new(b.x - a.x, b.y - a.y);
    let deltas: Vec<Point> = old.iter().zip(&new).map(delta).collect();
    let length = |d: &Point| libm::hypot(d.x, d.y);
    let moved: Vec<&Point> = deltas.iter().filter(|d| length(d) > ROUNDED).collect();
    let first = moved.first()?;
    let alike = |d: &Point| (d.x - first.x).abs() <= 2.0 * ROUNDED && (d.y - first.y).abs() <= 2.0 * ROUNDED;
    if moved.len() == deltas.len() && deltas.iter().all(alike) {
        return Some(format!("moved by ({}, {}) px", decimals(first.x), decimals(first.y)));
    }
    let most = deltas.iter().map(length).fold(0.0, f64::max);
    let points = if deltas.len() == 1 { "point" } else { "points" };
    Some(format!("{} of {} {points} moved, by {} px at most", moved.len(), deltas.len(), decimals(most)))
}

/// The points that say where a contour is; its pieces' kinds go to `kinds`.
fn points(contour: &Contour, kinds: &mut String) -> Vec<Point> {
    let mut all = Vec::new();
    match contour {
        Contour::Circle { center, radius } => {
            kinds.push('o');
            all.extend([*center, Point::new(center.x + radius, center.y)]);
        }
        Contour::Segments(segments) => {
            for segment in segments {
                let (kind, points) = match *segment {
                    Segment::Move(p) => ('m', vec![p]),
                    Segment::Line(p) => ('l', vec![p]),
                    Segment::Quad(c, p) => ('q', vec![c, p]),
                    Segment::Cubic(c, d, p) => ('c', vec![c, d, p]),
                    Segment::Arc { center, radius, start, sweep } => {
                        let at = |angle| {
                            Point::new(
                                center.x + radius * libm::cos(angle),
                                center.y + radius * libm::sin(angle),
                            )
                        };
                        ('a', vec![at(start), at(start + 0.5 * sweep), at(start + sweep)])
                    }
                    Segment::Close => ('z', vec![]),
                };
                kinds.push(kind);
                all.extend(points);
            }
        }
    }
    all
}

/// What is different, each with the elements in which it is.
#[derive(Default)]
struct Changes {
    /// A change in words, and the names of the elements that it happened to.
    all: Vec<(String, Vec<String>)>,
    /// Where in `all` a change stands.
    places: BTreeMap<String, usize>,
}

impl Changes {
    fn add(&mut self, what: String, name: &str) {
        let next = self.all.len();
        let at = *self.places.entry(what.clone()).or_insert(next);
        if at == next {
            self.all.push((what, Vec::new()));
        }
        let names = &mut self.all[at].1;
        if names.last().is_none_or(|last| last != name) {
            names.push(name.to_owned());
        }
    }

    fn color(&mut self, what: &str, old: &Paint, new: &Paint, name: &str) {
        let role = |p: &Paint| p.role.map_or("a tint", |role| role.name());
        if old.role != new.role {
            self.add(format!("colour of {} → of {}", role(old), role(new)), name);
        } else if old.color != new.color {
            self.add(format!("colour of {} {} → {}", role(new), hex(old.color), hex(new.color)), name);
        }
        if old.opacity != new.opacity {
            self.add(format!("{what} opacity {} → {}", old.opacity, new.opacity), name);
        }
    }

    fn lines(self) -> impl Iterator<Item = String> {
        self.all.into_iter().map(|(what, names)| {
            let more = names.len().saturating_sub(MAX_NAMES);
            let shown = names.iter().take(MAX_NAMES).cloned().collect::<Vec<_>>().join(", ");
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            format!("{shown}{more}: {what}")
        })
    }
}

/// What became of a text, in words; `None` where it stayed.
pub(super) fn words(what: &str, old: &str, new: &str) -> Option<String> {
    let drift = text::drift(old, new)?;
    let before = if what.is_empty() { String::new() } else { format!("{what}: ") };
    Some(format!("{before}reads `{}`, was `{}`", drift.actual, drift.expected))
}

fn hex(Color { r, g, b }: Color) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A number to hundredths, as the file has it.
fn decimals(v: f64) -> f64 {
    (100.0 * v).round() / 100.0 + 0.0
}
