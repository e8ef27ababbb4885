//! What rounding alone may make of a distance: the numbers of a scene are the doubles nearest to those that
//! are written, so circles of radius 1 and 0.5 at (0, 0) and (1.2, 0.9) overlap by 2.2e-17 and are meant to
//! touch.
//!
//! A coordinate is off by half an ulp at most, ε/2 of it. What lies between two bodies is off by no more than
//! the sum of what their numbers are: both coordinates of each position and of the way until then, and of the
//! farthest vertex, which an angle of up to half a turn takes π times as far, and both radii.

use crate::geometry::{Body, DVec2};

use super::Query;

impl Query<'_> {
    /// How far the distance of the bodies at its time may be off by the rounding of the numbers that they are
    /// written in, world units; 0 for one body.
    pub(crate) fn rounding(&self) -> f64 {
        let all = self.b.map_or(0.0, |b| size(self.a, self.time) + size(b, self.time));
        0.5 * f64::EPSILON * all
    }
}

/// The sum of the numbers of a body that its place and outline depend on, world units.
fn size(body: &Body, time: f64) -> f64 {
    let both = |v: DVec2| v.x.abs() + v.y.abs();
    let reach = body.shape.vertices.iter().map(|&v| both(v)).fold(0.0, f64::max);
    let turned = 1.0 + std::f64::consts::PI + body.spin.radians().abs() * time;
    both(body.position) + both(body.velocity) * time + reach * turned + body.shape.radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{placed, polygon};
    use crate::collision::{Pair, QueryKind};

    #[test]
    fn circles_meant_to_touch_are_within_the_rounding_of_their_numbers_and_no_others() {
        let circles = |x: f64| {
            let (a, b) = (polygon(&[[0.0, 0.0]], 1.0), placed(polygon(&[[0.0, 0.0]], 0.5), x, 0.9, 0.0));
            let kind = QueryKind::Separation;
            let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
            (Pair::at(&a, &b, 0.0).separation().separation, query.rounding())
        };
        let (meant, rounding) = circles(1.2);
        assert!(meant != 0.0 && meant.abs() <= rounding && rounding < 1e-15, "{meant} {rounding}");
        let (apart, rounding) = circles(1.2 + 1e-14);
        assert!(apart > rounding, "{apart} {rounding}");
    }
}
