//! Positions kept in 32-bit floats, and nothing else wrong.
//!
//! Such a number has 24 digits in base 2. Ten thousand kilometres from the origin it goes in steps of a
//! metre, and what is smaller than half of one is gone before any algorithm looks.

use crate::collision::QueryKind;
use crate::collision::certified::distance::Pair;
use crate::geometry::Body;

use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "single-precision",
    kinds: &[QueryKind::Separation, QueryKind::Overlap],
    claims: |[a, b], time| {
        let (a, b) = (kept(a, time), kept(b, time));
        let found = Pair::at(&a, &b, time).separation();
        Some(Claim::Separation(found.separation, *found.normal))
    },
};

/// A body that is at a time where single precision keeps it.
fn kept(body: &Body, time: f64) -> Body {
    let at = body.pose_at(time).position;
    Body { position: body.position + (at.as_vec2().as_dvec2() - at), ..body.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed};

    /// What is claimed of two squares, the second 0.9 beside the first, that far from the origin.
    fn claimed(far: f64) -> f64 {
        let square = |x: f64| placed(boxed("box", 0.5, 0.5), x, 0.0, 0.0);
        let Some(Claim::Separation(s, _)) = (NAIVE.claims)([&square(far), &square(far + 0.9)], 0.0) else {
            panic!()
        };
        s
    }

    #[test]
    fn a_tenth_of_a_metre_is_gone_ten_thousand_kilometres_away() {
        assert!((claimed(0.0) + 0.1).abs() < 1e-7, "{}", claimed(0.0));
        assert_eq!(claimed(1e7), 0.0, "they touch, it says");
    }
}
