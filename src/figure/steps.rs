//! The steps of a figure, counted: marks that came with an event get the number of the step that it ends.

use std::ops::Range;

use crate::collision::Answer;
use crate::drawing::{Group, Item, Path, Step, Text};
use crate::geometry::{insert_in_order, sort_by};
use crate::scene::{NOTES, Scene, StepWords};
use crate::trace::{Event, Hand, Voice, step};

use super::cue::Cue;
use super::fault::{Fault, Problem};
use super::runs::{Run, Runs};
use super::told_cue::{Told, result, said_again, titled};
use super::{asked, tongue};

/// Items of a page that share their cues: a panel, its title and its caption.
pub(super) struct Scope {
    /// Which of the items.
    pub(super) items: Range<usize>,
    /// What the numbers in its items stand for: 2 for the first cue, 1 for what was there before.
    pub(super) cues: Vec<Cue>,
    /// With what the panel as a whole comes; none for one that is there from the start.
    pub(super) base: Option<Cue>,
    /// Whether it shows the bodies: else B ⊖ A is what there is to begin with.
    pub(super) shows_bodies: bool,
}

impl Scope {
    /// The cue of a number in its items; `None` for what is there from the start.
    fn cue(&self, number: usize) -> Option<Cue> {
        let own = number.checked_sub(2).and_then(|index| self.cues.get(index)).copied();
        match (own, self.base) {
            (Some(own), Some(base)) if own.order(&base).is_lt() => Some(base),
            (own, base) => own.or(base),
        }
    }
}

/// Numbers the steps in all items, and tells them; with a note where the scene says more than there are.
pub(super) fn numbered(
    items: &mut [Item],
    scopes: &[Scope],
    (scene, runs): (&Scene, &Runs),
) -> (Vec<Step>, Option<Problem>) {
    let (runs, called) = (runs.all(), runs.called.names(scene));
    let voice = tongue::voice(scene, &called, Hand::Words);
    let mut cues = Vec::new();
    for scope in scopes {
        let mut used = Vec::new();
        items[scope.items.clone()].iter().for_each(|item| collect(item, &mut used));
        cues.extend(used.into_iter().filter_map(|number| scope.cue(number)));
    }
    sort_by(&mut cues, Cue::order);
    cues.dedup();
    let told: Vec<Told> =
        cues.iter().filter_map(|cue| Told::of((scene, voice), &runs, (*cue, &cues))).collect();
    let mut steps = vec![first((scene, voice), &runs)];
    let mut numbers = Vec::with_capacity(told.len());
    let mut is_open = false;
    let has_bodies = scopes.iter().any(|scope| scope.shows_bodies);
    for (i, this) in told.iter().enumerate() {
        if this.is_given && !has_bodies && steps.len() == 1 {
            numbers.push(1);
            steps[0].sentences.push(this.sentence.clone());
            continue;
        }
        if !is_open {
            steps.push(Step::default());
        }
        numbers.push(steps.len());
        if let Some(last) = steps.last_mut() {
            last.title.clone_from(&this.title);
            if last.sentences.last() != Some(&this.sentence) {
                last.sentences.push(this.sentence.clone());
            }
        }
        let goes_on = told.get(i + 1).is_some_and(|next| this.prepares(next));
        is_open = goes_on && !this.ends;
    }
    if let ([.., last], Some(end)) = (&mut steps[..], untold((scene, voice), &runs, &cues)) {
        let again = said_again((scene, voice), &runs);
        last.sentences.retain(|said| *said != end && again.as_ref() != Some(said));
        last.sentences.push(end);
    }
    let count = steps.len();
    let (steps, counted, unused) = worded(steps, &scene.steps);
    let note =
        unused.filter(|_| NOTES).map(|words| Problem::new(Fault::NoStepLeft { count }, words.span.clone()));
    for scope in scopes {
        let number = |number: usize| {
            let cue = scope.cue(number)?;
            told.binary_search_by(|told| told.cue.order(&cue)).ok().map(|i| counted[numbers[i] - 1])
        };
        for item in &mut items[scope.items.clone()] {
            item.for_each_shown(&|shown| {
                shown.since = number(shown.since).unwrap_or(1);
                shown.until = shown.until.and_then(number);
            });
        }
    }
    (steps, note)
}

/// The steps as a scene wants them, for each step as it was the number of the one that shows it now, and the
/// first words for which none is left.
fn worded(all: Vec<Step>, said: &[StepWords]) -> (Vec<Step>, Vec<usize>, Option<&StepWords>) {
    let (mut steps, mut counted): (Vec<Step>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut unused = None;
    for words in said {
        let from = counted.len();
        let until = words.until.unwrap_or(from + 1).min(all.len());
        let Some(joined) = all.get(from..until).filter(|joined| !joined.is_empty()) else {
            unused = Some(words);
            break;
        };
        // What is skipped comes with the next one, and with the one before where there is none.
        let is_last = until == all.len();
        if !words.skip {
            steps.push(one(joined, words));
        } else if is_last && steps.is_empty() {
            steps.extend_from_slice(&joined[joined.len() - 1..]);
        }
        let number = if words.skip && !is_last { steps.len() + 1 } else { steps.len() };
        counted.resize(until, number);
    }
    if counted.len() == all.len() {
        // Nothing comes after several that are skipped at the end.
        counted = counted.into_iter().map(|number| number.min(steps.len())).collect();
    }
    for step in all.into_iter().skip(counted.len()) {
        steps.push(step);
        counted.push(steps.len());
    }
    (steps, counted, unused)
}

/// Some steps as one.
fn one(joined: &[Step], words: &StepWords) -> Step {
    let [.., last] = joined else { return Step::default() };
    let own = || match joined {
        [step] => step.sentences.clone(),
        all => all.iter().map(|step| titled(&step.title, step.sentences.join(" "))).collect(),
    };
    Step {
        title: words.title.clone().unwrap_or_else(|| last.title.clone()),
        sentences: words.text.clone().map_or_else(own, |text| vec![text]),
    }
}

/// The numbers by which items come and go.
pub(super) fn collect(item: &Item, used: &mut Vec<usize>) {
    match item {
        Item::Group(Group { items, .. }) => items.iter().for_each(|item| collect(item, used)),
        Item::Path(Path { shown, .. }) | Item::Text(Text { shown, .. }) => {
            insert_in_order(used, shown.since);
            shown.until.into_iter().for_each(|until| insert_in_order(used, until));
        }
    }
}

/// The step before the first event: what the scene asks.
pub(super) fn first((scene, voice): (&Scene, Voice), runs: &[std::sync::Arc<Run>]) -> Step {
    let own = runs.iter().filter(|run| run.is_own()).find_map(|run| run.events().next());
    own.map_or_else(Step::default, |event| Step {
        title: step::title(event, 0, voice),
        sentences: asked::sentences(scene, event, voice),
    })
}

/// What the figure's own run came to, where no mark comes with that: its last step says it. A bound on a
/// motion is the sum of what its events tell.
fn untold(of: (&Scene, Voice), runs: &[std::sync::Arc<Run>], cues: &[Cue]) -> Option<String> {
    let is_end = |event: &Event| matches!(event, Event::Finished { .. });
    let is_sum = |run: &Run| matches!(run.answer, Answer::MotionBound(_));
    let own = runs.iter().find(|run| run.is_own() && (is_sum(run) || run.events().any(is_end)))?;
    let is_told = cues.iter().any(|cue| own.event_of(cue).is_some_and(is_end));
    (!is_told).then(|| result(of, runs, own))
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, draw_in_steps, plan};
    use crate::scene::open_text;

    /// The committed figures with the texts of their scenes, in order of their names.
    fn figures() -> Vec<(String, String)> {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let mut all: Vec<_> = files
            .filter(|path| path.extension().is_some_and(|end| end == "toml"))
            .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap()))
            .collect();
        all.sort();
        all
    }

    /// What the steps of a scene say.
    fn said(text: &str) -> Vec<String> {
        let scene = open_text("s", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let steps = draw_in_steps(&plan, plan.theme, "s").drawing.steps;
        steps.iter().map(|step| step.sentences.join(" ")).collect()
    }

    #[test]
    fn a_result_is_said_once_and_of_what_has_a_place() {
        let all = said(
            "shapes.A = { kind = 'box', half_extents = [1, 1], velocity = [1, 0], angular_velocity_deg = 40 }
             shapes.B = { kind = 'box', half_extents = [0.5, 0.5], position = [1.2, 0.2] }
             query = { kind = 'time-of-impact', of = ['A', 'B'], algorithm = 'conservative-advancement' }",
        );
        let last = all.last().unwrap();
        assert!(last.matches("the shortest push").count() == 1 && last.contains("from the start"), "{last}");
        assert!(all.iter().all(|said| !said.contains("are −")), "{all:?}");
        let all = said(
            "shapes.Kite = { kind = 'polygon', vertices = [[0, -1], [0.6, 0], [0, 0.5], [-0.6, 0]],
                position = [-3, 1.5], velocity = [5, -1.5] }
             shapes.Rock = { kind = 'regular-polygon', edges = 6, circumradius = 0.9, position = [1.4, 0.1],
                velocity = [-1, 0] }
             query = { kind = 'linear-sweep', of = ['Kite', 'Rock'], algorithm = 'ray-clipping' }",
        );
        let last = all.last().unwrap();
        let (apart, end) = (last.find("apart along"), last.find("That is no more"));
        assert!(apart.is_some() && apart < end, "{last}");
        // The edges of an overlap are those that its algorithm looks at.
        let all = said(
            "shapes.A = { kind = 'regular-polygon', edges = 6, circumradius = 1 }
             shapes.B = { kind = 'box', half_extents = [0.7, 0.5], position = [1.1, 0.4] }
             query = { kind = 'overlap', of = ['A', 'B'] }",
        );
        assert!(all.iter().all(|said| !said.contains("does not build")), "{all:?}");
    }

    #[test]
    fn each_figure_comes_about_in_steps_of_which_each_changes_it_and_the_last_is_the_figure() {
        let mut of_the_article = 0;
        for (name, text) in figures() {
            let scene = open_text(&name, &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let whole = draw_in_steps(&plan, plan.theme, "f").drawing;
            let count = whole.steps.len();
            let steps: Vec<_> = (1..=count).map(|step| whole.at_step(step).items).collect();
            for (k, pair) in (2..).zip(steps.windows(2)) {
                assert!(pair[0] != pair[1], "{name}: step {k} changes nothing");
            }
            assert_eq!(whole.at_step(count), draw(&plan, plan.theme, "f").drawing, "{name}");
            for step in &whole.steps {
                assert!(!step.title.is_empty() && !step.sentences.is_empty(), "{name}: {step:?}");
            }
            let number = name.rsplit('/').next().is_some_and(|file| file.starts_with('0'));
            assert!(count >= if number { 3 } else { 2 }, "{name} has {count} steps");
            of_the_article += usize::from(number);
        }
        assert_eq!(of_the_article, 8);
    }

    #[test]
    fn the_last_step_says_the_result_where_no_mark_comes_with_it() {
        let all = figures();
        let (name, text) = all.iter().find(|(name, _)| name.ends_with("gjk-steps.toml")).unwrap();
        let scene = open_text(name, text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let steps = draw_in_steps(&plan, plan.theme, "f").drawing.steps;
        let [.., before, last] = &steps[..] else { panic!("{steps:?}") };
        assert_eq!(last.sentences.last().unwrap(), "A and B are 3 apart along the normal (0.6, 0.8).");
        assert_eq!((before.sentences.len(), last.sentences.len()), (1, 2));
    }

    #[test]
    fn what_a_figure_is_about_comes_event_by_event_and_what_it_is_given_as_a_whole() {
        let titles = |algorithm: &str, layers: &str| -> Vec<String> {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-2, -1], [1, -2], [2, 1]] }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [6, 1] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = '{algorithm}' }}
                panels = [{layers}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let steps = draw_in_steps(&plan, plan.theme, "f").drawing.steps;
            steps.into_iter().map(|step| step.title).collect()
        };
        let both = "{ layers = ['shapes'] }, { space = 'configuration', layers = ['difference'] }";
        let edges = ["The question", "Edge 0 of A", "Edge 1 of A", "Edge 2 of A", "B ⊖ A"];
        assert_eq!(titles("minkowski", both), edges);
        assert_eq!(titles("gjk", both), ["The question", "B ⊖ A"]);
        // A choice of the merge is a step of its own where no mark of what follows from it comes with it.
        let taken = ["1: edge 0 of A", "2: edge 1 of A", "3: edge 2 of A"];
        for layer in ["edge-fan", "merging"] {
            let alone = titles("merge", &format!("{{ space = 'configuration', layers = ['{layer}'] }}"));
            assert_eq!((alone[0].as_str(), &alone[1..]), ("The question", &taken.map(str::to_owned)[..]));
            let found = format!("{{ space = 'configuration', layers = ['{layer}', 'difference'] }}");
            let found = titles("merge", &found);
            assert_eq!((&found[1..4], found.len()), (&taken.map(str::to_owned)[..], 5), "{found:?}");
        }
        // What is given is not shown edge by edge.
        let text = "shapes.A = { kind = 'box', half_extents = [1, 1] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [4, 1], angle_deg = 20 }
            panels = [{ layers = ['shapes'] }, { space = 'configuration', layers = ['difference'] }]";
        let passes = |algorithm: &str| {
            let query =
                format!("query = {{ kind = 'separation', of = ['A', 'B'], algorithm = '{algorithm}' }}");
            let scene = open_text("s", &format!("{text}\n{query}")).unwrap().scene;
            let plan = plan(&scene).unwrap();
            draw_in_steps(&plan, plan.theme, "f").drawing.takes_away()
        };
        assert_eq!(["minkowski", "gjk"].map(passes), [true, false]);
        // Without the bodies there would be nothing to begin with.
        assert_eq!(titles("gjk", "{ space = 'configuration', layers = ['difference'] }"), ["The question"]);
    }

    #[test]
    fn what_a_search_replaced_is_shown_until_then_and_the_figure_is_as_if_it_had_not_been() {
        let text = |b: &str, algorithm: &str, space: &str, layer: &str| {
            format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-3, 0], [3, -2], [1, 2]] }}
                shapes.B = {{ kind = 'polygon', vertices = {b} }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = '{algorithm}' }}
                panels = [{{ space = '{space}', layers = [{{ layer = {layer} }}] }}]"
            )
        };
        let apart = "[[2, 5], [6, 2], [5, 5]]";
        let inside = "[[-1, 0], [4, -1], [2, 3], [-2, 2]]";
        let cases = [
            (text(apart, "gjk", "configuration", "'simplex'"), ", step = 4"),
            (text(inside, "gjk", "configuration", "'polytope'"), ", step = 3"),
            (text(apart, "separating-axes", "world", "'projection'"), ", axis = 4"),
        ];
        for (text, which) in cases {
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let whole = draw_in_steps(&plan, plan.theme, "f").drawing;
            assert!(whole.takes_away(), "{text}");
            let titles: Vec<&str> = whole.steps.iter().map(|step| step.title.as_str()).collect();
            let unlike =
                titles.iter().all(|title| titles.iter().filter(|other| *other == title).count() == 1);
            assert!(unlike, "{titles:?}");
            let named = text.replace(" }] }]", &format!("{which} }}] }}]"));
            let scene = open_text("s", &named).unwrap().scene;
            let one = crate::figure::plan(&scene).unwrap();
            let (now, alone) = (draw(&plan, plan.theme, "f"), draw(&one, one.theme, "f"));
            let items = |figure: crate::figure::Figure| {
                let mut items = figure.drawing.items;
                let always = |shown: &mut crate::drawing::Shown| *shown = crate::drawing::Shown::ALWAYS;
                for item in &mut items {
                    item.for_each_shown(&always);
                }
                items
            };
            assert_eq!(now.panels[0].frame, alone.panels[0].frame);
            assert!(items(now) == items(alone), "{named}");
        }
    }

    #[test]
    fn a_scene_joins_skips_and_words_steps() {
        let steps = |said: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-2, -1], [1, -2], [2, 1]] }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [6, 1] }}
                query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'minkowski' }}
                panels = [{{ layers = ['shapes'] }}, {{ space = 'configuration', layers = ['difference'] }}]
                {said}"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let drawing = draw_in_steps(&plan, plan.theme, "f").drawing;
            let shown: Vec<_> = (1..=drawing.steps.len()).map(|k| drawing.at_step(k).items).collect();
            assert!(shown.windows(2).all(|pair| pair[0] != pair[1]), "{said}: a step changes nothing");
            assert_eq!(shown.last(), Some(&draw(&plan, plan.theme, "f").drawing.items), "{said}");
            drawing.steps
        };
        let titles = |said: &str| steps(said).into_iter().map(|step| step.title).collect::<Vec<_>>();
        let all = titles("");
        assert_eq!(all.len(), 5);
        assert_eq!(
            titles("steps = [{}, { until = 4, title = 'Its edges' }]"),
            [all[0].as_str(), "Its edges", all[4].as_str()]
        );
        assert_eq!(titles("steps = [{ until = 3, skip = true }]"), all[3..]);
        assert_eq!(titles("steps = [{ until = 4 }, { skip = true }]"), all[3..4]);
        assert_eq!(titles("steps = [{ until = 3 }, { skip = true }, { skip = true }]"), all[2..3]);
        assert_eq!(steps("steps = [{ until = 99, skip = true }]"), steps("")[4..], "the last one alone");
        let joined = steps("steps = [{ until = 99 }]")[0].sentences.clone();
        assert!(
            joined[0].starts_with("The question – ") && joined[1].starts_with("Edge 0 of A with"),
            "{joined:?}"
        );
        let worded = steps("steps = [{ text = 'Two bodies.' }, { until = 3 }]");
        assert_eq!(
            (worded[0].sentences.as_slice(), worded[1].sentences.len()),
            (&["Two bodies.".to_owned()][..], 2)
        );
    }
}
