//! Dimension lines and bars: lengths that are read off, beside what they measure.

use crate::drawing::{Contour, Offset, Point};
use crate::geometry::DVec2;

use super::{Cover, Pen, SPECK, Sketch, Weight};

/// Length of the ticks of a thin dimension line, page pixels.
const TICK: f64 = 7.0;
/// Length of a tick in widths of its line, where that is more.
const TICK_PER_WIDTH: f64 = 3.2;
/// How far an extension line begins from the point that it extends, and ends beyond its dimension, page
/// pixels.
const EXTENSION_GAP: f64 = 3.0;

impl Sketch<'_> {
    /// Draws the length between points of the panel's space `offset` page pixels to the left of from → to,
    /// with ticks at its ends and extension lines to where it belongs.
    pub(crate) fn dimension(&mut self, from: DVec2, to: DVec2, offset: f64, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (p, q) = (self.frame.page(from), self.frame.page(to));
        // What is left at a contact has the direction of its rounding.
        let Some(u) = (q - p).unit().filter(|_| (q - p).length() >= SPECK) else { return self };
        let shift = u.left() * offset;
        let (a, b) = (p + shift, q + shift);
        self.reach_on_page(&[a, b]);
        self.extension(p, a);
        self.extension(q, b);
        self.page_ticked(a, b, u, pen);
        self
    }

    /// Draws a bar with ticks between points of the panel's space, `offset` page pixels to the left of from →
    /// to and without extension lines: a length that the figure is about.
    pub(crate) fn bar(&mut self, from: DVec2, to: DVec2, offset: f64, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (p, q) = (self.frame.page(from), self.frame.page(to));
        if let Some(u) = (q - p).unit() {
            let shift = u.left() * offset;
            self.reach_on_page(&[p + shift, q + shift]);
            self.page_ticked(p + shift, q + shift, u, pen);
        }
        self
    }

    /// Draws a line on the page with a tick at either end, square to the unit offset `u`.
    fn page_ticked(&mut self, a: Point, b: Point, u: Offset, pen: Pen) {
        let half = u.left() * (0.5 * self.fitted(TICK.max(TICK_PER_WIDTH * self.width(pen))));
        for (from, to) in [(a, b), (a + -half, a + half), (b + -half, b + half)] {
            self.push_stroked(Contour::line(from, to), pen);
            self.keep_off(Cover::Stroke { from, to, half: 0.5 * self.width(pen) });
        }
    }

    /// Draws a thin line on the page from a point to the end of its dimension, a little away from the one
    /// and beyond the other.
    fn extension(&mut self, from: Point, to: Point) {
        let gap = self.fitted(EXTENSION_GAP);
        let Some(u) = (to - from).unit().filter(|_| (to - from).length() > 2.0 * gap) else { return };
        let (a, b) = (from + u * gap, to + u * gap);
        let weight = self.weight;
        self.weight(Weight::Light);
        self.push_stroked(Contour::line(a, b), Pen::extension());
        self.keep_off(Cover::Stroke { from: a, to: b, half: 0.5 });
        self.weight(weight);
    }
}
