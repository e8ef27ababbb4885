//! The small square that says that two lines meet at a right angle.

use crate::drawing::{Contour, Role, Segment};
use crate::geometry::DVec2;

use super::{Cover, Pen, Sketch, Weight};

/// Edge of the square, page pixels: as long as an arrow's head.
const EDGE: f64 = 9.0;
/// The least length of either leg, page pixels: on a shorter one the square would be taken for a marker.
const LEG: f64 = 18.0;

impl Sketch<'_> {
    /// Draws the square of a right angle at a point of the panel's space, between its legs, the vectors `a`
    /// and `b` of that space; none where a leg is too short for it.
    pub(crate) fn right_angle(&mut self, at: DVec2, a: DVec2, b: DVec2) -> &mut Self {
        let p = self.frame.page(at);
        let legs = [a, b].map(|leg| self.frame.page(at + leg) - p);
        let [Some(u), Some(v)] = legs.map(|leg| leg.unit().filter(|_| leg.length() >= self.fitted(LEG)))
        else {
            return self;
        };
        let edge = self.fitted(EDGE);
        let [first, middle, last] = [p + u * edge, p + u * edge + v * edge, p + v * edge];
        let contour =
            Contour::Segments(vec![Segment::Move(first), Segment::Line(middle), Segment::Line(last)]);
        let weight = self.weight;
        self.weight(Weight::Light);
        self.push_stroked(contour, Pen::dimension(Role::Muted));
        for (from, to) in [(first, middle), (middle, last)] {
            self.keep_off(Cover::Stroke { from, to, half: 0.5 });
        }
        self.weight(weight)
    }
}
