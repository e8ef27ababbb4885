//! What the algorithms about a motion share: moments as events tell them, and the end of a story. At the end
//! of a miss stands how near it came.
//!
//! The outcome alone asks for no closest approach, so that it costs nothing where nobody wants to know;
//! whoever prints, tells or draws an answer asks for it here. It is proved by
//! [`crate::collision::certified::approach`], so that it is the same whoever found the miss.

use crate::collision::certified::approach;
use crate::collision::{Answer, ClosestApproach, Outcome, Query};
use crate::geometry::Body;
use crate::trace::{Event, Moment, Tracer};

/// How near the bodies of a query come to each other, where its answer is a miss; None for any other answer.
///
/// Times are in [0, 1], lengths in world units. Without turning the bounds are as narrow as those of a
/// separation; where a body turns up to ten times, mostly below 1e-9 of the pair's size.
///
/// ```
/// use tracefig::collision::{ALGORITHMS, Query, QueryKind, closest_approach};
/// use tracefig::geometry::{Angle, Body, DVec2, Shape, shape::FieldValue};
/// let disc = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
/// let at = |x, y, speed| Body {
///     shape: disc.clone(), position: DVec2::new(x, y), angle: Angle::ZERO,
///     velocity: DVec2::new(speed, 0.0), spin: Angle::ZERO,
/// };
/// let (a, b) = (at(-2.0, 0.0, 8.0), at(0.0, 3.0, 0.0));
/// let query = Query {
///     kind: QueryKind::LinearSweep, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100,
/// };
/// // A passes below B a quarter of the way.
/// let closest = closest_approach(&query, &query.answer().unwrap()).unwrap();
/// assert_eq!((closest.time, closest.contact.separation), (0.25, 1.0));
/// assert!(closest.bounds.lo <= 1.0 && 1.0 <= closest.bounds.hi);
/// ```
#[must_use]
pub fn closest_approach(query: &Query, answer: &Answer) -> Option<ClosestApproach> {
    match (answer, query.b) {
        (Answer::Impact(impact), Some(b)) => found(query, b, &impact.outcome),
        _ => None,
    }
}

/// The closest approach of a miss.
fn found(query: &Query, b: &Body, outcome: &Outcome) -> Option<ClosestApproach> {
    (*outcome == Outcome::Miss).then(|| approach::closest_approach(query.a, b))
}

/// The moment of time `t`, as events tell it.
pub(crate) fn moment(a: &Body, b: &Body, t: f64) -> Moment {
    Moment { time: t, angle_a: a.angle_at(t), angle_b: b.angle_at(t) }
}

/// Ends an algorithm about a motion: tells how near a miss came, where somebody listens, and the outcome.
pub(crate) fn finish(query: &Query, outcome: &Outcome, tracer: &mut impl Tracer) {
    if tracer.listens()
        && let Some(b) = query.b
        && let Some(closest) = found(query, b, outcome)
    {
        let ClosestApproach { time, contact, bounds } = closest;
        tracer.record(|| Event::ClosestApproachFound {
            at: moment(query.a, b, time),
            separation: contact.separation,
            bounds,
            normal: *contact.normal,
            points: contact.points,
        });
    }
    tracer.record(|| Event::Finished { outcome: outcome.word() });
}
