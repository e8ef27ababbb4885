//! The distance, and what is below a fixed length is nothing.
//!
//! Engines forgive bodies a few millimetres so that stacks come to rest. The number is right for crates in
//! metres. In a watch, or in a world whose unit is a kilometre, it is as large as the bodies.

use crate::collision::QueryKind;
use crate::collision::certified::distance::Pair;

use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "slop",
    kinds: &[QueryKind::Separation, QueryKind::Overlap],
    claims: |[a, b], time| {
        let found = Pair::at(a, b, time).separation();
        let s = found.separation;
        Some(Claim::Separation(if s.abs() < SLOP { 0.0 } else { s }, *found.normal))
    },
};

/// What is nothing, in whatever unit: the half centimetre of engines whose unit is a metre, as
/// `b2_linearSlop` is.
const SLOP: f64 = 0.005;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed};

    /// What is claimed of two squares that are as far apart as they are wide.
    fn squares(size: f64) -> f64 {
        let square = |x: f64| placed(boxed("box", 0.5 * size, 0.5 * size), x, 0.0, 0.0);
        let Some(Claim::Separation(s, _)) = (NAIVE.claims)([&square(0.0), &square(2.0 * size)], 0.0) else {
            panic!()
        };
        s
    }

    #[test]
    fn cogs_that_are_as_far_apart_as_they_are_wide_touch_it_says() {
        assert_eq!(squares(1.0), 1.0);
        assert_eq!(squares(0.004), 0.0);
    }
}
