//! What a layer may know: the scene, the panel it stands in, and what the algorithms answer and tell.

use std::sync::Arc;

use crate::collision::{Answer, Outcome, Separation};
use crate::geometry::{Body, DVec2, Pose, Side};
use crate::scene::{Scene, Space, When};
use crate::trace::Event;

use super::runs::{Run, Runs};
use super::sketch::Outline;

/// The moment that a panel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moment {
    /// The time, in [0, 1].
    pub(crate) time: f64,
    /// The algorithm's step, from 1, in a panel that shows one.
    pub(crate) step: Option<usize>,
}

/// What a layer may know of the figure, at its panel's moment.
pub(crate) struct Context<'f> {
    /// The scene that the figure shows.
    pub(crate) scene: &'f Scene,
    /// The space that the panel shows.
    pub(crate) space: &'f Space,
    /// The panel's moment, in [0, 1].
    pub(crate) time: f64,
    /// The algorithm's step that the panel shows, from 1.
    pub(crate) step: Option<usize>,
    /// The algorithm runs of the figure so far, to which the layers add.
    pub(crate) runs: &'f Runs,
}

impl Context<'_> {
    /// The query's bodies: A, and B where it is about two.
    #[must_use]
    pub(crate) fn sides(&self) -> Vec<Side> {
        if self.scene.query.of.len() > 1 { vec![Side::A, Side::B] } else { vec![Side::A] }
    }

    /// A body of the query with its name.
    fn shape(&self, side: Side) -> Option<&(crate::scene::Spanned<String>, Body)> {
        let index = usize::from(side == Side::B);
        self.scene.query.of.get(index).and_then(|&i| self.scene.shapes.get(i))
    }

    /// A body of the query; `None` for B where the query is about one.
    #[must_use]
    pub(crate) fn body(&self, side: Side) -> Option<&Body> {
        self.shape(side).map(|(_, body)| body)
    }

    /// A body's name as markup: a formula if it is one letter (`$A$`), else words.
    #[must_use]
    pub(crate) fn name(&self, side: Side) -> String {
        self.primed(side, 0)
    }

    /// A body's name with primes: `$A'$` for the body elsewhere, or at another time.
    #[must_use]
    pub(crate) fn primed(&self, side: Side, primes: usize) -> String {
        let name = self.shape(side).map_or("", |(name, _)| name.value.as_str());
        if name.chars().count() == 1 && name.chars().all(char::is_alphabetic) {
            format!("${name}{}$", "'".repeat(primes))
        } else {
            format!("{}{}", escaped(name), "′".repeat(primes))
        }
    }

    /// Where a body is at `time` in [0, 1]: its origin in world units and its rotation.
    #[must_use]
    pub(crate) fn pose(&self, side: Side, time: f64) -> Option<Pose> {
        self.body(side).map(|body| body.pose_at(time))
    }

    /// A body's outline at `time` in [0, 1], in world units.
    #[must_use]
    pub(crate) fn outline(&self, side: Side, time: f64) -> Option<Outline> {
        self.body(side).map(|body| Outline::of_body(body, &body.pose_at(time)))
    }

    /// A vertex of a body at `time` in [0, 1], in world units; `index` is its number in the file's order.
    #[must_use]
    pub(crate) fn vertex(&self, side: Side, index: usize, time: f64) -> Option<DVec2> {
        let body = self.body(side)?;
        Some(body.pose_at(time).point(*body.shape.vertices.get(index)?))
    }

    /// The run of the scene's own question at the panel's moment.
    #[must_use]
    pub(crate) fn run(&self) -> Arc<Run> {
        self.runs.own(self.scene, self.time)
    }

    /// A run that asks for the separation of the pair at `time` in [0, 1], whatever the scene asks; `None`
    /// for one body, and for shapes whose separation no algorithm answers.
    #[must_use]
    pub(crate) fn separation_at(&self, time: f64) -> Option<Arc<Run>> {
        self.runs.separation(self.scene, time)
    }

    /// A run that tells the edges of B ⊖ A at `time` in [0, 1]; `None` where no algorithm does.
    #[must_use]
    pub(crate) fn difference_at(&self, time: f64) -> Option<Arc<Run>> {
        self.runs.difference(self.scene, time)
    }

    /// The first contact: the last time in [0, 1] proved free, and the pair then, in world units; at t = 0
    /// for bodies that overlap from the start. `None` for any other answer.
    #[must_use]
    pub(crate) fn hit(&self) -> Option<(f64, Separation)> {
        match &self.run().answer {
            Answer::Impact(impact) => match impact.outcome {
                Outcome::Hit { time, contact } => Some((time.lo, contact)),
                Outcome::Overlapping { contact } => Some((0.0, contact)),
                Outcome::Miss | Outcome::Unresolved { .. } => None,
            },
            _ => None,
        }
    }

    /// Whether the question is for the first contact, whatever the answer is.
    #[must_use]
    pub(crate) fn asks_for_a_hit(&self) -> bool {
        matches!(self.run().answer, Answer::Impact(_))
    }

    /// The moment that a scene names; `None` where there is no hit, or no such step.
    #[must_use]
    pub(crate) fn moment(&self, when: &When) -> Option<Moment> {
        let at = |time| Some(Moment { time, step: None });
        match when {
            When::Time(t) => at(*t),
            When::Start => at(0.0),
            When::End => at(1.0),
            When::Hit => at(self.hit()?.0),
            When::Step(k) => {
                let time = self.steps().get(k.checked_sub(1)?).copied()?;
                Some(Moment { time, step: Some(*k) })
            }
        }
    }

    /// The times of an advancement's steps, each in [0, 1], in order; none for an algorithm without steps.
    #[must_use]
    pub(crate) fn steps(&self) -> Vec<f64> {
        let time = |e: &Event| if let Event::Advanced { at, .. } = e { Some(at.time) } else { None };
        self.run().told(time).collect()
    }
}

/// Plain text as markup: a dollar sign is written `\$`.
fn escaped(text: &str) -> String {
    text.replace('$', "\\$")
}
