//! A query that stands ready is answered as one that starts from the scene's numbers.

use crate::collision::tests::asking::query;
use crate::collision::tests::bodies::Bodies;
use crate::collision::{ALGORITHMS, Answer, Outcome, Query};
use crate::geometry::{Angle, Body};

/// What encloses the number of an answer.
fn span(answer: &Answer) -> (f64, f64) {
    match answer {
        Answer::Separation(found) => (found.bounds.lo, found.bounds.hi),
        Answer::Overlap(found) => (found.separation_bounds.lo, found.separation_bounds.hi),
        Answer::Impact(found) => match found.outcome {
            Outcome::Hit { time, .. } => (time.lo, time.hi),
            Outcome::Miss => (1.0, 2.0),
            Outcome::Overlapping { .. } => (0.0, 0.0),
            Outcome::Unresolved { free_until, .. } => (free_until, 2.0),
        },
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_stands_ready_gives_the_answer_of_a_fresh_query() {
    let still = |body: &Body| Body { spin: Angle::Degrees(0.0), ..body.clone() };
    let mut asked = 0;
    for algorithm in ALGORITHMS {
        let Some(ready) = algorithm.ready else { continue };
        let mut bodies = Bodies::new(19);
        for k in 0..200 {
            let (a, b) = bodies.flying_pair(200.0);
            for &kind in algorithm.kinds {
                let query = Query { tolerance: 1e-9, ..query(kind, &a, &b) };
                let (a, b) = (still(&a), still(&b));
                let query =
                    if algorithm.takes(&query) { query } else { Query { a: &a, b: Some(&b), ..query } };
                let (fresh, prepared) = (algorithm.ask(&query), ready(&query));
                let (lo, hi) = span(&fresh);
                for _ in 0..2 {
                    let (from, to) = span(&prepared());
                    assert!(from <= hi && lo <= to, "{} {k}: {fresh:?} {:?}", algorithm.name, prepared());
                }
                asked += 1;
            }
        }
    }
    assert_eq!(asked, 800, "separation and overlap, a sweep, a time of impact");
}
