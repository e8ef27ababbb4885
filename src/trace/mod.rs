//! What an algorithm did, as past-tense facts.
//!
//! A query is generic over [`Tracer`]; with [`NoTrace`] the closure that would build an event is never
//! called, so an untraced query costs what it would without tracing.

mod event;
mod foreign;
mod json;
mod story;
mod tongue;
mod vocabulary;

pub use event::{Culling, EVENTS, Event, Goal, Moment, SupportVertex};
#[cfg(not(tracefig_page))]
pub(crate) use foreign::of_language;
pub(crate) use foreign::{bring_texts, text};
pub use json::{HEADER, VALUES, json_lines};
pub(crate) use story::{
    Hand, TOLD, USUAL, Voice, WHOLE, all_phrases, growth, place, script, sentence_in, so_far, step, taken,
    told,
};
pub use story::{sentence, story};
#[cfg(test)]
pub(crate) use tongue::unlike;
pub(crate) use tongue::{Phrase, Tongue, phrase, phrases};
pub use vocabulary::{EventField, EventKind};

/// Listens to an algorithm.
///
/// ```
/// use tracefig::trace::{Event, NoTrace, Trace, Tracer};
/// let mut trace = Trace::default();
/// trace.record(|| Event::Finished { outcome: "apart" });
/// assert_eq!(trace.events, [Event::Finished { outcome: "apart" }]);
/// NoTrace.record(|| panic!("nobody listens, so no event is built"));
/// ```
pub trait Tracer {
    /// Takes an event; `make` is only called by tracers that keep it.
    fn record(&mut self, make: impl FnOnce() -> Event);

    /// Whether events are kept. Where an algorithm must walk something only to tell it, it asks first.
    /// Never decides an answer.
    #[inline]
    fn listens(&self) -> bool {
        true
    }
}

/// Listens to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoTrace;

impl Tracer for NoTrace {
    #[inline(always)]
    fn record(&mut self, _make: impl FnOnce() -> Event) {}

    #[inline]
    fn listens(&self) -> bool {
        false
    }
}

/// Events of the longest trace that is kept whole, 2¹⁸: 80 MB. An advancement of 20,000 steps on boxes leaves
/// half as many; what leaves more has thousands of vertices and thousands of steps, and nobody reads it.
pub const MOST_EVENTS: usize = 1 << 18;

/// Every event, in order, up to [`MOST_EVENTS`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// What the algorithm did, in order.
    pub events: Vec<Event>,
    /// How many events came after that and were not kept.
    pub left_out: usize,
}

impl Tracer for Trace {
    fn record(&mut self, make: impl FnOnce() -> Event) {
        if self.events.len() < MOST_EVENTS {
            self.events.push(make());
        } else {
            self.left_out += 1;
        }
    }

    /// A full trace is told nothing more that has to be walked for.
    fn listens(&self) -> bool {
        self.events.len() < MOST_EVENTS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trace_without_end_is_cut_and_says_so() {
        let mut trace = Trace::default();
        for _ in 0..MOST_EVENTS + 3 {
            trace.record(|| Event::Finished { outcome: "apart" });
        }
        assert_eq!((trace.events.len(), trace.left_out), (MOST_EVENTS, 3));
    }
}
