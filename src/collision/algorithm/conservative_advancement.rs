//! Time of impact of turning bodies by conservative advancement, as in the article.
//!
//! The bodies are moved forward by a time in which nothing can touch, their distance is asked again, and so
//! on until it is within the tolerance:
//!
//! ```text
//! t ← t + s / (v·n + r_A |ω_A| + r_B |ω_B|)
//! ```
//!
//! v = `v_A` − `v_B` closes along n (from A to B); r |ω| bounds how fast turning can bring any point of a
//! body closer, since its farthest point travels along an arc of length L = θ r. Each step leaves a constant
//! part of the distance, and near a graze the steps shrink with the root of the gap: hence the step cap,
//! which is an `unresolved` and never a hit. [`crate::collision::certified::impact::search`] has no such
//! trouble; this one is drawn, and measured.
//!
//! # Tolerance
//! World units; the one in force is at least 16 ε·S. At s ≤ tolerance only "free until t" is proved. Contact
//! is then looked for at t + 2 tolerance / closing speed: proved there, or of bodies that don't turn where
//! they graze each other, it is a hit, else `unresolved`, `within-tolerance`.
//!
//! Source: Erwin Coumans, *Continuous Collision Detection and Physics*, 2005; Brian Mirtich, *Impulse-based
//! Dynamic Simulation of Rigid Body Systems*, 1996; Paul Firth, "Collision detection for dummies" (2011),
//! section Continuous Angular/Linear, and the readers' thread there on the sign of `rayN`, which
//! [`crate::collision::algorithm::advancement`] settles.

use crate::collision::algorithm::advancement::{Flavor, advance};
use crate::collision::algorithm::{Algorithm, Stops, convex_pair};
use crate::collision::{Answer, Query, QueryKind};
use crate::trace::Tracer;

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "conservative-advancement",
    about: "steps by the distance over a bound on the closing speed (Mirtich 1996, Coumans 2005)",
    kinds: &[QueryKind::TimeOfImpact],
    shapes: convex_pair,
    stops: Stops::AtTolerance,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Answers a time of impact.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    Answer::Impact(advance(query, Flavor::Conservative, ALGORITHM.name, tracer))
}
