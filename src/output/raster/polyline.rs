//! Contours as chains of straight pieces, in image pixels.
//!
//! A Bézier curve is cut into n equal steps of its parameter. A chord is then off the curve by at most
//! d (d − 1) / 8 · M / n², with d the degree and M the largest second difference |P₀ − 2 P₁ + P₂| of the control points.
//! Source: G. Wang, *The subdivision method for finding the intersection between two Bézier curves or surfaces*, 1984.

use super::super::curves;
use crate::drawing::{Contour, Point, Segment};

/// How far a chord may be off its curve, in image pixels: one level of the sixteen that coverage has.
const FLATNESS: f64 = 1.0 / 16.0;

/// Most chords of one curve: enough for a circle across the largest image.
const MOST_CHORDS: f64 = 512.0;

/// Chains of points.
#[derive(Default)]
pub(super) struct Polylines {
    pub(super) points: Vec<Point>,
    /// Where each chain ends in `points`, and whether it goes back to its first point.
    pub(super) ends: Vec<(usize, bool)>,
}

impl Polylines {
    /// The contour's pieces, with points mapped to image pixels by `map`.
    pub(super) fn of(contour: &Contour, map: impl Fn(Point) -> Point) -> Self {
        let mut lines = Self::default();
        curves::pieces(contour, |segment| lines.segment(&segment, &map));
        lines.end(false);
        lines
    }

    /// Adds a piece.
    #[inline]
    pub(super) fn segment(&mut self, segment: &Segment, map: impl Fn(Point) -> Point) {
        match *segment {
            Segment::Move(p) => {
                self.end(false);
                self.points.push(map(p));
            }
            Segment::Line(p) => self.points.push(map(p)),
            Segment::Quad(c, p) => self.quad(map(c), map(p)),
            Segment::Cubic(c, d, p) => self.cubic(map(c), map(d), map(p)),
            Segment::Close => self.end(true),
            // `pieces` gives none.
            Segment::Arc { .. } => {}
        }
    }

    /// The chains, each with whether it is closed.
    pub(super) fn chains(&self) -> impl Iterator<Item = (&[Point], bool)> {
        let starts = std::iter::once(0).chain(self.ends.iter().map(|&(end, _)| end));
        starts.zip(&self.ends).map(|(start, &(end, closed))| (&self.points[start..end], closed))
    }

    pub(super) fn end(&mut self, closed: bool) {
        let end = self.points.len();
        if self.ends.last().map_or(0, |&(last, _)| last) < end {
            self.ends.push((end, closed));
        }
    }

    fn quad(&mut self, c: Point, p: Point) {
        let Some(&from) = self.points.last() else { return };
        let steps = chords(2.0 / 8.0, second_difference(from, c, p));
        self.steps(steps, p, |t| {
            let u = 1.0 - t;
            let (a, b, d) = (u * u, 2.0 * u * t, t * t);
            Point::new(a * from.x + b * c.x + d * p.x, a * from.y + b * c.y + d * p.y)
        });
    }

    fn cubic(&mut self, c: Point, d: Point, p: Point) {
        let Some(&from) = self.points.last() else { return };
        let steps = chords(6.0 / 8.0, second_difference(from, c, d).max(second_difference(c, d, p)));
        self.steps(steps, p, |t| {
            let u = 1.0 - t;
            let (a, b, e, f) = (u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t);
            Point::new(a * from.x + b * c.x + e * d.x + f * p.x, a * from.y + b * c.y + e * d.y + f * p.y)
        });
    }

    fn steps(&mut self, steps: f64, last: Point, at: impl Fn(f64) -> Point) {
        let mut i = 1.0;
        while i < steps {
            self.points.push(at(i / steps));
            i += 1.0;
        }
        self.points.push(last);
    }
}

fn second_difference(p: Point, q: Point, r: Point) -> f64 {
    let (x, y) = (p.x - 2.0 * q.x + r.x, p.y - 2.0 * q.y + r.y);
    libm::sqrt(x * x + y * y)
}

fn chords(factor: f64, difference: f64) -> f64 {
    libm::sqrt(factor * difference / FLATNESS).ceil().clamp(1.0, MOST_CHORDS)
}
