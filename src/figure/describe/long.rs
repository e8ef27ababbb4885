//! The long text: a paragraph.

use crate::collision::{Answer, Outcome};
use crate::figure::question::is_found_on_the_difference;
use crate::figure::runs::Run;
use crate::figure::text::plain;
use crate::geometry::Body;
use crate::scene::{Panel, Scene, Space, Spanned, When};
use crate::trace::told::is_by_component;
use crate::trace::{Event, Phrase};

use super::body::{body_in_words, kind_in_words};
use super::number::Speech;
use super::off::compared;
use super::phrases::{
    AT_BOUND, AT_CLOSEST, AT_END, AT_HIT, AT_START, AT_TIME, BESIDE, CHART, CONFIGURATION, EMPTY, ENLARGED,
    FOUND, FOUND_AMONG, FOUND_AT_ONCE, FOUND_IN, FRAME, IN_STEP, PANEL, PICTURE, SHOWS, TURNED_FRAME, WORLD,
};
use super::result::Account;

/// A panel, and what it shows.
pub(crate) struct Shown<'p> {
    /// The panel.
    pub(crate) panel: &'p Panel,
    /// Whether it is a chart.
    pub(crate) is_chart: bool,
    /// The moment that it shows, by name; `None` where it has none.
    pub(crate) when: Option<When>,
    /// What its layers are called.
    pub(crate) layers: Vec<&'static Phrase>,
}

/// A paragraph for `desc`: the bodies, the question, the answer, the steps, the panels.
pub(crate) fn long((scene, run): (&Scene, &Run), told: &Account, panels: &[Shown]) -> String {
    let speech = Speech::of(scene);
    let mut text = String::new();
    for &index in &scene.query.of {
        if let Some((name, body)) = scene.shapes.get(index) {
            text += &body_in_words(&name.value, body, speech);
            text.push(' ');
        }
    }
    text += &bystanders(scene, speech);
    text += &told.sentence();
    text.push(' ');
    text += &steps((scene, run), speech);
    let off = compared(scene, run, &scene.names());
    text += &off;
    text += if off.is_empty() { "" } else { " " };
    text += &shown(scene, panels);
    text.trim_end().to_owned()
}

/// The bodies that the query is not about, by name and kind; empty where there are none.
fn bystanders(scene: &Scene, speech: Speech) -> String {
    let others = scene.shapes.iter().enumerate().filter(|(i, _)| !scene.query.of.contains(i));
    let named = |(_, (name, body)): (usize, &(Spanned<String>, Body))| {
        format!("{} ({})", name.value, kind_in_words(body, speech))
    };
    let all: Vec<String> = others.map(named).collect();
    if all.is_empty() { String::new() } else { speech.say(&BESIDE, &[&all.join(", ")]) }
}

/// How the answer was found: the algorithm, and how many steps or edges it took.
fn steps((scene, run): (&Scene, &Run), speech: Speech) -> String {
    let algorithm = scene.query.algorithm.name;
    let advanced = run.events().filter(|e| matches!(e, Event::Advanced { .. })).count();
    let grown = run
        .events()
        .filter(|e| matches!(e, Event::SimplexUpdated { .. } | Event::PolytopeExpanded { .. }))
        .count();
    let edges = run.events().filter(|e| matches!(e, Event::DifferenceEdgeFound { .. })).count();
    match (is_found_on_the_difference(run.kind), advanced + grown, edges) {
        (_, 1, _) => speech.say(&FOUND_AT_ONCE, &[algorithm]),
        (_, steps @ 2.., _) => speech.say(&FOUND_IN, &[algorithm, &steps.to_string()]),
        (true, _, 1..) if !run.events().any(is_by_component) => {
            speech.say(&FOUND_AMONG, &[algorithm, &edges.to_string()])
        }
        _ => speech.say(&FOUND, &[algorithm]),
    }
}

/// What each panel shows: its space, or that it is a chart, its moment, its layers by name.
pub(crate) fn shown(scene: &Scene, panels: &[Shown]) -> String {
    let speech = Speech::of(scene);
    let mut text = String::new();
    let many = panels.len() > 1;
    for (i, Shown { panel, is_chart, when: at, layers }) in panels.iter().enumerate() {
        let title = panel.title.as_ref().map_or(String::new(), |t| format!(" ({})", plain(&t.value)));
        let which = if many {
            speech.say(&PANEL, &[&(i + 1).to_string(), &title])
        } else {
            speech.say(&PICTURE, &[&title])
        };
        let mut layers: Vec<&str> = layers.iter().map(|phrase| speech.0.word(*phrase)).collect();
        let named = layers.clone();
        let mut index = 0..;
        // A layer that is there twice is told once.
        layers.retain(|word| index.next().is_some_and(|i: usize| !named[..i].contains(word)));
        if layers.is_empty() {
            text += &speech.say(&EMPTY, &[&which]);
            continue;
        }
        let space = if *is_chart { speech.0.word(&CHART).to_owned() } else { space(scene, panel, speech) };
        let when = when(*at, speech);
        text += &speech.say(&SHOWS, &[&which, &space, &when, &layers.join(", ")]);
        text += if panel.inset.is_some() { speech.0.word(&ENLARGED) } else { ". " };
    }
    text
}

/// What a panel shows, as "the world".
fn space(scene: &Scene, panel: &Panel, speech: Speech) -> String {
    match panel.space {
        Space::World => speech.0.word(&WORLD).to_owned(),
        Space::Configuration => speech.0.word(&CONFIGURATION).to_owned(),
        Space::Body(body) => {
            let (name, turned) = scene.shapes.get(body).map_or(("", false), |(name, body)| {
                (&name.value, body.angle_at(0.0) != 0.0 || !body.spin.is_zero())
            });
            speech.say(if turned { &TURNED_FRAME } else { &FRAME }, &[name])
        }
    }
}

/// The moment that a panel shows that was asked for one, of a step the number of that; what it shows instead,
/// where this answer has none by that name.
pub(crate) fn shown_at(asked: When, step: Option<usize>, answer: &Answer) -> When {
    match (asked, answer) {
        (When::Step(_), _) => step.map_or(asked, When::Step),
        (When::Hit | When::Closest, Answer::Impact(impact)) => match impact.outcome {
            Outcome::Hit { .. } => When::Hit,
            Outcome::Miss => When::Closest,
            Outcome::Overlapping { .. } => When::Start,
            Outcome::Unresolved { free_until, .. } => When::Time(free_until),
        },
        _ => asked,
    }
}

/// A panel's moment, as " at the start"; empty where it has none.
fn when(at: Option<When>, speech: Speech) -> String {
    let Some(at) = at else { return String::new() };
    let phrase = match at {
        When::Time(t) => return speech.say(&AT_TIME, &[&speech.value(t)]),
        When::Step(k) => return speech.say(&IN_STEP, &[&k.to_string()]),
        When::Start => &AT_START,
        When::Hit => &AT_HIT,
        When::Closest => &AT_CLOSEST,
        When::Bound => &AT_BOUND,
        When::End => &AT_END,
    };
    speech.0.word(phrase).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::runs::Runs;
    use crate::scene::open_text;

    /// The paragraph of a scene.
    fn told(text: &str) -> String {
        let scene = open_text("long.toml", text).unwrap().scene;
        let runs = Runs::default();
        let run = runs.own(&scene, 0.0);
        long((&scene, &run), &Account::of(&scene, &runs, &run), &[])
    }

    #[test]
    fn an_algorithm_by_components_looks_at_no_edges() {
        let told = told(
            "shapes.a = { kind = 'aabb', half_extents = [1, 1] }
            shapes.b = { kind = 'aabb', half_extents = [1, 1], position = [3, 0] }
            query = { kind = 'separation', of = ['a', 'b'], algorithm = 'extents' }",
        );
        assert!(told.ends_with("Found by extents."), "{told}");
    }

    #[test]
    fn how_far_off_what_was_expected_is_stands_in_the_text() {
        let told = told(
            "shapes.a = { kind = 'circle', radius = 1 }
            shapes.b = { kind = 'circle', radius = 1, position = [3, 4] }
            query = { kind = 'separation', of = ['a', 'b'], expected = { separation = 3.25 } }",
        );
        assert!(told.ends_with("What was expected is off: the separation by 0.25."), "{told}");
    }
}
