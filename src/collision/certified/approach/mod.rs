//! How near a miss came: when two bodies that never touch are closest, and how far apart they are then,
//! proved.
//!
//! Of the separation s(t) over [0, 1] the least is asked, m = min s(t). The separation at any moment is an
//! upper bound of it. For a lower bound one direction n does where neither body turns ([`straight`]), and
//! separating axes of bodies that are grown until they nearly touch where one does ([`turning`]).
//!
//! Whoever asks has proved that the bodies never touch: m is above 0, whatever else could be proved.

mod least;
mod straight;
mod turning;

use crate::collision::answer::ClosestApproach;
use crate::collision::certified::impact::MovingPair;
use crate::geometry::{Body, Enclosure};

/// The closest approach of two bodies that are proved not to touch over [0, 1].
pub(crate) fn closest_approach(a: &Body, b: &Body) -> ClosestApproach {
    let pair = MovingPair::new(a, b);
    let (time, contact, least) =
        if pair.is_linear() { straight::closest(a, b) } else { turning::closest(&pair) };
    // The double nearest to the separation may be below what is proved of the exact one.
    let lo = least.max(0.0).min(contact.separation);
    ClosestApproach { time, contact, bounds: Enclosure { lo, hi: contact.bounds.hi } }
}

#[cfg(test)]
mod tests;
