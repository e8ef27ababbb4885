//! The algorithm runs behind a figure: each question once, when a panel or layer first asks it.
//!
//! The same query is asked at another moment by running it there; a layer that draws a distance in a scene
//! about motion asks for the separation at that moment.
//!
//! Behind an exercise's question stand no runs but those that build B ⊖ A: what nobody computes can't show.

use std::sync::{Arc, Mutex, PoisonError};

use crate::collision::{
    ALGORITHMS, Algorithm, Answer, Impact, Outcome, Overlap, Query, QueryKind, Reason, Separation,
};
use crate::geometry::{Enclosure, Feature, Side, insert_in_order};
use crate::scene::{Problem, Scene, Variant};
use crate::trace::{Event, MOST_EVENTS, Trace, step};

use super::again::Often;
use super::called::Called;
use super::cue::{Cue, Teller};
use super::distances::Distances;
use super::limits::{MAX_RUNS, within};
use super::question::is_of_a_moment;
use super::touching::touch;

/// An answer to a query, and how it was found.
#[derive(Debug)]
pub(crate) struct Run {
    /// The kind of query that was asked.
    pub(crate) kind: QueryKind,
    /// The moment asked about, in [0, 1]; 0 where the question is about all of [0, 1].
    pub(crate) time: f64,
    /// The answer.
    pub(crate) answer: Answer,
    /// What the algorithm told on its way to the answer.
    pub(crate) trace: Trace,
    /// The moment that each event is about, in [0, 1]; it never goes back.
    moments: Vec<f64>,
    /// The name of the algorithm.
    algorithm: &'static str,
    /// Whose story it is.
    teller: Teller,
    /// The end of the scene's own run about the same moment, of a run that answers another question: with
    /// that comes what this one found.
    beside: Option<Cue>,
    /// Which of the events the figure shows, by their place in the trace.
    shown: Mutex<Vec<usize>>,
    /// How often the bodies are as near as at their closest, of a miss.
    pub(crate) often: Often,
}

impl Run {
    /// A question of a kind at a moment, with an answer that says nothing and without a trace.
    fn unanswered(kind: QueryKind, time: f64) -> Self {
        let answer = match kind {
            QueryKind::LinearSweep | QueryKind::TimeOfImpact => {
                let outcome = Outcome::Unresolved { reason: Reason::IterationLimit, free_until: 0.0 };
                Answer::Impact(Impact { outcome, tolerance: 0.0, iterations: 0 })
            }
            _ => {
                let separation_bounds = Enclosure { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
                Answer::Overlap(Overlap { overlap: None, separation_bounds })
            }
        };
        let (moments, algorithm, shown) = (Vec::new(), "", Mutex::default());
        let (trace, teller, often) = (Trace::default(), Teller::Own, Often::default());
        Self { kind, time, answer, trace, moments, algorithm, teller, beside: None, shown, often }
    }

    /// The separation that it answers with: that of the question, or the contact of a hit.
    #[must_use]
    pub(crate) fn separation(&self) -> Option<&Separation> {
        match &self.answer {
            Answer::Separation(separation) => Some(separation),
            Answer::Contact(contact) => Some(&contact.separation),
            Answer::Impact(impact) => match &impact.outcome {
                Outcome::Hit { contact, .. } | Outcome::Overlapping { contact } => Some(contact),
                Outcome::Miss | Outcome::Unresolved { .. } => None,
            },
            _ => None,
        }
    }

    /// All events, in the order in which they were told.
    pub(crate) fn events(&self) -> impl Iterator<Item = &Event> {
        self.trace.events.iter()
    }

    /// What the figure shows of the events: all for which `pick` finds something count as shown from here on.
    pub(crate) fn told<'r, T>(
        &'r self,
        mut pick: impl FnMut(&'r Event) -> Option<T> + 'r,
    ) -> impl Iterator<Item = T> + 'r {
        self.trace.events.iter().enumerate().filter_map(move |(i, event)| {
            let picked = pick(event)?;
            self.mark(i);
            Some(picked)
        })
    }

    /// The first thing that `pick` finds in the events; that event counts as shown from here on.
    pub(crate) fn find_told<'r, T>(&'r self, mut pick: impl FnMut(&'r Event) -> Option<T>) -> Option<T> {
        let (i, found) = self.events().enumerate().find_map(|(i, event)| Some((i, pick(event)?)))?;
        self.mark(i);
        Some(found)
    }

    /// The last thing that `pick` finds in the events; that event counts as shown from here on.
    pub(crate) fn find_last_told<'r, T>(&'r self, mut pick: impl FnMut(&'r Event) -> Option<T>) -> Option<T> {
        let mut events = self.trace.events.iter().enumerate().rev();
        let (i, found) = events.find_map(|(i, event)| Some((i, pick(event)?)))?;
        self.mark(i);
        Some(found)
    }

    /// The cue of the last event that is so; `None` where none is. The event does not count as shown.
    pub(crate) fn last_cue(&self, is_so: impl Fn(&Event) -> bool) -> Option<Cue> {
        let index = self.trace.events.iter().rposition(is_so)?;
        Some(self.cue(index))
    }

    /// The cues of all events that are so, in order, each with what `pick` finds in it.
    pub(crate) fn cues<'r, T>(
        &'r self,
        mut pick: impl FnMut(&'r Event) -> Option<T> + 'r,
    ) -> impl Iterator<Item = (Cue, T)> + 'r {
        self.events().enumerate().filter_map(move |(i, event)| Some((self.cue(i), pick(event)?)))
    }

    /// The cue of the answer: the end of the run.
    pub(crate) fn end(&self) -> Cue {
        self.cue(self.trace.events.len().saturating_sub(1))
    }

    /// The body and the edge or vertex of the best candidate; `None` without one.
    pub(crate) fn candidate(&self) -> Option<(Side, Feature)> {
        let source = |event: &Event| match event {
            Event::CandidateImproved { source, .. } => Some(*source),
            _ => None,
        };
        self.trace.events.iter().rev().find_map(source)
    }

    /// The cue with which the nearest point is known: of the best candidate, else of the answer.
    pub(crate) fn nearest(&self) -> Cue {
        self.last_cue(|event| matches!(event, Event::CandidateImproved { .. })).unwrap_or_else(|| self.end())
    }

    /// The cue with which the whole of B ⊖ A is known, after its last edge.
    pub(crate) fn whole_difference(&self) -> Option<Cue> {
        let last = self.last_cue(tells_difference)?;
        Some(if self.is_own() { last.part(step::WHOLE) } else { last })
    }

    /// The cue of an event by its place in the trace. Of runs that the figure is not about, B ⊖ A comes as a
    /// whole, a step of an advancement by itself, and all else with the answer.
    fn cue(&self, index: usize) -> Cue {
        let events = &self.trace.events;
        if let Some(end) = self.beside.filter(|_| !events.get(index).is_some_and(tells_difference)) {
            return end;
        }
        let event = match events.get(index) {
            _ if self.teller == Teller::Own => index,
            Some(Event::Advanced { .. }) => index,
            Some(event) if tells_difference(event) => {
                events.iter().rposition(tells_difference).unwrap_or(index)
            }
            _ => events.len().saturating_sub(1),
        };
        let (teller, algorithm) = (self.teller, self.algorithm);
        let moment = self.moments.get(event).copied().unwrap_or(self.time);
        Cue { moment, teller, algorithm, asked: self.time, event, part: 0 }
    }

    /// Whether it is the scene's own question to its own algorithm.
    pub(crate) fn is_own(&self) -> bool {
        self.teller == Teller::Own
    }

    /// The event of a cue; `None` where the cue is of another run.
    pub(crate) fn event_of(&self, cue: &Cue) -> Option<&Event> {
        let own = (self.teller, self.algorithm, self.time.to_bits());
        let is_so = own == (cue.teller, cue.algorithm, cue.asked.to_bits());
        self.trace.events.get(cue.event).filter(|_| is_so)
    }

    /// Counts an event as shown.
    fn mark(&self, index: usize) {
        insert_in_order(&mut self.shown.lock().unwrap_or_else(PoisonError::into_inner), index);
    }

    /// Whether it tells of such an event, which then counts as shown.
    pub(crate) fn tells(&self, is_so: impl Fn(&Event) -> bool) -> bool {
        self.find_told(|event| is_so(event).then_some(())).is_some()
    }

    /// The events that were shown, in order, after the one that says which algorithm began at which moment;
    /// none where nothing was.
    #[must_use]
    pub(crate) fn shown(&self) -> Vec<&Event> {
        let shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        let event = |&i: &usize| self.trace.events.get(i);
        let began = |event: &&Event| matches!(event, Event::Started { .. });
        let mut events: Vec<&Event> = shown.iter().filter_map(event).filter(|e| !began(e)).collect();
        if !events.is_empty() {
            events.splice(0..0, self.trace.events.first().filter(began));
        }
        events
    }
}

/// What identifies a run: the question, the algorithm, the bits of the moment, the step cap.
type Key = (QueryKind, &'static str, u64, usize);

/// The runs of a figure so far, in the order they were asked for.
#[derive(Debug, Default)]
pub(crate) struct Runs {
    /// Each run with what identifies it, in the order in which they were asked for.
    done: Mutex<Vec<(Key, Arc<Run>)>>,
    /// Whether the figure is a question, whose answer it does not know.
    is_blind: bool,
    /// What the figure calls the bodies.
    pub(crate) called: Called,
    /// How far its bodies are apart over time.
    pub(crate) distances: Distances,
}

impl Runs {
    /// No runs yet, of a figure of this scene that calls the bodies so.
    pub(crate) fn of(scene: &Scene, called: Called) -> Self {
        Self { is_blind: scene.variant == Variant::Question, called, ..Self::default() }
    }

    /// The scene's own question at a moment (which matters only to bounds, overlap and separation).
    pub(crate) fn own(&self, scene: &Scene, time: f64) -> Arc<Run> {
        let time = if is_of_a_moment(scene.query.kind) { time } else { 0.0 };
        if self.is_blind {
            return Arc::new(Run::unanswered(scene.query.kind, time));
        }
        self.run(scene, scene.query.algorithm, &scene.query_at(time))
    }

    /// The separation at a moment: by the scene's algorithm where it answers that, else by the pair's
    /// default.
    pub(crate) fn separation(&self, scene: &Scene, time: f64) -> Option<Arc<Run>> {
        if self.is_blind {
            return None;
        }
        let query = Query { kind: QueryKind::Separation, ..scene.query_at(time) };
        let algorithm = std::iter::once(scene.query.algorithm).chain(ALGORITHMS).find(|a| a.takes(&query))?;
        Some(self.run(scene, algorithm, &query))
    }

    /// A run at a moment that tells all edges of B ⊖ A: of the scene's own overlap, else of a separation.
    pub(crate) fn difference(&self, scene: &Scene, time: f64) -> Option<Arc<Run>> {
        let query = Query { kind: QueryKind::Separation, ..scene.query_at(time) };
        query.b?;
        let tells = |run: &Arc<Run>| run.events().any(tells_difference);
        let stops = |run: &Run| run.events().any(|e| matches!(e, Event::SeparatingAxisFound { .. }));
        let asks = scene.query.kind == QueryKind::Overlap && !self.is_blind;
        let own = asks.then(|| self.own(scene, time)).filter(|run| tells(run) && !stops(run));
        let of_another = || {
            let mut all =
                std::iter::once(scene.query.algorithm).chain(ALGORITHMS).filter(|a| a.takes(&query));
            all.find_map(|a| Some(self.run(scene, a, &query)).filter(tells))
        };
        own.or_else(of_another)
    }

    /// The scene's own question by an algorithm that advances: the scene's own, else the first one that does,
    /// which takes one step and no more.
    pub(crate) fn first_step(&self, scene: &Scene) -> Option<Arc<Run>> {
        if self.is_blind {
            return None;
        }
        let advances = |run: &Arc<Run>| run.events().any(|e| matches!(e, Event::Advanced { .. }));
        let own = Some(self.own(scene, 0.0)).filter(advances);
        let query = Query { max_iterations: 1, ..scene.query_at(0.0) };
        let of_another = || {
            ALGORITHMS.iter().filter(|a| a.takes(&query)).map(|a| self.run(scene, a, &query)).find(advances)
        };
        own.or_else(of_another)
    }

    /// All runs so far, in the order they were asked for.
    pub(crate) fn all(&self) -> Vec<Arc<Run>> {
        let done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        done.iter().map(|(_, run)| Arc::clone(run)).collect()
    }

    /// What is wrong when the runs were too many, or told more than can be kept; `None` when they were not.
    pub(crate) fn overflow(&self, scene: &Scene) -> Option<Problem> {
        let done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        let at = &scene.query.span;
        let events = done.iter().map(|(_, run)| run.trace.events.len() + run.trace.left_out).sum();
        let pairs = done.len() * pairs(&scene.query_of_bodies());
        within("the steps of the figure's algorithms", "events", events, MOST_EVENTS, at)
            .and_then(|()| within("the moments of the figure", "pairs of vertices", pairs, MAX_RUNS, at))
            .err()
    }

    /// Whether a query is for the separation at the first contact.
    fn is_contact(&self, scene: &Scene, query: &Query) -> bool {
        let may_be = query.kind == QueryKind::Separation && query.time > 0.0;
        if self.is_blind || !may_be || is_of_a_moment(scene.query.kind) {
            return false;
        }
        match &self.own(scene, 0.0).answer {
            Answer::Impact(Impact { outcome: Outcome::Hit { time, .. }, .. }) => {
                (time.lo..=time.hi).contains(&query.time)
            }
            _ => false,
        }
    }

    /// The end of the scene's own run about the moment of a query that is another one than the scene's;
    /// `None` where the scene asks about a motion.
    fn end_beside(&self, scene: &Scene, query: &Query) -> Option<Cue> {
        let is_beside = !self.is_blind && query.kind != scene.query.kind && is_of_a_moment(scene.query.kind);
        is_beside.then(|| self.own(scene, query.time).end())
    }

    /// The run of a query by an algorithm: an earlier one where it was asked before.
    fn run(&self, scene: &Scene, algorithm: &'static Algorithm, query: &Query) -> Arc<Run> {
        let contact = self.is_contact(scene, query);
        let key = (query.kind, algorithm.name, query.time.to_bits(), query.max_iterations);
        let beside = self.end_beside(scene, query);
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, run)) = done.iter().find(|(k, _)| *k == key) {
            return Arc::clone(run);
        }
        // Of runs without number, only the first are of use: the figure will be refused.
        let told = done.iter().map(|(_, run)| run.trace.events.len()).sum::<usize>();
        let full = told > MOST_EVENTS || done.len() * pairs(query) > MAX_RUNS;
        if let Some((_, run)) = done.first().filter(|_| full) {
            return Arc::clone(run);
        }
        let mut trace = Trace::default();
        let mut answer = (algorithm.traced)(query, &mut trace);
        if contact {
            touch(&mut answer, query);
        }
        let (shown, often) = (Mutex::default(), Often::default());
        let (algorithm, teller) = (algorithm.name, teller(scene, algorithm, query));
        let moments = moments(query.time, &trace, &answer);
        let (kind, time) = (query.kind, query.time);
        let run =
            Arc::new(Run { kind, time, answer, trace, moments, algorithm, teller, beside, shown, often });
        done.push((key, Arc::clone(&run)));
        run
    }
}

/// The moments that the events of a run are about, which was asked about the moment `asked`: that of the last
/// one that has a moment of its own; that of a hit at the end.
fn moments(asked: f64, trace: &Trace, answer: &Answer) -> Vec<f64> {
    let mut now = asked;
    let moment = |event: &Event| match *event {
        Event::Started { at, .. } | Event::Advanced { at, .. } | Event::ClosestApproachFound { at, .. } => {
            at.time
        }
        Event::AxisSwept { from, .. } => from,
        _ => asked,
    };
    let mut all: Vec<f64> = Vec::with_capacity(trace.events.len());
    for event in &trace.events {
        now = now.max(moment(event));
        all.push(now);
    }
    if let (Answer::Impact(Impact { outcome: Outcome::Hit { time, .. }, .. }), Some(last)) =
        (answer, all.last_mut())
    {
        *last = last.max(time.lo);
    }
    all
}

/// Whose story the run of a query by an algorithm is.
fn teller(scene: &Scene, algorithm: &Algorithm, query: &Query) -> Teller {
    // A question tells no story.
    if scene.variant == Variant::Question {
        return Teller::OtherQuestion;
    }
    if query.kind != scene.query.kind {
        Teller::OtherQuestion
    } else if algorithm.name != scene.query.algorithm.name {
        Teller::OtherAlgorithm
    } else {
        Teller::Own
    }
}

/// Whether an event tells of the shape of B ⊖ A.
pub(crate) fn tells_difference(event: &Event) -> bool {
    matches!(event, Event::DifferenceEdgeFound { .. } | Event::DifferenceRounded { .. })
}

/// Pairs of vertices that the slowest algorithm looks at for a query.
fn pairs(query: &Query) -> usize {
    query.a.shape.core.len() * query.b.map_or(1, |b| b.shape.core.len())
}
