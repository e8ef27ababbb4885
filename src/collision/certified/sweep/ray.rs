//! Linear sweep as one ray against B ⊖ A: where it enters, and what that says of the bodies.
//!
//! Seen from A, B moves by −v, v = `v_A` − `v_B`; so A meets B when the ray r(t) = t v from the origin enters
//! B ⊖ A. The ray's *line* enters a convex set once if at all, at some time in (−∞, ∞). In [0, 1] that is the
//! first contact, later is none; before 0 the bodies overlap, or have passed each other, which their
//! separation at t = 0 tells.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section Continuous.

use crate::collision::answer::{Outcome, Reason};
use crate::collision::certified::distance::witnesses::{self, Proved};
use crate::collision::certified::distance::{Pair, certify, settle};
use crate::collision::feature::DifferenceFeature;
use crate::geometry::Enclosure;

/// Where the ray's line enters B ⊖ A, as far as it is proved.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Entry {
    /// Nothing moves relative to the other body: there is no ray.
    Still,
    /// Nowhere: the line passes B ⊖ A.
    Misses,
    /// Through this feature.
    At {
        /// The edge of B ⊖ A, or the vertex at whose disc.
        feature: DifferenceFeature,
        /// Encloses the time of entry, which may be negative or above 1; free of contact up to `lo` if that
        /// is in [0, 1].
        time: Enclosure,
        /// The pair at `time.lo`, where it is proved with the entry.
        contact: Option<Proved>,
    },
    /// Rounding leaves open whether it enters, or where.
    Unsure,
}

impl Entry {
    /// What an entry says of the bodies; `pair` is them at t = 0.
    #[inline]
    pub(crate) fn outcome(&self, pair: &Pair) -> Outcome {
        match *self {
            Self::At { time, contact: Some(ref proved), .. } if time.lo >= 0.0 => {
                Outcome::Hit { time, contact: witnesses::answer_at(&pair.placement_at(time.lo), proved) }
            }
            Self::Misses => Outcome::Miss,
            ref open => open.outcome_by_balls(pair),
        }
    }

    /// What an entry says of the bodies, where a separation is still to be proved.
    #[cold]
    fn outcome_by_balls(&self, pair: &Pair) -> Outcome {
        match *self {
            Self::At { feature, time, .. } => entering(pair, feature, time),
            Self::Misses => Outcome::Miss,
            Self::Still => at_start(pair, Outcome::Miss),
            Self::Unsure => at_start(pair, undecided(0.0)),
        }
    }
}

/// The outcome where the ray's line enters through `feature` within a span of time.
fn entering(pair: &Pair, feature: DifferenceFeature, time: Enclosure) -> Outcome {
    let Enclosure { lo, hi } = time;
    if lo >= 1.0 {
        Outcome::Miss
    } else if lo < 0.0 {
        // At or before t = 0: the bodies overlap, or have passed each other.
        at_start(pair, if hi < 0.0 { Outcome::Miss } else { undecided(0.0) })
    } else if hi <= 1.0 {
        // Just before the bodies touch the filter's proof would hardly ever be tight enough.
        Outcome::Hit { time, contact: settle(&pair.unturned_at(lo), Some(feature)) }
    } else {
        undecided(lo)
    }
}

/// Overlap at t = 0, or else what is given for bodies that are apart then.
fn at_start(pair: &Pair, apart: Outcome) -> Outcome {
    let start = certify(pair, None);
    if start.bounds.hi <= 0.0 {
        Outcome::Overlapping { contact: start }
    } else if start.bounds.lo > 0.0 {
        apart
    } else {
        undecided(0.0)
    }
}

/// Proved free until a time, and no more.
fn undecided(free_until: f64) -> Outcome {
    Outcome::Unresolved { reason: Reason::WithinRounding, free_until }
}
