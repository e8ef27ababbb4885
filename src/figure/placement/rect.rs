//! Rectangles on the page beside points, lines and each other. All lengths are page pixels.

use crate::drawing::{Offset, Point, Rect};

/// The eight directions on the page, y down, in the order of [`COMPASS`](crate::scene::COMPASS): from the
/// east counter-clockwise.
pub(super) const DIRECTIONS: [(f64, f64); 8] =
    [(1.0, 0.0), (1.0, -1.0), (0.0, -1.0), (-1.0, -1.0), (-1.0, 0.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0)];

/// The length of a segment inside a rectangle; 0 where it only touches, `None` where it does not.
pub(super) fn length_inside(from: Point, to: Point, rect: &Rect) -> Option<f64> {
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

/// Distance of a point from a rectangle; 0 inside.
pub(super) fn distance_to(rect: &Rect, p: Point) -> f64 {
    (p - nearest_in(rect, p)).length()
}

/// Distance of two rectangles; 0 where they touch.
pub(super) fn rect_distance(a: &Rect, b: &Rect) -> f64 {
    let gap = |lo: f64, hi: f64| (lo - hi).max(0.0);
    let dx = gap(a.x0, b.x1).max(gap(b.x0, a.x1));
    let dy = gap(a.y0, b.y1).max(gap(b.y0, a.y1));
    libm::hypot(dx, dy)
}

/// Distance of a segment from a rectangle; 0 where they touch.
pub(super) fn segment_distance(rect: &Rect, from: Point, to: Point) -> f64 {
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

/// The point of a rectangle nearest to a point; of one that has no width or height after all, its upper left.
pub(super) fn nearest_in(rect: &Rect, p: Point) -> Point {
    Point::new(p.x.max(rect.x0).min(rect.x1), p.y.max(rect.y0).min(rect.y1))
}

/// The rectangle of a width and height about a centre.
pub(super) fn about(center: Point, (w, h): (f64, f64)) -> Rect {
    let half = Offset::new(0.5 * w, 0.5 * h);
    Rect::new(center + -half, center + half)
}

/// How far a rectangle of a width and height reaches from its centre along a unit offset, at most.
pub(super) fn reach(u: Offset, (w, h): (f64, f64)) -> f64 {
    0.5 * (u.dx.abs() * w + u.dy.abs() * h)
}

/// The box of points; `None` without any.
pub(super) fn bounds(points: impl IntoIterator<Item = Point>) -> Option<Rect> {
    points.into_iter().map(|p| Rect::new(p, p)).reduce(Rect::union)
}

/// Twice the area, in square page pixels, of a triangle whose vertices count as on one line: far more than
/// the last bits of an answer make, far less than is seen.
const FLAT: f64 = 1e-6;

/// Whether two segments cross; those that only touch do not.
pub(super) fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = |p: Point, q: Point, r: Point| {
        let area = (q - p).cross(r - p);
        if area.abs() < FLAT { 0.0 } else { area }
    };
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
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

    #[test]
    fn segments_that_only_touch_do_not_cross() {
        let p = Point::new;
        assert!(cross(p(0.0, 0.0), p(2.0, 2.0), p(0.0, 2.0), p(2.0, 0.0)));
        assert!(!cross(p(0.0, 0.0), p(1.0, 1.0), p(0.0, 2.0), p(2.0, 0.0)));
    }

    #[test]
    fn the_directions_are_those_of_the_compass() {
        for (k, &(dx, dy)) in DIRECTIONS.iter().enumerate() {
            let word = crate::scene::COMPASS[k];
            let letter = |c, along: f64| if word.contains(c) { along } else { 0.0 };
            assert_eq!(dx, letter('E', 1.0) + letter('W', -1.0), "{word}");
            assert_eq!(dy, letter('S', 1.0) + letter('N', -1.0), "{word}");
        }
    }
}
