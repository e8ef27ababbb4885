//! When a mark comes into a figure: with the event that told what it shows.
//!
//! The story of a figure goes by moments. At each, what other algorithms know comes first, as a whole, since
//! the figure is not about them; then the scene's own algorithm, event by event.

use std::cmp::Ordering;

/// Whose story an event belongs to, in the order of telling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Teller {
    /// Who answers another question than the scene asks.
    OtherQuestion,
    /// Who answers the scene's question instead of its algorithm.
    OtherAlgorithm,
    /// The scene's algorithm, about its question.
    Own,
}

/// An event of a run, or a part of one, with which marks come or go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cue {
    // What tells most cues of a figure apart comes first: they are compared in this order.
    /// Which event of the run, from 0.
    pub(crate) event: usize,
    /// Which part of the event, from 0.
    pub(crate) part: usize,
    /// The moment that the event is about, in [0, 1].
    pub(crate) moment: f64,
    /// Whose event it is.
    pub(crate) teller: Teller,
    /// The name of the algorithm.
    pub(crate) algorithm: &'static str,
    /// The moment that the run was asked about, in [0, 1].
    pub(crate) asked: f64,
}

impl Cue {
    /// A later part of the same event.
    #[must_use]
    pub(crate) fn part(self, part: usize) -> Self {
        Self { part, ..self }
    }

    /// Whether another cue is of the same run.
    #[must_use]
    pub(crate) fn is_of_the_run_of(&self, other: &Self) -> bool {
        (self.teller, self.algorithm, self.asked.to_bits())
            == (other.teller, other.algorithm, other.asked.to_bits())
    }

    /// Which one comes first.
    #[must_use]
    pub(crate) fn order(&self, other: &Self) -> Ordering {
        self.moment
            .total_cmp(&other.moment)
            .then(self.teller.cmp(&other.teller))
            .then(self.asked.total_cmp(&other.asked))
            .then(self.algorithm.cmp(other.algorithm))
            .then(self.event.cmp(&other.event))
            .then(self.part.cmp(&other.part))
    }
}
