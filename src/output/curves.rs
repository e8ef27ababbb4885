//! Circular arcs as Bézier curves, for formats that have no arcs.
//!
//! An arc of angle θ becomes a cubic whose control points lie (4/3) tan(θ/4) r along the tangents of its
//! ends. Its radial error is about (2/27) sin⁶(θ/4) / cos²(θ/4) r; with pieces of at most 45° that is
//! 4.3·10⁻⁶ r, 0.004 pixels on a circle as large as the largest page.
//! Source: M. Goldapp, *Approximation of circular arcs by cubic polynomials*, 1991.

use std::f64::consts::{FRAC_PI_4, TAU};

use crate::drawing::{Contour, Point, Segment};
use crate::typeset::{Outline, OutlineSegment};

/// Distance in page pixels under which an arc starts where the piece before it ends.
///
/// From 10⁻¹² to 0.02, all committed figures are the same. Below the rounding of sine and cosine a line
/// without length would stand before an arc; above a hundredth, the last digit of a place in a file, gaps
/// would stay open.
const TOUCH: f64 = 1e-6;

/// Gives `each` all pieces of a contour in order, a move first: arcs and circles become cubic curves.
pub(super) fn pieces(contour: &Contour, mut each: impl FnMut(Segment)) {
    match contour {
        Contour::Circle { center, radius } => {
            each(Segment::Move(at(*center, *radius, 0.0)));
            arc(*center, *radius, 0.0, TAU, &mut each);
            each(Segment::Close);
        }
        Contour::Segments(segments) => {
            let mut current: Option<Point> = None;
            for &segment in segments {
                let Segment::Arc { center, radius, start, sweep } = segment else {
                    current = end(&segment).or(current);
                    each(segment);
                    continue;
                };
                let from = at(center, radius, start);
                match current {
                    None => each(Segment::Move(from)),
                    Some(point) if !touches(point, from) => each(Segment::Line(from)),
                    Some(_) => {}
                }
                arc(center, radius, start, sweep, &mut each);
                current = Some(at(center, radius, start + sweep));
            }
        }
    }
}

/// Gives `each` all pieces of a glyph's outline in order, its points as `place` maps them.
pub(super) fn glyph(outline: &Outline, place: impl Fn(Point) -> Point, mut each: impl FnMut(Segment)) {
    let at = |p: [f32; 2]| place(Point::new(f64::from(p[0]), f64::from(p[1])));
    for segment in &outline.segments {
        each(match *segment {
            OutlineSegment::Move(p) => Segment::Move(at(p)),
            OutlineSegment::Line(p) => Segment::Line(at(p)),
            OutlineSegment::Quad(c, p) => Segment::Quad(at(c), at(p)),
            OutlineSegment::Cubic(c, d, p) => Segment::Cubic(at(c), at(d), at(p)),
            OutlineSegment::Close => Segment::Close,
        });
    }
}

/// Point of a circle at an angle in radians, from the x axis towards the y axis.
pub(super) fn at(center: Point, radius: f64, angle: f64) -> Point {
    Point::new(center.x + radius * libm::cos(angle), center.y + radius * libm::sin(angle))
}

/// Whether two points are one for the eye: closer than [`TOUCH`] in x and in y.
pub(super) fn touches(p: Point, q: Point) -> bool {
    (p.x - q.x).abs() <= TOUCH && (p.y - q.y).abs() <= TOUCH
}

/// End of a piece; `None` for [`Segment::Close`], which ends where its contour began.
pub(super) fn end(segment: &Segment) -> Option<Point> {
    match *segment {
        Segment::Move(p) | Segment::Line(p) | Segment::Quad(_, p) | Segment::Cubic(_, _, p) => Some(p),
        Segment::Arc { center, radius, start, sweep } => Some(at(center, radius, start + sweep)),
        Segment::Close => None,
    }
}

/// Gives `each` the cubic curves of an arc, without the move to its start; its angles are in radians.
fn arc(center: Point, radius: f64, start: f64, sweep: f64, each: &mut impl FnMut(Segment)) {
    let sweep = sweep.clamp(-TAU, TAU);
    let pieces = (sweep.abs() / FRAC_PI_4).ceil().max(1.0);
    let theta = sweep / pieces;
    let reach = 4.0 / 3.0 * libm::tan(0.25 * theta) * radius;
    let (mut i, mut angle) = (0.0, start);
    while i < pieces {
        i += 1.0;
        let next = start + theta * i;
        let (from, to) = (at(center, radius, angle), at(center, radius, next));
        let (c0, s0) = (libm::cos(angle), libm::sin(angle));
        let (c1, s1) = (libm::cos(next), libm::sin(next));
        each(Segment::Cubic(
            Point::new(from.x - reach * s0, from.y + reach * c0),
            Point::new(to.x + reach * s1, to.y - reach * c1),
            to,
        ));
        angle = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curves_of_an_arc_stay_on_its_circle() {
        let (center, radius) = (Point::new(3.0, -4.0), 1000.0);
        let contour = Contour::Segments(vec![Segment::Arc { center, radius, start: 0.3, sweep: -4.0 }]);
        let mut from = Point::default();
        let mut count = 0;
        pieces(&contour, |segment| match segment {
            Segment::Move(p) => from = p,
            Segment::Cubic(c, d, to) => {
                for i in 0..=16 {
                    let t = f64::from(i) / 16.0;
                    let u = 1.0 - t;
                    let mix = |a: f64, b: f64, c: f64, d: f64| {
                        u * u * u * a + 3.0 * u * u * t * b + 3.0 * u * t * t * c + t * t * t * d
                    };
                    let x = mix(from.x, c.x, d.x, to.x) - center.x;
                    let y = mix(from.y, c.y, d.y, to.y) - center.y;
                    assert!((libm::hypot(x, y) - radius).abs() < 5e-6 * radius, "{x} {y}");
                }
                from = to;
                count += 1;
            }
            other => panic!("{other:?}"),
        });
        assert_eq!(count, 6, "4 radians in pieces of at most 45°");
        assert!(touches(from, at(center, radius, -3.7)));
    }
}
