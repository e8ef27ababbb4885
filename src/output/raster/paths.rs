//! What is drawn as paths of tiny-skia, in image pixels.

use std::f64::consts::FRAC_PI_4;

use tiny_skia::{LineCap, LineJoin, Path, PathBuilder, StrokeDash};

use super::super::curves;
use crate::drawing::{Cap, Contour, Point, Rect, Segment, Stroke};
use crate::typeset::Outline;

/// How finely tiny-skia follows a curve when it makes the sides of a line along it: at 1, within a quarter of
/// a pixel. At 4, rings with radii of 6 to 140 pixels come no nearer to exact ones.
const SIDES: f32 = 1.0;

/// How finely it measures a curve to cut it into dashes: at 1, the dots of a circle of radius 90 run 0.4
/// pixels ahead within a round, at 4 by 0.13, and at 16 by 0.07.
const LENGTHS: f32 = 4.0;

/// The contour at `scale` image pixels for a page pixel; none where it has no length.
pub(super) fn contour(contour: &Contour, scale: f64) -> Option<Path> {
    let mut builder = PathBuilder::new();
    curves::pieces(contour, |segment| piece(&mut builder, &segment, scale));
    builder.finish()
}

/// Straight lines, each from one point to the other, at `scale` image pixels for a page pixel.
pub(super) fn lines(lines: &[(Point, Point)], scale: f64) -> Option<Path> {
    let segments = lines.iter().flat_map(|&(from, to)| [Segment::Move(from), Segment::Line(to)]);
    contour(&Contour::Segments(segments.collect()), scale)
}

/// Adds the contours of a glyph whose origin is at `origin` and whose units have `unit` image pixels.
pub(super) fn push_glyph(builder: &mut PathBuilder, outline: &Outline, origin: Point, unit: f64) {
    let place = |p: Point| Point::new(origin.x + p.x * unit, origin.y + p.y * unit);
    curves::glyph(outline, place, |segment| piece(builder, &segment, 1.0));
}

/// Adds a rectangle that is given in image pixels.
pub(super) fn push_rectangle(builder: &mut PathBuilder, rect: Rect) {
    let Rect { x0, y0, x1, y1 } = rect;
    let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Point::new(x, y));
    curves::pieces(&Contour::polygon(&corners), |segment| piece(builder, &segment, 1.0));
}

/// Adds a piece, its points times `scale`.
fn piece(builder: &mut PathBuilder, segment: &Segment, scale: f64) {
    #[expect(clippy::cast_possible_truncation, reason = "the places of a mask are single precision")]
    let at = |p: Point| ((p.x * scale) as f32, (p.y * scale) as f32);
    match *segment {
        Segment::Move(p) => {
            let (x, y) = at(p);
            builder.move_to(x, y);
        }
        Segment::Line(p) => {
            let (x, y) = at(p);
            builder.line_to(x, y);
        }
        Segment::Quad(c, p) => {
            let ((cx, cy), (x, y)) = (at(c), at(p));
            builder.quad_to(cx, cy, x, y);
        }
        Segment::Cubic(c, d, p) => {
            let ((cx, cy), (dx, dy), (x, y)) = (at(c), at(d), at(p));
            builder.cubic_to(cx, cy, dx, dy, x, y);
        }
        Segment::Close => builder.close(),
        // `pieces` gives none.
        Segment::Arc { .. } => {}
    }
}

/// How many image pixels wide a line is drawn, and how much of its colour it keeps.
///
/// Of a line thinner than a pixel, few samples or none are inside, so it is drawn a pixel wide and as much
/// fainter, as browsers do. A dash of length l and width w with round ends has the area w l + c w², c = π/4,
/// and is drawn with the area l + c, so that dots grow fainter than lines.
pub(super) fn visible_width(stroke: &Stroke, scale: f64) -> (f64, f64) {
    let width = (stroke.width * scale).max(0.0);
    if width >= 1.0 {
        return (width, 1.0);
    }
    let share = match (stroke.cap, stroke.dash.first()) {
        (Cap::Round, Some(&dash)) => (dash * scale + FRAC_PI_4 * width) / (dash * scale + FRAC_PI_4),
        _ => 1.0,
    };
    (1.0, width * share)
}

/// The area of a line along `path`; its width and dashes are in page pixels, of `scale` image pixels each.
#[expect(clippy::cast_possible_truncation, reason = "the places of a mask are single precision")]
pub(super) fn outline(path: &Path, stroke: &Stroke, scale: f64) -> Option<Path> {
    let cap = match stroke.cap {
        Cap::Butt => LineCap::Butt,
        Cap::Round => LineCap::Round,
    };
    let (width, _) = visible_width(stroke, scale);
    let dash = StrokeDash::new(stroke.dash.iter().map(|d| (d * scale) as f32).collect(), 0.0);
    match dash.and_then(|dash| path.dash(&dash, LENGTHS)) {
        Some(dashed) => along(&dashed, width, cap),
        None => along(path, width, cap),
    }
}

/// What lies within `reach` image pixels of a path's line.
pub(super) fn around(path: &Path, reach: f64) -> Option<Path> {
    along(path, 2.0 * reach, LineCap::Butt)
}

#[expect(clippy::cast_possible_truncation, reason = "the places of a mask are single precision")]
fn along(path: &Path, width: f64, line_cap: LineCap) -> Option<Path> {
    let line_join = LineJoin::Round;
    path.stroke(&tiny_skia::Stroke { width: width as f32, line_cap, line_join, ..Default::default() }, SIDES)
}

/// The rectangle that holds a path.
pub(super) fn bounds(path: &Path) -> Rect {
    let [x0, y0, x1, y1] = {
        let r = path.bounds();
        [r.left(), r.top(), r.right(), r.bottom()].map(f64::from)
    };
    Rect { x0, y0, x1, y1 }
}
