//! The one place where world meets page: a similarity from a panel's space to page pixels, y up to y down.
//!
//! In a `body` panel the world is first brought into the frame of a body.

use crate::drawing::{Contour, Point, Rect, Segment};
use crate::geometry::{DVec2, Pose};

use super::outline::{Outline, Piece, angle_of};

/// Where a panel's space lies on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The body whose frame is shown; none for the world and for configuration space.
    pub pose: Option<Pose>,
    /// The point of the space at the middle of the panel.
    pub center: DVec2,
    /// The middle of the panel, page pixels.
    pub middle: Point,
    /// Page pixels per unit.
    pub scale: f64,
    /// The panel: nothing is drawn outside it.
    pub panel: Rect,
}

impl Frame {
    /// Shows the rectangle `lo`, `hi` of the space as large as `panel` allows, centred.
    #[must_use]
    pub fn fit(pose: Option<Pose>, lo: DVec2, hi: DVec2, panel: Rect) -> Self {
        let size = (hi - lo).max(DVec2::splat(f64::MIN_POSITIVE));
        let scale = (panel.width() / size.x).min(panel.height() / size.y);
        Self { pose, center: 0.5 * (lo + hi), middle: panel.center(), scale, panel }
    }

    /// A point of the space (of the world, in a `body` panel), on the page.
    ///
    /// ```
    /// use tracefig::{drawing::{Point, Rect}, figure::Frame, geometry::DVec2};
    /// let panel = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };
    /// let frame = Frame::fit(None, DVec2::ZERO, DVec2::new(10.0, 10.0), panel);
    /// assert_eq!(frame.page(DVec2::new(1.0, 2.0)), Point { x: 10.0, y: 80.0 });
    /// ```
    #[must_use]
    pub fn page(&self, p: DVec2) -> Point {
        let q = self.pose.map_or(p, |pose| pose.inverse_point(p)) - self.center;
        Point::new(self.middle.x + self.scale * q.x, self.middle.y - self.scale * q.y)
    }

    /// The point of the space (of the world, in a `body` panel) at a page point.
    #[must_use]
    pub fn space(&self, p: Point) -> DVec2 {
        let q = self.center + DVec2::new(p.x - self.middle.x, self.middle.y - p.y) / self.scale;
        self.pose.map_or(q, |pose| pose.point(q))
    }

    /// A contour of the space, on the page; arcs stay arcs.
    #[must_use]
    pub fn contour(&self, outline: &Outline) -> Contour {
        if let ([Piece::Arc { center, radius, sweep, .. }], true) =
            (outline.pieces.as_slice(), outline.closed)
            && *sweep >= std::f64::consts::TAU
        {
            return Contour::Circle { center: self.page(*center), radius: radius * self.scale };
        }
        let mut segments = vec![Segment::Move(self.page(outline.start))];
        segments.extend(outline.pieces.iter().map(|piece| match *piece {
            Piece::Line(p) => Segment::Line(self.page(p)),
            Piece::Arc { center, radius, start, sweep } => Segment::Arc {
                center: self.page(center),
                radius: radius * self.scale,
                start: -(start - self.turn()),
                sweep: -sweep,
            },
        }));
        if outline.closed {
            segments.push(Segment::Close);
        }
        Contour::Segments(segments)
    }

    /// Angle of the shown body's frame in the world, radians; 0 in other panels.
    fn turn(&self) -> f64 {
        self.pose.map_or(0.0, |pose| angle_of(DVec2::new(pose.rotation.cos, pose.rotation.sin)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::on_circle;
    use crate::geometry::Rotation;

    fn frame() -> Frame {
        let panel = Rect { x0: 20.0, y0: 40.0, x1: 220.0, y1: 140.0 };
        let pose = Pose { position: DVec2::new(1.0, -2.0), rotation: Rotation { cos: 0.8, sin: 0.6 } };
        Frame::fit(Some(pose), DVec2::new(-3.0, -1.0), DVec2::new(3.0, 1.0), panel)
    }

    #[test]
    fn page_and_space_undo_each_other() {
        let p = DVec2::new(0.3, 4.5);
        assert!(frame().space(frame().page(p)).distance(p) < 1e-12);
    }

    #[test]
    fn an_arc_begins_where_its_first_point_lies() {
        let (c, r, start, sweep) = (DVec2::new(0.5, 0.25), 2.0, 0.7, 1.1);
        let Contour::Segments(segments) = frame().contour(&Outline::arc(c, r, start, sweep)) else {
            panic!()
        };
        let Segment::Arc { center, radius, start: s, sweep: w } = segments[1] else { panic!() };
        for (angle, page) in [(start, s), (start + sweep, s + w)] {
            let expected = frame().page(on_circle(c, r, angle));
            let got = Point::new(center.x + radius * libm::cos(page), center.y + radius * libm::sin(page));
            assert!((expected.x - got.x).abs() + (expected.y - got.y).abs() < 1e-9, "{expected:?} {got:?}");
        }
    }
}
