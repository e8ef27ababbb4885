//! Path data of an SVG of ours as a contour: the letters M L H V Q C A Z, and m h v l q t c z in outlines of glyphs.

use std::f64::consts::{PI, TAU};

use crate::drawing::{Contour, Point, Segment};

/// From an element's coordinates to the page: scaled, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Map {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) scale: f64,
}

impl Default for Map {
    fn default() -> Self {
        Self { x: 0.0, y: 0.0, scale: 1.0 }
    }
}

impl Map {
    /// `translate(x y)scale(f)`.
    pub(super) fn read(text: &str) -> Option<Self> {
        let (place, scale) = text.strip_prefix("translate(")?.strip_suffix(')')?.split_once(")scale(")?;
        let (x, y) = place.split_once(' ')?;
        Some(Self { x: x.parse().ok()?, y: y.parse().ok()?, scale: scale.parse().ok()? })
    }

    /// What comes of an inner map, then this one.
    pub(super) fn then(self, inner: Self) -> Self {
        let Point { x, y } = self.point(inner.x, inner.y);
        Self { x, y, scale: self.scale * inner.scale }
    }

    pub(super) fn point(self, x: f64, y: f64) -> Point {
        Point::new(self.x + self.scale * x, self.y + self.scale * y)
    }
}

/// The contour of path data.
pub(super) fn contour(data: &str, map: Map) -> Option<Contour> {
    let mut pen = Pen { at: [0.0; 2], begin: [0.0; 2], control: None, map, segments: Vec::new() };
    let mut numbers = Numbers { rest: data };
    let mut letter = None;
    while let Some(next) = numbers.letter_or(letter) {
        pen.piece(next, &mut numbers)?;
        // What follows a move or a close without a letter of its own.
        letter = match next {
            'M' => Some('L'),
            'm' => Some('l'),
            'Z' | 'z' => None,
            other => Some(other),
        };
    }
    numbers.rest.is_empty().then_some(Contour::Segments(pen.segments))
}

/// The text that is not read yet.
struct Numbers<'t> {
    rest: &'t str,
}

impl Numbers<'_> {
    /// The next letter, or the one that goes on if a number comes.
    fn letter_or(&mut self, goes_on: Option<char>) -> Option<char> {
        let first = self.rest.chars().next()?;
        if !first.is_ascii_alphabetic() {
            return goes_on;
        }
        self.rest = &self.rest[1..];
        Some(first)
    }

    /// A number ends at a space, a letter, a sign, or a second point.
    fn next(&mut self) -> Option<f64> {
        let text = self.rest.trim_start_matches(' ');
        let mut points = 0;
        let end = text.char_indices().find(|&(i, c)| {
            points += u32::from(c == '.');
            !(c.is_ascii_digit() || (c == '.' && points == 1) || (c == '-' && i == 0))
        });
        let (number, rest) = text.split_at(end.map_or(text.len(), |(i, _)| i));
        self.rest = rest;
        number.parse().ok()
    }

    fn pair(&mut self, from: [f64; 2]) -> Option<[f64; 2]> {
        Some([from[0] + self.next()?, from[1] + self.next()?])
    }
}

struct Pen {
    at: [f64; 2],
    begin: [f64; 2],
    /// The control point of the last piece, if it was a quadratic curve.
    control: Option<[f64; 2]>,
    map: Map,
    segments: Vec<Segment>,
}

impl Pen {
    fn piece(&mut self, letter: char, numbers: &mut Numbers) -> Option<()> {
        let from = if letter.is_ascii_lowercase() { self.at } else { [0.0; 2] };
        let at = self.at;
        let control = self.control.take();
        match letter.to_ascii_uppercase() {
            'M' => {
                self.begin = numbers.pair(from)?;
                self.to(self.begin, Segment::Move);
            }
            'L' => self.to(numbers.pair(from)?, Segment::Line),
            'H' => self.to([from[0] + numbers.next()?, at[1]], Segment::Line),
            'V' => self.to([at[0], from[1] + numbers.next()?], Segment::Line),
            'Q' => self.quad(numbers.pair(from)?, numbers.pair(from)?),
            'T' => {
                let [cx, cy] = control.unwrap_or(at);
                self.quad([2.0 * at[0] - cx, 2.0 * at[1] - cy], numbers.pair(from)?);
            }
            'C' => {
                let (c, d) = (numbers.pair(from)?, numbers.pair(from)?);
                let (c, d) = (self.page(c), self.page(d));
                self.to(numbers.pair(from)?, |p| Segment::Cubic(c, d, p));
            }
            'A' => {
                let (radius, _, _) = (numbers.next()?, numbers.next()?, numbers.next()?);
                let (large, clockwise) = (numbers.next()?, numbers.next()?);
                let to = numbers.pair(from)?;
                self.arc(radius, large != 0.0, clockwise != 0.0, to);
            }
            'Z' => {
                self.at = self.begin;
                self.segments.push(Segment::Close);
            }
            _ => return None,
        }
        Some(())
    }

    fn page(&self, [x, y]: [f64; 2]) -> Point {
        self.map.point(x, y)
    }

    fn to(&mut self, p: [f64; 2], segment: impl FnOnce(Point) -> Segment) {
        self.segments.push(segment(self.page(p)));
        self.at = p;
    }

    fn quad(&mut self, c: [f64; 2], p: [f64; 2]) {
        let control = self.page(c);
        self.to(p, |p| Segment::Quad(control, p));
        self.control = Some(c);
    }

    /// The centre lies on the bisector of the chord, at √(r² − (chord / 2)²) from its middle (SVG 2, appendix B.2.4).
    fn arc(&mut self, radius: f64, large: bool, clockwise: bool, to: [f64; 2]) {
        let [dx, dy] = [0.5 * (to[0] - self.at[0]), 0.5 * (to[1] - self.at[1])];
        let half = libm::hypot(dx, dy);
        if half == 0.0 || radius == 0.0 {
            return self.to(to, Segment::Line);
        }
        let radius = radius.max(half);
        let off = libm::sqrt((radius - half) * (radius + half)) / half
            * if large == clockwise { -1.0 } else { 1.0 };
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
        assert_eq!(contour("M1 2x", Map::default()), None);
        assert_eq!(contour("M1", Map::default()), None);
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
}
