//! The marks of a pattern as lines, so that every format draws the same ones.
//!
//! Both patterns are the lines x + y = k s √2 for whole k, at 45°, a distance s apart; dots are dashes
//! without length on them. Their phase is the page's, so that the marks of two areas agree where they meet.

use super::{Cap, Pattern, PatternKind, Point, Rect, Stroke};

/// Distance between the lines of a pattern, in page pixels. At a third of a figure's size, lines of 1 px
/// still have gaps; with half the distance they would be grey there, with twice it a small shape would hold a
/// line or two.
const SPACING: f64 = 7.0;

/// Width of a hatch line, in page pixels: it covers a seventh of its area. At twice that it would be as wide
/// as the outlines of shapes, at half of it as faint as the grid.
const HATCH_WIDTH: f64 = 1.0;

/// Diameter of a dot, in page pixels: dots cover π/4 · 2.2² / 7² = 8 % of their area. At twice that they
/// would cover 31 % and hide what is below, at half of it 2 %.
const DOT_DIAMETER: f64 = 2.2;

/// Length of the dash that makes a dot: above 0, as a dash without length is dropped by some renderers.
const DOT_DASH: f64 = 0.01;

/// The largest page of a scene: marks beyond it are on no page, and an area seen from very near has millions
/// of them.
const PAGE: Rect = Rect { x0: 0.0, y0: 0.0, x1: 4096.0, y1: 4096.0 };

impl Pattern {
    /// The lines over what of `area` can be on a page, which is at most 4096 pixels wide and high, and how
    /// each is drawn. They are to be cut to the contour that they fill.
    ///
    /// ```
    /// use tracefig::drawing::{Color, Paint, Pattern, PatternKind, Rect, Role};
    /// let hatch = Pattern { kind: PatternKind::Hatch, paint: Paint::role(Role::A, Color::hex(0)) };
    /// let (lines, stroke) = hatch.marks(Rect { x0: 0.0, y0: 0.0, x1: 70.0, y1: 70.0 });
    /// assert!(lines.iter().all(|(p, q)| ((p.x + p.y) - (q.x + q.y)).abs() < 1e-9));
    /// assert_eq!((lines.len(), stroke.width), (15, 1.0));
    /// ```
    #[must_use]
    pub fn marks(&self, area: Rect) -> (Vec<(Point, Point)>, Stroke) {
        let Some(area) = area.intersection(PAGE) else { return (Vec::new(), self.stroke()) };
        let step = SPACING * std::f64::consts::SQRT_2;
        // Starting heights on a multiple of half a step put the dots of all lines on one grid.
        let (top, bottom) = (area.y0, (area.y1 / (0.5 * step)).ceil() * 0.5 * step);
        let mut lines = Vec::new();
        let mut k = ((area.x0 + area.y0) / step).ceil();
        while k * step <= area.x1 + area.y1 {
            lines.push((Point::new(k * step - bottom, bottom), Point::new(k * step - top, top)));
            k += 1.0;
        }
        (lines, self.stroke())
    }

    /// How each line of [`Pattern::marks`] is drawn.
    pub(crate) fn stroke(&self) -> Stroke {
        let paint = self.paint;
        match self.kind {
            PatternKind::Hatch => Stroke::solid(paint, HATCH_WIDTH),
            PatternKind::Dots => {
                let dash = vec![DOT_DASH, SPACING - DOT_DASH];
                Stroke { paint, width: DOT_DIAMETER, dash, cap: Cap::Round }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Color, Paint, Role};

    #[test]
    fn an_area_seen_from_very_near_has_no_more_marks_than_a_page() {
        let hatch = Pattern { kind: PatternKind::Hatch, paint: Paint::role(Role::A, Color::hex(0)) };
        let near = Rect { x0: -1e6, y0: -1e6, x1: 1e6, y1: 1e6 };
        assert_eq!(hatch.marks(near), hatch.marks(PAGE));
        assert!(hatch.marks(Rect { x0: -9.0, y0: -9.0, x1: -1.0, y1: -1.0 }).0.is_empty());
    }
}
