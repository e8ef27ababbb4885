//! Bodies and queries that no scene has: nothing is said of them.

use crate::collision::{ALGORITHMS, MovingPair, Outcome, Pair, Query, QueryKind, Reason, Sweep};
use crate::geometry::shape::FieldValue;
use crate::geometry::{Angle, Body, DVec2, Shape};

/// A box that flies at a wall, and reaches it.
fn flying() -> [Body; 2] {
    let square = Shape::rectangle(DVec2::ONE).unwrap();
    let flies = Body { velocity: 10.0 * DVec2::X, ..Body::at_rest(square.clone(), DVec2::ZERO) };
    [flies, Body::at_rest(square, DVec2::new(6.0, 0.0))]
}

/// Says nothing of a pair, whoever is called A.
fn is_open(a: &Body, b: &Body) {
    for [a, b] in [[a, b], [b, a]] {
        let open = Outcome::Unresolved { reason: Reason::NotFinite, free_until: 0.0 };
        let nothing = |outcome: Outcome| outcome == open;
        assert!(nothing(Sweep::new(a, b).first_contact()), "{a:?} {b:?}");
        assert!(nothing(MovingPair::new(a, b).first_contact(1e-9, 100).outcome), "{a:?} {b:?}");
        let found = Pair::at(a, b, 0.0).separation();
        assert_eq!((found.bounds.lo, found.bounds.hi), (f64::NEG_INFINITY, f64::INFINITY), "{a:?} {b:?}");
        for kind in [QueryKind::Separation, QueryKind::Contact, QueryKind::TimeOfImpact] {
            let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 1e-9, max_iterations: 100 };
            assert_eq!(query.answer(), None, "{query:?}");
        }
    }
}

#[test]
fn of_numbers_that_are_not_finite_nothing_is_said() {
    let [body, wall] = flying();
    assert!(matches!(Sweep::new(&body, &wall).first_contact(), Outcome::Hit { .. }));
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut round = body.clone();
        round.shape.radius = wrong;
        let all = [
            Body { position: DVec2::new(wrong, 0.0), ..body.clone() },
            Body { velocity: DVec2::new(10.0, wrong), ..body.clone() },
            Body { angle: Angle::Radians(wrong), ..body.clone() },
            Body { spin: Angle::Degrees(wrong), ..body.clone() },
            round,
        ];
        for body in &all {
            is_open(body, &wall);
        }
        assert_eq!(Pair::at(&body, &wall, wrong).separation().bounds.hi, f64::INFINITY, "at {wrong}");
    }
    for tolerance in [f64::NAN, -1.0] {
        let found = MovingPair::new(&body, &wall).first_contact(tolerance, 100).outcome;
        assert!(matches!(found, Outcome::Unresolved { reason: Reason::NotFinite, .. }), "{tolerance}");
    }
}

#[test]
fn of_an_outline_nothing_is_said() {
    let [_, wall] = flying();
    let bent = [(0., 0.), (2., 0.), (1., 0.5), (1., 2.)].map(DVec2::from).to_vec();
    let outline = Shape::of_kind("outline", &[("vertices", FieldValue::Points(bent))]).unwrap();
    is_open(&Body::at_rest(outline, DVec2::ZERO), &wall);
}

#[test]
fn an_algorithm_answers_no_query_that_it_does_not_take() {
    let [a, b] = flying();
    let mut answered = 0;
    for kind in [QueryKind::Bounds, QueryKind::Separation, QueryKind::TimeOfImpact, QueryKind::MotionBound] {
        for other in [None, Some(&b)] {
            let query = Query { kind, a: &a, b: other, time: 0.0, tolerance: 1e-9, max_iterations: 100 };
            for algorithm in ALGORITHMS {
                let found = algorithm.answer(&query);
                assert_eq!(found.is_some(), algorithm.takes(&query), "{} of {query:?}", algorithm.name);
                assert_eq!(found, algorithm.answer_traced(&query).map(|(answer, _)| answer));
                answered += usize::from(found.is_some());
            }
            let needs_two = matches!(kind, QueryKind::Separation | QueryKind::TimeOfImpact);
            assert_eq!(query.answer().is_none(), needs_two && other.is_none(), "{query:?}");
        }
    }
    assert!(answered > 10, "{answered}");
}
