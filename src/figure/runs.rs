//! The algorithm runs behind a figure: each question once, when a panel or layer first asks it.
//!
//! The same query is asked at another moment by running it there; a layer that draws a distance in a scene about
//! motion asks for the separation at that moment.

use std::sync::{Arc, Mutex, PoisonError};

use crate::collision::{ALGORITHMS, Algorithm, Answer, Query, QueryKind, Separation};
use crate::scene::Scene;
use crate::trace::{Event, Trace};

/// An answer, and how it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// What was asked.
    pub kind: QueryKind,
    /// The moment asked about; 0 where the question is about all of [0, 1].
    pub time: f64,
    /// What came out.
    pub answer: Answer,
    /// How.
    pub trace: Trace,
}

impl Run {
    /// The separation that it answers with: that of the question, or the contact of a hit.
    #[must_use]
    pub fn separation(&self) -> Option<&Separation> {
        use crate::collision::Outcome;
        match &self.answer {
            Answer::Separation(separation) => Some(separation),
            Answer::Impact(impact) => match &impact.outcome {
                Outcome::Hit { contact, .. } | Outcome::Overlapping { contact } => Some(contact),
                Outcome::Miss | Outcome::Unresolved { .. } => None,
            },
            _ => None,
        }
    }

    /// Its events.
    pub fn events(&self) -> impl Iterator<Item = &Event> {
        self.trace.events.iter()
    }
}

/// What identifies a run: the question, the algorithm, the bits of the moment.
type Key = (QueryKind, &'static str, u64);

/// The runs of a figure so far, in the order they were asked for.
#[derive(Debug, Default)]
pub(crate) struct Runs {
    done: Mutex<Vec<(Key, Arc<Run>)>>,
}

impl Runs {
    /// The scene's own question at a moment (which matters only to bounds, overlap and separation).
    pub(crate) fn own(&self, scene: &Scene, time: f64) -> Arc<Run> {
        let time = if is_static(scene.query.kind) { time } else { 0.0 };
        self.run(scene.query.algorithm, &scene.query_at(time))
    }

    /// The separation at a moment: by the scene's algorithm where it answers that, else by the pair's default.
    pub(crate) fn separation(&self, scene: &Scene, time: f64) -> Option<Arc<Run>> {
        let query = Query { kind: QueryKind::Separation, ..scene.query_at(time) };
        let algorithm =
            std::iter::once(scene.query.algorithm).chain(ALGORITHMS).find(|a| takes(a, &query))?;
        Some(self.run(algorithm, &query))
    }

    /// The separation at a moment by an algorithm that tells the edges of B ⊖ A.
    pub(crate) fn difference(&self, scene: &Scene, time: f64) -> Option<Arc<Run>> {
        let query = Query { kind: QueryKind::Separation, ..scene.query_at(time) };
        query.b?;
        let tells = |run: &Run| run.events().any(tells_difference);
        std::iter::once(scene.query.algorithm)
            .chain(ALGORITHMS)
            .filter(|a| takes(a, &query))
            .map(|a| self.run(a, &query))
            .find(|run| tells(run))
    }

    fn run(&self, algorithm: &'static Algorithm, query: &Query) -> Arc<Run> {
        let key = (query.kind, algorithm.name, query.time.to_bits());
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, run)) = done.iter().find(|(k, _)| *k == key) {
            return Arc::clone(run);
        }
        let mut trace = Trace::default();
        let answer = (algorithm.traced)(query, &mut trace);
        let run = Arc::new(Run { kind: query.kind, time: query.time, answer, trace });
        done.push((key, Arc::clone(&run)));
        run
    }
}

/// Whether a question is about one moment.
pub(crate) fn is_static(kind: QueryKind) -> bool {
    matches!(kind, QueryKind::Bounds | QueryKind::Overlap | QueryKind::Separation)
}

/// Whether an event tells of the shape of B ⊖ A.
pub(crate) fn tells_difference(event: &Event) -> bool {
    matches!(event, Event::DifferenceEdgeFound { .. } | Event::DifferenceRounded { .. })
}

fn takes(algorithm: &Algorithm, query: &Query) -> bool {
    algorithm.kinds.contains(&query.kind) && (algorithm.shapes)(query).is_ok()
}
