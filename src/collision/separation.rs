//! Signed separation with proven bounds: the default for every pair of convex bodies.
//!
//! See [`super::certify`] for the proof; here it meets queries.

use super::certify::certify;
use super::pair::Pair;
use super::relative::Relative;
use super::{Query, Separation, difference, witness};
use crate::collision::Answer;
use crate::trace::{Event, Tracer};

/// Its word in a scene file.
pub(crate) const NAME: &str = "closest-features";

/// Answers a query for overlap or separation.
pub(crate) fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let found = Pair::at(query.a, query.b.unwrap_or(query.a), query.time).separation();
    if tracer.listens() {
        let pair = Relative::of(query);
        tracer.record(|| Event::Started { algorithm: NAME, at: pair.at });
        difference::record(&pair, tracer);
        witness::tell(&pair, &found, tracer);
    }
    tracer.record(|| Event::Finished { outcome: witness::word(found.separation) });
    witness::answer(query.kind, found)
}

impl Pair<'_> {
    /// Signed separation with its witnesses, in world units, negative inside.
    ///
    /// The bounds enclose the exact separation of the bodies as their doubles say it; see [`Pair::at`] for an example.
    #[must_use]
    pub fn separation(&self) -> Separation {
        certify(self, None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Body, DVec2, Degrees, Feature, Shape, shape::FieldValue};

    fn body(shape: Shape, position: (f64, f64), angle: f64) -> Body {
        let (velocity, spin) = (DVec2::ZERO, Degrees(0.0));
        Body { shape, position: DVec2::new(position.0, position.1), angle: Degrees(angle), velocity, spin }
    }

    fn square(half: f64) -> Shape {
        Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::splat(half)))]).unwrap()
    }

    fn circle(radius: f64) -> Shape {
        Shape::of_kind("circle", &[("radius", FieldValue::Number(radius))]).unwrap()
    }

    #[test]
    fn coincident_squares_have_depth_one_and_four_ties() {
        let (a, b) = (body(square(0.5), (0.0, 0.0), 30.0), body(square(0.5), (0.0, 0.0), 30.0));
        let found = Pair::at(&a, &b, 0.0).separation();
        assert_eq!((found.separation, found.bounds.lo, found.bounds.hi, found.ties), (-1.0, -1.0, -1.0, 4));
    }

    #[test]
    fn faces_that_touch_are_exactly_zero_apart() {
        let (a, b) = (body(square(0.5), (0.0, 0.0), 0.0), body(square(0.5), (1.0, 0.25), 0.0));
        let found = Pair::at(&a, &b, 0.0).separation();
        assert_eq!((found.separation, found.bounds.lo, found.bounds.hi), (0.0, 0.0, 0.0));
        assert_eq!((found.normal, found.features), (DVec2::X, [Feature::Edge(1), Feature::Edge(3)]));
        assert_eq!(found.points, [DVec2::new(0.5, 0.125); 2]);
    }

    #[test]
    fn circles_in_three_four_five_touch_exactly() {
        let (a, b) = (body(circle(2.0), (0.0, 0.0), 0.0), body(circle(3.0), (3.0, 4.0), 0.0));
        let found = Pair::at(&a, &b, 0.0).separation();
        assert_eq!((found.bounds.lo, found.bounds.hi, found.ties), (0.0, 0.0, 1));
    }

    #[test]
    fn concentric_circles_tie_in_all_directions() {
        let (a, b) = (body(circle(2.0), (1.0, 1.0), 0.0), body(circle(3.0), (1.0, 1.0), 7.0));
        let found = Pair::at(&a, &b, 0.0).separation();
        assert_eq!((found.separation, found.ties, found.normal), (-5.0, 0, DVec2::X));
    }
}
