//! What a program sets of a scene besides its bodies and its question, checked as what a file says: the
//! page, moments and views of panels, steps.

use super::asked::{count, entries_of, list, number, text};
use super::canvas::Height;
use super::checked::check;
use super::fields::{CANVAS, PANEL};
use super::node::{Node, NodeValue};
use super::problem::{Problem, Problems};
use super::{Canvas, Detail, Panel, Scene, StepWords, When, steps};

/// All that is wrong with the values of a scene that a program may have set; nothing for one of a file.
pub(crate) fn wrong(scene: &Scene) -> Vec<Problem> {
    let mut p = Problems::default();
    check(&page(&scene.canvas), "canvas", CANVAS.place, CANVAS.fields, &mut p);
    for panel in &scene.panels {
        check(&shown(panel), "panels", PANEL.place, PANEL.fields, &mut p);
    }
    let mut before = 0;
    for words in &scene.steps {
        steps::step(&told(words), &mut before, &mut p);
    }
    p.into_sorted()
}

/// The numbers of a page.
fn page(canvas: &Canvas) -> Node {
    let height = match canvas.height {
        Some(Height::Pixels(height)) => Some(height),
        Some(Height::Auto) | None => None,
    };
    let numbers = [
        ("width", canvas.width),
        ("height", height),
        ("margin", canvas.margin),
        ("text", canvas.text),
        ("columns", canvas.columns.map(count)),
    ];
    entries_of(numbers.into_iter().filter_map(|(key, x)| Some((key, number(x?)))).collect())
}

/// The moment of a panel and what it must show.
fn shown(panel: &Panel) -> Node {
    let mut entries = Vec::new();
    match panel.when.as_ref().map(|when| &when.value) {
        Some(When::Time(t)) => entries.push(("time", number(*t))),
        Some(When::Step(step)) => entries.push(("step", number(count(*step)))),
        _ => {}
    }
    entries.extend(panel.columns.map(|columns| ("columns", number(count(columns)))));
    let corners = |view: [f64; 4]| list(view.map(number).into());
    entries.extend(panel.view.as_ref().map(|view| ("view", corners(view.value))));
    if let Some(Detail::Rectangle(inset)) = panel.inset.as_ref().map(|inset| &inset.value) {
        entries.push(("inset", corners(*inset)));
    }
    entries_of(entries)
}

/// What is said of steps.
fn told(words: &StepWords) -> Node {
    let texts = [("title", &words.title), ("text", &words.text)];
    let mut entries: Vec<_> =
        texts.into_iter().filter_map(|(key, words)| Some((key, text(words.as_ref()?)))).collect();
    entries.extend(words.until.map(|until| ("until", number(count(until)))));
    if words.skip {
        entries.push(("skip", Node { value: NodeValue::Bool(true), span: 0..0 }));
    }
    entries_of(entries)
}

#[cfg(test)]
pub(super) mod tests {
    use crate::collision::QueryKind;
    use crate::geometry::{Body, DVec2, Shape};
    use crate::scene::{LayerSpec, Panel, Refused, Scene, Space, StepWords, When};

    /// Two squares whose separation is asked, made without a text.
    pub(in crate::scene) fn made() -> Scene {
        let body = |x| Body::at_rest(Shape::rectangle(DVec2::ONE).unwrap(), DVec2::new(x, 0.0));
        Scene::asking(QueryKind::Separation, &[("A", body(0.0)), ("B", body(3.0))]).unwrap()
    }

    #[test]
    fn what_a_program_sets_is_refused_where_a_text_is() {
        let made = made();
        let said = |change: fn(&mut Scene)| {
            let mut scene = made.clone();
            change(&mut scene);
            let wrong = super::wrong(&scene);
            Refused::from(wrong).to_string()
        };
        let step = |until, skip| StepWords { until: Some(until), skip, ..StepWords::default() };
        assert_eq!(said(|_| {}), "");
        assert!(said(|s| s.canvas.width = Some(f64::NAN)).starts_with("error[not-finite]: `width`"));
        assert!(
            said(|s| s.canvas.width = Some(-5.0))
                .starts_with("error[out-of-range]: `width`: expected a number")
        );
        assert!(said(|s| s.canvas.columns = Some(0)).starts_with("error[out-of-range]: `columns`"));
        assert!(said(|s| s.canvas.text = Some(0.0)).starts_with("error[out-of-range]: `text`"));
        let panel = || Panel::showing(Space::World, vec![LayerSpec::named("shapes")]);
        for (panel, told) in [
            (Panel { when: Some(When::Time(f64::NAN).into()), ..panel() }, "error[not-finite]: `time`"),
            (Panel { when: Some(When::Step(0).into()), ..panel() }, "error[out-of-range]: `step`"),
            (Panel { columns: Some(0), ..panel() }, "error[out-of-range]: `columns`"),
            (
                Panel { view: Some([0.0, 0.0, f64::INFINITY, 1.0].into()), ..panel() },
                "error[not-finite]: `view`",
            ),
        ] {
            let mut scene = made.clone();
            scene.panels.push(panel);
            let wrong = Refused::from(super::wrong(&scene)).to_string();
            assert!(wrong.starts_with(told), "{wrong}");
        }
        for steps in [vec![step(0, false)], vec![step(3, false), step(1, true)]] {
            let scene = Scene { steps, ..made.clone() };
            assert!(!super::wrong(&scene).is_empty(), "steps go on");
        }
    }
}
