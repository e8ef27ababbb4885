//! Text as outlines, all of one winding.

use super::polyline::Polylines;
use crate::drawing::{Contour, Point, Rect, Segment, Text};
use crate::typeset::{OutlineSegment, UNITS_PER_EM};

/// All glyphs and rules of a text, in image pixels: one area instead of one a letter. Where the outer contour of a glyph
/// runs, its outside is on the left.
pub(super) fn lines(text: &Text, scale: f64) -> Polylines {
    let mut lines = Polylines::default();
    for placed in &text.line.glyphs {
        let em = placed.size / UNITS_PER_EM * scale;
        let x = (text.origin.x + placed.x) * scale;
        let y = (text.origin.y + placed.y) * scale;
        let map = |p: Point| Point::new(x + p.x * em, y + p.y * em);
        let first = lines.ends.len();
        for segment in &placed.glyph.outline().segments {
            lines.segment(&piece(segment), map);
        }
        lines.end(true);
        outside_left(&mut lines, first);
    }
    for rule in &text.line.rules {
        let (x0, y0) = (text.origin.x + rule.x, text.origin.y + rule.y);
        let rect = rectangle(Rect { x0, y0, x1: x0 + rule.width, y1: y0 + rule.height });
        super::super::curves::pieces(&rect, |segment| {
            lines.segment(&segment, |p| Point::new(p.x * scale, p.y * scale));
        });
    }
    lines
}

/// Font formats disagree on the direction of contours: turns the chains from `first` on round where the sum of their areas
/// tells that their outside is on the right.
fn outside_left(lines: &mut Polylines, first: usize) {
    let begin = first.checked_sub(1).map_or(0, |before| lines.ends[before].0);
    let mut area = 0.0;
    let mut start = begin;
    for &(end, _) in &lines.ends[first..] {
        let points = &lines.points[start..end];
        let next = points.iter().skip(1).chain(points.first());
        area += points.iter().zip(next).map(|(p, q)| p.x * q.y - q.x * p.y).sum::<f64>();
        start = end;
    }
    if area < 0.0 {
        let mut start = begin;
        for &(end, _) in &lines.ends[first..] {
            lines.points[start..end].reverse();
            start = end;
        }
    }
}

/// A rectangle, clockwise on the page: its outside is on the left.
pub(super) fn rectangle(rect: Rect) -> Contour {
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
