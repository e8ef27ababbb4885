//! The nearest point of B ⊖ A, walked to until a step gains less than a fixed number (Gilbert 1966).
//!
//! What a step gains, v·v − v·w, is an area. A number that is nothing to a crate is everything to a watch:
//! there the walk stops where it began.

use crate::collision::QueryKind;
use crate::geometry::Body;

use super::bodies::both;
use super::{Claim, Naive};

pub(super) const NAIVE: Naive =
    Naive { name: "fixed-tolerance", kinds: &[QueryKind::Separation, QueryKind::Overlap], claims };

/// What a step must gain, whatever the size of the bodies: no area by right, and so the fault.
const ENOUGH: f64 = 1e-6;

/// Steps of a walk that zigzags, as it does where the origin is inside.
const MOST_STEPS: usize = 1000;

fn claims(bodies: [&Body; 2], time: f64) -> Option<Claim> {
    let [a, b] = both(bodies, time)?;
    let mut v = *b.core.first()? - *a.core.first()?;
    for _ in 0..MOST_STEPS {
        let w = b.support(-v) - a.support(v);
        if v.dot(v) - v.dot(w) <= ENOUGH {
            break;
        }
        // The point of the segment from v to w that is nearest to O.
        let way = w - v;
        v += way * (-v.dot(way) / way.dot(way)).clamp(0.0, 1.0);
    }
    let n = v / v.length();
    Some(if n.is_finite() { Claim::Separation(v.length() - a.radius - b.radius, n) } else { Claim::Nothing })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Pair;
    use crate::collision::tests::bodies::{boxed, placed};

    /// What is claimed of two squares that are half as far apart as they are wide, and what is proved.
    fn squares(half: f64) -> (f64, f64) {
        let (a, b) = (boxed("box", half, half), placed(boxed("box", half, half), 3.0 * half, 0., 0.));
        let Some(Claim::Separation(claimed, _)) = claims([&a, &b], 0.0) else { panic!() };
        (claimed, Pair::at(&a, &b, 0.0).separation().bounds.hi)
    }

    #[test]
    fn what_is_right_for_crates_is_three_times_too_far_in_a_watch() {
        let (claimed, proved) = squares(1.0);
        assert!((claimed - proved).abs() < 1e-5, "{claimed}, {proved}");
        let (claimed, proved) = squares(1e-4);
        assert!(claimed > 2.9 * proved, "{claimed}, {proved}");
    }
}
