//! Signed separation with proven bounds: the default for every pair of convex bodies.
//!
//! See [`crate::collision::certified::distance::search`] for the proof; here it meets queries.

use crate::collision::Answer;
use crate::collision::Query;
use crate::collision::Separation;
use crate::collision::algorithm::candidate;
use crate::collision::algorithm::outline;
use crate::collision::algorithm::view::Relative;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::search::certify;
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "closest-features",
    about: "closest features of B - A, proved by supports and witnesses in double-doubles (Toussaint 1983)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    quiet: answer,
    traced: answer,
    ready: Some(|query| {
        let kind = query.kind;
        let pair = Pair::at(query.a, query.b.unwrap_or(query.a), query.time).refined();
        Box::new(move || candidate::answer(kind, pair.separation()))
    }),
};

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let found = Pair::at(query.a, query.b.unwrap_or(query.a), query.time).separation();
    if tracer.listens() {
        let pair = Relative::of(query);
        tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: pair.at });
        outline::record(&pair, tracer);
        candidate::tell(&pair, &found, tracer);
    }
    tracer.record(|| Event::Finished { outcome: found.word() });
    candidate::answer(query.kind, found)
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
        assert_eq!((*found.normal, found.features), (DVec2::X, [Feature::Edge(1), Feature::Edge(3)]));
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
        assert_eq!((found.separation, found.ties, *found.normal), (-5.0, 0, DVec2::X));
    }

    /// Random bodies: a polygon on an ellipse, a box, a capsule or a circle, rounded or not.
    struct Bodies(u64);

    impl Bodies {
        fn number(&mut self, lo: f64, hi: f64) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            #[expect(clippy::cast_precision_loss, reason = "a random number")]
            let unit = (self.0 >> 11) as f64 / (1u64 << 53) as f64;
            lo + (hi - lo) * unit
        }

        fn point(&mut self) -> DVec2 {
            DVec2::new(self.number(-2.0, 2.0), self.number(-2.0, 2.0))
        }

        fn shape(&mut self) -> Shape {
            let radius =
                FieldValue::Number(if self.number(0.0, 1.0) < 0.5 { 0.0 } else { self.number(0.0, 1.0) });
            let kind = self.number(0.0, 4.0);
            if kind < 1.0 {
                let center = FieldValue::Point(self.point());
                return Shape::of_kind("circle", &[("radius", radius), ("center", center)]).unwrap();
            }
            if kind < 2.0 {
                let points = FieldValue::Points(vec![self.point(), self.point()]);
                return Shape::of_kind("capsule", &[("radius", radius), ("points", points)]).unwrap();
            }
            if kind < 3.0 {
                let half = FieldValue::Point(self.point().abs() + DVec2::splat(0.01));
                return Shape::of_kind("box", &[("half_extents", half), ("radius", radius)]).unwrap();
            }
            let count = self.number(3.0, 20.0).floor();
            let mut vertices = Vec::new();
            let mut k = 0.0;
            while k < count {
                let angle = (k + self.number(-0.4, 0.4)) / count * std::f64::consts::TAU;
                vertices.push(DVec2::new(libm::cos(angle), 0.6 * libm::sin(angle)));
                k += 1.0;
            }
            Shape::of_kind("polygon", &[("vertices", FieldValue::Points(vertices)), ("radius", radius)])
                .unwrap()
        }

        fn pair(&mut self) -> [Body; 2] {
            [0, 1].map(|_| {
                let (shape, position) = (self.shape(), self.point());
                // Multiples of 30° half of the time: parallel and exact cases.
                let angle = self.number(-400.0, 400.0);
                let angle = if angle.abs() < 200.0 { (angle / 30.0).floor() * 30.0 } else { angle };
                body(shape, (position.x, position.y), angle)
            })
        }
    }

    fn found([a, b]: &[Body; 2]) -> Separation {
        Pair::at(a, b, 0.0).separation()
    }

    fn meet(x: &Separation, y: &Separation, factor: f64) -> bool {
        x.bounds.lo * factor <= y.bounds.hi && y.bounds.lo <= x.bounds.hi * factor
    }

    #[test]
    fn exchanging_the_bodies_changes_nothing_but_the_sign_of_the_normal() {
        let mut bodies = Bodies(1);
        for round in 0..2000 {
            let [a, b] = bodies.pair();
            let (one, two) = (found(&[a.clone(), b.clone()]), found(&[b, a]));
            assert!(meet(&one, &two, 1.0), "{round}: {one:?} {two:?}");
            assert_eq!(one.ties, two.ties, "{round}");
            if one.ties == 1 {
                assert!((*one.normal + *two.normal).length() < 1e-14, "{round}: {one:?} {two:?}");
            }
        }
    }

    #[test]
    fn a_quarter_turn_and_a_power_of_two_of_everything_keep_the_answer() {
        let mut bodies = Bodies(2);
        for round in 0..1000 {
            let pair = bodies.pair();
            let one = found(&pair);
            let turned = pair.clone().map(|body| Body {
                position: crate::geometry::perp(body.position),
                angle: Degrees(body.angle.0 + if body.angle.0 < 0.0 { 90.0 } else { -270.0 }),
                ..body
            });
            // The sum of degrees may round: then the bodies are others.
            if turned.iter().zip(&pair).all(|(t, p)| (t.angle.0 - p.angle.0).rem_euclid(360.0) == 90.0) {
                let two = found(&turned);
                assert!(meet(&one, &two, 1.0), "{round}: {one:?} {two:?}");
            }
        }
    }

    #[test]
    fn tiny_and_huge_scenes_have_the_same_answer_scaled() {
        let mut bodies = Bodies(3);
        for exponent in [-900, -300, 300, 800_i32] {
            let factor = libm::scalbn(1.0, exponent);
            for round in 0..200 {
                let pair = bodies.pair();
                let scaled = pair.clone().map(|body| {
                    let vertices: Vec<DVec2> = body.shape.vertices.iter().map(|v| *v * factor).collect();
                    let hull =
                        crate::geometry::Hull::new(body.shape.core.iter().map(|&k| vertices[k]).collect());
                    let radius = body.shape.radius * factor;
                    let shape = Shape { vertices, radius, hull, ..body.shape };
                    Body { shape, position: body.position * factor, ..body }
                });
                let (one, two) = (found(&pair), found(&scaled));
                assert!(meet(&one, &two, factor), "{exponent} {round}: {one:?} {two:?}");
                assert!(two.bounds.hi - two.bounds.lo <= 1e-14 * factor, "{exponent} {round}: {two:?}");
            }
        }
    }

    #[test]
    fn the_quick_proof_and_the_full_search_agree() {
        let mut bodies = Bodies(4);
        let mut quick = 0;
        for round in 0..2000 {
            let [a, b] = bodies.pair();
            let pair = Pair::at(&a, &b, 0.0);
            let (one, two) =
                (pair.separation(), crate::collision::certified::distance::search::settle(&pair, None));
            assert!(meet(&one, &two, 1.0) && one.ties == two.ties, "{round}: {one:?} {two:?}");
            assert_eq!(one.features, two.features, "{round}");
            quick += usize::from(crate::collision::certified::distance::filter::proved(&pair).is_some());
        }
        assert!(quick > 1200, "{quick} of 2000 were proved quickly");
    }
}
