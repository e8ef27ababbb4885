//! Contours in world (or configuration) space: straight pieces and true arcs.
//!
//! A body is a convex core swept by a disc, so its outline is the core's edges moved outward by the radius,
//! joined by arcs about the core's vertices. A circle has one vertex and one arc of a full turn.

use std::f64::consts::TAU;

use crate::drawing::{Contour, Segment};
use crate::figure::frame::Frame;
use crate::geometry::{Body, DVec2, Pose, perp};

/// The longest piece of an arc that a chord may stand for when an outline is sampled: 5°. On a radius of 200
/// page pixels the chord is 0.2 px from the arc; twice the angle would show as kinks in label distances.
const SAMPLE_ANGLE: f64 = TAU / 72.0;

/// More than this no outline turns at a vertex, radians: a convex core turns by half a turn at most, at the
/// end of a segment, and what rounding makes of no turn is almost a whole one.
const MOST_OF_A_TURN: f64 = 0.75 * TAU;

/// A sweep without the turns after the first that add nothing to the picture: it ends at the same point, and
/// what draws it or samples it is done.
fn wound(sweep: f64) -> f64 {
    if sweep.abs() < 2.0 * TAU { sweep } else { (TAU + sweep.abs() % TAU).copysign(sweep) }
}

/// A piece of an outline, after the piece before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Piece {
    /// A straight line to this point.
    Line(DVec2),
    /// An arc of a circle, after a straight line to its start.
    Arc {
        /// Centre of the circle.
        center: DVec2,
        /// Radius of the circle, in units of the space.
        radius: f64,
        /// Where the arc starts, radians counter-clockwise from +x.
        start: f64,
        /// How far the arc runs, radians, counter-clockwise where positive.
        sweep: f64,
    },
}

/// A contour in world or configuration space.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Outline {
    /// The point where it begins.
    pub(crate) start: DVec2,
    /// The pieces that follow.
    pub(crate) pieces: Vec<Piece>,
    /// Whether it returns to its beginning, straight if need be.
    pub(crate) closed: bool,
}

/// The point of a circle at an angle in radians, counter-clockwise from +x.
#[must_use]
pub(crate) fn on_circle(center: DVec2, radius: f64, angle: f64) -> DVec2 {
    center + radius * DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The direction of a vector: radians in (−π, π], counter-clockwise from +x.
#[must_use]
pub(crate) fn angle_of(v: DVec2) -> f64 {
    libm::atan2(v.y, v.x)
}

impl Outline {
    /// An open line through `points`.
    #[must_use]
    pub(crate) fn polyline(points: &[DVec2]) -> Self {
        let start = points.first().copied().unwrap_or(DVec2::ZERO);
        Self { start, pieces: points.iter().skip(1).map(|&p| Piece::Line(p)).collect(), closed: false }
    }

    /// A closed line through `points`.
    #[must_use]
    pub(crate) fn polygon(points: &[DVec2]) -> Self {
        Self { closed: true, ..Self::polyline(points) }
    }

    /// A whole circle; `radius` in units of the space.
    #[must_use]
    pub(crate) fn circle(center: DVec2, radius: f64) -> Self {
        Self { closed: true, ..Self::arc(center, radius, 0.0, TAU) }
    }

    /// Part of a circle from `start` over `sweep`; angles in radians, counter-clockwise from +x.
    #[must_use]
    pub(crate) fn arc(center: DVec2, radius: f64, start: f64, sweep: f64) -> Self {
        let (first, sweep) = (on_circle(center, radius, start), wound(sweep));
        Self { start: first, pieces: vec![Piece::Arc { center, radius, start, sweep }], closed: false }
    }

    /// A slice of a disc from `start` over `sweep`: centre, arc, and back; angles in radians,
    /// counter-clockwise from +x.
    #[must_use]
    pub(crate) fn sector(center: DVec2, radius: f64, start: f64, sweep: f64) -> Self {
        let arc = Piece::Arc { center, radius, start, sweep: wound(sweep) };
        Self { start: center, pieces: vec![arc], closed: true }
    }

    /// A convex core swept by a disc: `core` are its vertices, counter-clockwise, and `radius` is in their
    /// units; 0 leaves the polygon itself.
    #[must_use]
    pub(crate) fn rounded(core: &[DVec2], radius: f64) -> Self {
        match core {
            [] => Self::polygon(core),
            [center] => Self::circle(*center, radius),
            _ if radius <= 0.0 => Self::polygon(core),
            _ => Self::offset(core, radius),
        }
    }

    /// A body as it stands in `pose`, in the world.
    #[must_use]
    pub(crate) fn of_body(body: &Body, pose: &Pose) -> Self {
        let shape = &body.shape;
        if shape.core.is_empty() {
            let all: Vec<_> = shape.vertices.iter().map(|&v| pose.point(v)).collect();
            return Self::polygon(&all);
        }
        let core: Vec<_> =
            shape.core.iter().filter_map(|&i| shape.vertices.get(i)).map(|&v| pose.point(v)).collect();
        Self::rounded(&core, shape.radius)
    }

    /// The outline elsewhere: every point moved by `by`, in units of the space.
    #[must_use]
    pub(crate) fn moved(&self, by: DVec2) -> Self {
        let piece = |piece: &Piece| match *piece {
            Piece::Line(p) => Piece::Line(p + by),
            Piece::Arc { center, radius, start, sweep } => {
                Piece::Arc { center: center + by, radius, start, sweep }
            }
        };
        Self { start: self.start + by, pieces: self.pieces.iter().map(piece).collect(), closed: self.closed }
    }

    /// The outline after half a turn about a point: x becomes 2 `about` − x.
    #[must_use]
    pub(crate) fn turned_about(&self, about: DVec2) -> Self {
        let turned = |p: DVec2| 2.0 * about - p;
        let piece = |piece: &Piece| match *piece {
            Piece::Line(p) => Piece::Line(turned(p)),
            Piece::Arc { center, radius, start, sweep } => {
                Piece::Arc { center: turned(center), radius, start: start + 0.5 * TAU, sweep }
            }
        };
        Self {
            start: turned(self.start),
            pieces: self.pieces.iter().map(piece).collect(),
            closed: self.closed,
        }
    }

    /// Points along the outline, close enough that chords stand for arcs; the first again at the end of a
    /// closed one.
    #[must_use]
    pub(crate) fn sampled(&self) -> Vec<DVec2> {
        let mut points = vec![self.start];
        for piece in &self.pieces {
            match *piece {
                Piece::Line(p) => points.push(p),
                Piece::Arc { center, radius, start, sweep } => {
                    let count = (sweep.abs() / SAMPLE_ANGLE).ceil().max(1.0);
                    let mut i = 0.0;
                    while i <= count {
                        points.push(on_circle(center, radius, start + sweep * i / count));
                        i += 1.0;
                    }
                }
            }
        }
        if self.closed {
            points.push(self.start);
        }
        points
    }

    /// The outline on the page, through a panel's map; arcs stay arcs.
    #[must_use]
    pub(crate) fn on_page(&self, frame: &Frame) -> Contour {
        if let ([Piece::Arc { center, radius, sweep, .. }], true) = (self.pieces.as_slice(), self.closed)
            && *sweep >= TAU
        {
            return Contour::Circle { center: frame.page(*center), radius: radius * frame.scale };
        }
        let mut segments = vec![Segment::Move(frame.page(self.start))];
        segments.extend(self.pieces.iter().map(|piece| match *piece {
            Piece::Line(p) => Segment::Line(frame.page(p)),
            Piece::Arc { center, radius, start, sweep } => Segment::Arc {
                center: frame.page(center),
                radius: radius * frame.scale,
                start: -(start - frame.turn()),
                sweep: -sweep,
            },
        }));
        if self.closed {
            segments.push(Segment::Close);
        }
        Contour::Segments(segments)
    }

    /// The edges of a convex core moved outward by `radius`, joined by arcs about its vertices.
    fn offset(core: &[DVec2], radius: f64) -> Self {
        let n = core.len();
        let normal = |i: usize| -perp(core[(i + 1) % n] - core[i]).normalize_or_zero();
        let mut pieces = Vec::with_capacity(2 * n);
        let start = core[0] + radius * normal(0);
        for i in 0..n {
            let vertex = core[(i + 1) % n];
            pieces.push(Piece::Line(vertex + radius * normal(i)));
            let from = angle_of(normal(i));
            let turn = angle_of(normal((i + 1) % n)) - from;
            let sweep = if turn < 0.0 { turn + TAU } else { turn };
            // Edges that go on in one line turn by nothing, or by rounding's little to the other side.
            if sweep > 0.0 && sweep < MOST_OF_A_TURN {
                pieces.push(Piece::Arc { center: vertex, radius, start: from, sweep });
            }
        }
        Self { start, pieces, closed: true }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Point, Rect};

    #[test]
    fn edges_that_go_on_in_one_line_have_no_arc_between_them() {
        let slanted = DVec2::new(0.1, 0.7);
        for (a, b) in [(DVec2::ZERO, DVec2::X), (DVec2::new(0.3, 0.2), slanted)] {
            let middle = a + (b - a) / 3.0;
            let core = [a, middle, b, a + (b - a) * 0.5 + perp(b - a)];
            let arcs = Outline::rounded(&core, 0.25).pieces.into_iter().filter_map(|piece| match piece {
                Piece::Arc { center, sweep, .. } if center != middle => Some(sweep),
                Piece::Arc { sweep, .. } => {
                    assert!(sweep < 1e-12, "{sweep}");
                    None
                }
                Piece::Line(_) => None,
            });
            assert!((arcs.sum::<f64>() - TAU).abs() < 1e-9);
        }
    }

    #[test]
    fn an_arc_of_many_turns_ends_where_it_ends_and_is_drawn_as_few() {
        let (start, sweep) = (0.3, -1000.25 * TAU);
        let arc = Outline::arc(DVec2::ZERO, 2.0, start, sweep);
        let points = arc.sampled();
        assert!(points.len() < 3 * 72);
        assert!(points.last().unwrap().distance(on_circle(DVec2::ZERO, 2.0, start + sweep)) < 1e-9);
    }

    #[test]
    fn a_rounded_outline_is_everywhere_its_radius_from_the_core() {
        let core = [DVec2::ZERO, DVec2::new(2.0, 0.0), DVec2::new(1.0, 1.5)];
        let n = core.len();
        let points = Outline::rounded(&core, 0.25).sampled();
        assert!(points.len() > 2 * n, "{points:?}");
        for p in points {
            let distance = (0..n)
                .map(|i| {
                    let (a, b) = (core[i], core[(i + 1) % n]);
                    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                    p.distance(a + t * (b - a))
                })
                .fold(f64::INFINITY, f64::min);
            assert!((distance - 0.25).abs() < 1e-12, "{p} is {distance} away");
        }
    }

    #[test]
    fn a_circle_is_one_arc_of_a_full_turn() {
        let circle = Outline::rounded(&[DVec2::ONE], 2.0);
        assert_eq!(circle.pieces, [Piece::Arc { center: DVec2::ONE, radius: 2.0, start: 0.0, sweep: TAU }]);
        assert!(circle.closed);
    }

    #[test]
    fn an_arc_on_the_page_begins_where_its_first_point_lies() {
        let panel = Rect { x0: 20.0, y0: 40.0, x1: 220.0, y1: 140.0 };
        let pose = Pose {
            position: DVec2::new(1.0, -2.0),
            rotation: crate::geometry::Rotation { cos: 0.8, sin: 0.6 },
        };
        let frame = Frame::fit(Some(pose), DVec2::new(-3.0, -1.0), DVec2::new(3.0, 1.0), panel);
        let (c, r, start, sweep) = (DVec2::new(0.5, 0.25), 2.0, 0.7, 1.1);
        let Contour::Segments(segments) = Outline::arc(c, r, start, sweep).on_page(&frame) else { panic!() };
        let Segment::Arc { center, radius, start: s, sweep: w } = segments[1] else { panic!() };
        for (angle, page) in [(start, s), (start + sweep, s + w)] {
            let expected = frame.page(on_circle(c, r, angle));
            let got = Point::new(center.x + radius * libm::cos(page), center.y + radius * libm::sin(page));
            assert!((expected.x - got.x).abs() + (expected.y - got.y).abs() < 1e-9, "{expected:?} {got:?}");
        }
    }

    #[test]
    fn directions_are_counted_counter_clockwise_from_the_x_axis() {
        assert_eq!(on_circle(DVec2::new(1.0, 2.0), 3.0, 0.0), DVec2::new(4.0, 2.0));
        assert_eq!(angle_of(DVec2::new(0.0, 2.0)), 0.25 * TAU);
    }

    #[test]
    fn a_capsule_has_two_straight_sides_and_two_half_circles() {
        let capsule = Outline::rounded(&[DVec2::ZERO, DVec2::X], 0.5);
        let sweeps: Vec<f64> = capsule
            .pieces
            .iter()
            .filter_map(|piece| match piece {
                Piece::Arc { sweep, .. } => Some(*sweep),
                Piece::Line(_) => None,
            })
            .collect();
        assert_eq!((capsule.pieces.len(), sweeps), (4, vec![0.5 * TAU; 2]));
    }
}
