//! An SVG of ours, read again as the drawing that it shows, so that two of them are compared by what is seen.
//!
//! Only what our own writer writes is understood: groups, paths, circles, rectangles, uses of outlines, clips. A file with
//! anything else, as one that was edited by hand, is none that this reads, and is then compared as text.

mod path_data;
mod style;

use std::collections::BTreeMap;

use roxmltree::{Document, Node};

use crate::drawing::{
    Contour, Drawing, Group, Item, Path, Pattern, PatternKind, Point, Rect, Segment, Stroke,
};
use path_data::{Map, contour};
use style::{Style, attribute, number};

/// A file of ours: what it shows, and the style sheet, which no picture of ours follows.
pub(super) struct Picture {
    pub(super) drawing: Drawing,
    pub(super) sheet: String,
}

/// What an SVG of ours shows; `None` where it is none, or was changed into something that we do not write.
pub(super) fn read(bytes: &[u8]) -> Option<Picture> {
    let document = Document::parse(std::str::from_utf8(bytes).ok()?).ok()?;
    let root = document.root_element();
    let prefix = root.attribute("aria-labelledby")?.split_once("-title")?.0.to_owned();
    let text = |name: &str| {
        let node = root.children().find(|n| n.has_tag_name(name));
        node.and_then(|n| n.text()).unwrap_or_default().to_owned()
    };
    let page = root.children().find(|n| n.has_tag_name("rect"))?;
    let mut reader = Reader {
        by_id: document.descendants().filter_map(|n| Some((n.attribute("id")?, n))).collect(),
        prefix: &prefix,
        uses: 0,
    };
    let mut items = Vec::new();
    for node in root.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "title" | "desc" | "metadata" | "style" | "defs" => {}
            "rect" if node == page => {}
            _ => reader.element(node, &Style::default(), Map::default(), &mut items)?,
        }
    }
    let drawing = Drawing {
        width: number(root, "width")?,
        height: number(root, "height")?,
        title: text("title"),
        desc: text("desc"),
        background: Style::default().inside(page)?.fill?,
        fill_opacity: 1.0,
        dark: None,
        metadata: String::new(),
        hash: String::new(),
        items,
        id: prefix.clone(),
    };
    Some(Picture { drawing, sheet: text("style") })
}

/// Largest difference of a colour in the style sheets of two files, in levels; `None` where anything else that is read or
/// followed, title, description or rule, is another one.
pub(super) fn sheets_apart(old: &[u8], new: &[u8]) -> Option<u8> {
    let (old, new) = (read(old)?, read(new)?);
    let words = |p: &Picture| [p.drawing.title.clone(), p.drawing.desc.clone()];
    let (mut old_parts, mut new_parts) = (old.sheet.split('#'), new.sheet.split('#'));
    if words(&old) != words(&new) || old_parts.next() != new_parts.next() {
        return None;
    }
    let mut worst = 0;
    loop {
        let (a, b) = match (old_parts.next(), new_parts.next()) {
            (None, None) => return Some(worst),
            (a, b) => (a?, b?),
        };
        if a.get(6..)? != b.get(6..)? {
            return None;
        }
        for channel in [0..2, 2..4, 4..6] {
            let level = |text: &str| u8::from_str_radix(text.get(channel.clone())?, 16).ok();
            worst = worst.max(level(a)?.abs_diff(level(b)?));
        }
    }
}

/// References that are followed, at most: more are no figure.
const MOST_USES: usize = 100_000;

/// A document being read.
struct Reader<'d> {
    by_id: BTreeMap<&'d str, Node<'d, 'd>>,
    /// Begins every id.
    prefix: &'d str,
    /// References followed so far.
    uses: usize,
}

impl<'d> Reader<'d> {
    /// Adds what an element draws; `None` where it is none of ours.
    fn element(&mut self, node: Node<'d, 'd>, style: &Style, map: Map, items: &mut Vec<Item>) -> Option<()> {
        let style = style.inside(node)?;
        match node.tag_name().name() {
            "g" => self.group(node, &style, map, items),
            "use" => self.reference(node, &style, map, items),
            // Read where it is referred to.
            "clipPath" => Some(()),
            "path" | "circle" | "rect" => {
                let shape = shape(node, map)?;
                let path = match attribute(node, "clip-path") {
                    Some(url) => self.pattern(url, &shape, &style, map)?,
                    None => Path {
                        contour: shape,
                        fill: style.fill,
                        pattern: None,
                        stroke: style.stroke(map.scale),
                    },
                };
                items.push(Item::Path(path));
                Some(())
            }
            _ => None,
        }
    }

    fn group(&mut self, node: Node<'d, 'd>, style: &Style, map: Map, items: &mut Vec<Item>) -> Option<()> {
        let map = match attribute(node, "transform") {
            Some(text) => map.then(Map::read(text)?),
            None => map,
        };
        // A line of text is a group with an id when it has a halo; it is no part of the picture by itself.
        let name = attribute(node, "id").and_then(|id| id.strip_prefix(self.prefix)?.strip_prefix('-'));
        let Some(name) = name.filter(|n| *n != "t" && !n.starts_with("t-")) else {
            return self.children(node, style, map, items);
        };
        let mut group = Group::new(name);
        group.label = attribute(node, "aria-label").map(str::to_owned);
        group.opacity = if node.has_attribute("opacity") { number(node, "opacity")? } else { 1.0 };
        if let Some(url) = attribute(node, "clip-path") {
            let rect = self.referred(url)?.first_element_child().filter(|n| n.has_tag_name("rect"))?;
            let side = |name| number(rect, name);
            let (x0, y0) = (side("x")?, side("y")?);
            group.clip = Some(Rect { x0, y0, x1: x0 + side("width")?, y1: y0 + side("height")? });
        }
        self.children(node, style, map, &mut group.items)?;
        items.push(Item::Group(group));
        Some(())
    }

    fn children(&mut self, node: Node<'d, 'd>, style: &Style, map: Map, items: &mut Vec<Item>) -> Option<()> {
        node.children().filter(Node::is_element).try_for_each(|n| self.element(n, style, map, items))
    }

    /// The outline of a glyph, or the text of a halo again.
    fn reference(
        &mut self,
        node: Node<'d, 'd>,
        style: &Style,
        map: Map,
        items: &mut Vec<Item>,
    ) -> Option<()> {
        self.uses += 1;
        let target =
            *self.by_id.get(node.attribute(("http://www.w3.org/1999/xlink", "href"))?.strip_prefix('#')?)?;
        if self.uses > MOST_USES || node.ancestors().any(|n| n == target) {
            return None;
        }
        let offset = |name| if node.has_attribute(name) { number(node, name) } else { Some(0.0) };
        let map = map.then(Map { x: offset("x")?, y: offset("y")?, scale: 1.0 });
        self.element(target, style, map, items)
    }

    fn referred(&self, url: &str) -> Option<Node<'d, 'd>> {
        let id = url.strip_prefix("url(#")?.strip_suffix(')')?;
        self.by_id.get(id).copied().filter(|n| n.has_tag_name("clipPath"))
    }

    /// Marks over an area, where they are the ones of a pattern of ours.
    fn pattern(&self, url: &str, marks: &Contour, style: &Style, map: Map) -> Option<Path> {
        let contour = shape(self.referred(url)?.first_element_child()?, map)?;
        let stroke = style.stroke(map.scale)?;
        let kind = if stroke.dash.is_empty() { PatternKind::Hatch } else { PatternKind::Dots };
        let pattern = Pattern { kind, paint: stroke.paint };
        let (lines, expected) = pattern.marks(contour.bounds()?);
        let ours: Vec<Segment> =
            lines.iter().flat_map(|&(p, q)| [Segment::Move(p), Segment::Line(q)]).collect();
        (same_line(&expected, &stroke) && same_points(&ours, marks)).then_some(Path {
            contour,
            fill: None,
            pattern: Some(pattern),
            stroke: None,
        })
    }
}

/// Numbers in a file are rounded to hundredths, and the marks are those of a contour that was rounded: two of these.
const ROUNDED: f64 = 0.03;

fn same_line(a: &Stroke, b: &Stroke) -> bool {
    let close = |x: f64, y: f64| (x - y).abs() <= ROUNDED;
    close(a.width, b.width) && a.cap == b.cap && a.dash.len() == b.dash.len()
}

fn same_points(ours: &[Segment], marks: &Contour) -> bool {
    let Contour::Segments(marks) = marks else { return false };
    let close = |p: Point, q: Point| (p.x - q.x).abs() <= ROUNDED && (p.y - q.y).abs() <= ROUNDED;
    let same = |(a, b): (&Segment, &Segment)| match (*a, *b) {
        (Segment::Move(p), Segment::Move(q)) | (Segment::Line(p), Segment::Line(q)) => close(p, q),
        _ => false,
    };
    ours.len() == marks.len() && ours.iter().zip(marks).all(same)
}

/// The contour of a path, circle or rectangle on the page.
fn shape(node: Node, map: Map) -> Option<Contour> {
    match node.tag_name().name() {
        "path" => contour(attribute(node, "d")?, map),
        "circle" => {
            let center = map.point(number(node, "cx")?, number(node, "cy")?);
            Some(Contour::Circle { center, radius: number(node, "r")? * map.scale })
        }
        "rect" => {
            let (x, y) = (number(node, "x")?, number(node, "y")?);
            let (w, h) = (number(node, "width")?, number(node, "height")?);
            let corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)];
            Some(Contour::polygon(&corners.map(|(x, y)| map.point(x, y))))
        }
        _ => None,
    }
}
