//! Path data of an SVG of ours as a contour.
//!
//! `svgtypes` reads the letters and the numbers. Ours is what becomes of them: pieces in page pixels, an arc
//! as an arc about its centre, and refusal of what our writer never writes (`S`).

use std::f64::consts::{PI, TAU};

use svgtypes::{PathParser, PathSegment, Transform};

use crate::drawing::{Contour, Point, Segment};

/// From an element's coordinates to the page: scaled, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Map {
    /// Page x of the element's origin, in pixels.
    pub(super) x: f64,
    /// Page y of the element's origin, in pixels.
    pub(super) y: f64,
    /// Page pixels for a unit of the element.
    pub(super) scale: f64,
}

impl Default for Map {
    fn default() -> Self {
        Self { x: 0.0, y: 0.0, scale: 1.0 }
    }
}

impl Map {
    /// A `transform` that moves and scales; `None` for one that turns, skews or stretches, which we do not
    /// write.
    pub(super) fn read(text: &str) -> Option<Self> {
        let Transform { a, b, c, d, e, f } = text.parse().ok()?;
        (a == d && b == 0.0 && c == 0.0).then_some(Self { x: e, y: f, scale: a })
    }

    /// What comes of an inner map, then this one.
    pub(super) fn then(self, inner: Self) -> Self {
        let Point { x, y } = self.point(inner.x, inner.y);
        Self { x, y, scale: self.scale * inner.scale }
    }

    /// The page point of an element's point.
    pub(super) fn point(self, x: f64, y: f64) -> Point {
        Point::new(self.x + self.scale * x, self.y + self.scale * y)
    }
}

/// The contour of path data; `None` where it is broken, or has a piece that we do not write.
pub(super) fn contour(data: &str, map: Map) -> Option<Contour> {
    let mut pen = Pen { at: [0.0; 2], begin: [0.0; 2], control: None, map, segments: Vec::new() };
    for piece in PathParser::from(data) {
        pen.piece(piece.ok()?)?;
    }
    Some(Contour::Segments(pen.segments))
}

/// Follows path data; its points are the element's, its segments the page's.
struct Pen {
    /// Where the last piece ended.
    at: [f64; 2],
    /// Where the last move went: a close comes back here.
    begin: [f64; 2],
    /// The control point of the last piece, if it was a quadratic curve.
    control: Option<[f64; 2]>,
    /// From the element to the page.
    map: Map,
    /// The contour so far.
    segments: Vec<Segment>,
}

impl Pen {
    /// Adds one piece; `None` where we do not write its like.
    fn piece(&mut self, piece: PathSegment) -> Option<()> {
        let control = self.control.take();
        let at = self.at;
        let [left, top] = if piece.is_abs() { [0.0; 2] } else { at };
        let point = |x: f64, y: f64| [left + x, top + y];
        match piece {
            PathSegment::MoveTo { x, y, .. } => {
                self.begin = point(x, y);
                self.to(self.begin, Segment::Move);
            }
            PathSegment::LineTo { x, y, .. } => self.to(point(x, y), Segment::Line),
            PathSegment::HorizontalLineTo { x, .. } => self.to([left + x, at[1]], Segment::Line),
            PathSegment::VerticalLineTo { y, .. } => self.to([at[0], top + y], Segment::Line),
            PathSegment::Quadratic { x1, y1, x, y, .. } => self.quad(point(x1, y1), point(x, y)),
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let [cx, cy] = control.unwrap_or(at);
                self.quad([2.0 * at[0] - cx, 2.0 * at[1] - cy], point(x, y));
            }
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                let (c, d) = (self.page(point(x1, y1)), self.page(point(x2, y2)));
                self.to(point(x, y), |p| Segment::Cubic(c, d, p));
            }
            PathSegment::EllipticalArc { rx, ry, large_arc, sweep, x, y, .. } if rx == ry => {
                self.arc(rx, large_arc, sweep, point(x, y));
            }
            PathSegment::ClosePath { .. } => {
                self.at = self.begin;
                self.segments.push(Segment::Close);
            }
            PathSegment::SmoothCurveTo { .. } | PathSegment::EllipticalArc { .. } => return None,
        }
        Some(())
    }

    /// The page point of an element's point.
    fn page(&self, [x, y]: [f64; 2]) -> Point {
        self.map.point(x, y)
    }

    /// Adds a segment that ends at a point.
    fn to(&mut self, p: [f64; 2], segment: impl FnOnce(Point) -> Segment) {
        self.segments.push(segment(self.page(p)));
        self.at = p;
    }

    /// Adds a quadratic curve and keeps its control point for the next one.
    fn quad(&mut self, c: [f64; 2], p: [f64; 2]) {
        let control = self.page(c);
        self.to(p, |p| Segment::Quad(control, p));
        self.control = Some(c);
    }

    /// Adds an arc by its ends. The centre lies on the bisector of the chord, at √(r² − (chord / 2)²) from
    /// its middle (SVG 2, appendix B.2.4).
    fn arc(&mut self, radius: f64, large: bool, clockwise: bool, to: [f64; 2]) {
        let [dx, dy] = [0.5 * (to[0] - self.at[0]), 0.5 * (to[1] - self.at[1])];
        let half = libm::hypot(dx, dy);
        if half == 0.0 || radius == 0.0 {
            return self.to(to, Segment::Line);
        }
        let radius = radius.max(half);
        let off =
            ((radius - half) * (radius + half)).sqrt() / half * if large == clockwise { -1.0 } else { 1.0 };
        let center = [self.at[0] + dx - off * dy, self.at[1] + dy + off * dx];
        let angle = |p: [f64; 2]| libm::atan2(p[1] - center[1], p[0] - center[0]);
        let start = angle(self.at);
        let mut sweep = angle(to) - start;
        if clockwise && sweep < 0.0 {
            sweep += TAU;
        } else if !clockwise && sweep > 0.0 {
            sweep -= TAU;
        }
        debug_assert!(sweep.abs() <= TAU && (large || sweep.abs() <= PI + 1e-6));
        let (center, radius) = (self.page(center), radius * self.map.scale);
        self.to(to, |_| Segment::Arc { center, radius, start, sweep });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(data: &str) -> Vec<Segment> {
        let Some(Contour::Segments(segments)) = contour(data, Map::default()) else { panic!("{data}") };
        segments
    }

    #[test]
    fn numbers_without_a_space_between_are_told_apart() {
        let p = Point::new;
        let want = [Segment::Move(p(1.5, 0.25)), Segment::Line(p(-3.0, 4.0)), Segment::Line(p(-3.0, -0.5))];
        assert_eq!(read("M1.5 .25-3 4V-.5"), want);
        for broken in ["M1 2x", "M1", "M1 2S3 4 5 6", "M1 2A3 4 0 0 1 5 6"] {
            assert_eq!(contour(broken, Map::default()), None, "{broken}");
        }
    }

    #[test]
    fn relative_letters_start_from_the_last_point() {
        let p = Point::new;
        let got = read("m10 10h5v-5q2 0 2 2t2 2z");
        assert_eq!(got[1..3], [Segment::Line(p(15.0, 10.0)), Segment::Line(p(15.0, 5.0))]);
        assert_eq!(
            got[3..],
            [
                Segment::Quad(p(17.0, 5.0), p(17.0, 7.0)),
                Segment::Quad(p(17.0, 9.0), p(19.0, 9.0)),
                Segment::Close
            ]
        );
    }

    #[test]
    fn an_arc_has_its_centre_again() {
        for (sweep, data) in [(1.0, "M20 10A10 10 0 0 1 10 20"), (-1.0, "M10 20A10 10 0 0 0 20 10")] {
            let Segment::Arc { center, radius, sweep: got, .. } = read(data)[1] else { panic!("no arc") };
            assert!((center.x - 10.0).abs() < 1e-12 && (center.y - 10.0).abs() < 1e-12, "{center:?}");
            assert_eq!(radius, 10.0);
            assert!((got - sweep * std::f64::consts::FRAC_PI_2).abs() < 1e-12, "{got}");
        }
    }

    #[test]
    fn a_map_moves_and_scales_and_nothing_else() {
        assert_eq!(Map::read("translate(10 -.5)scale(.016)"), Some(Map { x: 10.0, y: -0.5, scale: 0.016 }));
        for other in ["rotate(3)", "scale(2 3)", "skewX(3)", "translate(1", ""] {
            assert_eq!(Map::read(other).filter(|_| !other.is_empty()), None, "{other}");
        }
    }
}
