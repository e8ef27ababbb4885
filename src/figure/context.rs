//! What a layer may know: the scene, the panel it stands in, and what the algorithms answer and tell.
//!
//! Places are those that the panel shows: in a moving body's frame, what is at another moment is where it is
//! as seen from that body then (`moving_frame.rs`).

use std::sync::Arc;

use crate::collision::{Answer, Outcome, Separation};
use crate::geometry::{Body, DVec2, Enclosure, Pose, Side};
use crate::scene::{Scene, Space, When};
use crate::trace::Event;
use crate::trace::step::advanced;

use super::cue::Cue;
use super::moving_frame::MovingFrame;
use super::name::Name;
use super::question::keeps_the_difference;
use super::runs::{Run, Runs};
use super::sketch::Outline;

/// How many pieces a full turn of a way is drawn in, and any curved way at least: as many chords are 0.3 px
/// from a path of 200 px radius.
const PIECES: u32 = 64;
/// How many turns of a way are drawn: more are a blur, and at fewer pieces each it would be another way.
const MOST_TURNS: u32 = 128;

/// The moment that a panel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moment {
    /// The time, in [0, 1].
    pub(crate) time: f64,
    /// The algorithm's step, from 1, in a panel that shows one.
    pub(crate) step: Option<usize>,
}

/// How near the bodies of a miss came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Approach {
    /// When they are closest, in [0, 1].
    pub(crate) time: f64,
    /// How far apart they are then, world units.
    pub(crate) separation: f64,
    /// Encloses the least separation over [0, 1], world units.
    pub(crate) bounds: Enclosure,
    /// The closest points of A and B then.
    pub(crate) points: [DVec2; 2],
}

/// How many pieces a way that turns by so many radians is drawn in; `None` where it turns too often.
fn pieces(turn: f64) -> Option<u32> {
    let turns = turn / std::f64::consts::TAU;
    match turns {
        0.0 => Some(1),
        _ => whole_turns(turns, MOST_TURNS).map(|whole| whole * PIECES),
    }
}

/// The whole turns, one at least, that hold so many turns; `None` where there would be more than `most`.
pub(crate) fn whole_turns(turns: f64, most: u32) -> Option<u32> {
    (1..=most).find(|&whole| f64::from(whole) >= turns)
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
    /// What becomes of the panel in a figure that plays.
    pub(crate) play: super::play::Play,
    /// The algorithm runs of the figure so far, to which the layers add.
    pub(crate) runs: &'f Runs,
}

impl Context<'_> {
    /// What `look` finds where another scene is asked.
    pub(crate) fn where_asked<T>(&self, scene: &Scene, look: impl FnOnce(&Context) -> T) -> T {
        look(&Context { scene, runs: &Runs::default(), ..*self })
    }

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

    /// A body's name, to be set in type.
    pub(crate) fn named(&self, side: Side) -> Name<'_> {
        self.runs.called.side(self.scene, side)
    }

    /// A body's name as markup.
    #[must_use]
    pub(crate) fn name(&self, side: Side) -> String {
        self.named(side).primed(0)
    }

    /// A quantity of a body in LaTeX: numbered where the bodies have letters for names, as the article's r₁
    /// and r₂ of A and B; else with the body's name.
    #[must_use]
    pub(crate) fn numbered(&self, letter: &str, side: Side) -> String {
        match side {
            _ if !self.has_letters() => self.named(side).below(letter),
            Side::A => format!("{letter}_1"),
            Side::B => format!("{letter}_2"),
        }
    }

    /// Whether both bodies have letters for names, as the article's.
    #[must_use]
    pub(crate) fn has_letters(&self) -> bool {
        self.sides().into_iter().all(|side| self.named(side).is_symbol())
    }

    /// The frame of the moving body in which the panel shows the world; `None` in other panels, and where the
    /// body rests.
    #[must_use]
    pub(crate) fn moving_frame(&self) -> Option<MovingFrame<'_>> {
        let Space::Body(index) = *self.space else { return None };
        let (_, body) = self.scene.shapes.get(index)?;
        MovingFrame::of(body, self.time)
    }

    /// The pose of the body in whose frame the panel shows the world, at the panel's moment; `None` in other
    /// panels.
    #[must_use]
    pub(crate) fn frame(&self) -> Option<Pose> {
        let Space::Body(index) = *self.space else { return None };
        self.scene.shapes.get(index).map(|(_, body)| body.pose_at(self.time))
    }

    /// The symbol of a quantity of a body, as markup: `$v_A$`, or as a moving frame sees it `$v_{A/B}$`.
    #[must_use]
    pub(crate) fn symbol(&self, letter: &str, side: Side) -> String {
        let own = self.named(side);
        let frame = self.moving_frame().and(match *self.space {
            Space::Body(index) => Some(self.runs.called.name(self.scene, index)),
            Space::World | Space::Configuration => None,
        });
        match frame {
            Some(name) => format!("${letter}_{{{}/{}}}$", own.script(), name.script()),
            None => format!("${}$", own.below(letter)),
        }
    }

    /// A point of the world in the coordinates of the panel's space.
    #[must_use]
    pub(crate) fn in_space(&self, p: DVec2) -> DVec2 {
        self.frame().map_or(p, |frame| frame.inverse_point(p))
    }

    /// Where a body is at `time` in [0, 1], as the panel shows it: its origin, in world units, and its
    /// rotation.
    #[must_use]
    pub(crate) fn pose(&self, side: Side, time: f64) -> Option<Pose> {
        let body = self.body(side)?;
        Some(self.moving_frame().map_or_else(|| body.pose_at(time), |frame| frame.pose(body, time)))
    }

    /// A body's outline at `time` in [0, 1], in world units.
    #[must_use]
    pub(crate) fn outline(&self, side: Side, time: f64) -> Option<Outline> {
        Some(Outline::of_body(self.body(side)?, &self.pose(side, time)?))
    }

    /// The bodies that are asked nothing, each with its index, its name as markup and its outline at the
    /// panel's moment, as the panel shows it.
    pub(crate) fn bystanders(&self) -> impl Iterator<Item = (usize, String, Outline)> {
        let shapes = self.scene.shapes.iter().enumerate();
        shapes.filter(|(i, _)| !self.scene.query.of.contains(i)).map(|(i, (_, body))| {
            let name = self.runs.called.name(self.scene, i).primed(0);
            (i, name, Outline::of_body(body, &body.pose_at(self.time)))
        })
    }

    /// A vertex of a body at `time` in [0, 1], in world units; `index` is its number in the file's order.
    #[must_use]
    pub(crate) fn vertex(&self, side: Side, index: usize, time: f64) -> Option<DVec2> {
        Some(self.pose(side, time)?.point(*self.body(side)?.shape.vertices.get(index)?))
    }

    /// The closing velocity `v_A` − `v_B`: the way the origin goes, seen from B ⊖ A.
    #[must_use]
    pub(crate) fn closing_velocity(&self) -> DVec2 {
        let velocity = |side| self.body(side).map_or(DVec2::ZERO, |body| body.velocity);
        velocity(Side::A) - velocity(Side::B)
    }

    /// Whether a body of the query turns.
    #[must_use]
    pub(crate) fn turns(&self) -> bool {
        self.sides().into_iter().any(|side| self.body(side).is_some_and(|body| !body.spin.is_zero()))
    }

    /// The time at which a panel of configuration space shows B ⊖ A: the panel's moment. A step of a sweep
    /// without turning moves the estimate and not the difference: that is as it was at the start.
    #[must_use]
    pub(crate) fn difference_time(&self) -> f64 {
        let still = self.step.is_some() && keeps_the_difference(self.scene.query.kind);
        if still { 0.0 } else { self.time }
    }

    /// Where the origin of the panel's moment lies against the B ⊖ A that the panel shows: the estimate of a
    /// sweep's step, else the origin itself.
    #[must_use]
    pub(crate) fn estimate(&self) -> DVec2 {
        self.closing_velocity() * (self.time - self.difference_time())
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

    /// The separation of the pair at `time` in [0, 1], its points and normal as the panel shows them; `None`
    /// as for [`Context::separation_at`].
    #[must_use]
    pub(crate) fn separation_seen(&self, time: f64) -> Option<Separation> {
        self.separation_at(time)?.separation().map(|found| self.seen(found, time))
    }

    /// What was found at `time`, its points and normal as the panel shows them.
    fn seen(&self, found: &Separation, time: f64) -> Separation {
        self.moving_frame().map_or(*found, |frame| frame.separation(found, time))
    }

    /// A run that tells the edges of B ⊖ A at `time` in [0, 1]; `None` where no algorithm does.
    #[must_use]
    pub(crate) fn difference_at(&self, time: f64) -> Option<Arc<Run>> {
        self.runs.difference(self.scene, time)
    }

    /// The time of first contact with its bounds; 0 for bodies that overlap from the start. `None` for any
    /// other answer.
    #[must_use]
    pub(crate) fn hit_time(&self) -> Option<Enclosure> {
        match &self.run().answer {
            Answer::Impact(impact) => match impact.outcome {
                Outcome::Hit { time, .. } => Some(time),
                Outcome::Overlapping { .. } => Some(Enclosure { lo: 0.0, hi: 0.0 }),
                Outcome::Miss | Outcome::Unresolved { .. } => None,
            },
            _ => None,
        }
    }

    /// A run of the scene's own question that tells the first step of an advancement, from t = 0; `None`
    /// where no algorithm takes one.
    #[must_use]
    pub(crate) fn first_step(&self) -> Option<Arc<Run>> {
        self.runs.first_step(self.scene)
    }

    /// The time until which the first step of an advancement proves the bodies free; `None` where it takes
    /// none, or needs none.
    #[must_use]
    fn bound_time(&self) -> Option<f64> {
        let next = |event: &Event| if let Event::Advanced { next, .. } = event { Some(*next) } else { None };
        self.first_step()?.find_told(next)?
    }

    /// The first contact: the last time in [0, 1] proved free, and the pair then, as the panel shows it; at
    /// t = 0 for bodies that overlap from the start. `None` for any other answer.
    #[must_use]
    pub(crate) fn hit(&self) -> Option<(f64, Separation)> {
        let time = self.hit_time()?.lo;
        let contact = *self.run().separation()?;
        Some((time, self.seen(&contact, time)))
    }

    /// How near a miss came, its points as the panel shows them; `None` for any other answer.
    #[must_use]
    pub(crate) fn closest(&self) -> Option<Approach> {
        let run = self.run();
        let mut approach = run.find_told(|event| match *event {
            Event::ClosestApproachFound { at, separation, bounds, points, .. } => {
                Some(Approach { time: at.time, separation, bounds, points })
            }
            _ => None,
        })?;
        if self.moving_frame().is_some() {
            let there = self.body(Side::A)?.pose_at(approach.time);
            let here = self.pose(Side::A, approach.time)?;
            approach.points = approach.points.map(|p| here.point(there.inverse_point(p)));
        }
        Some(approach)
    }

    /// The way of the point of a body that is at `local` in its frame, from one time to another, as the panel
    /// shows it: two points where it is straight, none where it turns more often than can be drawn.
    #[must_use]
    pub(crate) fn track(&self, side: Side, local: DVec2, [from, to]: [f64; 2]) -> Vec<DVec2> {
        let spin = |body: &Body| if local == DVec2::ZERO { 0.0 } else { body.spin.radians().abs() };
        let own = self.body(side).map_or(0.0, spin);
        let seen = self.moving_frame().map_or(0.0, |frame| frame.turning());
        let Some(pieces) = pieces((own + seen) * (to - from).abs()) else { return Vec::new() };
        let time = |i: u32| from + (to - from) * (f64::from(i) / f64::from(pieces));
        let at = |i: u32| self.pose(side, time(i)).map(|pose| pose.point(local));
        (0..=pieces).filter_map(at).collect()
    }

    /// Whether the question is for the first contact, whatever the answer is.
    #[must_use]
    pub(crate) fn asks_for_a_hit(&self) -> bool {
        matches!(self.run().answer, Answer::Impact(_))
    }

    /// The cue of the last event of the scene's own question that is so; `None` where none is.
    #[must_use]
    pub(crate) fn cue(&self, is_so: impl Fn(&Event) -> bool) -> Option<Cue> {
        self.run().last_cue(is_so)
    }

    /// The cue of the answer to the scene's own question at the panel's moment.
    #[must_use]
    pub(crate) fn answered(&self) -> Cue {
        self.run().end()
    }

    /// The cue with which a moment is known; `None` for one that needs no answer.
    #[must_use]
    pub(crate) fn known(&self, when: &When) -> Option<Cue> {
        let left = |k: usize| {
            let run = self.run();
            let cue = run.last_cue(|event| matches!(event, Event::Advanced { step, .. } if *step == k));
            cue.map(|cue| cue.part(advanced::NEXT))
        };
        match when {
            When::Time(_) | When::Start | When::End => None,
            When::Hit => Some(self.answered()),
            When::Closest => self.cue(|event| matches!(event, Event::ClosestApproachFound { .. })),
            When::Bound => {
                let cue = self.first_step()?.last_cue(|event| matches!(event, Event::Advanced { .. }));
                cue.map(|cue| cue.part(advanced::NEXT))
            }
            When::Step(k) => left(k.checked_sub(1)?),
        }
    }

    /// The moment that a scene names; `None` where there is no hit, no miss, or no such step.
    #[must_use]
    pub(crate) fn moment(&self, when: &When) -> Option<Moment> {
        let at = |time| Some(Moment { time, step: None });
        match when {
            When::Time(t) => at(*t),
            When::Start => at(0.0),
            When::End => at(1.0),
            When::Hit => at(self.hit()?.0),
            When::Closest => at(self.closest()?.time),
            When::Bound => at(self.bound_time()?),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_has_as_many_pieces_as_it_turns_and_none_where_it_is_a_blur() {
        let turns = |turns: f64| pieces(turns * std::f64::consts::TAU);
        assert_eq!([0.0, 0.25, 1.0, 4.5].map(turns), [Some(1), Some(64), Some(64), Some(320)]);
        assert_eq!((turns(128.0), turns(129.0)), (Some(8192), None));
    }
}
