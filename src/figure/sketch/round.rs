//! Circles and arcs.

use crate::geometry::DVec2;

use super::{Outline, Pen, Sketch, Wash, on_circle};

impl Sketch<'_> {
    /// Draws a whole circle of the panel's space, its area and its line each where it is given; `radius` in
    /// units of that space.
    pub(crate) fn circle(
        &mut self,
        center: DVec2,
        radius: f64,
        wash: Option<Wash>,
        pen: Option<Pen>,
    ) -> &mut Self {
        self.area(&Outline::circle(center, radius), wash, pen)
    }

    /// Draws part of a circle of the panel's space from `start` over `sweep`; angles in radians,
    /// counter-clockwise from +x.
    pub(crate) fn arc(&mut self, center: DVec2, radius: f64, start: f64, sweep: f64, pen: Pen) -> &mut Self {
        self.stroke(&Outline::arc(center, radius, start, sweep), pen)
    }

    /// Draws part of a circle of the panel's space with a filled head at its end; angles as for
    /// [`Sketch::arc`].
    pub(crate) fn arc_arrow(
        &mut self,
        center: DVec2,
        radius: f64,
        start: f64,
        sweep: f64,
        pen: Pen,
    ) -> &mut Self {
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
}
