//! What must hold of the filter of the time of impact: on pairs that nobody chose, and on hard ones.

use crate::collision::answer::{Impact, Outcome};
use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::closest::closest_features;
use crate::collision::certified::impact::filter::gap_series::{Instant, TurnedGap, rounding};
use crate::collision::certified::impact::limits::Limits;
use crate::collision::certified::impact::{MovingPair, filter};
use crate::collision::tests::bodies::Bodies;
use crate::collision::tests::hard_pairs::{hard_pairs, span};

/// Calls `visit` with pairs, the axis of their closest features at some moment, and that moment.
fn each_axis(seed: u64, most: f64, mut visit: impl FnMut(&MovingPair, Axis, f64, &mut Bodies)) {
    let mut bodies = Bodies::new(seed);
    for _ in 0..2_000 {
        let (a, b) = bodies.flying_pair(most);
        let pair = MovingPair::new(&a, &b);
        let t = bodies.roll();
        if let Some(axis) = Axis::through(&pair, closest_features(&pair, t).0, t) {
            visit(&pair, axis, t, &mut bodies);
        }
    }
}

fn gap(pair: &MovingPair, axis: &Axis, t: f64) -> Option<TurnedGap> {
    axis.turned_gap(pair, &Instant::new(pair, t), axis.facing)
}

#[test]
fn the_series_follows_the_gap_to_the_fifth_order() {
    let (mut seen, mut worst) = (0, 0.0_f64);
    each_axis(11, 400.0, |pair, axis, t, bodies| {
        let rates = pair.rate[0].abs() + pair.rate[1].abs();
        let h = 0.01 * (bodies.roll() - 0.5) / rates.max(1.0);
        let (Some(now), Some(then)) = (gap(pair, &axis, t), gap(pair, &axis, t + h)) else { return };
        if now.lowest != then.lowest {
            return;
        }
        let told = now.series(pair, axis.owner).iter().rev().fold(0.0, |sum, c| sum * h + c);
        // (0.015)⁵ / 120 of lengths about 10.
        worst = worst.max((told - then.value).abs() / pair.rounding.max(1e-10));
        seen += 1;
    });
    assert!(seen > 1_000 && worst < 1.0, "{seen} {worst}");
}

#[test]
fn no_gap_bends_more_than_its_bound_and_some_as_much() {
    let mut most = 0.0_f64;
    each_axis(14, 200.0, |pair, axis, t, bodies| {
        let later = (t + 0.1 * bodies.roll()).min(1.0);
        let (Some(from), Some(to)) = (gap(pair, &axis, t), gap(pair, &axis, later)) else { return };
        let bound = from.curvature(&to, pair, axis.owner);
        for now in (0..=20).filter_map(|k| gap(pair, &axis, t + (later - t) * f64::from(k) / 20.0)) {
            let [_, _, half, ..] = now.series(pair, axis.owner);
            assert!(2.0 * half <= bound, "{half} {bound} {from:?} {to:?}");
            most = most.max(2.0 * half / bound);
        }
    });
    assert!(most > 0.95, "the bound would be idle: {most}");
}

#[test]
fn a_gap_that_is_proved_open_is_open_between() {
    let (mut proved, mut open) = (0, 0);
    each_axis(12, 200.0, |pair, axis, t, bodies| {
        let later = (t + 0.3 * bodies.roll()).min(1.0);
        let (Some(from), Some(to)) = (gap(pair, &axis, t), gap(pair, &axis, later)) else { return };
        let least = (0..=200)
            .filter_map(|k| gap(pair, &axis, t + (later - t) * f64::from(k) / 200.0))
            .map(|gap| gap.value)
            .fold(f64::INFINITY, f64::min);
        if from.stays_open(&to, pair, axis.owner, rounding(pair)) {
            assert!(least > 0.0, "{least} {from:?} {to:?}");
            proved += 1;
        }
        open += i32::from(least > 0.0);
    });
    assert!(proved > 400 && 3 * proved > 2 * open, "the proof would be idle: {proved} of {open}");
}

/// A pair asked with the filter and without it, at the tolerance of scenes that name none.
fn both_ways(pair: &MovingPair) -> [Impact; 2] {
    let limits = Limits { tolerance: 1e-12, max_queries: 10_000 };
    [pair.first_contact(1e-12, 10_000), pair.first_contact_by_search(limits, 0, |_| ())]
}

/// Whether the filter alone decides a pair.
fn is_filtered(pair: &MovingPair) -> bool {
    let limits = Limits { tolerance: 1e-12, max_queries: 10_000 };
    filter::first_contact(pair, limits, |_| ()).outcome.is_some()
}

fn assert_the_same(name: &str, [with, without]: &[Outcome; 2]) {
    assert_eq!(with.word(), without.word(), "{name}: {with:?} {without:?}");
    let ((lo, hi), (from, to)) = (span(with), span(without));
    assert!(lo <= to && from <= hi, "{name}: {with:?} {without:?}");
}

#[test]
fn without_the_filter_verdicts_are_the_same_and_bounds_overlap() {
    let mut bodies = Bodies::new(13);
    let (mut decided, mut hits) = (0, 0);
    for k in 0..2_000 {
        let most = if k % 4 == 0 { 3_000.0 } else { 500.0 };
        let (a, b) = bodies.flying_pair(most);
        let pair = MovingPair::new(&a, &b);
        let outcomes = both_ways(&pair).map(|impact| impact.outcome);
        assert_the_same(&format!("{a:?} {b:?}"), &outcomes);
        decided += i32::from(is_filtered(&pair));
        hits += i32::from(matches!(outcomes[0], Outcome::Hit { .. }));
    }
    assert!(decided > 1_200 && hits > 200, "the filter would be idle: {decided} {hits}");
}

#[test]
fn without_the_filter_hard_cases_are_answered_as_truly() {
    let (mut cases, mut decided) = (0, 0);
    for case in hard_pairs(29, 800).filter(|case| !case.is_linear) {
        let pair = MovingPair::new(&case.a, &case.b);
        let outcomes = both_ways(&pair).map(|impact| impact.outcome);
        assert_the_same(&case.name, &outcomes);
        assert!(case.bears_out(&outcomes[1]), "{}: {outcomes:?}", case.name);
        let is_another = span(&outcomes[0]) != span(&outcomes[1]);
        assert!(!is_another || case.bears_out(&outcomes[0]), "{}: {outcomes:?}", case.name);
        cases += 1;
        decided += i32::from(is_filtered(&pair));
    }
    assert!(decided > 50 && cases > 300, "{decided} of {cases}");
}
