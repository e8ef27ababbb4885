//! Where world meets page: a similarity from a panel's space to page pixels, y up to y down.
//!
//! ```text
//! page(p) = middle + scale · (x, −y)   with (x, y) = pose⁻¹(p) − center
//! ```
//!
//! In a `body` panel the world is first brought into the frame of a body (pose⁻¹); elsewhere that is left
//! out.

use crate::drawing::{Point, Rect};
use crate::geometry::{DVec2, Pose};

/// What a panel shows, its smallest and largest coordinates in its own space; `None` where it shows nothing.
pub(crate) type Extent = Option<(DVec2, DVec2)>;

/// How far heads and ticks reach beyond the ends of lines, page pixels.
const ENDS: f64 = 7.0;

/// What holds both.
pub(crate) fn union(a: Extent, b: Extent) -> Extent {
    match (a, b) {
        (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
        (a, b) => a.or(b),
    }
}

/// Where a panel's space lies on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The pose of the body whose frame is shown; `None` for the world and for configuration space.
    pub(crate) pose: Option<Pose>,
    /// The point of the space at the middle of the panel, in its own units.
    pub(crate) center: DVec2,
    /// The middle of the panel, page pixels.
    pub(crate) middle: Point,
    /// Page pixels per unit of the space.
    pub(crate) scale: f64,
    /// The panel on the page, page pixels: nothing is drawn outside it.
    pub panel: Rect,
}

impl Frame {
    /// Shows the rectangle from `lo` to `hi`, in units of the space, as large as `panel` allows, and centred
    /// in it.
    pub(crate) fn fit(pose: Option<Pose>, lo: DVec2, hi: DVec2, panel: Rect) -> Self {
        let size = (hi - lo).max(DVec2::splat(f64::MIN_POSITIVE));
        let scale = (panel.width() / size.x).min(panel.height() / size.y);
        Self { pose, center: 0.5 * (lo + hi), middle: panel.center(), scale, panel }
    }

    /// Where a point of the panel's space lies on the page, in page pixels, y down.
    ///
    /// `p` is in world units, y up: a point of the world, in a `body` panel too, or of configuration space.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, geometry::DVec2, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1 }
    /// query = { kind = "bounds", of = ["A"] }
    /// panels = [{ space = "world", view = [-2, -1, 2, 1], layers = ["shapes"] }]
    /// "#;
    /// let scene = read(&Source::new("circle.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let frame = draw(&plan, plan.theme, "circle").panels[0].frame;
    /// let (middle, above) = (frame.page(DVec2::ZERO), frame.page(DVec2::Y));
    /// assert_eq!(middle, frame.panel.center());
    /// assert!(above.y < middle.y && above.x == middle.x);
    /// ```
    #[must_use]
    pub fn page(&self, p: DVec2) -> Point {
        let q = self.pose.map_or(p, |pose| pose.inverse_point(p)) - self.center;
        Point::new(self.middle.x + self.scale * q.x, self.middle.y - self.scale * q.y)
    }

    /// The smallest and largest coordinates that the panel shows, in its space (a body's own, in its panel).
    #[must_use]
    pub(crate) fn visible(&self) -> (DVec2, DVec2) {
        let half = DVec2::new(self.panel.width(), self.panel.height()) / (2.0 * self.scale);
        let off = self.panel.center() - self.middle;
        let center = self.center + DVec2::new(off.dx, -off.dy) / self.scale;
        (center - half, center + half)
    }

    /// Whether all that an extent reaches is in view, with what is at its ends.
    pub(crate) fn holds(&self, extent: Extent) -> bool {
        let ((lo, hi), edge) = (self.visible(), DVec2::splat(ENDS / self.scale));
        extent.is_none_or(|(from, to)| lo.cmple(from - edge).all() && to.cmple(hi - edge).all())
    }

    /// Angle of the shown body's frame in the world, radians, counter-clockwise; 0 in other panels.
    pub(crate) fn turn(&self) -> f64 {
        self.pose.map_or(0.0, |pose| libm::atan2(pose.rotation.sin, pose.rotation.cos))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Rotation;

    #[test]
    fn a_view_fills_its_panel_and_y_points_up() {
        let panel = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };
        let frame = Frame::fit(None, DVec2::ZERO, DVec2::new(10.0, 10.0), panel);
        assert_eq!(frame.page(DVec2::new(1.0, 2.0)), Point { x: 10.0, y: 80.0 });
    }

    #[test]
    fn a_body_panel_shows_the_body_upright_about_the_middle_of_its_view() {
        let panel = Rect { x0: 20.0, y0: 40.0, x1: 220.0, y1: 140.0 };
        let pose = Pose { position: DVec2::new(1.0, -2.0), rotation: Rotation { cos: 0.8, sin: 0.6 } };
        let frame = Frame::fit(Some(pose), DVec2::new(-3.0, -1.0), DVec2::new(3.0, 1.0), panel);
        for local in [DVec2::ZERO, DVec2::new(0.3, 0.75), DVec2::new(-3.0, 1.0)] {
            let (got, scale) = (frame.page(pose.point(local)), 200.0 / 6.0);
            let expected = Point::new(120.0 + scale * local.x, 90.0 - scale * local.y);
            assert!((got - expected).length() < 1e-12 * 120.0, "{local}: {got:?} {expected:?}");
        }
        assert!((frame.turn() - libm::atan2(0.6, 0.8)).abs() < 1e-15);
    }
}
