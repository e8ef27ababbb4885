//! What must hold of the filter of sweeps: on pairs that nobody chose, and on hard ones.

use crate::collision::answer::Outcome;
use crate::collision::certified::distance::Pair;
use crate::collision::certified::sweep::heading::Heading;
use crate::collision::certified::sweep::ray::Entry;
use crate::collision::certified::sweep::{Sweep, balls, filter};
use crate::collision::tests::bodies::{Bodies, boxed, moving, placed, polygon};
use crate::collision::tests::hard_pairs::{hard_pairs, span};

/// What the filter alone says of a pair at t = 0.
fn filtered(pair: &Pair) -> Option<Entry> {
    Heading::of(pair).and_then(|heading| filter::entry(pair, &heading))
}

#[test]
fn doubles_prove_most_rays_and_say_what_balls_say() {
    let (mut bodies, mut decided, count) = (Bodies::new(11), 0, 3000);
    for k in 0..count {
        let (a, b) = bodies.flying_pair(0.0);
        let pair = Pair::refined_at(&a, &b, 0.0);
        let Some(entry) = filtered(&pair) else { continue };
        match (entry, balls::entry(&pair)) {
            (Entry::Misses, Entry::Misses) => {}
            (Entry::At { feature, time, .. }, Entry::At { feature: same, time: proved, .. }) => {
                assert_eq!(feature, same, "{k}");
                let is_outside = time.hi < 0.0 || time.lo >= 1.0;
                let holds = time.lo <= proved.lo && proved.hi <= time.hi;
                assert!(time == proved || (is_outside && holds), "{k}: {feature:?}");
            }
            (entry, proved) => panic!("{k}: {entry:?}, but {proved:?}"),
        }
        decided += 1;
    }
    assert!(decided * 10 >= count * 9, "{decided} of {count}");
}

/// A pair asked with the filter and without it.
fn both_ways(sweep: &Sweep) -> [Outcome; 2] {
    [sweep.first_contact(), Sweep { heading: None, ..*sweep }.first_contact()]
}

fn assert_the_same(name: &str, [with, without]: &[Outcome; 2]) {
    assert_eq!(with.word(), without.word(), "{name}: {with:?} {without:?}");
    let ((lo, hi), (from, to)) = (span(with), span(without));
    assert!(lo <= to && from <= hi, "{name}: {with:?} {without:?}");
    if let (Outcome::Hit { time, contact: x }, Outcome::Hit { time: same, contact: y }) = (with, without)
        && time == same
    {
        let overlap = x.bounds.lo <= y.bounds.hi && y.bounds.lo <= x.bounds.hi;
        assert!(overlap, "{name}: {with:?} {without:?}");
    }
}

#[test]
fn without_the_filter_verdicts_are_the_same_and_bounds_overlap() {
    let (mut bodies, mut hits) = (Bodies::new(31), 0);
    for _ in 0..3_000 {
        let (a, b) = bodies.flying_pair(0.0);
        let outcomes = both_ways(&Sweep::new(&a, &b));
        assert_the_same(&format!("{a:?} {b:?}"), &outcomes);
        hits += i32::from(matches!(outcomes[0], Outcome::Hit { .. }));
    }
    assert!(hits > 300, "{hits}");
}

#[test]
fn without_the_filter_hard_cases_are_answered_as_truly() {
    let (mut cases, mut decided) = (0, 0);
    for case in hard_pairs(37, 1_600).filter(|case| case.is_linear) {
        let sweep = Sweep::new(&case.a, &case.b);
        let outcomes = both_ways(&sweep);
        assert_the_same(&case.name, &outcomes);
        assert!(case.bears_out(&outcomes[1]), "{}: {outcomes:?}", case.name);
        let is_another = span(&outcomes[0]) != span(&outcomes[1]);
        assert!(!is_another || case.bears_out(&outcomes[0]), "{}: {outcomes:?}", case.name);
        cases += 1;
        decided += i32::from(filtered(&sweep.pair).is_some());
    }
    assert!(cases > 300 && decided > 100, "{decided} of {cases}");
}

#[test]
fn a_box_that_all_but_slides_along_a_wall_meets_it_when_balls_say_so() {
    // The box comes nearer by 1e-4 to 1e-12 of what it slides: of the closing speed in doubles that leaves as
    // few digits.
    let wall = placed(polygon(&[[0.0, -4.0], [0.0, 4.0]], 0.0), 0.0, 0.0, 180.0);
    let (mut bodies, mut decided) = (Bodies::new(41), 0);
    for k in 0..800 {
        let speed = libm::exp10(-4.0 - 8.0 * bodies.roll());
        let slide = 1.0 + bodies.roll();
        let reach = 1.125 * std::f64::consts::FRAC_1_SQRT_2;
        let a = placed(boxed("box", 1.0, 0.125), -reach - 0.5 * speed, -0.5 * slide, 45.0);
        let a = moving(a, [speed, slide], 0.0);
        for (x, y) in [(&a, &wall), (&wall, &a)] {
            let sweep = Sweep::new(x, y);
            assert_the_same(&format!("{k}, {speed:e}"), &both_ways(&sweep));
            decided += i32::from(filtered(&sweep.pair).is_some());
        }
    }
    assert!(decided > 1_000, "{decided} of 1,600");
}
