//! Our own algorithms as contenders: every row of the table that answers a workload's question.

use crate::collision::{ALGORITHMS, Algorithm, Answer, Outcome as End, QueryKind, Stops, When};
use crate::trace::NoTrace;

use super::contender::{Contender, Outcome, Preparation, Prepared};
use super::workload::Case;

/// Tolerances that the algorithms that have one are asked with, coarse to fine, in world units.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Every algorithm of ours, as contenders.
///
/// ```
/// use tracefig::{collision::ALGORITHMS, report::contenders};
/// assert_eq!(contenders().len(), ALGORITHMS.len());
/// ```
#[must_use]
pub fn contenders() -> Vec<Box<dyn Contender>> {
    ALGORITHMS.iter().map(|algorithm| Box::new(Ours { algorithm }) as Box<dyn Contender>).collect()
}

/// A row of the table of algorithms as a contender.
struct Ours {
    /// The row.
    algorithm: &'static Algorithm,
}

/// The number of an answer that the workload asks for.
fn outcome(answer: &Answer) -> Outcome {
    match answer {
        Answer::Separation(s) => Outcome::Value(s.separation),
        Answer::Impact(impact) => first_contact(&impact.outcome),
        _ => Outcome::Undecided,
    }
}

/// The number or the verdict of an impact.
fn first_contact(end: &End) -> Outcome {
    match end {
        End::Hit { time, .. } => Outcome::Value(time.lo),
        End::Miss => Outcome::Miss,
        End::Overlapping { .. } => Outcome::Value(0.0),
        End::Unresolved { .. } => Outcome::Undecided,
    }
}

impl Contender for Ours {
    fn name(&self) -> &str {
        self.algorithm.name
    }

    fn precision(&self) -> &'static str {
        "f64, certified"
    }

    fn tolerances(&self, kind: QueryKind) -> Vec<f64> {
        match self.algorithm.stops {
            _ if !self.algorithm.kinds.contains(&kind) => Vec::new(),
            Stops::AtTolerance => TOLERANCES.to_vec(),
            Stops::Exactly => vec![0.0],
        }
    }

    fn prepare<'c>(
        &'c self,
        case: &'c Case,
        kind: QueryKind,
        tolerance: f64,
        preparation: Preparation,
    ) -> Option<Prepared<'c>> {
        let query = case.query(kind, tolerance);
        if !self.algorithm.takes(&query) {
            return None;
        }
        if preparation == Preparation::Prepared {
            let ready = self.algorithm.ready?(&query);
            return Some(Prepared { ask: Box::new(move || outcome(&ready())), steps: None });
        }
        let ask = Box::new(move || outcome(&(self.algorithm.quiet)(&query, &mut NoTrace)));
        let steps = Box::new(move || match (self.algorithm.quiet)(&query, &mut NoTrace) {
            Answer::Impact(impact) => impact.iterations,
            _ => 1,
        });
        let counted = kind.question().when == When::OverTheMotion;
        Some(Prepared { ask, steps: counted.then_some(steps as Box<dyn Fn() -> usize>) })
    }
}
