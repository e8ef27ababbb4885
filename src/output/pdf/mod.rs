//! PDF: one page of vector graphics, for papers and slides.
//!
//! A page pixel is ¾ of a point, as in CSS. The page's coordinates are turned over once, so that everything below is
//! in page pixels, y down. Text is outlines: each glyph that occurs is a form that its places refer to. Opacities are graphics
//! states, clips and patterns are clipping paths. There is no date and no random number in the file.
//! Source: *ISO 32000-1:2008, Document management – Portable document format 1.7*, section 8.

mod flate;
mod object;

use std::collections::BTreeSet;

use super::number::{push, push_factor};
use super::{Depends, Format, Options, OutputError, Writer, validity, curves};
use crate::drawing::{
    Cap, Contour, Drawing, Group, Halo, Item, Paint, Path, Point, Rect, Segment, Stroke, Text,
};
use crate::typeset::{Glyph, OutlineSegment, Rule, UNITS_PER_EM};
use object::{Objects, Packing};

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "pdf",
    about: "one vector page, text as outlines",
    usual: false,
    depends: Depends::Page,
    write: Writer::One(write),
    read: None,
};

/// Points a page pixel.
const POINTS: f64 = 0.75;

fn write(drawing: &Drawing, _options: &Options) -> Result<Vec<u8>, OutputError> {
    document(drawing, Packing::Deflated)
}

fn document(drawing: &Drawing, packing: Packing) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    let mut page = Page::default();
    page.number(POINTS);
    page.content.push_str("0 0 ");
    page.number(-POINTS);
    page.content.push_str("0 ");
    page.number(drawing.height * POINTS);
    page.content.push_str("cm 1 j\n");
    page.color(&drawing.background, Use::Fill);
    page.rect(Rect { x0: 0.0, y0: 0.0, x1: drawing.width, y1: drawing.height });
    page.content.push_str("f\n");
    page.items(&drawing.items);
    Ok(page.file(drawing, packing))
}

/// Whether a colour is for areas or for lines.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Fill,
    Stroke,
}

/// The page's content, and what it refers to.
#[derive(Default)]
struct Page {
    content: String,
    /// Opacities in thousandths, each a graphics state.
    opacities: BTreeSet<u16>,
    /// Glyphs, each a form.
    glyphs: BTreeSet<Glyph>,
    /// Groups with an opacity, each a form: what it draws.
    groups: Vec<String>,
}

impl Page {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.group(group),
                Item::Path(path) => self.path(path),
                Item::Text(text) => self.text(text),
            }
        }
    }

    fn group(&mut self, group: &Group) {
        self.content.push_str("q\n");
        if let Some(clip) = group.clip {
            self.rect(clip);
            self.content.push_str("W n\n");
        }
        if group.opacity < 1.0 {
            let outside = std::mem::take(&mut self.content);
            self.items(&group.items);
            let inside = std::mem::replace(&mut self.content, outside);
            self.groups.push(inside);
            let number = self.groups.len() - 1;
            self.opacity(group.opacity, "");
            say(&mut self.content, format_args!("/X{number} Do\n"));
        } else {
            self.items(&group.items);
        }
        self.content.push_str("Q\n");
    }

    fn path(&mut self, path: &Path) {
        if let Some(fill) = &path.fill {
            self.content.push_str("q\n");
            self.color(fill, Use::Fill);
            self.contour(&path.contour);
            self.content.push_str("f\nQ\n");
        }
        if let Some(pattern) = &path.pattern
            && let Some(bounds) = path.contour.bounds()
        {
            self.content.push_str("q\n");
            self.contour(&path.contour);
            self.content.push_str("W n\n");
            let (marks, stroke) = pattern.marks(bounds);
            self.stroke_style(&stroke);
            for (from, to) in marks {
                self.contour(&Contour::line(from, to));
            }
            self.content.push_str("S\nQ\n");
        }
        if let Some(stroke) = &path.stroke {
            self.content.push_str("q\n");
            self.stroke_style(stroke);
            self.contour(&path.contour);
            self.content.push_str("S\nQ\n");
        }
    }

    fn stroke_style(&mut self, stroke: &Stroke) {
        self.color(&stroke.paint, Use::Stroke);
        self.number(stroke.width);
        self.content.push_str("w\n");
        if stroke.cap == Cap::Round {
            self.content.push_str("1 J\n");
        }
        if !stroke.dash.is_empty() {
            self.content.push('[');
            stroke.dash.iter().for_each(|&length| self.number(length));
            self.content.push_str("] 0 d\n");
        }
    }

    fn text(&mut self, text: &Text) {
        if let Some(halo) = &text.halo {
            self.halo(text, halo);
        }
        self.content.push_str("q\n");
        self.color(&text.paint, Use::Fill);
        for placed in &text.line.glyphs {
            if placed.glyph.outline().segments.is_empty() {
                continue;
            }
            self.glyphs.insert(placed.glyph);
            self.content.push_str("q ");
            let factor = placed.size / UNITS_PER_EM;
            push_factor(&mut self.content, factor);
            self.content.push_str(" 0 0 ");
            push_factor(&mut self.content, factor);
            self.content.push(' ');
            self.number(text.origin.x + placed.x);
            self.number(text.origin.y + placed.y);
            say(&mut self.content, format_args!("cm /{} Do Q\n", glyph_name(placed.glyph)));
        }
        for rule in &text.line.rules {
            self.rect(place(rule, text.origin));
            self.content.push_str("f\n");
        }
        self.content.push_str("Q\n");
    }

    /// The outlines of all glyphs, stroked wide: a form can't be stroked, so they are written out.
    fn halo(&mut self, text: &Text, halo: &Halo) {
        self.content.push_str("q\n");
        self.color(&halo.paint, Use::Fill);
        self.color(&halo.paint, Use::Stroke);
        self.number(2.0 * halo.width);
        self.content.push_str("w\n");
        for placed in &text.line.glyphs {
            let em = placed.size / UNITS_PER_EM;
            let (x, y) = (text.origin.x + placed.x, text.origin.y + placed.y);
            outline(&mut self.content, placed.glyph, |p| Point::new(x + p.x * em, y + p.y * em));
        }
        for rule in &text.line.rules {
            self.rect(place(rule, text.origin));
        }
        self.content.push_str("B\nQ\n");
    }

    fn color(&mut self, paint: &Paint, use_: Use) {
        for channel in [paint.color.r, paint.color.g, paint.color.b] {
            push_factor(&mut self.content, f64::from(channel) / 255.0);
            self.content.push(' ');
        }
        let (operator, key) = if use_ == Use::Fill { ("rg\n", "f") } else { ("RG\n", "s") };
        self.content.push_str(operator);
        if paint.opacity < 1.0 {
            self.opacity(paint.opacity, key);
        }
    }

    /// Sets an opacity: of fills `f`, of strokes `s`, or, without a key, of all.
    fn opacity(&mut self, opacity: f64, key: &str) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 1000")]
        let thousandths = (opacity.clamp(0.0, 1.0) * 1000.0).round() as u16;
        self.opacities.insert(thousandths);
        say(&mut self.content, format_args!("/G{thousandths}{key} gs\n"));
    }

    fn contour(&mut self, contour: &Contour) {
        let content = &mut self.content;
        let mut at = Point::default();
        curves::pieces(contour, |segment| {
            let segment = match segment {
                Segment::Quad(c, p) => cubic(at, c, p),
                other => other,
            };
            at = curves::end(&segment).unwrap_or(at);
            segment_to(content, &segment);
        });
    }

    fn rect(&mut self, rect: Rect) {
        for value in [rect.x0, rect.y0, rect.width(), rect.height()] {
            self.number(value);
        }
        self.content.push_str("re\n");
    }

    fn number(&mut self, value: f64) {
        push(&mut self.content, value);
        self.content.push(' ');
    }

    /// The whole file: page, content, and the forms and states that it refers to.
    fn file(self, drawing: &Drawing, packing: Packing) -> Vec<u8> {
        let mut objects = Objects::new(packing);
        let catalog = objects.reserve();
        let (pages, page, resources) = (objects.reserve(), objects.reserve(), objects.reserve());
        let mut size = String::from("[0 0 ");
        push(&mut size, drawing.width * POINTS);
        size.push(' ');
        push(&mut size, drawing.height * POINTS);
        size.push(']');
        let mut forms = String::new();
        for &glyph in &self.glyphs {
            let mut body = String::new();
            outline(&mut body, glyph, |p| p);
            body.push_str("f\n");
            let [x0, y0, x1, y1] = glyph.outline().bounds;
            let form = objects.form(&format!("[{x0} {y0} {x1} {y1}]"), "", &body);
            say(&mut forms, format_args!("/{} {form} 0 R ", glyph_name(glyph)));
        }
        let everywhere = format!("[0 0 {} {}]", drawing.width.ceil(), drawing.height.ceil());
        let group = format!("/Group <</S /Transparency /I true>> /Resources {resources} 0 R ");
        for (number, body) in self.groups.iter().enumerate() {
            let form = objects.form(&everywhere, &group, body);
            say(&mut forms, format_args!("/X{number} {form} 0 R "));
        }
        let mut states = String::new();
        for thousandths in &self.opacities {
            let mut value = String::new();
            push_factor(&mut value, f64::from(*thousandths) / 1000.0);
            say(
                &mut states,
                format_args!(
                    "/G{thousandths} <</ca {value} /CA {value}>> /G{thousandths}f <</ca {value}>> /G{thousandths}s <</CA {value}>> "
                ),
            );
        }
        let content = objects.stream("", &self.content);
        objects.set(catalog, &format!("<</Type /Catalog /Pages {pages} 0 R /Lang (en)>>"));
        objects.set(pages, &format!("<</Type /Pages /Kids [{page} 0 R] /Count 1>>"));
        objects.set(
            page,
            &format!("<</Type /Page /Parent {pages} 0 R /MediaBox {size} /Resources {resources} 0 R /Contents {content} 0 R>>"),
        );
        objects.set(resources, &format!("<</XObject <<{forms}>> /ExtGState <<{states}>>>>"));
        let info = objects.info(&drawing.title, &drawing.desc);
        objects.finish(catalog, info)
    }
}

fn say(out: &mut String, what: std::fmt::Arguments) {
    // Writing to a string can't fail.
    let _ = std::fmt::Write::write_fmt(out, what);
}

fn place(rule: &Rule, origin: Point) -> Rect {
    let (x0, y0) = (origin.x + rule.x, origin.y + rule.y);
    Rect { x0, y0, x1: x0 + rule.width, y1: y0 + rule.height }
}

fn glyph_name(glyph: Glyph) -> String {
    format!("{:?}{}", glyph.face, glyph.id)
}

/// Appends the outline of a glyph, its points mapped.
fn outline(out: &mut String, glyph: Glyph, map: impl Fn(Point) -> Point) {
    let point = |p: [f32; 2]| map(Point::new(f64::from(p[0]), f64::from(p[1])));
    let mut at = Point::default();
    for segment in &glyph.outline().segments {
        let segment = match *segment {
            OutlineSegment::Move(p) => Segment::Move(point(p)),
            OutlineSegment::Line(p) => Segment::Line(point(p)),
            OutlineSegment::Cubic(c, d, p) => Segment::Cubic(point(c), point(d), point(p)),
            OutlineSegment::Quad(c, p) => cubic(at, point(c), point(p)),
            OutlineSegment::Close => Segment::Close,
        };
        at = curves::end(&segment).unwrap_or(at);
        segment_to(out, &segment);
    }
}

/// The cubic curve that a quadratic one is: PDF has no other.
fn cubic(from: Point, c: Point, to: Point) -> Segment {
    let toward = |p: Point| Point::new(p.x + 2.0 / 3.0 * (c.x - p.x), p.y + 2.0 / 3.0 * (c.y - p.y));
    Segment::Cubic(toward(from), toward(to), to)
}

fn segment_to(out: &mut String, segment: &Segment) {
    let (points, operator): (&[Point], _) = match segment {
        Segment::Move(p) => (&[*p], "m\n"),
        Segment::Line(p) => (&[*p], "l\n"),
        Segment::Cubic(c, d, p) => (&[*c, *d, *p], "c\n"),
        Segment::Close => (&[], "h\n"),
        // Both have become cubic curves.
        Segment::Quad(..) | Segment::Arc { .. } => return,
    };
    for p in points {
        push(out, p.x);
        out.push(' ');
        push(out, p.y);
        out.push(' ');
    }
    out.push_str(operator);
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn states_are_kept_and_brought_back_in_pairs_and_every_name_is_known() {
        let file = document(&everything(), Packing::Plain).unwrap();
        let file: String = file.into_iter().map(|b| if b.is_ascii() { char::from(b) } else { '?' }).collect();
        let lines = || file.lines().flat_map(str::split_whitespace);
        assert_eq!(lines().filter(|w| *w == "q").count(), lines().filter(|w| *w == "Q").count());
        let mut words = lines().collect::<Vec<_>>();
        words.dedup();
        for pair in words.windows(2) {
            if pair[1] == "Do" {
                assert!(
                    file.contains(&format!("{} ", pair[0])) && file.contains("/XObject <<"),
                    "{}",
                    pair[0]
                );
                let defined = words
                    .windows(4)
                    .any(|w| w[0].trim_start_matches("<<") == pair[0] && w[3].starts_with('R'));
                assert!(defined, "{} has no object", pair[0]);
            }
        }
        assert!(file.starts_with("%PDF-1.7") && file.ends_with("%%EOF\n"));
        let packed = write(&everything(), &Options::default()).unwrap();
        assert!(packed.len() < file.len() / 2, "{} of {}", packed.len(), file.len());
    }
}
