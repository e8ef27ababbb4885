//! Linear sweep as one ray cast: the default for bodies that do not turn.
//!
//! See [`crate::collision::certified::sweep::ray`] for the idea and its proof; here it meets queries.

use crate::collision::Answer;
use crate::collision::Impact;
use crate::collision::QueryKind;
use crate::collision::Sweep;
use crate::collision::algorithm::{Algorithm, Stops, unturning_pair};
use crate::collision::certified::sweep::ray::answer;

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "ray-cast",
    about: "one ray against the edges of B - A that face it, direct (Firth 2011, Continuous)",
    kinds: &[QueryKind::LinearSweep],
    shapes: unturning_pair,
    stops: Stops::Exactly,
    quiet: answer,
    traced: answer,
    ready: Some(|query| {
        let sweep = Sweep::new(query.a, query.b.unwrap_or(query.a));
        Box::new(move || {
            Answer::Impact(Impact { outcome: sweep.first_contact(), tolerance: 0.0, iterations: 1 })
        })
    }),
};
