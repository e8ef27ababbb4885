//! What must hold of the filter of separations: on pairs that nobody chose, and on hard ones.

use crate::collision::answer::Separation;
use crate::collision::certified::distance::{Pair, filter, settle};
use crate::collision::tests::bodies::{Bodies, boxed, placed, polygon};
use crate::collision::tests::hard_pairs::hard_resting_pairs;
use crate::geometry::{DVec2, perp};

/// A pair asked with the filter and without it.
fn both_ways(pair: &Pair) -> [Separation; 2] {
    [pair.separation(), settle(pair, None)]
}

fn assert_the_same(name: &str, [with, without]: &[Separation; 2]) {
    let overlap = with.bounds.lo <= without.bounds.hi && without.bounds.lo <= with.bounds.hi;
    assert!(overlap && with.ties == without.ties, "{name}: {with:?} {without:?}");
    assert!(with.ties != 1 || with.features == without.features, "{name}: {with:?} {without:?}");
}

#[test]
fn without_the_filter_separations_are_the_same_and_bounds_overlap() {
    let (mut bodies, mut decided) = (Bodies::new(4), 0);
    for round in 0..2_000 {
        let [a, b] = bodies.resting_pair();
        let pair = Pair::at(&a, &b, 0.0);
        let found = both_ways(&pair);
        assert_the_same(&format!("{round}"), &found);
        assert_eq!(found[0].features, found[1].features, "{round}");
        decided += i32::from(filter::proved(&pair).is_some());
    }
    assert!(decided > 1_200, "the filter would be idle: {decided} of 2000");
}

#[test]
fn without_the_filter_hard_cases_are_answered_as_truly() {
    let (mut cases, mut decided) = (0, 0);
    for case in hard_resting_pairs(41, 3_000) {
        let pair = Pair::at(&case.a, &case.b, case.time);
        let found = both_ways(&pair);
        assert_the_same(&case.name, &found);
        assert!(found.iter().all(|s| case.is_enclosed_by(s.bounds)), "{}: {found:?}", case.name);
        cases += 1;
        decided += i32::from(filter::proved(&pair).is_some());
    }
    assert!(cases > 1_000 && decided > 300, "{decided} of {cases}");
}

#[test]
fn bodies_of_many_vertices_are_answered_alike_without_the_filter() {
    let (mut bodies, mut decided) = (Bodies::new(42), 0);
    for round in 0..400 {
        let (a, b) = (bodies.of_many_vertices(9 + round), bodies.of_many_vertices(3 + round / 2));
        let pair = Pair::at(&a, &b, 0.0);
        assert_the_same(&format!("{round}"), &both_ways(&pair));
        decided += i32::from(filter::proved(&pair).is_some());
    }
    assert!(decided > 360, "the filter would be idle: {decided} of 400");
}

#[test]
fn what_the_filter_says_of_touching_pairs_is_as_tight_as_it_promises() {
    let (mut near, mut refused) = (0, 0);
    let a = placed(boxed("box", 1.0, 1.0), 0.0, 0.0, 30.0);
    let n = a.pose_at(0.0).vector(DVec2::X);
    for k in 0..4_000 {
        // A disc some roundings from an edge of A, or that much inside.
        let gap = f64::from(k - 2_000) * 0.05 * f64::EPSILON;
        let apart = n * (2.0 + gap) + perp(n) * (f64::from(k) / 8_000.0);
        let b = placed(polygon(&[[0.0, 0.0]], 1.0), apart.x, apart.y, 0.0);
        let pair = Pair::at(&a, &b, 0.0);
        let size = pair.magnitude * f64::EPSILON;
        match filter::proved(&pair) {
            Some(found) => {
                let width = found.bounds.hi - found.bounds.lo;
                let separation = found.separation.abs();
                // Twice 8 ε, and the last place on either side.
                assert!(width <= 18.0 * f64::EPSILON * separation, "{k}: {width:e} of {separation:e}");
                near += i32::from(separation < 100.0 * size);
            }
            None => refused += 1,
        }
    }
    assert!(near > 1_000 && refused > 10, "{near} near and {refused} refused");
}
