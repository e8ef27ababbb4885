//! Which panels of a figure play, and to what moment.
//!
//! Those play whose moment the answer gives (`hit`, `closest`, `bound`), each up to its moment, so that the
//! figure is where they arrive. Where there are none, those play that say no moment, and where there are none
//! of them, the first panel of the world at `start` or `end`: up to the moment of the question, or to the
//! hit, the closest approach or the end of the motion. All other panels stand still, and graphs over time,
//! which show all moments.

use crate::collision::{Answer, Impact, Outcome};
use crate::geometry::{Body, DVec2};
use crate::scene::{Scene, Space, When};
use crate::trace::Event;

use super::panel::PanelPlan;
use super::plan::Plan;
use super::question::is_of_a_moment;
use super::runs::Run;

/// The panels of a figure that play, each with the moment at which it arrives.
pub(super) struct Played(pub(super) Vec<(usize, f64)>);

/// Whether a body moves or turns.
fn moves(body: &Body) -> bool {
    body.velocity != DVec2::ZERO || !body.spin.is_zero()
}

impl Played {
    /// Which panels of a plan play, or why none does.
    pub(super) fn of(plan: &Plan<'_>) -> Result<Self, &'static str> {
        let scene = plan.scene;
        if !scene.query.of.iter().filter_map(|&i| scene.shapes.get(i)).any(|(_, body)| moves(body)) {
            return Err("no body moves that the question is about");
        }
        let named = |panel: &PanelPlan| panel.source.when.as_ref().map(|when| when.value);
        let those = |is_so: fn(Option<When>) -> bool| {
            let all = plan.panels.iter().enumerate();
            all.filter(move |(_, panel)| !panel.is_chart() && is_so(named(panel)))
        };
        let answered = those(|when| matches!(when, Some(When::Hit | When::Closest | When::Bound)));
        let up_to_its_own = answered.map(|(i, panel)| (i, panel.moment.time)).filter(|(_, time)| *time > 0.0);
        let target = target(scene, &plan.own_run());
        let free = those(|when| when.is_none()).map(|(i, _)| (i, target));
        let pinned = those(|when| matches!(when, Some(When::Start | When::End)));
        let world = pinned.filter(|(_, panel)| panel.source.space != Space::Configuration);
        let world = world.take(1).map(|(i, _)| (i, target));
        let tiers: [Vec<(usize, f64)>; 3] = [up_to_its_own.collect(), free.collect(), world.collect()];
        let found = tiers.into_iter().find(|panels| !panels.is_empty()).map(Self);
        found.ok_or("each panel is pinned to a time or a step, or shows configuration space")
    }

    /// The last moment.
    pub(super) fn end(&self) -> f64 {
        self.0.iter().map(|(_, time)| *time).fold(0.0, f64::max)
    }

    /// Whether a figure tells its answer at a time: where the motion has come to it, and that bodies overlap
    /// from the start while they stand there.
    pub(super) fn tells_answer(&self, plan: &Plan, time: f64) -> bool {
        match &plan.own_run().answer {
            Answer::Impact(Impact { outcome: Outcome::Overlapping { .. }, .. }) => time <= 0.0,
            _ => time >= self.end(),
        }
    }

    /// Whether the figure shows all of them where they arrive.
    pub(super) fn is_shown(&self, plan: &Plan) -> bool {
        self.0.iter().all(|&(i, time)| plan.panels[i].moment.time == time)
    }

    /// The moments of all panels of a figure at `time`; none for those that stand still.
    pub(super) fn moments(&self, count: usize, time: f64) -> Vec<Option<f64>> {
        let mut all = vec![None; count];
        for &(i, until) in &self.0 {
            all[i] = Some(time.min(until));
        }
        all
    }
}

/// The moment that a motion leads to: that of the question, or the hit, the closest approach or else the end
/// of the motion.
fn target(scene: &Scene, run: &Run) -> f64 {
    let closest = |event: &Event| match event {
        Event::ClosestApproachFound { at, .. } => Some(at.time),
        _ => None,
    };
    let time = match &run.answer {
        _ if is_of_a_moment(scene.query.kind) => scene.query.time,
        Answer::Impact(impact) => match impact.outcome {
            Outcome::Hit { time, .. } => time.lo,
            Outcome::Unresolved { free_until, .. } => free_until,
            Outcome::Miss => run.events().find_map(closest).unwrap_or(0.0),
            Outcome::Overlapping { .. } => 0.0,
        },
        _ => 0.0,
    };
    if time > 0.0 { time } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use crate::drawing::Item;
    use crate::figure::{draw_in_motion, plan};
    use crate::scene::open_text;

    /// Whether each picture of a film of a question for the first contact of two bodies tells the answer.
    fn told(a: &str, b: &str) -> Vec<bool> {
        let query = "query = { kind = 'linear-sweep', of = ['A', 'B'] }";
        let scene =
            open_text("s", &format!("shapes.A = {{ {a} }}\nshapes.B = {{ {b} }}\n{query}")).unwrap().scene;
        let plan = plan(&scene).unwrap().with_room_to_move().unwrap();
        let drawing = draw_in_motion(&plan, plan.theme, "s", 3).unwrap().drawing;
        let tells = |items: &[Item]| {
            let is_caption = |item: &Item| matches!(item, Item::Group(group) if group.name == "caption");
            let drawn = items.iter().filter(|item| is_caption(item)).map(Item::extent);
            drawn.flatten().count() > 0
        };
        drawing.pictures().iter().map(|(picture, _)| tells(&picture.items)).collect()
    }

    #[test]
    fn that_bodies_overlap_from_the_start_is_told_while_they_stand_there() {
        let block = "kind = 'box', half_extents = [1, 0.5]";
        let told = told(&format!("{block}, velocity = [6, 0]"), &format!("{block}, position = [-1, 0.4]"));
        assert_eq!(told, [true, false, false, true], "at the start, and as the figure");
    }

    #[test]
    fn an_answer_is_told_where_the_motion_has_come_to_it() {
        let told = told(
            "kind = 'circle', radius = 1, velocity = [8, 0]",
            "kind = 'circle', radius = 1, position = [6, 0]",
        );
        assert_eq!(told, [false, false, true, true], "twice on the way, at the hit, and as the figure");
    }
}
