//! The values that hang on how an answer turns out: a text may name one that this answer lacks, if another
//! has it.

use crate::collision::QueryKind;
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
    ("hit.n.x", |context| context.asks_for_a_hit()),
    ("hit.n.y", |context| context.asks_for_a_hit()),
    ("bound", |context| context.asks_for_a_hit()),
    ("contacts", asks_for_contact),
    ("d_1", asks_for_contact),
    ("d_2", asks_for_contact),
    ("shallow", asks_for_contact),
    ("contact.a.x", asks_for_contact),
    ("contact.a.y", asks_for_contact),
    ("contact.b.x", asks_for_contact),
    ("contact.b.y", asks_for_contact),
    ("step.next", |context| context.step.is_some()),
    ("step.bound", |context| context.asks_for_a_hit()),
    ("step.moving", |context| context.asks_for_a_hit()),
    ("step.turning", |context| context.asks_for_a_hit()),
];

/// Whether the question is for a contact: of one point or two, or of none.
fn asks_for_contact(context: &Context) -> bool {
    context.scene.query.kind == QueryKind::Contact
}

/// Whether another answer to the question has the value of that name, where this one lacks it.
pub(crate) fn another_answer_has(name: &str, context: &Context) -> bool {
    OF_THE_OUTCOME.iter().any(|(known, asks)| *known == name && asks(context))
}

#[cfg(test)]
mod tests {
    use super::another_answer_has;
    use crate::figure::plan;
    use crate::figure::text::values::{VALUES, value_of};
    use crate::scene::open_text;

    /// The values that a question about two circles of radius 1 has, and those that it lacks and another
    /// answer has; B comes from `x`.
    fn values(query: &str, x: f64) -> [Vec<&'static str>; 2] {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [{x}, 0.5], velocity = [-4, 0] }}
            query = {{ of = ['A', 'B'], {query} }}"
        );
        let scene = open_text("outcome", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let context = plan.panels[0].context(&scene, &plan.runs);
        let names = VALUES.iter().map(|value| value.name);
        let (has, lacks): (Vec<_>, Vec<_>) = names.partition(|name| value_of(name, &context).is_some());
        [has, lacks.into_iter().filter(|name| another_answer_has(name, &context)).collect()]
    }

    #[test]
    fn what_one_outcome_of_a_question_has_no_other_one_takes_for_a_mistake() {
        for query in [
            "kind = 'time-of-impact'",
            "kind = 'time-of-impact', algorithm = 'conservative-advancement'",
            "kind = 'linear-sweep'",
            "kind = 'separation'",
            "kind = 'contact'",
        ] {
            // A hit, a miss and an overlap.
            let all = [4.0, 9.0, 1.0].map(|x| values(query, x));
            for [has, _] in &all {
                for (k, [own, of_others]) in all.iter().enumerate() {
                    for name in has {
                        assert!(own.contains(name) || of_others.contains(name), "{query}: {name}, {k}");
                    }
                }
            }
        }
    }
}
