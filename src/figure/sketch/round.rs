//! Circles, arcs, angle marks, sectors.

use crate::geometry::DVec2;

use super::super::outline::{Outline, on_circle};
use super::super::pen::{Pen, Wash};
use super::Sketch;

impl Sketch<'_> {
    /// A whole circle.
    pub fn circle(&mut self, center: DVec2, radius: f64, wash: Option<Wash>, pen: Option<Pen>) -> &mut Self {
        self.area(&Outline::circle(center, radius), wash, pen)
    }

    /// Part of a circle; angles in radians, counter-clockwise in the panel's space.
    pub fn arc(&mut self, center: DVec2, radius: f64, start: f64, sweep: f64, pen: Pen) -> &mut Self {
        self.stroke(&Outline::arc(center, radius, start, sweep), pen)
    }

    /// A slice of a disc.
    pub fn sector(&mut self, center: DVec2, radius: f64, start: f64, sweep: f64, wash: Wash) -> &mut Self {
        self.area(&Outline::sector(center, radius, start, sweep), Some(wash), None)
    }

    /// Part of a circle with a filled head at its end.
    pub fn arc_arrow(&mut self, center: DVec2, radius: f64, start: f64, sweep: f64, pen: Pen) -> &mut Self {
        let page_radius = self.on_page(radius);
        let head = self.head_length(pen, page_radius * sweep.abs());
        let turn = |px: f64| (px / page_radius).min(sweep.abs()).copysign(sweep);
        self.arc(center, radius, start, sweep - turn(0.6 * head), pen);
        // The head is a chord of the arc: it looks from where its base lies towards the end.
        let tip = self.frame.page(on_circle(center, radius, start + sweep));
        let base = self.frame.page(on_circle(center, radius, start + sweep - turn(head)));
        if let Some(u) = (tip - base).unit() {
            self.page_head(tip, u, head, pen);
        }
        self
    }

    /// The mark of the angle from `start` over `sweep` about a point, `radius_px` page pixels out.
    pub fn angle_mark(&mut self, at: DVec2, radius_px: f64, start: f64, sweep: f64, pen: Pen) -> &mut Self {
        let radius = self.px(radius_px);
        self.arc(at, radius, start, sweep, pen)
    }

    /// A disc of `radius_px` page pixels in the pen's colour: a dot that is no marker.
    pub fn dot(&mut self, at: DVec2, radius_px: f64, pen: Pen) -> &mut Self {
        self.reach(&[at]);
        let center = self.frame.page(at);
        self.page_dot(center, radius_px * self.unit, pen);
        self
    }
}
