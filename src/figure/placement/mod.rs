//! Labels place themselves.
//!
//! A label has up to 16 candidate places around what it belongs to. A place costs more the more it hides: foreign
//! strokes, markers, arrowheads, the panel's edge; two places that overlap cost each other most. Labels are set in the
//! order of regret (who would lose most by waiting goes first), then one after the other moves to its best place
//! until none wants to. No clock and no randomness: the same figure gives the same places.
//!
//! The approach follows Christensen, Marks, Shieber, "An Empirical Study of Algorithms for Point-Feature Label
//! Placement", ACM Transactions on Graphics 14(3), 1995, with regret as the greedy order.

mod candidates;
mod cost;
mod faults;
mod inside;
mod solve;

use std::ops::Range;
use std::sync::Arc;

use crate::drawing::{Offset, Point, Rect, Role};
use crate::figure::frame::Frame;
use crate::figure::sketch::{Anchor, Obstacle, Rank};
use crate::scene::LabelPlace;
use crate::typeset::Line;

pub use faults::LabelFault;
pub(crate) use faults::faults;
pub(crate) use solve::place;

/// A label whose text is set and whose place is sought.
#[derive(Clone, Debug)]
pub(crate) struct Sought {
    pub(crate) key: &'static str,
    pub(crate) lines: Vec<Arc<Line>>,
    pub(crate) anchor: Anchor,
    pub(crate) role: Role,
    pub(crate) rank: Rank,
    pub(crate) part: usize,
    pub(crate) pin: Option<LabelPlace>,
    /// What a warning points at.
    pub(crate) span: Range<usize>,
}

/// Room between two lines of a label, page pixels.
pub(crate) const LEADING: f64 = 6.0;

impl Sought {
    /// Width and height in page pixels.
    pub(crate) fn size(&self) -> (f64, f64) {
        let width = self.lines.iter().map(|l| l.width).fold(0.0, f64::max);
        let height: f64 = self.lines.iter().map(|l| l.height() + LEADING).sum();
        (width, (height - LEADING).max(0.0))
    }
}

/// A label at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// Its key.
    pub key: &'static str,
    /// Its colour.
    pub(crate) role: Role,
    /// Who gives way.
    pub(crate) rank: Rank,
    /// What was set, with the left end of each baseline.
    pub(crate) lines: Vec<(Point, Arc<Line>)>,
    /// The box of its glyphs.
    pub bounds: Rect,
    /// A line to what it belongs to, where it stands far from it.
    pub(crate) leader: Option<(Point, Point)>,
    /// The part that it belongs to.
    pub(crate) part: usize,
    /// Where what it belongs to lies, from the upper left corner of its panel.
    pub(crate) home: Offset,
    /// What a warning points at.
    pub(crate) span: Range<usize>,
}

/// A panel with its labels.
#[derive(Clone, Debug, PartialEq)]
pub struct Labelled {
    /// The panel on the page, and its map.
    pub frame: Frame,
    /// What labels keep off.
    pub(crate) obstacles: Vec<Obstacle>,
    /// The labels that found a place.
    pub placed: Vec<Placed>,
    /// Keys of labels that did not, with the places that warnings point at.
    pub(crate) dropped: Vec<(&'static str, Range<usize>)>,
}

/// Whether a segment touches a rectangle, and over which length in page pixels.
fn length_inside(from: Point, to: Point, rect: &Rect) -> Option<f64> {
    let d = to - from;
    let (mut lo, mut hi) = (0.0_f64, 1.0_f64);
    for (start, step, min, max) in [(from.x, d.dx, rect.x0, rect.x1), (from.y, d.dy, rect.y0, rect.y1)] {
        if step == 0.0 {
            if start < min || start > max {
                return None;
            }
            continue;
        }
        let (a, b) = ((min - start) / step, (max - start) / step);
        (lo, hi) = (lo.max(a.min(b)), hi.min(a.max(b)));
    }
    (lo <= hi).then(|| (hi - lo) * d.length())
}

/// Distance of a point from a rectangle, page pixels; 0 inside.
fn distance_to(rect: &Rect, p: Point) -> f64 {
    (p - nearest_in(rect, p)).length()
}

/// Distance of a segment from a rectangle, page pixels; 0 where they touch.
fn segment_distance(rect: &Rect, from: Point, to: Point) -> f64 {
    if length_inside(from, to, rect).is_some() {
        return 0.0;
    }
    let d = to - from;
    let beside = |corner: Point| {
        let t = if d.dot(d) > 0.0 { ((corner - from).dot(d) / d.dot(d)).clamp(0.0, 1.0) } else { 0.0 };
        (corner - (from + d * t)).length()
    };
    let corners = [(rect.x0, rect.y0), (rect.x1, rect.y0), (rect.x1, rect.y1), (rect.x0, rect.y1)];
    let ends = distance_to(rect, from).min(distance_to(rect, to));
    corners.iter().map(|&(x, y)| beside(Point::new(x, y))).fold(ends, f64::min)
}

/// The point of a rectangle nearest to a point.
fn nearest_in(rect: &Rect, p: Point) -> Point {
    Point::new(p.x.clamp(rect.x0, rect.x1), p.y.clamp(rect.y0, rect.y1))
}

/// The rectangle of a size about a centre.
fn about(center: Point, (w, h): (f64, f64)) -> Rect {
    let half = Offset::new(0.5 * w, 0.5 * h);
    Rect::new(center + -half, center + half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_that_crosses_a_rectangle_is_measured_inside_it() {
        let rect = Rect { x0: 0.0, y0: 0.0, x1: 4.0, y1: 3.0 };
        assert_eq!(length_inside(Point::new(-1.0, 1.0), Point::new(9.0, 1.0), &rect), Some(4.0));
        assert_eq!(length_inside(Point::new(-1.0, 4.0), Point::new(9.0, 4.0), &rect), None);
        assert_eq!(length_inside(Point::new(1.0, 1.0), Point::new(1.0, 2.0), &rect), Some(1.0));
    }
}
