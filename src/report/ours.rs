//! Our own algorithms as contenders: every row of the table that answers a workload's question.

use crate::collision::{ALGORITHMS, Algorithm, Answer, MovingPair, Outcome as End, Pair, QueryKind, Sweep};
use crate::trace::NoTrace;

use super::contender::{Contender, Outcome, Preparation, Prepared};
use super::workload::Case;

/// Tolerances of the algorithms that have one, coarse to fine, world units.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Names of the algorithms whose answer depends on the tolerance.
const ITERATIVE: [&str; 3] = ["ray-clipping", "conservative-advancement", "swept-axis"];

/// Every algorithm of ours, as contenders.
#[must_use]
pub fn contenders() -> Vec<Box<dyn Contender>> {
    ALGORITHMS.iter().map(|algorithm| Box::new(Ours { algorithm }) as Box<dyn Contender>).collect()
}

struct Ours {
    algorithm: &'static Algorithm,
}

impl Ours {
    /// Asks a pair that stands ready, where the library takes one for this question: places, cosines and sines are known,
    /// for a sweep the relative velocity, for turning bodies their spins in radians; features, times and contacts are not.
    fn ask_of_ready<'c>(
        &self,
        case: &'c Case,
        kind: QueryKind,
        tolerance: f64,
    ) -> Option<Box<dyn FnMut() -> Outcome + 'c>> {
        match (kind, self.algorithm.name) {
            (QueryKind::Separation, "closest-features") => {
                let pair = Pair::at(&case.a, &case.b, 0.0).refined();
                Some(Box::new(move || Outcome::Value(pair.separation().separation)))
            }
            (QueryKind::TimeOfImpact, "swept-axis") => {
                let pair = MovingPair::new(&case.a, &case.b);
                let limit = case.query(kind, tolerance).max_iterations;
                Some(Box::new(move || first_contact(&pair.first_contact(tolerance, limit).outcome)))
            }
            (QueryKind::LinearSweep, "ray-cast") => {
                let sweep = Sweep::new(&case.a, &case.b);
                Some(Box::new(move || first_contact(&sweep.first_contact())))
            }
            _ => None,
        }
    }
}

/// The number of an answer that the workload asks for.
fn outcome(answer: &Answer) -> Outcome {
    match answer {
        Answer::Separation(s) => Outcome::Value(s.separation),
        Answer::Impact(impact) => first_contact(&impact.outcome),
        _ => Outcome::Undecided,
    }
}

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
        if !self.algorithm.kinds.contains(&kind) {
            Vec::new()
        } else if ITERATIVE.contains(&self.algorithm.name) {
            TOLERANCES.to_vec()
        } else {
            vec![0.0]
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
        if (self.algorithm.shapes)(&query).is_err() {
            return None;
        }
        if preparation == Preparation::Prepared {
            return self.ask_of_ready(case, kind, tolerance).map(|ask| Prepared { ask, steps: None });
        }
        let ask = Box::new(move || outcome(&(self.algorithm.quiet)(&query, &mut NoTrace)));
        let steps = Box::new(move || match (self.algorithm.quiet)(&query, &mut NoTrace) {
            Answer::Impact(impact) => impact.iterations,
            _ => 1,
        });
        let counted = matches!(kind, QueryKind::TimeOfImpact | QueryKind::LinearSweep);
        Some(Prepared { ask, steps: counted.then_some(steps as Box<dyn Fn() -> usize>) })
    }
}
