//! Time of impact by separating axes that turn with a body: the default where bodies turn.
//!
//! A distance query gives a separating axis. Fixed in the frame of the body that owns it, the axis goes on
//! separating for a while; when it is used up, a new one is asked for. The axes, each with its span of time,
//! are a certificate that nothing touches before the last of them ends; each is told as it is proved. How
//! they are found and followed, and how contact just after the last is proved, is
//! [`crate::collision::certified::impact`]'s.
//!
//! # Tolerance
//! World units. A hit's time bounds may be as wide as a few tolerances over the closing speed; however small
//! it is, they are never wider than rounding makes them.
//!
//! Source: the separating axis as the root that is advanced is Catto's, "Continuous Collision", Game
//! Developers Conference 2013.

use crate::collision::algorithm::motion::{self, moment};
use crate::collision::algorithm::{Algorithm, Stops, convex_pair};
use crate::collision::certified::impact::{AxisSpan, MovingPair};
use crate::collision::{Answer, Query, QueryKind};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "swept-axis",
    about: "separating axes that turn with a body, followed until they are used up; certified",
    kinds: &[QueryKind::TimeOfImpact],
    shapes: convex_pair,
    stops: Stops::AtTolerance,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: Some(|query| {
        let (tolerance, limit) = (query.tolerance, query.max_iterations);
        let pair = MovingPair::new(query.a, query.b.unwrap_or(query.a));
        Box::new(move || Answer::Impact(pair.first_contact(tolerance, limit)))
    }),
};

/// Answers a time of impact.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let (a, b) = (query.a, query.b.unwrap_or(query.a));
    tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: moment(a, b, 0.0) });
    let told = |AxisSpan { axis, from, to }: AxisSpan| {
        tracer.record(|| Event::AxisSwept { from, to, owner: axis.owner, normal: axis.n });
    };
    let impact = MovingPair::new(a, b).first_contact_told(query.tolerance, query.max_iterations, told);
    motion::finish(query, &impact.outcome, tracer);
    Answer::Impact(impact)
}
