//! Time of impact by separating axes that turn with a body: the default where bodies turn.
//!
//! See [`crate::collision::certified::impact::search`] for the idea and its proof; here it meets queries.

use crate::collision::Answer;
use crate::collision::MovingPair;
use crate::collision::QueryKind;
use crate::collision::algorithm::{Algorithm, Stops, convex_pair};
use crate::collision::certified::impact::search::answer;

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "swept-axis",
    about: "separating axes that turn with a body, followed until they are used up; certified",
    kinds: &[QueryKind::TimeOfImpact],
    shapes: convex_pair,
    stops: Stops::AtTolerance,
    quiet: answer,
    traced: answer,
    ready: Some(|query| {
        let (tolerance, limit) = (query.tolerance, query.max_iterations);
        let pair = MovingPair::new(query.a, query.b.unwrap_or(query.a));
        Box::new(move || Answer::Impact(pair.first_contact(tolerance, limit)))
    }),
};
