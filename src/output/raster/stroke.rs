//! Lines with a width, and dashes.
//!
//! A line's outline is the chain moved to its left, and back along it moved to its right. Where the chain turns away from
//! the side, an arc about the corner joins the two pieces; where it turns towards it, the outline goes through the corner, so
//! that the loop it makes lies inside the line and winds as it does.

use std::f64::consts::PI;

use super::polyline::Polylines;
use crate::drawing::{Cap, Point};

/// How far a chord may be off an arc at a corner or an end, in image pixels: arcs are small, and a chord only ever loses
/// area, so less than for curves.
const FLATNESS: f64 = 1.0 / 64.0;

/// Most dashes of one line; a line with more is drawn solid, as none would be seen.
const MOST_DASHES: f64 = 100_000.0;

/// The outline of lines that are `width` image pixels wide.
pub(super) fn outline(lines: &Polylines, width: f64, cap: Cap) -> Polylines {
    let mut pen = Pen { half: 0.5 * width, turn: largest_turn(0.5 * width), cap, out: Polylines::default() };
    for (points, closed) in lines.chains() {
        pen.chain(&distinct(points, closed), closed);
    }
    pen.out
}

/// What lies within `reach` of an area, the area included; its outer contours have their outside on the left.
///
/// Moved to its left, a contour winds about the area, and about each piece between it and the moved one, in one sense.
pub(super) fn grown(area: &Polylines, reach: f64) -> Polylines {
    let mut pen = Pen { half: reach, turn: largest_turn(reach), cap: Cap::Butt, out: Polylines::default() };
    for (points, _) in area.chains() {
        let points = distinct(points, true);
        if let [first, .., last] = points[..] {
            pen.side(&mut points.iter().copied().chain([first]), last);
        }
    }
    pen.out
}

/// The lines cut into dashes: lengths of dashes and gaps alternate, in image pixels.
pub(super) fn dashes(lines: &Polylines, dash: &[f64]) -> Option<Polylines> {
    let period: f64 = dash.iter().sum();
    let length: f64 = lines.chains().map(|(points, closed)| length(points, closed)).sum();
    let sound = dash.iter().all(|&d| d >= 0.0) && period > 0.0 && length / period < MOST_DASHES;
    if !sound {
        return None;
    }
    let mut out = Polylines::default();
    for (points, closed) in lines.chains() {
        chain_dashes(points, closed, dash, &mut out);
    }
    Some(out)
}

fn chain_dashes(points: &[Point], closed: bool, dash: &[f64], out: &mut Polylines) {
    let Some(&first) = points.first() else { return };
    let (mut index, mut left) = (0, dash[0]);
    out.points.push(first);
    let mut from = first;
    for &to in points[1..].iter().chain(closed.then_some(&first)) {
        let whole = distance(from, to);
        let mut done = 0.0;
        while whole - done > left {
            done += left;
            let t = done / whole;
            let at = Point::new(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
            if index % 2 == 0 {
                out.points.push(at);
                out.end(false);
            }
            index = (index + 1) % dash.len();
            left = dash[index];
            if index % 2 == 0 {
                out.points.push(at);
            }
        }
        left -= whole - done;
        if index % 2 == 0 {
            out.points.push(to);
        }
        from = to;
    }
    out.end(false);
}

fn length(points: &[Point], closed: bool) -> f64 {
    let open: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    match (points.first(), points.last()) {
        (Some(&first), Some(&last)) if closed => open + distance(last, first),
        _ => open,
    }
}

fn distance(p: Point, q: Point) -> f64 {
    let (x, y) = (q.x - p.x, q.y - p.y);
    libm::sqrt(x * x + y * y)
}

/// The points without those that equal the one before: a piece without length has no direction.
fn distinct(points: &[Point], closed: bool) -> Vec<Point> {
    let mut distinct: Vec<Point> = Vec::with_capacity(points.len());
    for &p in points {
        if distinct.last() != Some(&p) {
            distinct.push(p);
        }
    }
    while closed && distinct.len() > 1 && distinct.first() == distinct.last() {
        distinct.pop();
    }
    distinct
}

/// The largest angle of an arc that a chord may replace.
fn largest_turn(radius: f64) -> f64 {
    if radius <= FLATNESS { PI } else { 2.0 * libm::acos(1.0 - FLATNESS / radius) }
}

/// Draws outlines.
struct Pen {
    half: f64,
    turn: f64,
    cap: Cap,
    out: Polylines,
}

impl Pen {
    fn chain(&mut self, points: &[Point], closed: bool) {
        match points {
            [] => {}
            [only] => self.dot(*only),
            [.., last] if closed && points.len() > 2 => {
                let (first, last) = (points[0], *last);
                self.side(&mut points.iter().copied().chain([first]), last);
                self.side(&mut points.iter().rev().copied().chain([last]), first);
            }
            _ => self.open(points),
        }
    }

    /// A line without length: with round caps a disc, else nothing.
    fn dot(&mut self, at: Point) {
        if self.cap == Cap::Round {
            self.arc(at, Point::new(self.half, 0.0), 2.0 * PI);
            self.out.end(true);
        }
    }

    /// One side of a closed chain, whose last point is its first again and that `before` precedes.
    fn side(&mut self, points: &mut dyn Iterator<Item = Point>, before: Point) {
        let mut normal: Option<Point> = None;
        let mut from = before;
        for to in points {
            let next = self.normal(from, to);
            if let Some(normal) = normal {
                self.join(from, normal, next);
            }
            normal = Some(next);
            from = to;
        }
        self.out.end(true);
    }

    fn open(&mut self, points: &[Point]) {
        let (first, last) = (points[0], points[points.len() - 1]);
        let forth = self.half_outline(&mut points.iter().copied());
        self.end_cap(last, forth.1);
        let back = self.half_outline(&mut points.iter().rev().copied());
        self.end_cap(first, back.1);
        self.out.end(true);
    }

    /// One side of an open chain; its first and last normal.
    fn half_outline(&mut self, points: &mut dyn Iterator<Item = Point>) -> (Point, Point) {
        let mut ends: Option<(Point, Point)> = None;
        let Some(mut from) = points.next() else { return Default::default() };
        for to in points {
            let next = self.normal(from, to);
            let first = if let Some((first, normal)) = ends {
                self.join(from, normal, next);
                first
            } else {
                self.push(from, next);
                next
            };
            ends = Some((first, next));
            from = to;
        }
        let ends = ends.unwrap_or_default();
        self.push(from, ends.1);
        ends
    }

    fn end_cap(&mut self, at: Point, normal: Point) {
        if self.cap == Cap::Round {
            self.arc(at, normal, PI);
        }
    }

    /// From a piece with one normal to the next piece, at their common corner.
    fn join(&mut self, corner: Point, normal: Point, next: Point) {
        let cross = normal.x * next.y - normal.y * next.x;
        let dot = normal.x * next.x + normal.y * next.y;
        let angle = libm::atan2(cross, dot);
        self.push(corner, normal);
        if angle > self.turn {
            self.arc(corner, normal, angle);
        } else if angle < -self.turn {
            self.out.points.push(corner);
        }
        self.push(corner, next);
    }

    /// Points of the arc about `center` from `center + radius` on, both ends excluded.
    fn arc(&mut self, center: Point, radius: Point, angle: f64) {
        let steps = (angle.abs() / self.turn).ceil().max(1.0);
        let (sin, cos) = (libm::sin(angle / steps), libm::cos(angle / steps));
        let mut r = radius;
        let mut i = 1.0;
        while i < steps {
            r = Point::new(r.x * cos - r.y * sin, r.x * sin + r.y * cos);
            self.push(center, r);
            i += 1.0;
        }
    }

    fn push(&mut self, at: Point, normal: Point) {
        self.out.points.push(Point::new(at.x + normal.x, at.y + normal.y));
    }

    /// From the line to its left side, where y points down: half the width long.
    fn normal(&self, from: Point, to: Point) -> Point {
        let scale = self.half / distance(from, to);
        Point::new((to.y - from.y) * scale, (from.x - to.x) * scale)
    }
}

#[cfg(test)]
mod tests {
    use super::super::coverage::{LEVELS, rows};
    use super::*;

    fn lines(points: &[(f64, f64)], closed: bool) -> Polylines {
        let points: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let ends = vec![(points.len(), closed)];
        Polylines { points, ends }
    }

    fn area(lines: &Polylines) -> f64 {
        rows(&[lines], 100, 100).iter().flatten().map(|s| f64::from((s.end - s.start) * s.level)).sum::<f64>()
            / f64::from(LEVELS)
    }

    #[test]
    fn a_line_has_its_length_times_its_width_and_round_ends_a_disc_more() {
        let line = lines(&[(10.0, 10.0), (70.0, 55.0)], false);
        assert!((area(&outline(&line, 4.0, Cap::Butt)) - 300.0).abs() < 2.0);
        let round = area(&outline(&line, 8.0, Cap::Round));
        assert!((round - (600.0 + PI * 16.0)).abs() < 4.0, "{round}");
    }

    #[test]
    fn a_closed_line_is_a_ring_in_either_winding() {
        let square = [(20.0, 20.0), (80.0, 20.0), (80.0, 80.0), (20.0, 80.0)];
        // Four sides of 60 × 6, less the corners' doubles, with quarter discs for the outer corners.
        let expected = 4.0 * 60.0 * 6.0 - 4.0 * 9.0 + PI * 9.0;
        for points in [square.to_vec(), square.into_iter().rev().collect()] {
            let ring = area(&outline(&lines(&points, true), 6.0, Cap::Butt));
            assert!((ring - expected).abs() < 2.0, "{ring} for {expected}");
        }
    }

    #[test]
    fn a_sharp_corner_is_round_outside_and_has_no_hole_inside() {
        let corner = lines(&[(20.0, 80.0), (50.0, 20.0), (60.0, 80.0)], false);
        let rows = rows(&[&outline(&corner, 10.0, Cap::Butt)], 100, 100);
        let at = |x: u32, y: usize| rows[y].iter().find(|s| s.start <= x && x < s.end).map_or(0, |s| s.level);
        assert_eq!((at(50, 20), at(50, 24), at(50, 17)), (LEVELS, LEVELS, LEVELS));
        assert_eq!(at(50, 13), 0, "no spike");
    }

    #[test]
    fn dashes_cover_their_share_and_dots_are_dashes_without_length() {
        let line = lines(&[(5.0, 50.0), (50.0, 50.0), (95.0, 50.0)], false);
        let dashed = dashes(&line, &[7.0, 3.0]).unwrap();
        assert_eq!(dashed.chains().count(), 9);
        assert!((area(&outline(&dashed, 2.0, Cap::Butt)) - 2.0 * 63.0).abs() < 1.0);
        let dots = dashes(&line, &[0.0, 10.0]).unwrap();
        let expected = 9.0 * PI * 4.0;
        let dotted = area(&outline(&dots, 4.0, Cap::Round));
        assert!((dotted - expected).abs() < 4.0, "{dotted} for {expected}");
        assert!(dashes(&line, &[0.0, 0.0]).is_none());
    }

    #[test]
    fn what_lies_within_reach_of_a_ring_fills_its_hole_where_that_is_small() {
        let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)];
        let ring = |low: f64, high: f64| {
            let mut ring = lines(&square(10.0, 90.0), true);
            ring.points.extend(square(low, high).iter().rev().map(|&(x, y)| Point::new(x, y)));
            ring.ends.push((8, true));
            ring
        };
        let outside = 80.0 * 80.0 + 4.0 * 80.0 * 5.0 + PI * 25.0;
        let (wide, narrow) = (grown(&ring(30.0, 70.0), 5.0), grown(&ring(46.0, 54.0), 5.0));
        assert!((area(&wide) - (outside - 900.0)).abs() < 4.0, "{}", area(&wide));
        assert!((area(&narrow) - outside).abs() < 4.0, "{}", area(&narrow));
    }
}
