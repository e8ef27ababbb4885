//! Time per query and error of each contender on each workload.
//!
//! A round asks every case of a workload once; rounds are repeated until the clock's grain no longer matters,
//! and the fastest of several such batches counts: on a shared machine noise only ever adds.

use std::time::{Duration, Instant};

use super::Report;
use super::contender::{Contender, Outcome, Preparation, Prepared};
use super::workload::{Case, Class, Difficulty, Workload};

/// How long to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// How long a batch lasts at least: long enough that the clock's grain, some 30 ns, does not matter.
    pub batch: Duration,
    /// How many batches there are, of which the fastest counts.
    pub batches: usize,
}

impl Default for Effort {
    fn default() -> Self {
        Self { batch: Duration::from_millis(2), batches: 7 }
    }
}

/// One contender at one setting on one workload.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What the pairs do.
    pub class: Class,
    /// How hard they are.
    pub difficulty: Difficulty,
    /// Vertices of each polygon.
    pub vertices: usize,
    /// Name of the contender.
    pub contender: String,
    /// What the contender's numbers are, as `f64, certified`.
    pub precision: String,
    /// What stood ready before the clock started.
    pub preparation: Preparation,
    /// Tolerance asked for, in world units; 0 where it has none.
    pub tolerance: f64,
    /// Nanoseconds per query, in the fastest batch.
    pub nanoseconds: f64,
    /// Largest error over the cases, relative to S for separations; for times of impact in units of t.
    pub worst_error: f64,
    /// Median error, in the units of the worst.
    pub median_error: f64,
    /// Mean number of steps, where they are counted.
    pub steps: Option<f64>,
    /// How many cases were answered.
    pub answered: usize,
    /// How many cases have the wrong verdict: a hit for a miss, a miss for a hit, apart for overlapping.
    pub wrong: usize,
    /// How many cases the contender left undecided.
    pub undecided: usize,
    /// How many cases the workload has.
    pub cases: usize,
}

/// Runs every contender on every workload. `progress` hears (done, of) and a name before each row and says
/// whether to go on; when it does not, the report holds what is finished.
///
/// ```
/// use std::time::Duration;
/// use tracefig::report::{Contender, Effort, contenders, run, workloads};
/// let (workloads, ours) = (workloads(), contenders());
/// let ours: Vec<&dyn Contender> = ours.iter().map(AsRef::as_ref).collect();
/// let effort = Effort { batch: Duration::ZERO, batches: 1 };
/// let mut rows = 0;
/// let report = run(&workloads[..1], &ours, effort, vec![], &mut |_, _, _| { rows += 1; rows < 3 });
/// assert!(report.partial && report.rows.iter().all(|row| row.wrong == 0));
/// ```
pub fn run(
    workloads: &[Workload],
    contenders: &[&dyn Contender],
    effort: Effort,
    machine: Vec<(String, String)>,
    progress: &mut dyn FnMut(usize, usize, &str) -> bool,
) -> Report {
    let jobs = jobs(workloads, contenders);
    let mut report = Report { machine, rows: Vec::new(), partial: false };
    for (done, job) in jobs.iter().enumerate() {
        if !progress(done, jobs.len(), &format!("{} · {}", job.workload.name(), job.contender.name())) {
            report.partial = true;
            break;
        }
        report.rows.extend(measure(job, effort));
    }
    report
}

/// What becomes one row.
struct Job<'a> {
    /// The cases.
    workload: &'a Workload,
    /// Who is asked.
    contender: &'a dyn Contender,
    /// The tolerance that is asked for, in world units.
    tolerance: f64,
    /// What stands ready before the clock starts.
    preparation: Preparation,
}

fn jobs<'a>(workloads: &'a [Workload], contenders: &[&'a dyn Contender]) -> Vec<Job<'a>> {
    let mut jobs = Vec::new();
    for workload in workloads {
        for preparation in [Preparation::Prepared, Preparation::FromScene] {
            for &contender in contenders {
                for tolerance in contender.tolerances(workload.class.query()) {
                    jobs.push(Job { workload, contender, tolerance, preparation });
                }
            }
        }
    }
    jobs
}

/// The row of a job; `None` where the contender takes none of the cases.
fn measure(job: &Job, effort: Effort) -> Option<Row> {
    let kind = job.workload.class.query();
    let mut prepared: Vec<(&Case, Prepared)> = job
        .workload
        .cases
        .iter()
        .filter_map(|case| Some((case, job.contender.prepare(case, kind, job.tolerance, job.preparation)?)))
        .collect();
    if prepared.is_empty() {
        return None;
    }
    let outcomes: Vec<(&Case, Outcome)> = prepared.iter_mut().map(|(case, p)| (*case, (p.ask)())).collect();
    let steps: Vec<usize> =
        prepared.iter().filter_map(|(_, p)| p.steps.as_ref().map(|steps| steps())).collect();
    let verdicts = Verdicts::of(&outcomes, job.workload.class);
    Some(Row {
        class: job.workload.class,
        difficulty: job.workload.difficulty,
        vertices: job.workload.vertices,
        contender: job.contender.name().to_owned(),
        precision: job.contender.precision().to_owned(),
        preparation: job.preparation,
        tolerance: job.tolerance,
        nanoseconds: fastest(&mut prepared, effort),
        worst_error: verdicts.errors.last().copied().unwrap_or(0.0),
        median_error: verdicts.errors.get(verdicts.errors.len() / 2).copied().unwrap_or(0.0),
        steps: mean(&steps),
        answered: outcomes.len() - verdicts.undecided,
        wrong: verdicts.wrong,
        undecided: verdicts.undecided,
        cases: job.workload.cases.len(),
    })
}

#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
fn mean(steps: &[usize]) -> Option<f64> {
    (!steps.is_empty()).then(|| steps.iter().sum::<usize>() as f64 / steps.len() as f64)
}

/// How the answers to a workload compare with the exact ones.
struct Verdicts {
    /// Errors of the answers, ascending.
    errors: Vec<f64>,
    /// How many verdicts are wrong.
    wrong: usize,
    /// How many cases were left undecided.
    undecided: usize,
}

impl Verdicts {
    fn of(outcomes: &[(&Case, Outcome)], class: Class) -> Self {
        let mut verdicts = Self { errors: Vec::new(), wrong: 0, undecided: 0 };
        for (case, outcome) in outcomes {
            match (outcome, case.exact) {
                (Outcome::Undecided, _) => verdicts.undecided += 1,
                (Outcome::Miss, None) => {}
                (Outcome::Value(value), Some([hi, lo])) if value.is_finite() => {
                    let error = ((value - hi) - lo).abs();
                    let separation = class.query() == crate::collision::QueryKind::Separation;
                    verdicts.wrong += usize::from(separation && (*value > 0.0) != (hi > 0.0));
                    verdicts.errors.push(if separation { error / case.scale } else { error });
                }
                _ => verdicts.wrong += 1,
            }
        }
        verdicts.errors.sort_by(f64::total_cmp);
        verdicts
    }
}

/// Nanoseconds per query, in the fastest batch.
fn fastest(prepared: &mut [(&Case, Prepared)], effort: Effort) -> f64 {
    let mut rounds = 1_u32;
    loop {
        let time = batch(prepared, rounds);
        if time >= effort.batch {
            break;
        }
        rounds = rounds.saturating_mul(2);
    }
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
    let queries = f64::from(rounds) * prepared.len() as f64;
    let best = (0..effort.batches).map(|_| batch(prepared, rounds)).min().unwrap_or_default();
    best.as_secs_f64() * 1e9 / queries
}

/// How long so many rounds through all cases take.
fn batch(prepared: &mut [(&Case, Prepared)], rounds: u32) -> Duration {
    let start = Instant::now();
    for _ in 0..rounds {
        for (_, p) in prepared.iter_mut() {
            std::hint::black_box((p.ask)());
        }
    }
    start.elapsed()
}
