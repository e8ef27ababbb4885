//! Linear sweep by clipping the ray, for any pair whose distance can be asked: the article's figure 6.
//!
//! The estimate starts at the origin and moves along the ray r(t) = t v. At each estimate the distance query
//! gives the closest point of B ⊖ A and the normal n there; the tangent at that point separates the estimate
//! from B ⊖ A, so the ray can't meet the surface before it meets the tangent, and there is the new estimate:
//!
//! ```text
//! t ← t + s / (v·n)         v·n ≤ 0: the ray never meets B ⊖ A
//! ```
//!
//! It never passes the surface, and converges quadratically on a round one.
//! [`crate::collision::certified::sweep::ray`] is the direct answer for the same question; this one is drawn,
//! and checked against it.
//!
//! Source: Gino van den Bergen, *Ray Casting against General Convex Objects with Application to Continuous
//! Collision Detection*, 2004; Paul Firth, "Collision detection for dummies" (2011), section Continuous.

use crate::collision::algorithm::advancement::{Flavor, advance};
use crate::collision::algorithm::{Algorithm, Stops, unturning_pair};
use crate::collision::{Answer, Query, QueryKind};
use crate::trace::Tracer;

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "ray-clipping",
    about: "the ray clipped to the tangent at the closest point, again and again (van den Bergen 2004)",
    kinds: &[QueryKind::LinearSweep],
    shapes: unturning_pair,
    stops: Stops::AtTolerance,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Answers a linear sweep.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    Answer::Impact(advance(query, Flavor::RayClipping, ALGORITHM.name, tracer))
}
