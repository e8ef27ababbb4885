//! Who takes part in a report.

use crate::collision::QueryKind;

use super::workload::Case;

/// What one query answered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// A signed separation, or a time of first contact.
    Value(f64),
    /// No contact in [0, 1].
    Miss,
    /// The contender says that it could not decide.
    Undecided,
}

/// A query that is ready to run.
pub struct Prepared<'c> {
    /// Runs the query once.
    pub ask: Box<dyn FnMut() -> Outcome + 'c>,
    /// How many distance queries or iterations one run takes, where the contender counts them.
    pub steps: Option<Box<dyn Fn() -> usize + 'c>>,
}

/// What stands ready before the clock starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Preparation {
    /// Shapes, poses, cosines and sines stand ready; the query finds features, times and contacts.
    Prepared,
    /// Nothing but the scene's numbers; pose, cosine and sine are part of the query.
    FromScene,
}

/// A solver, ours or a peer's.
pub trait Contender {
    /// The name in tables and plots.
    fn name(&self) -> &str;

    /// What the contender's numbers are: `f64, certified`, `f32`.
    fn precision(&self) -> &str;

    /// Tolerances to try for this question, coarse to fine, in world units; one entry of 0 where the
    /// contender has none, no entry where it does not answer the question.
    fn tolerances(&self, kind: QueryKind) -> Vec<f64>;

    /// Makes a query ready; `None` for what this contender does not take.
    fn prepare<'c>(
        &'c self,
        case: &'c Case,
        kind: QueryKind,
        tolerance: f64,
        preparation: Preparation,
    ) -> Option<Prepared<'c>>;
}
