//! What an algorithm did, as past-tense facts.
//!
//! A query is generic over [`Tracer`]; with [`NoTrace`] the closure that would build an event is never called, so an
//! untraced query costs what it would without tracing.

mod event;
mod json;
mod story;

pub use event::{Culling, Event, Goal, Moment, SupportVertex};
pub use json::{TRACE_FORMAT, json_lines};
pub use story::{sentence, story};

/// Listens to an algorithm.
pub trait Tracer {
    /// Takes an event; `make` is only called by tracers that keep it.
    fn record(&mut self, make: impl FnOnce() -> Event);

    /// Whether events are kept at all: where an algorithm must walk something only to tell it, it asks first. Never
    /// decides an answer.
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

/// Every event, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// The events.
    pub events: Vec<Event>,
}

impl Tracer for Trace {
    fn record(&mut self, make: impl FnOnce() -> Event) {
        self.events.push(make());
    }
}
