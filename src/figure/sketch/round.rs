//! Circles, arcs, angle marks, sectors.

use crate::geometry::DVec2;

use super::{Outline, Pen, Sketch, Wash, on_circle};

impl Sketch<'_> {
    /// A whole circle.
    pub(crate) fn circle(
        &mut self,
        center: DVec2,
        radius: f64,
        wash: Option<Wash>,
        pen: Option<Pen>,
    ) -> &mut Self {
        self.area(&Outline::circle(center, radius), wash, pen)
    }

    /// Part of a circle; angles in radians, counter-clockwise in the panel's space.
    pub(crate) fn arc(&mut self, center: DVec2, radius: f64, start: f64, sweep: f64, pen: Pen) -> &mut Self {
        self.stroke(&Outline::arc(center, radius, start, sweep), pen)
    }

    /// Part of a circle with a filled head at its end.
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
