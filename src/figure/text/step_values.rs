//! What a step of an advancement says of itself, and how many there are, for the values that text may name.

use crate::figure::context::Context;
use crate::trace::Event;

use super::quantity::Quantity;

/// A step of an advancement, as the algorithm told it.
pub(super) struct Step {
    /// When it looks.
    pub(super) time: f64,
    /// The separation then.
    pub(super) separation: f64,
    /// The closing speed v·n of the bodies as they move, without their turning.
    pub(super) closing: f64,
    /// The most by which they come nearer in a unit of time.
    pub(super) bound: f64,
    /// When the next one looks.
    pub(super) next: Option<f64>,
}

/// What `pick` takes of the panel's step; `None` in a panel without one.
pub(super) fn of_step(context: &Context, pick: fn(&Step) -> Option<f64>) -> Option<Quantity> {
    at(context.run().told(told), context.step?, pick)
}

/// What `pick` takes of the panel's step, or in a panel without one of the first, as an advancement takes it,
/// whichever algorithm answered.
pub(super) fn of_step_or_first(context: &Context, pick: fn(&Step) -> Option<f64>) -> Option<Quantity> {
    let own = at(context.run().told(told), context.step.unwrap_or(1), pick);
    if own.is_some() || context.step.is_some() {
        return own;
    }
    at(context.first_step()?.told(told), 1, pick)
}

/// What an event tells of a step.
fn told(event: &Event) -> Option<Step> {
    match *event {
        Event::Advanced { at, separation, closing_speed, bound, next, .. } => {
            Some(Step { time: at.time, separation, closing: closing_speed, bound, next })
        }
        _ => None,
    }
}

/// What `pick` takes of the step of that number, from 1.
fn at(
    mut steps: impl Iterator<Item = Step>,
    number: usize,
    pick: fn(&Step) -> Option<f64>,
) -> Option<Quantity> {
    pick(&steps.nth(number.checked_sub(1)?)?).map(Quantity::exactly)
}

/// The number of the last step, from 1.
pub(super) fn last_step(context: &Context) -> Option<Quantity> {
    Some(context.steps().len()).filter(|&last| last > 0).map(|last| Quantity::exactly(count(last)))
}

/// A count as a number.
#[expect(clippy::cast_precision_loss, reason = "a step cap is far below 2^53")]
pub(super) fn count(n: usize) -> f64 {
    n as f64
}
