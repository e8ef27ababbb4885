//! SVG: a picture that a page can hold, a reader can hear and a style sheet can recolour.
//!
//! Every id and class begins with the drawing's id, so two figures can be inlined in one page. Colours are
//! presentation attributes; a style sheet inside `@media` overrides them with custom properties, and is all
//! that a renderer without CSS variables loses. Circles and arcs are arcs; the outline of a glyph is written
//! once and used where it stands; words without ink lie over them, to be found and copied. Nothing is loaded
//! from elsewhere and nothing runs.

mod contour;
pub(super) mod inline;
pub(super) mod read;
pub(super) mod steps;
mod style;
mod text;
mod tint;
mod words;

use std::collections::BTreeMap;

use super::xml::Xml;
use super::{Bracket, Depends, Format, InSteps, Options, OutputError, Reader, Writer, number};
use crate::drawing::{Clip, Color, Contour, Drawing, Group, Item, Paint, Path, Pattern, Role, Shown, Stroke};
use style::Property;
pub(crate) use words::found_words;

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "svg",
    about: "scalable picture with alternative text, its colours open to the page",
    media_type: "image/svg+xml",
    usual: true,
    in_the_dark: true,
    depends: Depends::Page,
    write: Writer::One(write),
    in_steps: Some(steps::write),
    in_motion: None,
    bind: None,
    // Editors write a declaration or a comment before it, and comments after it.
    bracket: Bracket { begins: &[b"<".as_slice()], ends: &[b"</svg>".as_slice(), b"/>", b"-->"] },
    read: Some(Reader { stamp: read::stamp, picture: Some(read::picture) }),
    live: None,
};

/// Bytes that a figure takes at least; saves growing the buffer step by step.
const TYPICAL_SIZE: usize = 32 * 1024;

/// Writes the drawing as a document.
fn write(drawing: &Drawing, _options: &Options) -> Result<Vec<u8>, OutputError> {
    text(drawing).map(String::into_bytes)
}

/// What the bytes of a file depend on besides its scene; for a program that writes nothing else, which need
/// not hold the whole row and what reads the files again.
pub(crate) fn key(theme: &str) -> String {
    super::page_key(FORMAT.name, theme)
}

/// The file of a drawing as text.
pub(crate) fn text(drawing: &Drawing) -> Result<String, OutputError> {
    text_with(drawing, &found_words(drawing, None))
}

/// The file of a drawing as text, with the words that are found in it.
pub(crate) fn text_with(drawing: &Drawing, words: &str) -> Result<String, OutputError> {
    super::validity::page(drawing)?;
    Ok(with_words(drawing, None, words))
}

/// Whether a document has its style sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sheet {
    /// The sheet stands inside, so that pages and dark systems can set colours.
    Inside,
    /// There is none: the colours are those of the attributes, for programs that know no style sheets.
    Absent,
}

/// The whole document as text, without words that are found.
pub(super) fn document(drawing: &Drawing, sheet: Sheet) -> String {
    written(drawing, sheet, None).xml.finish()
}

/// The whole document as text, whose words a reader finds and copies, with its steps marked where that is
/// asked for.
pub(super) fn searchable(drawing: &Drawing, in_steps: Option<InSteps>) -> String {
    with_words(drawing, in_steps, &found_words(drawing, in_steps))
}

/// The whole document as text, with the words that are found in it.
fn with_words(drawing: &Drawing, in_steps: Option<InSteps>, words: &str) -> String {
    let mut document = written(drawing, Sheet::Inside, in_steps);
    document.xml.element(words);
    document.xml.finish()
}

/// A document with all that is seen, its root still open.
fn written(drawing: &Drawing, sheet: Sheet, in_steps: Option<InSteps>) -> Document {
    let prefix = identifier(&drawing.id);
    let used = style::Used::by(drawing);
    let mut document = Document {
        xml: Xml::with_capacity(TYPICAL_SIZE),
        prefix,
        ids: BTreeMap::new(),
        clips: Vec::new(),
        fill_opacity: drawing.fill_opacity,
        words: drawing.words.clone(),
        in_steps,
        shown: Shown::ALWAYS,
    };
    document.open(drawing);
    if sheet == Sheet::Inside {
        document.style(&used, drawing.dark.as_ref());
    }
    document.glyphs(&used.glyphs);
    if !drawing.is_transparent() {
        document.xml.start("rect");
        document.xml.number("width", drawing.width);
        document.xml.number("height", drawing.height);
        document.paint(Some(&drawing.background), None);
        document.xml.end();
    }
    document.items(&drawing.items);
    document
}

/// Letters, digits, `-` and `_`, a letter first: what an id, a class and a selector may be without escapes.
fn identifier(text: &str) -> String {
    let allowed = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
    let mut id: String = text.chars().map(allowed).collect();
    if !id.starts_with(|c: char| c.is_ascii_alphabetic()) {
        id.insert_str(0, "fig-");
    }
    id
}

/// A document being written.
struct Document {
    /// The elements so far.
    xml: Xml,
    /// What every id and class begins with.
    prefix: String,
    /// What ids given so far are called behind the prefix, each with the last number that was given to it.
    ids: BTreeMap<String, u64>,
    /// Clips that have an element; a clip's index is the number in its id.
    clips: Vec<Clip>,
    /// Opacity of the fills of areas.
    fill_opacity: f64,
    /// The roles whose words have a colour of their own, with that colour.
    words: Vec<(Role, Color)>,
    /// How steps are marked; none where they are not.
    in_steps: Option<InSteps>,
    /// Which steps show what is written now.
    shown: Shown,
}

impl Document {
    /// The root element, the words of the drawing and its metadata.
    fn open(&mut self, drawing: &Drawing) {
        let (title, desc) = (self.new_id("title"), self.new_id("desc"));
        let xml = &mut self.xml;
        xml.start("svg");
        xml.attribute("xmlns", "http://www.w3.org/2000/svg");
        // Inkscape before 1.3 and other readers of SVG 1.1 do not know a plain `href`.
        xml.attribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
        xml.number("width", drawing.width);
        xml.number("height", drawing.height);
        xml.attribute_by("viewBox", |out| {
            out.push_str("0 0 ");
            number::push(out, drawing.width);
            out.push(' ');
            number::push(out, drawing.height);
        });
        // What most elements have; each says it otherwise where it differs.
        xml.attribute("fill", "none");
        xml.attribute("stroke-linejoin", "round");
        if let Some(lang) = &drawing.lang {
            xml.attribute("xml:lang", lang);
        }
        xml.attribute("role", "img");
        xml.attribute("aria-labelledby", &format!("{title} {desc}"));
        let [of_title, of_desc] = drawing.languages_of_words();
        let words = [("title", title, &drawing.title, of_title), ("desc", desc, &drawing.desc, of_desc)];
        for (name, id, text, lang) in words {
            xml.start(name);
            xml.attribute("id", &id);
            if let Some(lang) = lang {
                xml.attribute("xml:lang", lang);
            }
            xml.text(text);
            xml.end();
        }
        if !drawing.metadata.is_empty() {
            xml.start("metadata");
            xml.text(&drawing.metadata);
            xml.end();
        }
    }

    /// An id that no other element has: the prefix, the name, and a number where the name was given before.
    fn new_id(&mut self, name: &str) -> String {
        let mut name = identifier(name);
        if let Some(&last) = self.ids.get(&name) {
            // All numbers up to the last one given are taken.
            let (mut own, mut count) = ([&name, "-"].concat(), last);
            let stem = own.len();
            loop {
                count += 1;
                own.truncate(stem);
                number::push_integer(&mut own, count);
                if !self.ids.contains_key(&own) {
                    break;
                }
            }
            if let Some(last) = self.ids.get_mut(&name) {
                *last = count;
            }
            name = own;
        }
        let id = [&self.prefix, "-", &name].concat();
        self.ids.insert(name, 1);
        id
    }

    fn items(&mut self, items: &[Item]) {
        match self.in_steps {
            Some(in_steps) => self.stepwise(items, in_steps),
            None => self.all(items),
        }
    }

    /// Writes items one after the other.
    fn all(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.group(group),
                Item::Path(path) => self.path(path),
                Item::Text(text) => self.text(text),
            }
        }
    }

    /// A group and what is in it; nothing for an empty one.
    fn group(&mut self, group: &Group) {
        if group.items.is_empty() {
            return;
        }
        let clip = group.clip.map(|clip| self.clip(clip));
        let id = self.new_id(&group.name);
        self.xml.start("g");
        self.xml.attribute("id", &id);
        if let Some(role) = group.role {
            self.xml.attribute("data-role", role.name());
        }
        if let Some(label) = &group.label {
            self.xml.attribute("role", "group");
            self.xml.attribute("aria-label", label);
        }
        if group.opacity < 1.0 {
            self.xml.number("opacity", group.opacity);
        }
        if let Some(clip) = clip {
            self.xml.attribute("clip-path", &format!("url(#{clip})"));
        }
        let first = painted_alike(&group.items);
        if let Some(first) = first.filter(|_| self.in_steps.is_none() || steps::is_of_one(&group.items)) {
            self.paint(first.fill.as_ref(), first.stroke.as_ref());
            for item in &group.items {
                if let Item::Path(path) = item {
                    self.shape(&path.contour);
                    self.xml.end();
                }
            }
        } else {
            self.items(&group.items);
        }
        self.xml.end();
    }

    /// The id of a clip, written here where it is new.
    fn clip(&mut self, clip: Clip) -> String {
        let known = self.clips.iter().position(|&known| known == clip);
        let number = known.unwrap_or(self.clips.len());
        let id = format!("{}-clip.{number}", self.prefix);
        if known.is_none() {
            self.clips.push(clip);
            let Clip { rect, radius } = clip;
            self.xml.start("clipPath");
            self.xml.attribute("id", &id);
            self.xml.start("rect");
            self.xml.number("x", rect.x0);
            self.xml.number("y", rect.y0);
            self.xml.number("width", rect.width());
            self.xml.number("height", rect.height());
            if radius > 0.0 {
                self.xml.number("rx", radius);
            }
            self.xml.end();
            self.xml.end();
        }
        id
    }

    /// A path in the order fill, pattern, stroke.
    fn path(&mut self, path: &Path) {
        let Some(pattern) = &path.pattern else {
            self.contour(&path.contour, path.fill.as_ref(), path.stroke.as_ref());
            return;
        };
        if path.fill.is_some() {
            self.contour(&path.contour, path.fill.as_ref(), None);
        }
        self.pattern(&path.contour, pattern);
        if path.stroke.is_some() {
            self.contour(&path.contour, None, path.stroke.as_ref());
        }
    }

    /// The marks as lines, cut by the contour: an SVG pattern would be a raster in some renderers.
    fn pattern(&mut self, contour: &Contour, pattern: &Pattern) {
        let Some(bounds) = contour.bounds() else { return };
        let id = self.new_id("marks");
        self.xml.start("clipPath");
        self.xml.attribute("id", &id);
        self.shape(contour);
        self.xml.end();
        self.xml.end();
        let (lines, stroke) = pattern.marks(bounds);
        self.xml.start("path");
        self.xml.attribute_by("d", |out| {
            for &(from, to) in &lines {
                contour::segments(
                    out,
                    &[crate::drawing::Segment::Move(from), crate::drawing::Segment::Line(to)],
                );
            }
        });
        self.paint(None, Some(&stroke));
        self.xml.attribute("clip-path", &format!("url(#{id})"));
        self.xml.end();
    }

    /// One element that is filled, stroked or both.
    fn contour(&mut self, contour: &Contour, fill: Option<&Paint>, stroke: Option<&Stroke>) {
        self.shape(contour);
        self.paint(fill, stroke);
        self.xml.end();
    }

    /// Starts the element of a contour.
    fn shape(&mut self, contour: &Contour) {
        match contour {
            Contour::Circle { center, radius } => {
                self.xml.start("circle");
                self.xml.number("cx", center.x);
                self.xml.number("cy", center.y);
                self.xml.number("r", *radius);
            }
            Contour::Segments(segments) => {
                self.xml.start("path");
                self.xml.attribute_by("d", |out| contour::segments(out, segments));
            }
        }
    }

    /// The attributes of fill and stroke, and the classes by which the style sheet finds them.
    fn paint(&mut self, fill: Option<&Paint>, stroke: Option<&Stroke>) {
        let of_fill = fill.map_or(Property::Fill, |paint| Property::of_fill(paint, self.fill_opacity));
        let roles = [
            (of_fill, fill.and_then(|paint| paint.role)),
            (Property::Stroke, stroke.and_then(|stroke| stroke.paint.role)),
        ];
        style::class_attribute(&mut self.xml, &self.prefix, &roles);
        if let Some(paint) = fill {
            style::paint(&mut self.xml, Property::Fill, paint);
        }
        if let Some(stroke) = stroke {
            style::stroke(&mut self.xml, stroke);
        }
    }
}

/// The first of several paths that are all painted alike, so that their group can say how.
fn painted_alike(items: &[Item]) -> Option<&Path> {
    let [Item::Path(first), rest @ ..] = items else { return None };
    let alike = |item: &Item| match item {
        Item::Path(path) => path.pattern.is_none() && path.fill == first.fill && path.stroke == first.stroke,
        _ => false,
    };
    (!rest.is_empty() && items.iter().all(alike)).then_some(first)
}
