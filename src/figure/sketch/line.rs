//! Lines, polygons, vectors.

use crate::drawing::{Contour, Offset, Point, Role};
use crate::geometry::DVec2;

use super::{Cover, Outline, Pen, Sketch};

/// Length of an arrowhead on a vector of 1.75 px, page pixels.
const HEAD_LENGTH: f64 = 9.0;
/// Width of that arrowhead across, page pixels.
const HEAD_WIDTH: f64 = 6.5;
/// How much a head grows for each pixel of the shaft above 1.75, page pixels.
const HEAD_GROWTH: f64 = 2.4;
/// The length of a vector, page pixels, below which its head is smaller: half of it, so that a shaft remains.
const SHORT: f64 = 14.0;
/// The length of a vector, page pixels, below which it is a dot: no direction can be seen.
const DOT: f64 = 6.0;
/// Radius of that dot, page pixels.
const DOT_RADIUS: f64 = 2.2;

impl Sketch<'_> {
    /// Draws the line of an outline of the panel's space, without its area.
    pub(crate) fn stroke(&mut self, outline: &Outline, pen: Pen) -> &mut Self {
        self.area(outline, None, Some(pen))
    }

    /// Draws a straight line between points of the panel's space.
    pub(crate) fn line(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        self.stroke(&Outline::polyline(&[from, to]), pen)
    }

    /// Draws a vector of the panel's space: a shaft that ends inside a filled head. Under 14 px the head is
    /// smaller, under 6 px it is a dot.
    pub(crate) fn arrow(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (tail, tip) = (self.frame.page(from), self.frame.page(to));
        self.page_arrow(tail, tip, pen, false);
        self
    }

    /// Draws a shaft with a head at both ends, between points of the panel's space.
    pub(crate) fn double_arrow(&mut self, from: DVec2, to: DVec2, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (tail, tip) = (self.frame.page(from), self.frame.page(to));
        self.page_arrow(tail, tip, pen, true);
        self
    }

    /// Draws a vector on the page; with `both`, a head at its tail too.
    pub(super) fn page_arrow(&mut self, tail: Point, tip: Point, pen: Pen, both: bool) {
        let shaft = tip - tail;
        let length = shaft.length();
        let Some(u) = shaft.unit().filter(|_| length >= DOT) else {
            self.page_dot(tail + shaft * 0.5, DOT_RADIUS, pen);
            return;
        };
        let head = self.head_length(pen, if both { 0.5 * length } else { length });
        let inset = u * (0.6 * head);
        let start = if both { tail + inset } else { tail };
        self.push_stroked(Contour::line(start, tip + -inset), pen);
        self.keep_off(Cover::Stroke { from: tail, to: tip, half: 0.5 * pen.width });
        self.page_head(tip, u, head, pen);
        if both {
            self.page_head(tail, -u, head, pen);
        }
    }

    /// Draws a filled head on the page with its point at `tip`, looking along the unit offset `u`.
    pub(super) fn page_head(&mut self, tip: Point, u: Offset, length: f64, pen: Pen) {
        let half = u.left() * (0.5 * length * HEAD_WIDTH / HEAD_LENGTH);
        let base = tip + u * -length;
        let paint = self.paint(pen.role).with_opacity(pen.opacity);
        self.keep_off(Cover::Head { at: tip + u * (-0.5 * length), radius: 0.5 * length });
        self.push_filled(Contour::polygon(&[tip, base + half, base + -half]), paint);
    }

    /// Draws a dot on the page; `radius` in page pixels.
    pub(super) fn page_dot(&mut self, center: Point, radius: f64, pen: Pen) {
        let paint = self.paint(pen.role).with_opacity(pen.opacity);
        self.keep_off(Cover::Marker { at: center, radius });
        self.push_filled(Contour::Circle { center, radius }, paint);
    }

    /// Length of a head on a shaft of `length` page pixels, page pixels.
    pub(super) fn head_length(&self, pen: Pen, length: f64) -> f64 {
        let usual = HEAD_LENGTH + HEAD_GROWTH * (pen.width - Pen::vector(Role::Ink).width).max(0.0);
        let share = if length < SHORT { 0.5 } else { 0.7 };
        (usual * self.unit).min(share * length)
    }
}
