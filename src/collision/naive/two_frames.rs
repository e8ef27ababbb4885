//! A look at the two frames, and at nothing between them.
//!
//! What overlaps in neither has not met, it says. A bullet that is on one side of a wall in the first frame
//! and on the other in the second has flown through it: *tunnelling*.

use crate::collision::QueryKind;
use crate::collision::certified::distance::Pair;

use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "two-frames",
    kinds: &[QueryKind::LinearSweep, QueryKind::TimeOfImpact],
    claims: |[a, b], _| {
        let overlaps = |t: &f64| Pair::at(a, b, *t).separation().separation <= 0.0;
        Some([0.0, 1.0].into_iter().find(overlaps).map_or(Claim::Miss, Claim::Hit))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, moving, placed, polygon};

    #[test]
    fn a_bullet_flies_through_a_wall() {
        let wall = boxed("aabb", 0.1, 1.0);
        let said = |speed: f64| {
            let bullet = moving(placed(polygon(&[[0., 0.]], 0.2), -3., 0., 0.), [speed, 0.], 0.);
            (NAIVE.claims)([&bullet, &wall], 0.0)
        };
        assert_eq!(said(3.0), Some(Claim::Hit(1.0)));
        assert_eq!(said(6.0), Some(Claim::Miss), "it went through at t = 0.45");
    }
}
