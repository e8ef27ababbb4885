//! A slide and its notes: the title, the picture, and what is said of it.
//!
//! The picture is an SVG, for programs that draw one, over a PNG, for those that do not ([MS-ODRAWXML],
//! `svgBlip`).
//! A slide with the whole figure has its title above its upper edge, where those who listen to slides and who
//! list them find it, as the picture has a headline of its own.
//! Source: ECMA-376-1:2016, *Office Open XML File Formats*, sections 19.3 and 20.1.

use super::super::xml::Xml;
use super::parts::{DECLARATION, Relation};
use crate::drawing::Drawing;

/// Width and height of a slide, in units of which an inch has 914,400: 13⅓ by 7½ inches.
pub(super) const SIZE: [u32; 2] = [12_192_000, 6_858_000];
/// Where the title of a step ends, so far from the upper edge; the picture is below.
const BELOW_TITLE: f64 = 1_000_000.0;
/// Free space below the picture of a step, and at its ends.
const MARGIN: f64 = 190_500.0;
/// The place of a title that is not seen, and its size: above the slide.
const UNSEEN: [[f64; 2]; 2] = [[457_200.0, -762_000.0], [11_277_600.0, 571_500.0]];

/// What says that a picture has an SVG, by the number of that extension.
const HAS_SVG: &str = "{96DAC541-7B7A-43D3-8B79-37D633B846F1}";

/// The namespaces of a part, by their usual letters.
const NAMESPACES: [(&str, &str); 3] = [
    ("xmlns:a", "http://schemas.openxmlformats.org/drawingml/2006/main"),
    ("xmlns:r", "http://schemas.openxmlformats.org/officeDocument/2006/relationships"),
    ("xmlns:p", "http://schemas.openxmlformats.org/presentationml/2006/main"),
];

/// Whether the title of a slide is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Title {
    /// It stands above the picture.
    Seen,
    /// It is for those who list slides or listen to them.
    Unseen,
}

/// A slide.
pub(super) struct Slide<'d> {
    /// The picture.
    pub(super) drawing: Drawing,
    /// What it is called.
    pub(super) title: String,
    /// Whether the title is seen.
    pub(super) shown: Title,
    /// What the picture shows, in words.
    pub(super) alt: String,
    /// What is to be said, a paragraph each.
    pub(super) notes: Vec<&'d str>,
}

/// An element with attributes, left open.
fn open(xml: &mut Xml, name: &'static str, attributes: &[(&str, &str)]) {
    xml.start(name);
    for (name, value) in attributes {
        xml.attribute(name, value);
    }
}

/// An element with attributes and nothing in it.
fn empty(xml: &mut Xml, name: &'static str, attributes: &[(&str, &str)]) {
    open(xml, name, attributes);
    xml.end();
}

/// Opens elements, each within the one before.
fn open_all(xml: &mut Xml, names: &[&'static str]) {
    for name in names {
        xml.start(name);
    }
}

/// Closes elements.
fn close(xml: &mut Xml, count: usize) {
    (0..count).for_each(|_| xml.end());
}

/// A length or a place, whole.
fn whole(value: f64) -> String {
    format!("{:.0}", value.round() + 0.0)
}

impl Slide<'_> {
    /// The language of its words.
    fn lang(&self) -> &str {
        self.drawing.lang.as_deref().unwrap_or(Drawing::OWN_LANG)
    }

    /// The slide as a part; its pictures are named by these relations, the one of dots first.
    pub(super) fn part(&self, [png, svg]: [&Relation; 2]) -> String {
        let mut xml = Xml::default();
        begin(&mut xml, "p:sld");
        if !self.drawing.is_transparent() {
            open_all(&mut xml, &["p:bg", "p:bgPr", "a:solidFill"]);
            empty(&mut xml, "a:srgbClr", &[("val", &hex(self.drawing.background.color))]);
            xml.end();
            empty(&mut xml, "a:effectLst", &[]);
            close(&mut xml, 2);
        }
        begin_tree(&mut xml);
        self.title(&mut xml);
        self.picture(&mut xml, [&png.id, &svg.id]);
        finish(xml)
    }

    /// The notes as a part.
    pub(super) fn notes_part(&self) -> String {
        let mut xml = Xml::default();
        begin(&mut xml, "p:notes");
        begin_tree(&mut xml);
        let locks = [("noGrp", "1"), ("noRot", "1"), ("noChangeAspect", "1")];
        placeholder(&mut xml, ("2", "Slide"), &locks, &[("type", "sldImg")]);
        empty(&mut xml, "p:spPr", &[]);
        xml.end();
        placeholder(&mut xml, ("3", "Notes"), &locks[..1], &[("type", "body"), ("idx", "1")]);
        empty(&mut xml, "p:spPr", &[]);
        paragraphs(&mut xml, &self.notes, self.lang(), None);
        xml.end();
        finish(xml)
    }

    /// The title, in the placeholder of titles.
    fn title(&self, xml: &mut Xml) {
        placeholder(xml, ("2", "Title"), &[("noGrp", "1")], &[("type", "title")]);
        xml.start("p:spPr");
        if self.shown == Title::Unseen {
            frame(xml, UNSEEN);
        }
        xml.end();
        paragraphs(xml, &[&self.title], self.lang(), Some(&hex(self.drawing.ink)));
        xml.end();
    }

    /// The picture: of dots, and for programs that draw it the SVG.
    fn picture(&self, xml: &mut Xml, [png, svg]: [&str; 2]) {
        open_all(xml, &["p:pic", "p:nvPicPr"]);
        let (name, descr) = (&self.drawing.title, &self.alt);
        empty(xml, "p:cNvPr", &[("id", "3"), ("name", name), ("descr", descr)]);
        xml.start("p:cNvPicPr");
        empty(xml, "a:picLocks", &[("noChangeAspect", "1")]);
        xml.end();
        empty(xml, "p:nvPr", &[]);
        xml.end();
        xml.start("p:blipFill");
        open(xml, "a:blip", &[("r:embed", png)]);
        xml.start("a:extLst");
        open(xml, "a:ext", &[("uri", HAS_SVG)]);
        let space = "http://schemas.microsoft.com/office/drawing/2016/SVG/main";
        empty(xml, "asvg:svgBlip", &[("xmlns:asvg", space), ("r:embed", svg)]);
        close(xml, 3);
        xml.start("a:stretch");
        empty(xml, "a:fillRect", &[]);
        close(xml, 2);
        xml.start("p:spPr");
        frame(xml, self.place());
        open(xml, "a:prstGeom", &[("prst", "rect")]);
        empty(xml, "a:avLst", &[]);
        close(xml, 3);
    }

    /// The place and the size of the picture: as large as fits, in the middle.
    fn place(&self) -> [[f64; 2]; 2] {
        let [width, height] = SIZE.map(f64::from);
        let [[x, y], [w, h]] = match self.shown {
            Title::Unseen => [[0.0; 2], [width, height]],
            Title::Seen => [[MARGIN, BELOW_TITLE], [width - 2.0 * MARGIN, height - BELOW_TITLE - MARGIN]],
        };
        let scale = (w / self.drawing.width).min(h / self.drawing.height);
        let size = [self.drawing.width * scale, self.drawing.height * scale];
        [[x + 0.5 * (w - size[0]), y + 0.5 * (h - size[1])], size]
    }
}

/// A colour, as these files write it.
pub(super) fn hex(color: crate::drawing::Color) -> String {
    color.to_string().trim_start_matches('#').to_owned()
}

/// Opens the root of a part.
pub(super) fn root(xml: &mut Xml, name: &'static str) {
    open(xml, name, &NAMESPACES);
}

/// Opens the root of a part that is seen, and what is on it.
fn begin(xml: &mut Xml, name: &'static str) {
    root(xml, name);
    xml.start("p:cSld");
}

/// Opens the list of what is on a slide.
fn begin_tree(xml: &mut Xml) {
    open_all(xml, &["p:spTree", "p:nvGrpSpPr"]);
    empty(xml, "p:cNvPr", &[("id", "1"), ("name", "")]);
    empty(xml, "p:cNvGrpSpPr", &[]);
    empty(xml, "p:nvPr", &[]);
    xml.end();
    empty(xml, "p:grpSpPr", &[]);
}

/// Closes the list, and gives the part.
fn finish(mut xml: Xml) -> String {
    close(&mut xml, 2);
    xml.start("p:clrMapOvr");
    empty(&mut xml, "a:masterClrMapping", &[]);
    format!("{DECLARATION}{}", xml.finish())
}

/// Opens a shape that takes a place of the layout.
fn placeholder(xml: &mut Xml, (id, name): (&str, &str), locks: &[(&str, &str)], of: &[(&str, &str)]) {
    open_all(xml, &["p:sp", "p:nvSpPr"]);
    empty(xml, "p:cNvPr", &[("id", id), ("name", name)]);
    xml.start("p:cNvSpPr");
    empty(xml, "a:spLocks", locks);
    xml.end();
    xml.start("p:nvPr");
    empty(xml, "p:ph", of);
    close(xml, 2);
}

/// Where something stands, and how large it is.
fn frame(xml: &mut Xml, [[x, y], [width, height]]: [[f64; 2]; 2]) {
    xml.start("a:xfrm");
    empty(xml, "a:off", &[("x", &whole(x)), ("y", &whole(y))]);
    empty(xml, "a:ext", &[("cx", &whole(width)), ("cy", &whole(height))]);
    xml.end();
}

/// The text of a shape, a paragraph each, in a colour where it has one of its own.
fn paragraphs(xml: &mut Xml, texts: &[&str], lang: &str, color: Option<&str>) {
    xml.start("p:txBody");
    empty(xml, "a:bodyPr", &[]);
    empty(xml, "a:lstStyle", &[]);
    for text in texts {
        open_all(xml, &["a:p", "a:r"]);
        open(xml, "a:rPr", &[("lang", lang)]);
        if let Some(color) = color {
            xml.start("a:solidFill");
            empty(xml, "a:srgbClr", &[("val", color)]);
            xml.end();
        }
        xml.end();
        xml.start("a:t");
        xml.text(text);
        close(xml, 3);
    }
    if texts.is_empty() {
        empty(xml, "a:p", &[]);
    }
    xml.end();
}
