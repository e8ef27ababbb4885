//! An SVG of ours, read again: what it says of itself, and the drawing that it shows, so that two are
//! compared by what is seen.
//!
//! Only what the writer beside this folder writes is understood: groups, paths, circles, rectangles, uses of
//! outlines, clips, and words without ink. A file with anything else, as one that was edited by hand, is none
//! that this reads.

mod around;
mod effort;
mod path_data;
mod size;
mod style;
mod words;

use std::collections::BTreeMap;

use roxmltree::{Document, NS_XML_URI, Node};
use svgtypes::FuncIRI;

use super::super::Stamped;
use super::super::picture::{Picture, TooMuch, Unread};
use crate::drawing::{
    Clip, Color, Contour, Drawing, Group, Item, Paint, Path, Pattern, PatternKind, Point, Rect, Segment,
    Shown, Stroke,
};
use effort::{Effort, MOST_LENGTH, MOST_PIECES};
use path_data::{Map, contour};
use size::{MOST_DRAWN, MOST_LEVELS, modest};
use style::{Style, number};

/// The background of a page that has none.
const NO_PAGE: Paint = Paint { role: None, color: Color::hex(0), opacity: 0.0 };

/// What a document says of itself: the text of its `<metadata>`.
pub(in crate::output) fn stamp(bytes: &[u8]) -> Option<Stamped> {
    let document = parsed(bytes).ok()?;
    let metadata = document.root_element().children().find(|n| n.has_tag_name("metadata"))?;
    Some(Stamped::Metadata(metadata.text()?.to_owned()))
}

/// The elements of a document that is no larger than ours are.
fn parsed(bytes: &[u8]) -> Result<Document<'_>, Unread> {
    let text = std::str::from_utf8(bytes).map_err(|_| Unread::Other)?;
    modest(text)?;
    Document::parse(text).map_err(|_| Unread::Other)
}

/// The first document inside another text, as in a page of HTML.
pub(in crate::output) fn inside(bytes: &[u8]) -> Option<&[u8]> {
    const END: &str = "</svg>";
    let text = std::str::from_utf8(bytes).ok()?;
    let start = text.find("<svg ")?;
    let end = start + text[start..].find(END)? + END.len();
    Some(&bytes[start..end])
}

/// What a document shows.
pub(super) fn picture(bytes: &[u8]) -> Result<Picture<'_>, Unread> {
    let document = parsed(bytes)?;
    let mut too_much = None;
    read(&document, &mut too_much).ok_or_else(|| too_much.map_or(Unread::Other, Unread::TooMuch))
}

/// What a document shows; `None` where it is none of ours, was changed into something that we do not write,
/// or has too much of something, which is then told.
fn read(document: &Document<'_>, too_much: &mut Option<TooMuch>) -> Option<Picture<'static>> {
    let root = document.root_element();
    if !around::is_ours(root) {
        return None;
    }
    let prefix = root.attribute("aria-labelledby")?.split_once("-title")?.0.to_owned();
    let text = |name: &str| {
        let node = root.children().find(|n| n.has_tag_name(name));
        node.and_then(|n| n.text()).unwrap_or_default().to_owned()
    };
    let page = root.children().find(|n| n.has_tag_name("rect"));
    let mut reader = Reader {
        by_id: document.descendants().filter_map(|n| Some((n.attribute("id")?, n))).collect(),
        prefix: &prefix,
        levels: 0,
        drawn: 0,
        effort: Effort::default(),
        page: Rect { x0: 0.0, y0: 0.0, x1: number(root, "width")?, y1: number(root, "height")? },
        too_much,
    };
    let (mut items, mut found) = (Vec::new(), None);
    for node in root.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "g" if words::are_in(node) && found.is_none() => found = Some(words::said(node)?),
            "title" | "desc" | "metadata" | "style" | "defs" => {}
            "rect" if Some(node) == page => {}
            _ => reader.element(node, &Style::default(), Map::default(), &mut items)?,
        }
    }
    let drawing = Drawing {
        width: number(root, "width")?,
        height: number(root, "height")?,
        lang: root.attribute((NS_XML_URI, "lang")).map(str::to_owned),
        title: text("title"),
        is_titled: false,
        heading: None,
        desc: text("desc"),
        background: match page {
            Some(page) => Style::default().inside(page)?.fill?,
            None => NO_PAGE,
        },
        ink: Color::hex(0),
        words: Vec::new(),
        fill_opacity: 1.0,
        dark: None,
        metadata: String::new(),
        hash: String::new(),
        items,
        steps: Vec::new(),
        motion: Vec::new(),
        narrow: None,
        id: prefix.clone(),
    };
    let found = found.unwrap_or_default();
    Some(Picture::Drawing {
        drawing: Box::new(drawing),
        sheet: text("style"),
        found,
        told: around::told(root),
    })
}

/// The largest difference of a colour between two style sheets, in levels of 255; `None` where they differ in
/// anything besides colours.
pub(crate) fn sheets_apart(old: &str, new: &str) -> Option<u8> {
    let (mut old_parts, mut new_parts) = (old.split('#'), new.split('#'));
    if old_parts.next() != new_parts.next() {
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

/// A document being read.
struct Reader<'d> {
    /// Elements by their ids.
    by_id: BTreeMap<&'d str, Node<'d, 'd>>,
    /// Begins every id.
    prefix: &'d str,
    /// Elements that are being read, in one another.
    levels: usize,
    /// Elements read so far, each time that they are referred to.
    drawn: usize,
    /// What it costs to draw what was read so far.
    effort: Effort,
    /// The page.
    page: Rect,
    /// The limit that was passed, if one was.
    too_much: &'d mut Option<TooMuch>,
}

impl<'d> Reader<'d> {
    /// Refuses what has too much of something.
    fn refuse_if(&mut self, is_more: bool, what: &'static str, most: usize) -> Option<()> {
        if is_more {
            self.too_much.get_or_insert(TooMuch { what, most });
            return None;
        }
        Some(())
    }

    /// Adds a path, unless that makes too much to draw.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a limit, some millions")]
    #[expect(clippy::cast_precision_loss, reason = "a limit, some millions")]
    fn path(&mut self, path: Path, items: &mut Vec<Item>) -> Option<()> {
        self.effort.add(&path, self.page);
        let Effort { pieces, length } = self.effort;
        self.refuse_if(pieces > MOST_PIECES as f64, "pieces of lines", MOST_PIECES)?;
        self.refuse_if(length > MOST_LENGTH, "page pixels of lines", MOST_LENGTH as usize)?;
        items.push(Item::Path(path));
        Some(())
    }

    /// Adds what an element draws; `None` where it is none of ours.
    fn element(&mut self, node: Node<'d, 'd>, style: &Style, map: Map, items: &mut Vec<Item>) -> Option<()> {
        (self.levels, self.drawn) = (self.levels + 1, self.drawn + 1);
        self.refuse_if(self.levels > MOST_LEVELS, "elements in one another", MOST_LEVELS)?;
        self.refuse_if(self.drawn > MOST_DRAWN, "elements that are drawn", MOST_DRAWN)?;
        self.known(node, style, map, items)?;
        self.levels -= 1;
        Some(())
    }

    /// Adds what an element draws that is counted.
    fn known(&mut self, node: Node<'d, 'd>, style: &Style, map: Map, items: &mut Vec<Item>) -> Option<()> {
        let style = style.inside(node)?;
        match node.tag_name().name() {
            "g" => self.group(node, &style, map, items),
            "use" => self.reference(node, &style, map, items),
            // Read where it is referred to.
            "clipPath" => Some(()),
            "path" | "circle" | "rect" => {
                let shape = shape(node, map)?;
                let path = match node.attribute("clip-path") {
                    Some(url) => self.pattern(url, &shape, &style, map)?,
                    None => Path {
                        contour: shape,
                        fill: style.fill,
                        pattern: None,
                        stroke: style.stroke(map.scale),
                        shown: Shown::ALWAYS,
                    },
                };
                self.path(path, items)
            }
            _ => None,
        }
    }

    /// Adds a group under its name, or what is in it where it is part of a text.
    fn group(&mut self, node: Node<'d, 'd>, style: &Style, map: Map, items: &mut Vec<Item>) -> Option<()> {
        let map = match node.attribute("transform") {
            Some(text) => map.then(Map::read(text)?),
            None => map,
        };
        // A line of text is a group with an id when it has a halo; it is no part of the picture by itself.
        let name = node.attribute("id").and_then(|id| id.strip_prefix(self.prefix)?.strip_prefix('-'));
        let Some(name) = name.filter(|n| *n != "t" && !n.starts_with("t-")) else {
            return self.children(node, style, map, items);
        };
        let mut group = Group::new(name);
        group.label = node.attribute("aria-label").map(str::to_owned);
        group.opacity = if node.has_attribute("opacity") { number(node, "opacity")? } else { 1.0 };
        if let Some(url) = node.attribute("clip-path") {
            let rect = self.referred(url)?.first_element_child().filter(|n| n.has_tag_name("rect"))?;
            let side = |name| number(rect, name);
            let (x0, y0) = (side("x")?, side("y")?);
            let all = Rect { x0, y0, x1: x0 + side("width")?, y1: y0 + side("height")? };
            let radius = if rect.has_attribute("rx") { side("rx")? } else { 0.0 };
            group.clip = Some(Clip::rounded(all, radius));
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
        let target =
            *self.by_id.get(node.attribute(("http://www.w3.org/1999/xlink", "href"))?.strip_prefix('#')?)?;
        if node.ancestors().any(|n| n == target) {
            return None;
        }
        let offset = |name| if node.has_attribute(name) { number(node, name) } else { Some(0.0) };
        let map = map.then(Map { x: offset("x")?, y: offset("y")?, scale: 1.0 });
        self.element(target, style, map, items)
    }

    /// The clip that `url(#…)` refers to.
    fn referred(&self, url: &str) -> Option<Node<'d, 'd>> {
        let FuncIRI(id) = FuncIRI::from_str(url).ok()?;
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
            shown: Shown::ALWAYS,
        })
    }
}

/// How far marks may lie from where this reader would lay them, in page pixels: numbers in a file are rounded
/// to hundredths, the marks follow a contour that was rounded before, and both ends of a mark add up.
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
        "path" => contour(node.attribute("d")?, map),
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
