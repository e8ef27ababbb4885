//! Pixels, straight from the display list.
//!
//! A contour becomes straight pieces ([`polyline`]), a line's width an outline ([`stroke`]), an outline the coverage of pixels
//! ([`coverage`]), and this the image ([`blend`]). A clip or the area under a pattern's marks is a coverage too; two of
//! them meet by their product. Everything is additions, products, quotients and square roots of doubles, with `libm` for
//! angles, so the pixels are the same on every machine.

mod blend;
mod coverage;
mod polyline;
mod stroke;

use super::{Options, OutputError, check};
use crate::drawing::{
    Contour, Drawing, Group, Item, Paint, Path, Pattern, Point, Rect, Segment, Stroke, Text,
};
use crate::typeset::{OutlineSegment, UNITS_PER_EM};
use blend::{Fineness, Ink};
use coverage::{Rasterizer, Span};
use polyline::Polylines;

/// An opaque image, 4 bytes a pixel: red, green, blue, 255; rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The bytes.
    pub rgba: Vec<u8>,
}

/// Draws at `scale` image pixels for a page pixel.
///
/// # Errors
///
/// [`OutputError`] for a page without pixels, too many of them, or places that are not finite.
///
/// ```
/// use tracefig::drawing::{Color, Drawing, Paint, Role};
/// let background = Paint::role(Role::Background, Color::hex(0xFF8000));
/// let drawing = Drawing {
///     width: 3.0, height: 2.0, id: "x".into(), title: String::new(), desc: String::new(), background,
///     fill_opacity: 0.14, dark: None, metadata: String::new(), hash: String::new(), items: vec![],
/// };
/// let pixels = tracefig::output::rasterize(&drawing, 2.0).unwrap();
/// assert_eq!((pixels.width, pixels.height), (6, 4));
/// assert_eq!(pixels.rgba[..4], [255, 128, 0, 255]);
/// ```
pub fn rasterize(drawing: &Drawing, scale: f64) -> Result<Pixels, OutputError> {
    let options = Options { scale, ..Options::default() };
    let (width, height) = check::image_size(drawing, &options)?;
    let crate::drawing::Color { r, g, b } = drawing.background.color;
    let count = width as usize * height as usize;
    let pixels = vec![[r, g, b, 255]; count];
    let rasterizer = Rasterizer::new(width, height);
    let mut canvas = Canvas { pixels, width: width as usize, scale, clip: None, rasterizer };
    canvas.items(&drawing.items);
    Ok(Pixels { width, height, rgba: canvas.pixels.into_flattened() })
}

/// A clip in force.
struct Clip {
    rect: Rect,
    coverage: Vec<Span>,
}

/// An image being drawn.
struct Canvas {
    pixels: Vec<[u8; 4]>,
    width: usize,
    scale: f64,
    clip: Option<Clip>,
    rasterizer: Rasterizer,
}

impl Canvas {
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
        let outer = self.clip.as_ref().map(|clip| clip.rect);
        let Some(rect) = group.clip else { return self.see_through(group) };
        let Some(rect) = outer.map_or(Some(rect), |o| o.intersection(rect)) else { return };
        let coverage = self.coverage(&rectangle(rect), None);
        let kept = self.clip.replace(Clip { rect, coverage });
        self.see_through(group);
        self.clip = kept;
    }

    /// Draws a group's items. Where the group has an opacity they are drawn solid and then mixed with what was there, which
    /// is what laying a separate image of the group over it comes to.
    fn see_through(&mut self, group: &Group) {
        if group.opacity >= 1.0 {
            return self.items(&group.items);
        }
        let Some((columns, rows)) = group.extent().and_then(|extent| self.place(extent)) else { return };
        let row = |y: usize| y * self.width + columns.start..y * self.width + columns.end;
        let before: Vec<[u8; 4]> = rows.clone().flat_map(|y| &self.pixels[row(y)]).copied().collect();
        let ranges: Vec<_> = rows.map(row).collect();
        self.items(&group.items);
        for (range, before) in ranges.into_iter().zip(before.chunks_exact(columns.len())) {
            blend::fade(&mut self.pixels[range], before, group.opacity);
        }
    }

    /// Columns and rows of the image that hold `extent`; `None` where nothing of it is in the image.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "cut to the image before")]
    #[expect(clippy::cast_precision_loss, reason = "an image is narrower than 2^26")]
    fn place(&self, extent: Rect) -> Option<(std::ops::Range<usize>, std::ops::Range<usize>)> {
        let (w, h) = (self.width as f64, (self.pixels.len() / self.width) as f64);
        let range = |low: f64, high: f64, most: f64| {
            // One pixel more on each side, for edges that only touch it.
            let low = ((low * self.scale).floor() - 1.0).clamp(0.0, most) as usize;
            low..((high * self.scale).ceil() + 1.0).clamp(0.0, most) as usize
        };
        let (columns, rows) = (range(extent.x0, extent.x1, w), range(extent.y0, extent.y1, h));
        (!columns.is_empty() && !rows.is_empty()).then_some((columns, rows))
    }

    fn path(&mut self, path: &Path) {
        let Some(extent) = path.extent() else { return };
        let lines = self.lines(&path.contour);
        if let Some(paint) = &path.fill {
            self.fill(&lines, paint, extent);
        }
        if let Some(pattern) = &path.pattern {
            self.pattern(&path.contour, &lines, pattern);
        }
        if let Some(stroke) = &path.stroke {
            let outline = self.outline(&lines, stroke);
            self.fill(&outline, &stroke.paint, extent);
        }
    }

    fn lines(&self, contour: &Contour) -> Polylines {
        let scale = self.scale;
        Polylines::of(contour, |p| Point::new(p.x * scale, p.y * scale))
    }

    /// The outline of a line along `lines`, dashed where the stroke is.
    fn outline(&self, lines: &Polylines, stroke: &Stroke) -> Polylines {
        let width = stroke.width * self.scale;
        let dash: Vec<f64> = stroke.dash.iter().map(|length| length * self.scale).collect();
        let dashed = if dash.is_empty() { None } else { stroke::dashes(lines, &dash) };
        stroke::outline(dashed.as_ref().unwrap_or(lines), width, stroke.cap)
    }

    /// Fills an area that lies within `extent`, given in page pixels.
    fn fill(&mut self, lines: &Polylines, paint: &Paint, extent: Rect) {
        self.rasterizer.add(lines);
        let spans = self.rasterizer.finish();
        let ink = Ink::of(paint, Fineness::at(self.scale));
        match &self.clip {
            Some(Clip { rect, coverage }) if rect.intersection(extent) != Some(extent) => {
                let inside = coverage::intersection(spans, coverage);
                blend::lay(&mut self.pixels, self.width, &inside, ink);
            }
            _ => blend::lay(&mut self.pixels, self.width, spans, ink),
        }
    }

    /// The coverage of an area, in an area of which that is known.
    fn coverage(&mut self, contour: &Contour, within: Option<&[Span]>) -> Vec<Span> {
        let lines = self.lines(contour);
        self.rasterizer.add(&lines);
        let spans = self.rasterizer.finish();
        within.map_or_else(|| spans.to_vec(), |within| coverage::intersection(spans, within))
    }

    /// The marks as lines, cut by the contour.
    fn pattern(&mut self, area: &Contour, lines: &Polylines, pattern: &Pattern) {
        let Some(bounds) = area.bounds() else { return };
        self.rasterizer.add(lines);
        let mut inside = self.rasterizer.finish().to_vec();
        if let Some(clip) = &self.clip {
            inside = coverage::intersection(&inside, &clip.coverage);
        }
        let (marks, stroke) = pattern.marks(bounds);
        let segments = marks.into_iter().flat_map(|(from, to)| [Segment::Move(from), Segment::Line(to)]);
        let lines = self.lines(&Contour::Segments(segments.collect()));
        let outline = self.outline(&lines, &stroke);
        self.rasterizer.add(&outline);
        let visible = coverage::intersection(self.rasterizer.finish(), &inside);
        blend::lay(&mut self.pixels, self.width, &visible, Ink::of(&stroke.paint, Fineness::at(self.scale)));
    }

    fn text(&mut self, text: &Text) {
        let lines = self.glyphs(text);
        let extent = text.extent();
        if let Some(halo) = &text.halo {
            let around = stroke::outline(&lines, 2.0 * halo.width * self.scale, crate::drawing::Cap::Butt);
            // Glyph and surrounding at once: they are one area.
            self.rasterizer.add(&lines);
            self.fill(&around, &halo.paint, extent);
        }
        self.fill(&lines, &text.paint, extent);
    }

    /// All glyphs and rules of a text: one area instead of one a letter.
    fn glyphs(&self, text: &Text) -> Polylines {
        let mut lines = Polylines::default();
        for placed in &text.line.glyphs {
            let em = placed.size / UNITS_PER_EM * self.scale;
            let x = (text.origin.x + placed.x) * self.scale;
            let y = (text.origin.y + placed.y) * self.scale;
            let map = |p: Point| Point::new(x + p.x * em, y + p.y * em);
            for segment in &placed.glyph.outline().segments {
                lines.segment(&piece(segment), map);
            }
        }
        for rule in &text.line.rules {
            let (x0, y0) = (text.origin.x + rule.x, text.origin.y + rule.y);
            let rect = rectangle(Rect { x0, y0, x1: x0 + rule.width, y1: y0 + rule.height });
            let scale = self.scale;
            super::curves::pieces(&rect, |segment| {
                lines.segment(&segment, |p| Point::new(p.x * scale, p.y * scale));
            });
        }
        lines.end(true);
        lines
    }
}

fn rectangle(rect: Rect) -> Contour {
    let Rect { x0, y0, x1, y1 } = rect;
    Contour::polygon(&[Point::new(x0, y0), Point::new(x1, y0), Point::new(x1, y1), Point::new(x0, y1)])
}

fn piece(segment: &OutlineSegment) -> Segment {
    let point = |p: [f32; 2]| Point::new(f64::from(p[0]), f64::from(p[1]));
    match *segment {
        OutlineSegment::Move(p) => Segment::Move(point(p)),
        OutlineSegment::Line(p) => Segment::Line(point(p)),
        OutlineSegment::Quad(c, p) => Segment::Quad(point(c), point(p)),
        OutlineSegment::Cubic(c, d, p) => Segment::Cubic(point(c), point(d), point(p)),
        OutlineSegment::Close => Segment::Close,
    }
}
