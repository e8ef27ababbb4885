//! The ray of A's centre against B, which was not grown by the shape of A.
//!
//! The centre comes to the surface when A is half inside, and flies past what A's flank hits. Against B grown
//! by −A, B ⊖ A, the same ray is right.

use crate::collision::QueryKind;
use crate::geometry::DVec2;

use super::bodies::{Placed, both};
use super::{Claim, Naive};

pub(super) const NAIVE: Naive = Naive {
    name: "centre-ray",
    kinds: &[QueryKind::LinearSweep],
    claims: |bodies, _| {
        let [a, b] = both(bodies, 0.0)?;
        let way = bodies[0].velocity - bodies[1].velocity;
        let [enter, exit] =
            if b.core.len() == 1 { disc(&b, a.centre(), way) } else { polygon(&b, a.centre(), way)? };
        let is_hit = enter <= exit && exit >= 0.0 && enter <= 1.0;
        Some(if is_hit { Claim::Hit(enter.max(0.0)) } else { Claim::Miss })
    },
};

/// A time at which nothing is entered.
const NEVER: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// When a point that goes a way from `start` enters a disc, and leaves it.
fn disc(disc: &Placed, start: DVec2, way: DVec2) -> [f64; 2] {
    let from = start - disc.centre();
    let (a, b, c) = (way.dot(way), from.dot(way), from.dot(from) - disc.radius * disc.radius);
    let root = (b * b - a * c).sqrt();
    if a > 0.0 && root >= 0.0 { [(-b - root) / a, (-b + root) / a] } else { NEVER }
}

/// When a point that goes a way from `start` enters a sharp polygon, and leaves it; `None` of a round one.
fn polygon(polygon: &Placed, start: DVec2, way: DVec2) -> Option<[f64; 2]> {
    if polygon.core.len() < 3 || polygon.radius > 0.0 {
        return None;
    }
    let [mut enter, mut exit] = [f64::NEG_INFINITY, f64::INFINITY];
    for n in polygon.normals() {
        let (to_go, speed) = (polygon.reach(n) - n.dot(start), n.dot(way));
        if speed < 0.0 {
            enter = enter.max(to_go / speed);
        } else if speed > 0.0 {
            exit = exit.min(to_go / speed);
        } else if to_go < 0.0 {
            return Some(NEVER);
        }
    }
    Some([enter, exit])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, moving, placed, polygon};
    use crate::collision::{MovingPair, Outcome};
    use crate::geometry::Body;

    /// When a ball that flies to the right at some height is said to hit a body, and when it does, at the
    /// earliest.
    fn said(height: f64, wall: &Body) -> (Claim, Option<f64>) {
        let ball = moving(placed(polygon(&[[0., 0.]], 0.5), -4., height, 0.), [8., 0.], 0.);
        let proved = match MovingPair::new(&ball, wall).first_contact(1e-9, 100).outcome {
            Outcome::Hit { time, .. } => Some(time.lo),
            _ => None,
        };
        ((NAIVE.claims)([&ball, wall], 0.0).unwrap(), proved)
    }

    #[test]
    fn the_ball_is_half_inside_when_its_centre_comes_to_the_wall() {
        for (wall, at) in [(boxed("box", 1., 1.), 0.375), (polygon(&[[0., 0.]], 1.), 0.375)] {
            let (claim, proved) = said(0.0, &wall);
            assert_eq!(claim, Claim::Hit(at));
            assert!(proved.unwrap() < at - 0.06, "{proved:?}");
        }
    }

    #[test]
    fn a_flank_that_hits_is_not_seen() {
        for wall in [boxed("box", 1., 1.), polygon(&[[0., 0.]], 1.)] {
            let (claim, proved) = said(1.25, &wall);
            assert_eq!(claim, Claim::Miss);
            assert!(proved.is_some());
            assert_eq!(said(1.75, &wall), (Claim::Miss, None));
        }
    }
}
