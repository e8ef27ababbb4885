//! The values that hang on how an answer turns out: a text may name one that this answer lacks, if another
//! has it.

use crate::figure::context::Context;

use super::values::separation;

/// Whether another answer to the question of a context has a value.
type Asks = fn(&Context) -> bool;

/// Values that hang on how the answer turns out.
static OF_THE_OUTCOME: &[(&str, Asks)] = &[
    ("depth", |context| separation(context).is_some()),
    ("time", |context| context.asks_for_a_hit()),
    ("closest.time", |context| context.asks_for_a_hit()),
    ("closest.separation", |context| context.asks_for_a_hit()),
    ("n.x", |context| context.asks_for_a_hit()),
    ("n.y", |context| context.asks_for_a_hit()),
    ("bound", |context| context.asks_for_a_hit()),
    ("step.next", |context| context.step.is_some()),
    ("step.bound", |context| context.asks_for_a_hit()),
    ("step.moving", |context| context.asks_for_a_hit()),
    ("step.turning", |context| context.asks_for_a_hit()),
];

/// Whether another answer to the question has the value of that name, where this one lacks it.
pub(crate) fn another_answer_has(name: &str, context: &Context) -> bool {
    OF_THE_OUTCOME.iter().any(|(known, asks)| *known == name && asks(context))
}
