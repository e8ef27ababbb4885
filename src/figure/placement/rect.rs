//! Rectangles on the page beside points, lines and each other. All lengths are page pixels.

use crate::drawing::{Offset, Point, Rect};

/// The eight directions on the page, y down, in the order of [`COMPASS`](crate::scene::COMPASS): from the
/// east counter-clockwise.
pub(super) const DIRECTIONS: [(f64, f64); 8] =
    [(1.0, 0.0), (1.0, -1.0), (0.0, -1.0), (-1.0, -1.0), (-1.0, 0.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0)];

/// The length of a segment inside a rectangle; 0 where it only touches, `None` where it does not.
pub(super) fn length_inside(from: Point, to: Point, rect: &Rect) -> Option<f64> {
    rect.shares_inside(from, to).map(|(lo, hi)| (hi - lo) * (to - from).length())
}

/// Whether a segment runs through a rectangle, or touches it.
pub(super) fn touches(from: Point, to: Point, rect: &Rect) -> bool {
    rect.shares_inside(from, to).is_some()
}

/// The part of a segment that lies inside a rectangle; all of it where that has no length.
pub(super) fn part_inside(from: Point, to: Point, rect: &Rect) -> (Point, Point) {
    match rect.shares_inside(from, to) {
        Some((lo, hi)) if lo < hi && hi - lo < 1.0 => (from + (to - from) * lo, from + (to - from) * hi),
        _ => (from, to),
    }
}

/// Distance of a point from a rectangle; 0 inside.
pub(super) fn distance_to(rect: &Rect, p: Point) -> f64 {
    (p - nearest_in(rect, p)).square().sqrt()
}

/// Distance of two rectangles; 0 where they touch.
pub(super) fn rect_distance(a: &Rect, b: &Rect) -> f64 {
    rect_square(a, b).sqrt()
}

/// The square of the distance of two rectangles; 0 where they touch.
pub(super) fn rect_square(a: &Rect, b: &Rect) -> f64 {
    let dx = (a.x0 - b.x1).max(b.x0 - a.x1).max(0.0);
    let dy = (a.y0 - b.y1).max(b.y0 - a.y1).max(0.0);
    dx * dx + dy * dy
}

/// Distance of a segment from a rectangle; 0 where they touch.
pub(super) fn segment_distance(rect: &Rect, from: Point, to: Point) -> f64 {
    segment_square(rect, from, to).sqrt()
}

/// The square of the distance of a segment from a rectangle; 0 where they touch.
pub(super) fn segment_square(rect: &Rect, from: Point, to: Point) -> f64 {
    if touches(from, to, rect) {
        return 0.0;
    }
    let corners = [(rect.x0, rect.y0), (rect.x1, rect.y0), (rect.x1, rect.y1), (rect.x0, rect.y1)];
    let beside = corners.map(|(x, y)| Point::new(x, y)).map(|p| (p - nearest_on(from, to, p)).square());
    let ends = [from, to].map(|p| (p - nearest_in(rect, p)).square());
    beside.into_iter().chain(ends).fold(f64::INFINITY, f64::min)
}

/// The point of a segment that is nearest to a point.
pub(super) fn nearest_on(from: Point, to: Point, p: Point) -> Point {
    from + way_to_nearest(from, to, p)
}

/// The way from the start of a segment to its point that is nearest to a point; none where it has no length,
/// or more than a double holds the square of.
fn way_to_nearest(from: Point, to: Point, p: Point) -> Offset {
    let d = to - from;
    let share = (p - from).dot(d) / d.square();
    if share > 0.0 && d.square() < f64::INFINITY { d * share.min(1.0) } else { Offset::default() }
}

/// The square of the distance of a point from a segment, taken from its start: of two points that mirror
/// each other the squares are the same to the last bit.
pub(super) fn point_square(from: Point, to: Point, p: Point) -> f64 {
    ((p - from) - way_to_nearest(from, to, p)).square()
}

/// The point of a rectangle nearest to a point; of one that has no width or height after all, its upper left.
pub(super) fn nearest_in(rect: &Rect, p: Point) -> Point {
    Point::new(p.x.max(rect.x0).min(rect.x1), p.y.max(rect.y0).min(rect.y1))
}

/// The shortest way of a rectangle into another one; none in a direction in which it is too wide for it.
pub(super) fn way_into(rect: &Rect, room: &Rect) -> Offset {
    let way = |lo: f64, hi: f64, least: f64, most: f64| {
        if hi - lo > most - least { 0.0 } else { (least - lo).max(0.0) - (hi - most).max(0.0) }
    };
    Offset::new(way(rect.x0, rect.x1, room.x0, room.x1), way(rect.y0, rect.y1, room.y0, room.y1))
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
    fn the_distance_of_a_segment_far_beyond_the_page_is_a_number() {
        let rect = Rect { x0: 0.0, y0: 0.0, x1: 4.0, y1: 3.0 };
        let from = Point::new(5.0, 3.0);
        for far in [1e160, 1e200, 1e308] {
            for to in [Point::new(far, far), Point::new(far, -far), Point::new(far, 0.0)] {
                assert_eq!(segment_square(&rect, from, to), 1.0, "{to:?}");
                assert_eq!(point_square(from, to, Point::new(4.0, 3.0)), 1.0, "{to:?}");
            }
        }
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
