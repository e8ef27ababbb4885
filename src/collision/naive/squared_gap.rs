//! The gap of two circles as the root of what their squares leave, d² − R².
//!
//! The squares are at hand from the early way out, and their difference has the right sign: it is 0 where the
//! circles touch. Its root is not the gap d − R but the length of a tangent, from one centre to a circle of
//! both radii around the other: √((d − R)(d + R)).

use crate::collision::QueryKind;
use crate::geometry::Body;

use super::bodies::both;
use super::{Claim, Naive};

pub(super) const NAIVE: Naive =
    Naive { name: "squared-gap", kinds: &[QueryKind::Separation, QueryKind::Overlap], claims };

fn claims(bodies: [&Body; 2], time: f64) -> Option<Claim> {
    let [a, b] = both(bodies, time)?;
    if [&a, &b].into_iter().any(|body| body.core.len() > 1) {
        return None;
    }
    let (way, radii) = (b.centre() - a.centre(), a.radius + b.radius);
    let left = way.dot(way) - radii * radii;
    let n = way / way.length();
    Some(if n.is_finite() { Claim::Separation(left.abs().sqrt().copysign(left), n) } else { Claim::Nothing })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{placed, polygon};

    /// What is claimed of circles of radii 2 and 1 whose centres are so far apart.
    fn apart(d: f64) -> Option<Claim> {
        let circle = |radius, x| placed(polygon(&[[0., 0.]], radius), x, 0., 0.);
        claims([&circle(2.0, 0.0), &circle(1.0, d)], 0.0)
    }

    #[test]
    fn it_is_right_where_they_touch_and_twice_too_large_two_units_on() {
        let claimed = |s| Some(Claim::Separation(s, crate::geometry::DVec2::X));
        assert_eq!(apart(3.0), claimed(0.0));
        assert_eq!(apart(5.0), claimed(4.0), "they are 2 apart");
        assert_eq!(apart(0.0), Some(Claim::Nothing));
    }

    #[test]
    fn bodies_that_are_no_circles_are_not_taken() {
        let (square, ball) = (polygon(&[[0., 0.], [1., 0.], [0., 1.]], 0.0), polygon(&[[9., 9.]], 1.0));
        assert_eq!(claims([&square, &ball], 0.0), None);
    }
}
