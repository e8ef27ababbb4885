//! What the article does: one algorithm a file, traced, and one row in [`ALGORITHMS`].
//!
//! A file is named as its algorithm is in a scene (`ray_cast.rs` is `ray-cast`) and ends in the row that the table
//! takes from it, `ALGORITHM`. To add one: write the file, its `mod` line, its line in the table. Scenes, `tracefig
//! list`, the figures' runs and the report follow the table.

pub(crate) mod advancement;
mod arc;
pub(crate) mod candidate;
mod circles;
mod clamp;
mod closest_features;
mod conservative_advancement;
mod early_out;
mod epa;
mod extents;
mod extremes;
mod gjk;
mod merge;
mod minkowski;
mod nearest_edge;
pub(crate) mod outline;
mod ray_cast;
mod ray_clipping;
mod separating_axes;
mod simplex;
mod swept_axis;
pub(crate) mod view;

use crate::collision::{Answer, Query, QueryKind};
use crate::geometry::Body;
use crate::trace::{NoTrace, Trace};

/// A row in the table of algorithms.
pub struct Algorithm {
    /// Its word in a scene file.
    pub name: &'static str,
    /// One line for `tracefig list`, with the source.
    pub about: &'static str,
    /// The questions it answers.
    pub kinds: &'static [QueryKind],
    /// Whether it takes this pair of shapes; the text says which shapes it takes.
    pub shapes: fn(&Query) -> Result<(), &'static str>,
    /// Whether [`Query::tolerance`] has a say in its answer.
    pub stops: Stops,
    /// Answers without a trace.
    pub quiet: fn(&Query, &mut NoTrace) -> Answer,
    /// Answers, and records what it did.
    pub traced: fn(&Query, &mut Trace) -> Answer,
    /// Prepares a query to be asked again and again, where poses, cosines and sines can be worked out beforehand;
    /// None where each answer starts from the scene's numbers.
    pub ready: Option<for<'q> fn(&Query<'q>) -> Ready<'q>>,
}

/// A query whose bodies are placed already: each call searches anew and answers it.
pub type Ready<'q> = Box<dyn Fn() -> Answer + 'q>;

/// What ends an algorithm's search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stops {
    /// It ends by itself, with bounds as narrow as rounding allows: it never looks at [`Query::tolerance`].
    Exactly,
    /// It ends where the bodies are within [`Query::tolerance`], or where that is all that is left undecided.
    AtTolerance,
}

impl Algorithm {
    /// Answers without a trace.
    #[must_use]
    pub fn answer(&self, query: &Query) -> Answer {
        (self.quiet)(query, &mut NoTrace)
    }

    /// Whether it answers this kind of question about these shapes.
    #[must_use]
    pub fn takes(&self, query: &Query) -> bool {
        self.kinds.contains(&query.kind) && (self.shapes)(query).is_ok()
    }
}

/// Every algorithm; the first that takes a query is its default.
pub static ALGORITHMS: &[Algorithm] = &[
    closest_features::ALGORITHM,
    circles::ALGORITHM,
    extents::ALGORITHM,
    clamp::ALGORITHM,
    merge::ALGORITHM,
    minkowski::ALGORITHM,
    separating_axes::ALGORITHM,
    gjk::ALGORITHM,
    extremes::ALGORITHM,
    arc::ALGORITHM,
    ray_cast::ALGORITHM,
    ray_clipping::ALGORITHM,
    swept_axis::ALGORITHM,
    conservative_advancement::ALGORITHM,
];

/// The questions about two bodies at one moment.
const DISCRETE: &[QueryKind] = &[QueryKind::Separation, QueryKind::Overlap];

/// Two bodies that have a core: all but outlines.
fn convex_pair(query: &Query) -> Result<(), &'static str> {
    let convex = |body: &Body| !body.shape.core.is_empty();
    match query.b {
        Some(b) if convex(query.a) && convex(b) => Ok(()),
        _ => Err("takes two convex bodies"),
    }
}

/// Two convex bodies that do not turn.
fn unturning_pair(query: &Query) -> Result<(), &'static str> {
    convex_pair(query)?;
    let turns = |body: &Body| body.spin.0 != 0.0;
    if turns(query.a) || query.b.is_some_and(turns) { Err("takes bodies that do not turn") } else { Ok(()) }
}
