//! Dimension lines and bars: lengths that are read off, beside what they measure.

use crate::drawing::{Contour, Offset, Point};
use crate::geometry::DVec2;

use super::{Cover, Pen, Sketch, Weight};

/// Length of a dimension's ticks, page pixels; wider lines have longer ones.
const TICK: f64 = 7.0;
/// Length of a tick per pixel of the line's width, where that is more.
const TICK_PER_WIDTH: f64 = 3.2;
/// An extension line begins this far from the point it extends and ends so far beyond its dimension, page pixels.
const EXTENSION_GAP: f64 = 3.0;

impl Sketch<'_> {
    /// A length, drawn `offset` page pixels to the left of from → to, with dashed extension lines to where it belongs.
    pub(crate) fn dimension(&mut self, from: DVec2, to: DVec2, offset: f64, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (p, q) = (self.frame.page(from), self.frame.page(to));
        let Some(u) = (q - p).unit() else { return self };
        let shift = u.left() * offset;
        let (a, b) = (p + shift, q + shift);
        self.extension(p, a);
        self.extension(q, b);
        self.page_ticked(a, b, u, pen);
        self
    }

    /// A thick bar with ticks, without extension lines: a length that the figure is about.
    pub(crate) fn bar(&mut self, from: DVec2, to: DVec2, offset: f64, pen: Pen) -> &mut Self {
        self.reach(&[from, to]);
        let (p, q) = (self.frame.page(from), self.frame.page(to));
        if let Some(u) = (q - p).unit() {
            let shift = u.left() * offset;
            self.page_ticked(p + shift, q + shift, u, pen);
        }
        self
    }

    fn page_ticked(&mut self, a: Point, b: Point, u: Offset, pen: Pen) {
        let half = u.left() * (0.5 * self.fitted(TICK.max(TICK_PER_WIDTH * pen.width)));
        for (from, to) in [(a, b), (a + -half, a + half), (b + -half, b + half)] {
            self.push_stroked(Contour::line(from, to), pen);
            self.keep_off(Cover::Stroke { from, to, half: 0.5 * pen.width });
        }
    }

    /// A dashed line from a point to the end of its dimension, a little away from the one and beyond the other.
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
