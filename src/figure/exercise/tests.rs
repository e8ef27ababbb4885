//! What a question does not know.

use crate::figure::layer::{LAYERS, Shows, Tells};
use crate::figure::{draw, plan};
use crate::scene::{Scene, Variant, open_text};

use super::variant;

/// A pair of which B lies at `x`, with every layer that tells of no found thing and every one that does.
fn scene(kind: &str, x: f64) -> Scene {
    let layers = |configuration: bool| {
        let fits =
            |shows: Shows| shows == Shows::Anywhere || (shows == Shows::Configuration) == configuration;
        let names = LAYERS.iter().filter(|layer| fits(layer.shows)).map(|layer| format!("'{}'", layer.name));
        names.collect::<Vec<_>>().join(", ")
    };
    let text = format!(
        "exercise.ask = 'd'
        shapes.A = {{ kind = 'circle', radius = 1.25, velocity = [3, 1] }}
        shapes.B = {{ kind = 'box', half_extents = [1, 0.5], position = [{x}, 0.7], angle_deg = 20 }}
        query = {{ kind = '{kind}', of = ['A', 'B'] }}
        panels = [{{ layers = [{}] }}, {{ space = 'configuration', layers = [{}] }}, {{ time = 'hit' }}]",
        layers(false),
        layers(true)
    );
    open_text("s.toml", &text).unwrap().scene
}

#[test]
fn no_algorithm_answers_behind_a_question() {
    for kind in ["separation", "overlap", "contact", "linear-sweep", "time-of-impact"] {
        let mut question = variant(&scene(kind, 4.5), Variant::Question).unwrap();
        let plan_of = |scene: &Scene| {
            let plan = plan(scene).unwrap();
            let _ = draw(&plan, plan.theme, "q");
            plan.runs.all().len()
        };
        // B ⊖ A is built of what is given.
        let built = plan_of(&question);
        assert!(built <= 1, "{kind}: {built}");
        for panel in &mut question.panels {
            let tells = |name: &str| LAYERS.iter().find(|layer| layer.name == name).unwrap().tells;
            panel.layers.iter_mut().for_each(|all| all.retain(|l| tells(&l.name.value) == Tells::Given));
        }
        question.panels.retain(|panel| panel.space == crate::scene::Space::World);
        assert_eq!(plan_of(&question), 0, "{kind}");
    }
}

#[test]
fn a_question_looks_the_same_whatever_the_answer_is() {
    // One motion, three questions and two answers: what is drawn is what is given.
    let drawn = |kind: &str, speed: &str| {
        let mut scene = variant(&scene(kind, 4.5), Variant::Question).unwrap();
        let b = scene.query.of[1];
        scene.shapes[b].1.velocity.x = speed.parse().unwrap();
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "q").drawing;
        let Some(crate::drawing::Item::Group(panel)) = figure.items.into_iter().nth(1) else { panic!() };
        panel
    };
    assert!(drawn("linear-sweep", "0") == drawn("separation", "0"));
    assert!(drawn("linear-sweep", "0") == drawn("time-of-impact", "0"));
    assert!(drawn("linear-sweep", "0") != drawn("linear-sweep", "2"), "a velocity is given");
}

#[test]
fn what_is_asked_for_and_hidden_must_exist() {
    let problems = |exercise: &str, as_variant| {
        let text = format!(
            "exercise = {exercise}
            shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [3, 0] }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let scene = variant(&scene, as_variant).unwrap();
        plan(&scene).map(|_| ()).map_err(|all| all[0].fault.to_string())
    };
    assert_eq!(problems("{ ask = 'd', hide = ['shapes', 'd'] }", Variant::Key), Ok(()));
    assert!(problems("{ ask = 'dept' }", Variant::Figure).unwrap_err().contains("value to ask for `dept`"));
    assert!(problems("{ ask = 'time' }", Variant::Figure).unwrap_err().contains("`time`"), "of no contact");
    assert!(problems("{ ask = 'd', hide = 'shape' }", Variant::Key).unwrap_err().contains("`shape`"));
    assert_eq!(problems("{ ask = 'depth' }", Variant::Figure), Ok(()), "a figure has no blank");
    let apart = problems("{ ask = 'depth' }", Variant::Key).unwrap_err();
    assert!(apart.contains("asks for `depth`") && apart.contains("the bodies are apart"), "{apart}");
}

#[test]
fn hidden_layers_and_labels_are_left_out_and_nothing_else() {
    let text = "exercise = { ask = 'd', hide = ['grid', 'A'] }
        shapes.A = { kind = 'circle', radius = 1 }
        shapes.B = { kind = 'circle', radius = 1, position = [3, 0] }
        query = { kind = 'separation', of = ['A', 'B'] }
        panels = [{ layers = ['grid', 'axes', 'shapes', 'separation'] }]";
    let scene = open_text("s.toml", text).unwrap().scene;
    let keys = |as_variant| {
        let scene = variant(&scene, as_variant).unwrap();
        let layers = scene.panels[0].layers.as_ref().unwrap().iter().map(|l| l.name.value.clone());
        let layers = layers.collect::<Vec<_>>().join(" ");
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "f");
        let labels: Vec<_> = figure.panels[0].placed.iter().map(|placed| placed.key).collect();
        (layers, labels.join(" "))
    };
    assert_eq!(keys(Variant::Question), ("axes shapes".to_owned(), "B".to_owned()));
    assert_eq!(keys(Variant::Key).0, "grid axes shapes separation");
}

#[test]
fn a_question_has_no_words_of_the_steps_to_its_answer() {
    let mut scene = scene("separation", 4.5);
    scene.steps = vec![crate::scene::StepWords { text: Some("d = 3".to_owned()), ..Default::default() }];
    assert_eq!(variant(&scene, Variant::Key).unwrap().steps, scene.steps);
    assert!(variant(&scene, Variant::Question).unwrap().steps.is_empty());
}

#[test]
fn the_bounds_of_two_bodies_are_those_of_both() {
    let text = "exercise.ask = ['min.x', 'max.x', 'max.y', 'h.x', 'c.y']
        headline = 'From {=min.x} to {=max.x}'
        shapes.A = { kind = 'aabb', half_extents = [1, 1] }
        shapes.B = { kind = 'aabb', half_extents = [1, 1], position = [10, 5] }
        query = { kind = 'bounds', of = ['A', 'B'] }";
    let scene = open_text("s.toml", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let answers: Vec<f64> = super::asked(&plan).iter().map(super::Asked::value).collect();
    assert_eq!(answers, [-1.0, 11.0, 6.0, 6.0, 2.5]);
    assert_eq!(plan.headline.words.as_deref(), Some("From −1 to 11"));
}

#[test]
fn what_cannot_be_asked_is_refused_with_the_reason() {
    let refused = |ask: &str, query: &str, b: &str| {
        let text = format!(
            "exercise.ask = '{ask}'
            shapes.A = {{ kind = 'aabb', half_extents = [3, 1] }}
            shapes.B = {{ {b} }}
            query = {{ of = ['A', 'B'], {query} }}"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let key = variant(&scene, Variant::Key).unwrap();
        let problems = plan(&key).map(|_| ()).unwrap_err();
        problems[0].fault.to_string()
    };
    let corner = "kind = 'box', half_extents = [1.5, 0.8], position = [0.3, 1.6], angle_deg = 9";
    let told = refused("shallow", "kind = 'contact'", corner);
    assert!(told.contains("which this scene does not have: there is one point of contact; it has"), "{told}");
    let circle = "kind = 'circle', radius = 1, position = [5, 1]";
    let told = refused("V.x", "kind = 'separation', algorithm = 'clamp'", circle);
    assert_eq!(told, "`V.x` is a value of texts, and none that an exercise asks for");
    let told = refused("time", "kind = 'linear-sweep'", circle);
    assert!(told.contains("this scene does not have"), "{told}");
}
