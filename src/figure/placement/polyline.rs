//! A line through points of the page that is asked how near it is: a body's outline, an arc, a vector.
//!
//! Labels ask this thousands of times, mostly of lines that are far off. So the pieces lie in runs, each with
//! its box, and a run whose box is farther off than what is known already is not looked at. Lengths are page
//! pixels, and are compared as their squares.

use crate::drawing::{Point, Rect};

use super::rect::{bounds, nearest_in, nearest_on, point_square, rect_square, segment_square, touches};

/// Pieces of a run: about the root of a circle's 72, so that it has as many runs as a run has pieces.
const RUN: usize = 8;

/// Points of the page, at least one, and the line through them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Polyline {
    /// The points; the first again at the end of a closed line.
    points: Vec<Point>,
    /// The box of every run of pieces.
    runs: Vec<Rect>,
    /// The box of all points.
    bounds: Rect,
}

impl Polyline {
    /// The open line through points; none without any.
    pub(super) fn open(points: Vec<Point>) -> Option<Self> {
        let bounds = bounds(points.iter().copied())?;
        let pieces = points.len() - 1;
        let run = |i: usize| super::rect::bounds(points[i..=(i + RUN).min(pieces)].iter().copied());
        let runs = (0..pieces).step_by(RUN).filter_map(run).collect();
        Some(Self { points, runs, bounds })
    }

    /// The closed line through points; none without any.
    pub(super) fn closed(mut points: Vec<Point>) -> Option<Self> {
        let first = *points.first()?;
        if points.last() != Some(&first) {
            points.push(first);
        }
        Self::open(points)
    }

    /// The points that it runs through.
    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }

    /// The box of its points.
    pub(super) fn bounds(&self) -> Rect {
        self.bounds
    }

    /// Its pieces.
    pub(super) fn pieces(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        self.points.windows(2).map(|pair| (pair[0], pair[1]))
    }

    /// Its runs: the box of each, and the points along it.
    fn runs(&self) -> impl Iterator<Item = (&Rect, &[Point])> {
        let last = self.points.len() - 1;
        self.runs.iter().zip((0..).step_by(RUN)).map(move |(b, i)| (b, &self.points[i..=(i + RUN).min(last)]))
    }

    /// The run whose box has the least of a measure, to be looked at first: what is found there rules out
    /// most of the others.
    fn first(&self, measure: impl Fn(&Rect) -> f64) -> impl Iterator<Item = (&Rect, &[Point])> {
        let first = self.runs().map(|run| (measure(run.0), run)).min_by(|a, b| a.0.total_cmp(&b.0));
        first.map(|(_, run)| run).into_iter()
    }

    /// The square of its distance from a point, or `most` where that is no less.
    pub(super) fn square_within(&self, p: Point, most: f64) -> f64 {
        let away = |bounds: &Rect| square(p, nearest_in(bounds, p));
        let mut least = most;
        for (bounds, run) in self.first(away).chain(self.runs()) {
            if away(bounds) < least {
                let squares = run.windows(2).map(|pair| point_square(pair[0], pair[1], p));
                least = squares.fold(least, f64::min);
            }
        }
        least
    }

    /// The point on it that is nearest to a point, the first of those that are.
    pub(super) fn nearest(&self, p: Point) -> Point {
        let mut best = self.points[0];
        let mut least = square(p, best);
        for (bounds, run) in self.runs() {
            if square(p, nearest_in(bounds, p)) < least {
                for q in run.windows(2).map(|pair| nearest_on(pair[0], pair[1], p)) {
                    if square(p, q) < least {
                        (best, least) = (q, square(p, q));
                    }
                }
            }
        }
        best
    }

    /// The square of its distance from a box, or `most` where that is no less; 0 where they touch.
    pub(super) fn square_from(&self, rect: &Rect, most: f64) -> f64 {
        let away = |bounds: &Rect| rect_square(rect, bounds);
        let mut least = most;
        for (bounds, run) in self.first(away).chain(self.runs()) {
            if away(bounds) < least {
                for pair in run.windows(2) {
                    if away(&Rect::new(pair[0], pair[1])) < least {
                        least = least.min(segment_square(rect, pair[0], pair[1]));
                    }
                }
            }
        }
        least
    }

    /// Whether it runs through a box, or touches it.
    pub(super) fn crosses(&self, rect: &Rect) -> bool {
        let near = self.runs().filter(|(bounds, _)| bounds.intersection(*rect).is_some());
        near.into_iter().any(|(_, run)| run.windows(2).any(|pair| touches(pair[0], pair[1], rect)))
    }

    /// Whether a point is inside, even-odd: whether a ray to the right crosses the closed line an odd number
    /// of times.
    pub(super) fn contains(&self, p: Point) -> bool {
        let mut inside = false;
        let is_level = |b: &Rect| b.y0 <= p.y && p.y < b.y1 && p.x <= b.x1;
        for pair in self.runs().filter(|(bounds, _)| is_level(bounds)).flat_map(|(_, run)| run.windows(2)) {
            let [a, b] = [pair[0], pair[1]];
            if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) {
                inside = !inside;
            }
        }
        inside
    }

    /// Where it crosses the way from `p` to `q`: the crossing that is nearest to `q`.
    pub(super) fn crossing(&self, p: Point, q: Point) -> Option<Point> {
        let (way, road) = (q - p, Rect::new(p, q));
        let cut = |pair: &[Point]| {
            let (d, e) = (pair[1] - pair[0], pair[0] - p);
            let area = way.cross(d);
            let (t, s) = (e.cross(d) / area, e.cross(way) / area);
            ((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&s)).then_some(t)
        };
        let near = self.runs().filter(|(bounds, _)| bounds.intersection(road).is_some());
        let cuts = near.flat_map(|(_, run)| run.windows(2)).filter_map(cut);
        cuts.max_by(f64::total_cmp).map(|t| p + way * t)
    }
}

/// The square of the distance of two points.
fn square(p: Point, q: Point) -> f64 {
    (p - q).square()
}

#[cfg(test)]
mod tests {
    use super::super::pole::tests::square;
    use super::super::rect::about;
    use super::*;

    /// A circle of 72 pieces, of radius 50 about (60, 60): nine runs.
    fn circle() -> Polyline {
        let at = |i: i32| f64::from(i) / 72.0 * std::f64::consts::TAU;
        let point = |i| Point::new(60.0 + 50.0 * libm::cos(at(i)), 60.0 + 50.0 * libm::sin(at(i)));
        Polyline::closed((0..72).map(point).collect()).unwrap()
    }

    /// Points all over the circle's box and beyond it.
    fn everywhere() -> impl Iterator<Item = Point> {
        (-2..15).flat_map(|i| (-2..15).map(move |j| Point::new(8.9 * f64::from(i), 9.1 * f64::from(j))))
    }

    #[test]
    fn runs_that_are_not_looked_at_change_no_answer() {
        let circle = circle();
        assert_eq!(circle.runs.len(), 9);
        for p in everywhere() {
            let to = circle.pieces().map(|(a, b)| point_square(a, b, p));
            let to = to.fold(f64::INFINITY, f64::min);
            assert_eq!(circle.square_within(p, f64::INFINITY), to);
            assert_eq!(circle.square_within(p, 0.5 * to), 0.5 * to);
            assert!(((p - circle.nearest(p)).square() - to).abs() < 1e-9);
            let rect = about(p, (14.0, 6.0));
            let from = circle.pieces().map(|(a, b)| segment_square(&rect, a, b));
            let from = from.fold(f64::INFINITY, f64::min);
            assert_eq!(circle.square_from(&rect, f64::INFINITY), from);
            assert_eq!(circle.crosses(&rect), from == 0.0);
            let off = libm::hypot(p.x - 60.0, p.y - 60.0);
            assert!((off - 50.0).abs() < 0.1 || circle.contains(p) == (off < 50.0), "{p:?}");
        }
    }

    #[test]
    fn a_way_out_of_an_area_crosses_its_line_where_it_leaves_it() {
        let area = Polyline::closed(square(10.0, 10.0, 80.0)).unwrap();
        let found = area.crossing(Point::new(50.0, 40.0), Point::new(130.0, 40.0)).unwrap();
        assert!((found - Point::new(90.0, 40.0)).length() < 1e-9, "{found:?}");
        assert_eq!(area.crossing(Point::new(50.0, 40.0), Point::new(60.0, 40.0)), None);
        assert_eq!(area.points().len(), 5, "the first point again at the end");
    }
}
