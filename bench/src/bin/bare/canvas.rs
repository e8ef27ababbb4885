//! The display list on tiny-skia.

use tiny_skia::{
    FillRule, LineCap, LineJoin, Mask, PathBuilder, Pixmap, PixmapPaint, Shader, StrokeDash, Transform,
};
use tracefig::drawing::{
    Cap, Contour, Drawing, Group, Item, Paint, Path, Pattern, Point, Rect, Segment, Stroke, Text,
};
use tracefig::typeset::{OutlineSegment, UNITS_PER_EM};

use super::SCALE;

/// The fastest PNG of the `png` crate.
pub(super) fn encode(pixmap: &Pixmap) -> Option<Vec<u8>> {
    let rgb: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixmap.width(), pixmap.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fastest);
    encoder.write_header().ok()?.write_image_data(&rgb).ok()?;
    Some(out)
}

/// The image.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a page of some thousand pixels")]
pub(super) fn rasterize(drawing: &Drawing) -> Option<Pixmap> {
    let mut pixmap = Pixmap::new((drawing.width * SCALE) as u32, (drawing.height * SCALE) as u32)?;
    pixmap.fill(color(&drawing.background));
    let mut canvas = Canvas { pixmap, frame: Frame { scale: SCALE, x: 0.0, y: 0.0 }, clip: None };
    canvas.items(&drawing.items);
    Some(canvas.pixmap)
}

/// From page pixels to image pixels.
#[derive(Clone, Copy)]
struct Frame {
    scale: f64,
    /// Image pixels that the layer's left edge is right of the image's.
    x: f64,
    /// Image pixels that the layer's top edge is below the image's.
    y: f64,
}

impl Frame {
    #[expect(clippy::cast_possible_truncation, reason = "the rasterizer takes single precision")]
    fn point(self, p: Point) -> (f32, f32) {
        ((p.x * self.scale - self.x) as f32, (p.y * self.scale - self.y) as f32)
    }

    #[expect(clippy::cast_possible_truncation, reason = "the rasterizer takes single precision")]
    fn length(self, length: f64) -> f32 {
        (length * self.scale) as f32
    }
}

/// A clip in force.
struct Clip {
    shape: tracefig::drawing::Clip,
    /// Made when the first item needs it.
    mask: Option<Mask>,
}

/// What is drawn on: the image, or a layer for a see-through group.
struct Canvas {
    pixmap: Pixmap,
    frame: Frame,
    clip: Option<Clip>,
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
        // No figure has a clip within a clip.
        let Some(shape) = group.clip else { return self.see_through(group) };
        let kept = self.clip.replace(Clip { shape, mask: None });
        self.see_through(group);
        self.clip = kept;
    }

    /// Draws a group's items, on a layer of their own where the group has an opacity.
    fn see_through(&mut self, group: &Group) {
        if group.opacity >= 1.0 {
            return self.items(&group.items);
        }
        let Some(extent) = group.extent() else { return };
        let Some((x, y, width, height)) = self.layer_place(extent) else { return };
        let Some(pixmap) = Pixmap::new(width, height) else { return };
        let frame = Frame { x: self.frame.x + f64::from(x), y: self.frame.y + f64::from(y), ..self.frame };
        let clip = self.clip.as_ref().map(|clip| Clip { shape: clip.shape, mask: None });
        let mut layer = Self { pixmap, frame, clip };
        layer.items(&group.items);
        #[expect(clippy::cast_possible_truncation, reason = "the rasterizer takes single precision")]
        let paint = PixmapPaint { opacity: group.opacity.clamp(0.0, 1.0) as f32, ..PixmapPaint::default() };
        self.pixmap.draw_pixmap(x, y, layer.pixmap.as_ref(), &paint, Transform::identity(), None);
    }

    /// Left, top, width and height in whole pixels of this canvas that hold `extent`, with one pixel around
    /// it for anti-aliasing; `None` where nothing of it is on the canvas.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "cut to the canvas before")]
    fn layer_place(&self, extent: Rect) -> Option<(i32, i32, u32, u32)> {
        let Frame { scale, x, y } = self.frame;
        let (w, h) = (f64::from(self.pixmap.width()), f64::from(self.pixmap.height()));
        let x0 = ((extent.x0 * scale - x).floor() - 1.0).clamp(0.0, w);
        let y0 = ((extent.y0 * scale - y).floor() - 1.0).clamp(0.0, h);
        let x1 = ((extent.x1 * scale - x).ceil() + 1.0).clamp(0.0, w);
        let y1 = ((extent.y1 * scale - y).ceil() + 1.0).clamp(0.0, h);
        (x1 > x0 && y1 > y0).then_some((x0 as i32, y0 as i32, (x1 - x0) as u32, (y1 - y0) as u32))
    }

    fn path(&mut self, path: &Path) {
        let Some(extent) = path.extent() else { return };
        let Some(shape) = contour(&path.contour, self.frame) else { return };
        if let Some(paint) = &path.fill {
            self.fill(&shape, paint, extent);
        }
        if let Some(pattern) = &path.pattern {
            self.pattern(&path.contour, &shape, pattern);
        }
        if let Some(stroke) = &path.stroke {
            self.stroke(&shape, stroke, extent);
        }
    }

    fn fill(&mut self, shape: &tiny_skia::Path, paint: &Paint, extent: Rect) {
        let (pixmap, mask) = self.target(extent);
        pixmap.fill_path(shape, &solid(paint), FillRule::Winding, Transform::identity(), mask);
    }

    fn stroke(&mut self, shape: &tiny_skia::Path, stroke: &Stroke, extent: Rect) {
        let settings = stroke_settings(stroke, self.frame);
        let (pixmap, mask) = self.target(extent);
        pixmap.stroke_path(shape, &solid(&stroke.paint), &settings, Transform::identity(), mask);
    }

    /// The marks as lines, with the contour as their mask.
    fn pattern(&mut self, area: &Contour, shape: &tiny_skia::Path, pattern: &Pattern) {
        let Some(bounds) = area.bounds() else { return };
        let Some(mut mask) = Mask::new(self.pixmap.width(), self.pixmap.height()) else { return };
        mask.fill_path(shape, FillRule::Winding, true, Transform::identity());
        if let Some(clip) = &self.clip
            && let Some(rect) = contour(&clip.shape.contour(), self.frame)
        {
            mask.intersect_path(&rect, FillRule::Winding, true, Transform::identity());
        }
        let (lines, stroke) = pattern.marks(bounds);
        let mut builder = PathBuilder::new();
        for (from, to) in lines {
            let ((x0, y0), (x1, y1)) = (self.frame.point(from), self.frame.point(to));
            builder.move_to(x0, y0);
            builder.line_to(x1, y1);
        }
        let Some(marks) = builder.finish() else { return };
        let settings = stroke_settings(&stroke, self.frame);
        let paint = solid(&stroke.paint);
        self.pixmap.stroke_path(&marks, &paint, &settings, Transform::identity(), Some(&mask));
    }

    fn text(&mut self, text: &Text) {
        let Some(shape) = line(text, self.frame) else { return };
        let extent = Item::Text(text.clone()).extent().unwrap_or_default();
        if let Some(halo) = &text.halo {
            let around = Stroke::solid(halo.paint, 2.0 * halo.width);
            self.fill(&shape, &halo.paint, extent);
            self.stroke(&shape, &around, extent);
        }
        self.fill(&shape, &text.paint, extent);
    }

    /// The image, and the clip's mask if `extent` reaches beyond the clip.
    fn target(&mut self, extent: Rect) -> (&mut Pixmap, Option<&Mask>) {
        let (width, height, frame) = (self.pixmap.width(), self.pixmap.height(), self.frame);
        let mask = self.clip.as_mut().and_then(|clip| {
            let r = clip.shape.rect;
            if clip.shape.radius <= 0.0 && r.x0 <= extent.x0 && r.y0 <= extent.y0 && extent.x1 <= r.x1 && extent.y1 <= r.y1 {
                return None;
            }
            if clip.mask.is_none() {
                let mut mask = Mask::new(width, height)?;
                mask.fill_path(&contour(&clip.shape.contour(), frame)?, FillRule::Winding, true, Transform::identity());
                clip.mask = Some(mask);
            }
            clip.mask.as_ref()
        });
        (&mut self.pixmap, mask)
    }
}

fn color(paint: &Paint) -> tiny_skia::Color {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
    let alpha = (paint.opacity.clamp(0.0, 1.0) * 255.0).round() as u8;
    let tracefig::drawing::Color { r, g, b } = paint.color;
    tiny_skia::Color::from_rgba8(r, g, b, alpha)
}

fn solid(paint: &Paint) -> tiny_skia::Paint<'static> {
    tiny_skia::Paint {
        shader: Shader::SolidColor(color(paint)),
        anti_alias: true,
        ..tiny_skia::Paint::default()
    }
}

fn stroke_settings(stroke: &Stroke, frame: Frame) -> tiny_skia::Stroke {
    let dash = stroke.dash.iter().map(|&length| frame.length(length)).collect();
    tiny_skia::Stroke {
        width: frame.length(stroke.width),
        line_cap: match stroke.cap {
            Cap::Butt => LineCap::Butt,
            Cap::Round => LineCap::Round,
        },
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dash, 0.0),
        ..tiny_skia::Stroke::default()
    }
}

fn rectangle(rect: Rect, frame: Frame) -> Option<tiny_skia::Path> {
    let ((x0, y0), (x1, y1)) =
        (frame.point(Point::new(rect.x0, rect.y0)), frame.point(Point::new(rect.x1, rect.y1)));
    Some(PathBuilder::from_rect(tiny_skia::Rect::from_ltrb(x0, y0, x1, y1)?))
}

fn contour(contour: &Contour, frame: Frame) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    match contour {
        Contour::Circle { center, radius } => {
            let (x, y) = frame.point(*center);
            builder.push_circle(x, y, frame.length(*radius));
        }
        Contour::Segments(segments) => {
            let mut begun = false;
            for segment in segments {
                piece(&mut builder, segment, frame, begun);
                begun = true;
            }
        }
    }
    builder.finish()
}

fn piece(builder: &mut PathBuilder, segment: &Segment, frame: Frame, begun: bool) {
    match *segment {
        Segment::Move(p) => {
            let (x, y) = frame.point(p);
            builder.move_to(x, y);
        }
        Segment::Line(p) => {
            let (x, y) = frame.point(p);
            builder.line_to(x, y);
        }
        Segment::Quad(c, p) => {
            let ((cx, cy), (x, y)) = (frame.point(c), frame.point(p));
            builder.quad_to(cx, cy, x, y);
        }
        Segment::Cubic(c, d, p) => {
            let ((cx, cy), (dx, dy), (x, y)) = (frame.point(c), frame.point(d), frame.point(p));
            builder.cubic_to(cx, cy, dx, dy, x, y);
        }
        Segment::Close => builder.close(),
        Segment::Arc { center, radius, start, sweep } => {
            arc(builder, frame, begun, (center, radius, start, sweep))
        }
    }
}

/// Cubics of at most 45° with control points (4/3) tan(θ/4) r along the tangents.
fn arc(
    builder: &mut PathBuilder,
    frame: Frame,
    begun: bool,
    (center, radius, start, sweep): (Point, f64, f64, f64),
) {
    let count = (sweep.abs() / std::f64::consts::FRAC_PI_4).ceil().max(1.0);
    let step = sweep / count;
    let reach = 4.0 / 3.0 * (step / 4.0).tan() * radius;
    let at = |angle: f64, along: f64| {
        let (sin, cos) = angle.sin_cos();
        frame.point(Point::new(center.x + radius * cos - along * sin, center.y + radius * sin + along * cos))
    };
    let (x, y) = at(start, 0.0);
    if begun {
        builder.line_to(x, y)
    } else {
        builder.move_to(x, y)
    }
    let mut angle = start;
    while (start + sweep - angle).abs() > step.abs() / 2.0 {
        let ((cx, cy), (dx, dy), (x, y)) =
            (at(angle, reach), at(angle + step, -reach), at(angle + step, 0.0));
        builder.cubic_to(cx, cy, dx, dy, x, y);
        angle += step;
    }
}

/// All glyphs and rules of a text as one contour: one call of the rasterizer instead of one a letter.
fn line(text: &Text, frame: Frame) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for placed in &text.line.glyphs {
        let (x, y) = frame.point(Point::new(text.origin.x + placed.x, text.origin.y + placed.y));
        let em = frame.length(placed.size / UNITS_PER_EM);
        let at = |p: [f32; 2]| (x + p[0] * em, y + p[1] * em);
        for segment in &placed.glyph.outline().segments {
            match *segment {
                OutlineSegment::Move(p) => {
                    let (x, y) = at(p);
                    builder.move_to(x, y);
                }
                OutlineSegment::Line(p) => {
                    let (x, y) = at(p);
                    builder.line_to(x, y);
                }
                OutlineSegment::Quad(c, p) => {
                    let ((cx, cy), (x, y)) = (at(c), at(p));
                    builder.quad_to(cx, cy, x, y);
                }
                OutlineSegment::Cubic(c, d, p) => {
                    let ((cx, cy), (dx, dy), (x, y)) = (at(c), at(d), at(p));
                    builder.cubic_to(cx, cy, dx, dy, x, y);
                }
                OutlineSegment::Close => builder.close(),
            }
        }
    }
    for rule in &text.line.rules {
        let (x0, y0) = (text.origin.x + rule.x, text.origin.y + rule.y);
        let rect = Rect { x0, y0, x1: x0 + rule.width, y1: y0 + rule.height };
        if let Some(path) = rectangle(rect, frame) {
            builder.push_path(&path);
        }
    }
    builder.finish()
}
