//! Conservative advancement whose bound forgets the spin: t + s / v·n instead of t + s / (v·n + Σ r|ω|).
//!
//! Each step is as long as the bodies' origins may go, and their ends go farther: an arm that swings round is
//! elsewhere after it, deep inside the other body or past it (Mirtich 1996, 2.3.2 has the bound whole).

use crate::collision::QueryKind;
use crate::collision::certified::distance::Pair;
use crate::geometry::Body;

use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "forgotten-spin",
    kinds: &[QueryKind::TimeOfImpact],
    claims: |bodies, _| Some(advance(bodies)),
};

/// Steps after which it is taken to have come as near as it will.
const MOST_STEPS: usize = 100;

/// The time to which the steps come.
fn advance([a, b]: [&Body; 2]) -> Claim {
    let mut t = 0.0;
    for _ in 0..MOST_STEPS {
        let found = Pair::at(a, b, t).separation();
        if found.separation <= 0.0 {
            break;
        }
        let closing = (a.velocity - b.velocity).dot(*found.normal);
        if closing <= 0.0 {
            return Claim::Miss;
        }
        t += found.separation / closing;
        if t > 1.0 {
            return Claim::Miss;
        }
    }
    Claim::Hit(t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, moving, placed, polygon};
    use crate::collision::{MovingPair, Outcome};

    #[test]
    fn an_arm_that_swings_into_a_wall_is_said_to_miss_it() {
        let wall = placed(boxed("aabb", 0.2, 3.0), 2.0, 0.0, 0.0);
        let arm = |spin| moving(placed(polygon(&[[0., 0.], [2., 0.]], 0.1), 0., 0., -80.), [0.5, 0.], spin);
        for (spin, hits) in [(0.0, false), (160.0, true)] {
            let arm = arm(spin);
            assert_eq!((NAIVE.claims)([&arm, &wall], 0.0), Some(Claim::Miss));
            let proved = MovingPair::new(&arm, &wall).first_contact(1e-9, 100).outcome;
            assert_eq!(proved == Outcome::Miss, !hits, "{proved:?}");
        }
    }
}
