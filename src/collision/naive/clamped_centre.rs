//! The closest point of a box by clamping the circle's centre, wherever that is.
//!
//! Outside it is right. A centre inside the box is left where it is: the way from the closest point to it has
//! no length, so that the normal is 0/0, and the distance would be −r wherever in the box the circle is.

use crate::collision::QueryKind;
use crate::geometry::{Body, DVec2};

use super::bodies::{Placed, both};
use super::{Claim, Naive};

pub(super) const NAIVE: Naive =
    Naive { name: "clamped-centre", kinds: &[QueryKind::Separation, QueryKind::Overlap], claims };

fn claims(bodies: [&Body; 2], time: f64) -> Option<Claim> {
    let placed = both(bodies, time)?;
    let is_box = |i: usize| bodies[i].shape.half_extents.is_some() && placed[i].radius == 0.0;
    let is_ball = |i: usize| placed[i].core.len() == 1;
    let [hull, ball] = [[0, 1], [1, 0]].into_iter().find(|[hull, ball]| is_box(*hull) && is_ball(*ball))?;
    let [x, y] = axes(&placed[hull])?;
    let v = *placed[ball].core.first()? - placed[hull].centre();
    // Left over of each component beyond the half-extent; 0 exactly where clamping changes nothing.
    let beyond = |axis: DVec2| {
        let (along, half) = (v.dot(axis) / axis.length(), axis.length());
        along - along.clamp(-half, half)
    };
    let d = x / x.length() * beyond(x) + y / y.length() * beyond(y);
    let n = d / d.length();
    // From A to B, whichever is the box.
    let n = if hull == 0 { n } else { -n };
    Some(if n.is_finite() { Claim::Separation(d.length() - placed[ball].radius, n) } else { Claim::Nothing })
}

/// Half the edges of a box, from its centre outward.
fn axes(hull: &Placed) -> Option<[DVec2; 2]> {
    let &[corner, x, _, y] = hull.core.as_slice() else { return None };
    Some([(x - corner) / 2.0, (y - corner) / 2.0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Pair;
    use crate::collision::tests::bodies::{boxed, placed, polygon};

    #[test]
    fn a_centre_outside_the_box_is_clamped_to_its_closest_point() {
        let (a, b) = (boxed("box", 2., 1.), polygon(&[[0., 0.]], 0.5));
        for (x, y, angle) in [(3.0, 0.5, 0.), (3.0, 2.5, 30.), (-1.0, -4.0, 70.)] {
            let (a, b) = (placed(a.clone(), 0.5, 0.25, angle), placed(b.clone(), x, y, 0.));
            let proved = Pair::at(&a, &b, 0.0).separation();
            for (pair, turned) in [([&a, &b], 1.0), ([&b, &a], -1.0)] {
                let Some(Claim::Separation(s, n)) = claims(pair, 0.0) else { panic!() };
                assert!((s - proved.separation).abs() < 1e-12, "{s}");
                assert!((n * turned - *proved.normal).length() < 1e-12, "{n}");
            }
        }
    }

    #[test]
    fn a_centre_inside_the_box_is_no_direction_away_from_it() {
        let (a, b) = (boxed("box", 2., 1.), placed(polygon(&[[0., 0.]], 0.5), 1.5, 0.25, 0.));
        assert_eq!(claims([&a, &b], 0.0), Some(Claim::Nothing));
        let turned = placed(a.clone(), 0.3, 0.1, 33.0);
        assert_eq!(claims([&turned, &b], 0.0), Some(Claim::Nothing));
        assert!(Pair::at(&a, &b, 0.0).separation().bounds.hi < -0.9);
        assert_eq!(claims([&b, &b], 0.0), None, "two balls and no box");
    }
}
