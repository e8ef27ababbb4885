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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::feature::DifferenceEdge;
    use crate::collision::tests::bodies::{boxed, placed};
    use crate::geometry::{DVec2, perp};

    #[test]
    fn only_what_may_have_an_absolute_error_is_answered() {
        let a = placed(boxed("box", 1.0, 1.0), 0.0, 0.0, 30.0);
        let n = a.pose_at(0.0).vector(DVec2::X);
        let reach = a.shape.hull.reach;
        let (mut answered, mut left) = (0, 0);
        for k in 0..4_000 {
            // The vertex of B in the direction −n is some roundings above an edge of A.
            let gap = f64::from(k) * 2.0 * f64::EPSILON;
            let apart = n * (1.0 + std::f64::consts::SQRT_2 + gap) + perp(n) * 0.25;
            let b = placed(boxed("box", 1.0, 1.0), apart.x, apart.y, 75.0);
            let scale = apart.x.abs() + apart.y.abs() + 2.0 * reach;
            let facing = |vertex| DifferenceEdge { source: Side::A, edge: 1, vertex };
            let found = (0..4).find_map(|i| separation(&a, &b, 0.0, DifferenceFeature::Edge(facing(i))));
            match found {
                Some(found) => {
                    let most = 1e3 * f64::EPSILON * scale;
                    assert!(found.bounds.hi < most, "{k}: {:e} of {most:e}", found.bounds.hi);
                    answered += 1;
                }
                None => left += 1,
            }
        }
        assert!(answered > 200 && left > 3_000, "{answered} answered, {left} left");
    }
}
