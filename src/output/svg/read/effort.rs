//! What it costs to draw a path that was read, before it is drawn.
//!
//! Measured at two pixels for a page pixel: a line takes 0.3 µs for each page pixel of its length, an area a
//! quarter of that for its outline, whatever either is made of; a cubic curve that is drawn as a line takes
//! 1.3 KB while that is made, a straight line 80 bytes.

use crate::drawing::{Contour, Path, Point, Rect, Segment};

/// Pieces of all contours, each with its weight. The largest figure has 250,000 points. At twice as many,
/// drawing takes half of the memory that a scene may take.
pub(super) const MOST_PIECES: usize = 2_000_000;
/// Length of all lines on the page, in page pixels; it takes a second. Figures have some 100,000.
pub(super) const MOST_LENGTH: f64 = 3e6;

/// Pieces that a dash counts as: both its ends are round.
const DASH: f64 = 8.0;
/// What of a line's cost the outline of an area has.
const AREA: f64 = 0.25;

/// What has been asked for so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Effort {
    /// Pieces of contours, by weight.
    pub(super) pieces: f64,
    /// Length of lines on the page, in page pixels.
    pub(super) length: f64,
}

impl Effort {
    /// Adds what a path on a page takes.
    pub(super) fn add(&mut self, path: &Path, page: Rect) {
        let measured = measure(&path.contour, page);
        if path.fill.is_some() || path.pattern.is_some() {
            self.pieces += measured.weight / 8.0;
            self.length += AREA * measured.on_page;
        }
        if let Some(stroke) = &path.stroke {
            self.pieces += measured.weight;
            self.length += measured.on_page;
            let period: f64 = stroke.dash.iter().sum();
            if !stroke.dash.is_empty() {
                self.pieces += DASH * measured.whole / period.max(f64::MIN_POSITIVE);
            }
        }
        // What is not a number is on no page, which is told when it is to be drawn.
        self.pieces += measured.count;
    }
}

/// A contour's measures.
#[derive(Default)]
struct Measured {
    /// How many pieces it has.
    count: f64,
    /// Pieces by what they cost as a line; a straight one is 1.
    weight: f64,
    /// Its length, in page pixels, by its control points.
    whole: f64,
    /// What of its length can be on the page.
    on_page: f64,
}

impl Measured {
    fn add(&mut self, weight: f64, length: f64, bounds: Rect, page: Rect) {
        // A piece that turns no more than once around does not pass the sides of its box more than twice.
        let seen = bounds.intersection(page).map_or(0.0, |r| 2.0 * (r.x1 - r.x0 + r.y1 - r.y0));
        self.count += 1.0;
        self.weight += weight;
        self.whole += length;
        self.on_page += length.min(seen);
    }
}

fn measure(contour: &Contour, page: Rect) -> Measured {
    let mut measured = Measured::default();
    let around = |c: Point, r: f64| Rect { x0: c.x - r, y0: c.y - r, x1: c.x + r, y1: c.y + r };
    match contour {
        Contour::Circle { center, radius } => {
            measured.add(32.0, std::f64::consts::TAU * radius, around(*center, *radius), page);
        }
        Contour::Segments(segments) => {
            let (mut at, mut begin) = (Point::new(0.0, 0.0), Point::new(0.0, 0.0));
            for segment in segments {
                let (weight, points) = match *segment {
                    Segment::Move(p) => {
                        (at, begin) = (p, p);
                        continue;
                    }
                    Segment::Line(p) => (1.0, vec![p]),
                    Segment::Quad(c, p) => (8.0, vec![c, p]),
                    Segment::Cubic(c, d, p) => (16.0, vec![c, d, p]),
                    Segment::Close => (1.0, vec![begin]),
                    Segment::Arc { center, radius, start, sweep } => {
                        let angle = start + sweep;
                        at = Point::new(
                            center.x + radius * libm::cos(angle),
                            center.y + radius * libm::sin(angle),
                        );
                        measured.add(16.0, radius * sweep.abs(), around(center, radius), page);
                        continue;
                    }
                };
                let mut bounds = around(at, 0.0);
                let mut length = 0.0;
                for p in points {
                    length += libm::hypot(p.x - at.x, p.y - at.y);
                    bounds = bounds.union(around(p, 0.0));
                    at = p;
                }
                measured.add(weight, length, bounds, page);
            }
        }
    }
    measured
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Color, Paint, Role, Stroke};

    const PAGE: Rect = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };

    fn effort(contour: Contour, dash: &[f64]) -> Effort {
        let stroke =
            Stroke { dash: dash.to_vec(), ..Stroke::solid(Paint::role(Role::A, Color::hex(0)), 1.0) };
        let mut effort = Effort::default();
        effort.add(&Path::stroked(contour, stroke), PAGE);
        effort
    }

    #[test]
    fn lines_count_by_their_length_on_the_page() {
        let p = Point::new;
        assert_eq!(effort(Contour::line(p(10.0, 10.0), p(40.0, 50.0)), &[]).length, 50.0);
        let far = effort(Contour::line(p(-1e6, 50.0), p(1e6, 50.0)), &[]);
        assert_eq!(far.length, 200.0);
        assert_eq!(effort(Contour::line(p(-9.0, -9.0), p(-1.0, -1.0)), &[]).length, 0.0);
        let circle = effort(Contour::Circle { center: p(50.0, 50.0), radius: 1e7 }, &[]);
        assert_eq!(circle.length, 400.0);
    }

    #[test]
    fn dashes_count_each() {
        let line = Contour::line(Point::new(0.0, 5.0), Point::new(100.0, 5.0));
        assert_eq!(effort(line.clone(), &[2.0, 3.0]).pieces, 2.0 + 8.0 * 20.0);
        assert!(effort(line.clone(), &[0.0, 1e-9]).pieces > 1e9);
        assert!(effort(line, &[0.0]).pieces > 1e9);
    }
}
