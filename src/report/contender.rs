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

/// A query that is ready to run, with how many steps it took last time where the contender counts them.
pub struct Prepared<'c> {
    /// Runs the query once.
    pub ask: Box<dyn FnMut() -> Outcome + 'c>,
    /// Distance queries or iterations of one run, where they are counted.
    pub steps: Option<Box<dyn Fn() -> usize + 'c>>,
}

/// What stands ready before the clock starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Preparation {
    /// Shapes, poses, cosines and sines.
    Prepared,
    /// Only the scene's numbers; pose, cosine and sine are part of the query.
    FromScene,
}

/// A solver, ours or a peer's.
pub trait Contender {
    /// Name in tables and plots.
    fn name(&self) -> &str;

    /// What its numbers are: `f64, certified`, `f32`.
    fn precision(&self) -> &str;

    /// Tolerances to try, coarse to fine, for this question; one entry where it has none.
    fn tolerances(&self, kind: QueryKind) -> Vec<f64>;

    /// Makes a query ready, or None for what this contender does not take.
    fn prepare<'c>(
        &'c self,
        case: &'c Case,
        kind: QueryKind,
        tolerance: f64,
        preparation: Preparation,
    ) -> Option<Prepared<'c>>;
}
