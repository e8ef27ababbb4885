//! The certified separation of two bodies that nearly touch: the last part of a hit, in one pass of
//! double-doubles. The filter ends a few roundings of doubles before contact, with the pair proved apart and
//! a vertex proved to be above an edge. What is left to compute is how far: to a fraction of ε·S, as no more
//! is asked of a separation below 1e3 ε·S.

use crate::collision::Separation;
use crate::collision::certified::distance::Pair;
use crate::collision::certified::distance::conditions::{Support, support};
use crate::collision::certified::distance::refine::{along_normal, between};
use crate::collision::certified::distance::witnesses::{self, Carrier, Proved};
use crate::collision::certified::rounding::LAST_ERROR;
use crate::collision::feature::DifferenceFeature;
use crate::geometry::{Body, Enclosure, Side};

/// A separation below this many ε of the largest reach or radius may have an absolute error: S is not below
/// 1/√2 of a reach, which leaves a third of the 1e3 ε·S. Neither half nor twice is noticed: the filter
/// ends within tens of ε.
const NEAR: f64 = 448.0 * f64::EPSILON;

/// The separation at `t`, where a vertex's foot is clearly inside the edge of `near` and the pair is apart;
/// None where doubles leave open which vertex is lowest, or the separation is not small.
pub(crate) fn separation(a: &Body, b: &Body, t: f64, near: DifferenceFeature) -> Option<Separation> {
    let DifferenceFeature::Edge(facing) = near else { return None };
    let pair = Pair::at(a, b, t);
    if !pair.is_tame() || !matches!(support(&pair, facing), Support::Vertex) {
        return None;
    }
    let d = between(&pair, facing.start());
    let (normal, core) = along_normal(&pair, facing, d);
    let separation = core - pair.radius;
    // An edge of B: its normal is turned as well.
    let turning =
        if facing.source == Side::B { 2.0 * pair.turn_error * (d[0].hi.abs() + d[1].hi.abs()) } else { 0.0 };
    let error = pair.placing_error + turning + LAST_ERROR * (pair.magnitude + pair.radius.hi);
    let value = separation.hi;
    let size = a.shape.hull.reach.max(b.shape.hull.reach).max(pair.radius.hi);
    if value > NEAR * size {
        return None;
    }
    let bounds = Enclosure {
        lo: (value + (separation.lo - error)).next_down().max(0.0),
        hi: (value + (separation.lo + error)).next_up(),
    };
    let proved = Proved {
        carrier: Carrier::Edge(facing),
        normal: Some(normal),
        core: core.hi,
        separation: value.max(bounds.lo),
        bounds,
        ties: 1,
    };
    Some(witnesses::answer(&pair, &proved))
}
