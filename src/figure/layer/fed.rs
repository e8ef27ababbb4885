//! Whether a layer finds what it draws: in this answer, in another answer to the same question, or never.
//!
//! A scene is often a template that many lines of a log are put through. One of them is a miss, and then the
//! layer of the contact has nothing to draw; that is no mistake in the scene. A layer that no answer could
//! ever feed is one.

use crate::collision::{Answer, Outcome};
use crate::figure::context::Context;
use crate::scene::{NOTES, When};

use super::Options;

/// Whether a layer finds what it draws at its panel's moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fed {
    /// It does.
    Yes,
    /// It does, but one of its options has nothing to draw.
    Without {
        /// The option.
        option: &'static str,
        /// Why not, as "the bodies are apart".
        why: &'static str,
    },
    /// The answer lacks it, and another answer to the same question may have it: the layer draws nothing.
    NotByThisAnswer,
    /// The answer lacks it for this reason, as "the closest points are vertices of both".
    NotHere(&'static str),
    /// No answer to the scene's question by its algorithm has it: the scene is wrong.
    Never,
}

impl Fed {
    /// The answer lacks it for this reason, which no page tells.
    pub(super) fn not_here(why: &'static str) -> Self {
        Self::NotHere(if NOTES { why } else { "" })
    }

    /// What is drawn at one moment only: a `path` that is asked for has no way to draw.
    pub(super) fn at_one_moment(self, options: &Options) -> Self {
        match self {
            Self::Yes if NOTES && options.flag("path", false) => {
                Self::Without { option: "path", why: "no motion leads there" }
            }
            other => other,
        }
    }

    /// A layer that depends on the scene's bodies and algorithm alone, and not on how the answer turns out.
    pub(super) fn by_the_scene(found: bool) -> Self {
        if found { Self::Yes } else { Self::Never }
    }

    /// A layer that finds its matter or does not, where `ever` says whether another answer could have it.
    pub(super) fn by_the_answer(found: bool, ever: bool) -> Self {
        match (found, ever) {
            (true, _) => Self::Yes,
            (false, true) => Self::NotByThisAnswer,
            (false, false) => Self::Never,
        }
    }

    /// A layer of another moment, which the answer has or has not; a miss that is proved at the start has no
    /// first step.
    pub(super) fn by_a_moment(found: bool, context: &Context, when: Option<When>) -> Self {
        match (&context.run().answer, when) {
            (Answer::Impact(impact), Some(When::Bound)) if !found && impact.outcome == Outcome::Miss => {
                Self::not_here("the start alone proves that nothing touches, and there is no first step")
            }
            _ => Self::by_the_answer(found, context.asks_for_a_hit()),
        }
    }

    /// A layer of a step of the algorithm, which finds the one that is asked for or does not: whether any was
    /// told, and whether another answer could have some.
    pub(super) fn by_the_steps(found: bool, any: bool, ever: bool) -> Self {
        match (found, any) {
            (true, _) => Self::Yes,
            (false, true) => Self::not_here("the algorithm took fewer steps"),
            (false, false) => Self::by_the_answer(false, ever),
        }
    }

    /// A layer of the first contact.
    pub(super) fn by_a_hit(context: &Context) -> Self {
        Self::by_the_answer(context.hit().is_some(), context.asks_for_a_hit())
    }

    /// What is drawn by an answer without a hit too: an option that needs one, if it is given, draws nothing.
    pub(super) fn with_a_hit_for(self, option: Option<&'static str>, context: &Context) -> Self {
        match option {
            Some(option) if NOTES && self == Self::Yes && context.hit().is_none() => {
                Self::Without { option, why: "the answer has no hit" }
            }
            _ => self,
        }
    }

    /// Fed where it has something to draw; else, in the panel of a frame that moves, not there, for the first
    /// reason, and in a question for the first contact, whose bodies may well be at rest, for the second.
    pub(super) fn by_the_frame(
        found: bool,
        context: &Context,
        [of_frame, at_rest]: [&'static str; 2],
    ) -> Self {
        match (found, context.moving_frame()) {
            (true, _) => Self::Yes,
            (false, Some(_)) => Self::not_here(of_frame),
            (false, None) if context.asks_for_a_hit() => Self::not_here(at_rest),
            (false, None) => Self::Never,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::plan;
    use crate::scene::open_text;

    #[test]
    fn a_miss_without_a_first_step_says_so_and_one_with_it_has_the_moment() {
        for (velocity, told) in [("[-3, 0]", true), ("[3, 0]", false)] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], position = [-3, 3],
                    velocity = {velocity} }}
                shapes.B = {{ kind = 'circle', radius = 1 }}
                query = {{ kind = 'time-of-impact', of = ['A', 'B'] }}
                panels = [{{ layers = ['shapes', {{ layer = 'ghosts', at = 'bound' }},
                    {{ layer = 'separation', at = 'bound' }}] }}]"
            );
            let scene = open_text("bound", &text).unwrap().scene;
            let told_of: Vec<String> =
                plan(&scene).unwrap().warnings.iter().map(|w| w.fault.to_string()).collect();
            let said = told_of.iter().filter(|note| note.ends_with("and there is no first step")).count();
            assert_eq!((said, told_of.len()), if told { (2, 2) } else { (0, 0) }, "{told_of:?}");
        }
    }
}
