//! What a cue says: the title of a step that ends with it, and what happened.

use std::mem::Discriminant;
use std::sync::Arc;

use crate::collision::{Answer, Outcome};
use crate::scene::Scene;
use crate::trace::{Event, Voice, growth, so_far, step, taken, told};

use super::cue::{Cue, Teller};
use super::describe::Account;
use super::runs::{Run, tells_difference};

/// A cue in words.
pub(super) struct Told {
    /// The cue.
    pub(super) cue: Cue,
    /// The title of a step that ends with it.
    pub(super) title: String,
    /// What happened.
    pub(super) sentence: String,
    /// Whether a step ends with it.
    pub(super) ends: bool,
    /// Whether it is B ⊖ A as another algorithm knows it.
    pub(super) is_given: bool,
    /// The kind of event.
    kind: Discriminant<Event>,
}

impl Told {
    /// Whether it may be of the step of the next one: of its run, and not the same again, which follows from
    /// nothing that the figure shows of this one.
    pub(super) fn prepares(&self, next: &Self) -> bool {
        next.cue.is_of_the_run_of(&self.cue) && next.kind != self.kind
    }

    /// What one of the cues says; `None` where no run has it.
    pub(super) fn of(
        (scene, voice): (&Scene, Voice),
        runs: &[Arc<Run>],
        (cue, all_cues): (Cue, &[Cue]),
    ) -> Option<Self> {
        let (run, event) = runs.iter().find_map(|run| Some((run, run.event_of(&cue)?)))?;
        let title = step::title(event, cue.part, voice);
        let is_given = cue.teller != Teller::Own && tells_difference(event);
        let ends = step::ends_step(event);
        let kind = std::mem::discriminant(event);
        let tell = |title, sentence| Self { cue, title, sentence, ends, is_given, kind };
        Some(match event {
            Event::DifferenceEdgeFound { .. } | Event::DifferenceRounded { .. }
                if is_whole(&cue) && run.events().any(tells_edge) =>
            {
                let edges = run.events().filter(|event| tells_edge(event)).count();
                // One that looks at its edges, and stops before the last, has a use for it.
                let looks = |run: &Arc<Run>| run.is_own() && run.events().any(tells_difference);
                let is_unbuilt = is_given && !runs.iter().any(looks);
                let whole = step::sentence_of_difference(edges, is_unbuilt, voice);
                let round = run.events().find(|event| matches!(event, Event::DifferenceRounded { .. }));
                let round = round.map(|event| step::sentence_of_part(event, cue.part, voice));
                tell(voice.difference(), together([Some(whole), round].into_iter().flatten()))
            }
            Event::Finished { .. } => {
                let of_a_moment = cue.teller == Teller::OtherQuestion;
                let title = if of_a_moment { step::title_at(cue.asked, voice) } else { title };
                let end = end_of_advancement(run, all_cues, voice);
                tell(title, together(end.into_iter().chain([result((scene, voice), runs, run)])))
            }
            Event::SimplexUpdated { .. } | Event::PolytopeExpanded { .. } => {
                let all = &run.trace.events;
                let (before, after) = (&all[..cue.event], &all[cue.event + 1..]);
                let title = growth::title(before, event, after, voice).unwrap_or(title);
                let said = growth::sentence(event, after.iter(), voice);
                let said = said.unwrap_or_else(|| step::sentence_of_part(event, cue.part, voice));
                let held = growth::held(before, event, voice);
                let held = held.filter(|(simplex, _)| !shows(simplex, run, all_cues)).map(|(_, said)| said);
                tell(title, together(held.into_iter().chain([said])))
            }
            Event::RayClipped { .. } if told::is_away(event) => {
                let away = run.events().skip(cue.event).take_while(|event| told::is_away(event)).count();
                tell(title, told::skipped(away, voice).unwrap_or_default())
            }
            _ => {
                let title = taken::title(&run.trace.events, cue.event, voice).unwrap_or(title);
                let may_be_the_end = matches!(event, Event::CandidateImproved { .. });
                let search = || told::Search::of(run.events()).at(&run.trace.events[cue.event + 1..]);
                let end = may_be_the_end.then(search).and_then(|search| search.end(event, voice));
                let so_far = || so_far::sentence(&run.trace.events[..cue.event], event, voice);
                let own = || step::sentence_of_part(event, cue.part, voice);
                let said = || together([Some(own()), so_far()].into_iter().flatten());
                let advanced = || advanced((run, event), (cue, all_cues), voice);
                tell(title, end.or_else(advanced).unwrap_or_else(said))
            }
        })
    }
}

/// What a step says that stands in the place of another: what is that of now, and what of before.
pub(super) fn titled(title: &str, said: String) -> String {
    if said.starts_with(title) { said } else { format!("{title} – {said}") }
}

/// Sentences one after the other.
fn together(sentences: impl Iterator<Item = String>) -> String {
    sentences.collect::<Vec<_>>().join(" ")
}

/// What a step of an advancement says beside its own: how many came before of which the figure shows none,
/// and how far apart the bodies are, where no mark comes with that and how far it is safe follows from it.
fn advanced((run, event): (&Run, &Event), (cue, all): (Cue, &[Cue]), voice: Voice) -> Option<String> {
    let number = |event: &Event| match event {
        Event::Advanced { step, .. } => Some(*step),
        _ => None,
    };
    let now = number(event)?;
    let is_before = |other: &&Cue| other.is_of_the_run_of(&cue) && other.event < cue.event;
    let last = all.iter().filter(is_before).filter_map(|other| number(run.event_of(other)?)).max();
    let apart = cue.part(step::advanced::APART);
    let is_first = !all.contains(&apart) || cue == apart;
    let left_out = last.and_then(|last| now.checked_sub(last + 1)).filter(|&count| is_first && count > 0);
    let parts = if is_first { apart.part..=cue.part } else { cue.part..=cue.part };
    let said = left_out.map(|count| step::left_out(count, voice));
    let own = parts.map(|part| step::sentence_of_part(event, part, voice));
    Some(together(said.into_iter().chain(own)))
}

/// Why the advancement of a run ends, where no mark of the figure comes with that.
fn end_of_advancement(run: &Run, all: &[Cue], voice: Voice) -> Option<String> {
    let Answer::Impact(impact) = &run.answer else { return None };
    let last = run.last_cue(|event| matches!(event, Event::Advanced { .. }))?.part(step::advanced::NEXT);
    let event = run.event_of(&last).filter(|_| !all.contains(&last))?;
    let end = step::end_of_advancement(event, impact.tolerance, voice)?;
    // "That" is how far apart they are then.
    let apart = last.part(step::advanced::APART);
    let said = if all.contains(&apart) { None } else { advanced((run, event), (apart, all), voice) };
    let said = said.map(|said| titled(&step::title(event, apart.part, voice), said));
    Some(together(said.into_iter().chain([end])))
}

/// What a run came to.
pub(super) fn result((scene, voice): (&Scene, Voice), runs: &[Arc<Run>], run: &Run) -> String {
    let beside = |other: &&Arc<Run>| other.time == run.time && other.separation().is_some();
    let other = runs.iter().find(beside).map(Arc::as_ref);
    let told = Account::beside(scene, run, other);
    if run.is_own() { told.sentence_and_off(voice.names) } else { told.sentence_of_bodies(voice.names) }
}

/// What the result of a motion says, too: how deep bodies overlap at the start, how near a miss comes.
pub(super) fn said_again(of: (&Scene, Voice), runs: &[Arc<Run>]) -> Option<String> {
    let own = runs.iter().find(|run| run.is_own())?;
    let Answer::Impact(impact) = &own.answer else { return None };
    match impact.outcome {
        Outcome::Overlapping { .. } => {
            let mut others = runs.iter().filter(|run| !run.is_own() && run.time == 0.0);
            others.find(|run| run.separation().is_some()).map(|run| result(of, runs, run))
        }
        Outcome::Miss => {
            let is_closest = |event: &&Event| matches!(event, Event::ClosestApproachFound { .. });
            own.events().find(is_closest).map(|event| step::sentence_of_part(event, 0, of.1))
        }
        Outcome::Hit { .. } | Outcome::Unresolved { .. } => None,
    }
}

/// Whether a mark of the figure comes with an event.
fn shows(event: &Event, run: &Run, cues: &[Cue]) -> bool {
    cues.iter().filter_map(|cue| run.event_of(cue)).any(|shown| std::ptr::eq(shown, event))
}

/// Whether a cue of B ⊖ A is that of the whole.
fn is_whole(cue: &Cue) -> bool {
    cue.teller != Teller::Own || cue.part == step::WHOLE
}

/// Whether an event tells an edge of B ⊖ A.
fn tells_edge(event: &Event) -> bool {
    matches!(event, Event::DifferenceEdgeFound { .. })
}

#[cfg(test)]
mod tests {
    use crate::drawing::Step;
    use crate::figure::{Fault, draw, draw_in_steps, plan};
    use crate::scene::open_text;

    /// The steps of a question about two bodies, drawn as we choose.
    fn steps(a: &str, b: &str, query: &str) -> Vec<Step> {
        let text =
            format!("shapes.A = {{ {a} }}\nshapes.B = {{ {b} }}\nquery = {{ of = ['A', 'B'], {query} }}");
        let scene = open_text("s", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        draw_in_steps(&plan, plan.theme, "f").drawing.steps
    }

    #[test]
    fn what_is_known_beside_the_answer_comes_with_it_and_is_said_once() {
        let ball = "kind = 'circle', radius = 0.6, position = [1.4, 1.1]";
        let all =
            steps("kind = 'aabb', half_extents = [1, 0.5]", ball, "kind = 'overlap', algorithm = 'clamp'");
        let titles: Vec<&str> = all.iter().map(|step| step.title.as_str()).collect();
        let [first, .., last] = titles[..] else { panic!("{titles:?}") };
        assert_eq!((first, titles[1], last), ("The question", "From centre to centre", "The answer"));
        let ground = "kind = 'polygon', vertices = [[-3, -1], [3, -0.6], [3, 0.2], [-3, 0]]";
        let all = steps(ground, "kind = 'circle', radius = 0.5, position = [0.4, 0.5]", "kind = 'contact'");
        let last = all.last().unwrap();
        assert_eq!((last.title.as_str(), last.sentences.len()), ("The answer", 1), "{last:?}");
    }

    #[test]
    fn a_step_of_an_advancement_says_what_it_follows_from_and_how_many_are_left_out() {
        let a = "kind = 'box', half_extents = [1.5, 0.08], angular_velocity_deg = 100";
        let b = "kind = 'regular-polygon', edges = 5, circumradius = 0.4, position = [0.9, 1.3]";
        let query = "kind = 'time-of-impact', algorithm = 'conservative-advancement' }
            panels = [{ time = 'start', layers = ['shapes', 'contact'] }, { space = 'configuration',
                time = 'start', layers = ['axes', { layer = 'difference', at = 'steps' }] }]
            canvas = {";
        let all = steps(a, b, query);
        let said: Vec<String> = all.iter().map(|step| step.sentences.join(" ")).collect();
        let safe = |said: &&String| said.contains("nothing touches before");
        assert!(said.iter().filter(safe).count() > 2, "{said:?}");
        assert!(said.iter().filter(safe).all(|said| said.contains("apart along")), "{said:?}");
        assert!(said.iter().any(|said| said.starts_with("Steps in between: ")), "{said:?}");
    }

    #[test]
    fn a_bound_is_told_of_the_body_that_turns() {
        let rotor = "kind = 'box', half_extents = [2, 0.2], angular_velocity_deg = 200";
        let mast = "kind = 'box', half_extents = [1, 1], position = [4, 1], velocity = [-1, 0]";
        let all = steps(rotor, mast, "kind = 'motion-bound'");
        let said: String = all.iter().flat_map(|step| step.sentences.clone()).collect();
        assert!(said.contains("Turning moves no point of A farther than L = "), "{said}");
        assert!(!said.contains("L = θ r = 0."), "{said}");
    }

    #[test]
    fn the_long_text_names_the_moment_that_a_panel_shows() {
        let text = "shapes.A = { kind = 'circle', radius = 1, velocity = [4, 0] }
            shapes.B = { kind = 'circle', radius = 1, position = [2, 4] }
            query = { kind = 'linear-sweep', of = ['A', 'B'] }
            panels = [{ time = 'hit', layers = ['shapes'] }]";
        let scene = open_text("s", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let said = draw(&plan, plan.theme, "f").drawing.desc;
        assert!(said.contains("the world at the closest approach: shapes"), "{said}");
    }

    #[test]
    fn words_for_steps_that_are_not_there_are_told_where_the_figure_is_in_steps() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            shapes.B = { kind = 'circle', radius = 1, position = [3, 1] }
            query = { kind = 'separation', of = ['A', 'B'] }
            steps = [{ until = 99 }, { title = 'never' }]";
        let scene = open_text("s", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let in_steps = draw_in_steps(&plan, plan.theme, "f");
        let is_it = |fault: &Fault| matches!(fault, Fault::NoStepLeft { .. });
        let told: Vec<_> = in_steps.warnings.iter().filter(|w| is_it(&w.fault)).collect();
        assert_eq!(told.iter().map(|w| &text[w.span.clone()]).collect::<Vec<_>>(), ["{ title = 'never' }"]);
        assert!(draw(&plan, plan.theme, "f").warnings.iter().all(|warning| !is_it(&warning.fault)));
    }
}
