//! The scene of a variant: what a question leaves out, by the tables of layers and moments.

use std::ops::Range;

use crate::figure::layer::{Tells, find, is_key};
use crate::scene::{
    Exercise, LabelOverride, LayerSpec, Panel, Scene, Spanned, Value, Variant, When, panels_of_text,
};

/// What is drawn of a question whose scene leaves that to the answer.
const PANELS: &str = r#"
[[panels]]
layers = ["grid", "axes", "shapes", "velocity", "spin"]
"#;

/// How a value begins in a text.
const VALUE: &str = "{=";

/// The scene of a variant of an exercise; `None` where the scene is no exercise. A figure is the scene
/// itself.
///
/// ```
/// use tracefig::{figure::exercise::variant, scene::{Variant, open_text}};
/// let text = "headline = 'They are {=d} apart.'\nexercise.ask = 'd'\n\
///     shapes.A = { kind = 'circle', radius = 1 }\n\
///     shapes.B = { kind = 'circle', radius = 1, position = [3, 0] }\n\
///     query = { kind = 'separation', of = ['A', 'B'] }\n\
///     panels = [{ layers = ['shapes', 'separation'] }]";
/// let scene = open_text("s.toml", text)?.scene;
/// let question = variant(&scene, Variant::Question).unwrap();
/// assert!(question.headline.is_none());
/// assert_eq!(question.panels[0].layers.as_ref().unwrap().len(), 1);
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn variant(scene: &Scene, variant: Variant) -> Option<Scene> {
    let exercise = scene.exercise.as_ref()?;
    Some(match variant {
        Variant::Figure | Variant::Key => Scene { variant, ..scene.clone() },
        Variant::Question => question(scene, exercise),
    })
}

/// The scene without what shows its answer.
fn question(scene: &Scene, exercise: &Exercise) -> Scene {
    let panels: Vec<Panel> = scene.panels.iter().filter_map(|panel| asking(panel, exercise)).collect();
    let is_bare = panels.is_empty();
    let mut labels: Vec<(Spanned<String>, LabelOverride)> = scene.labels.clone();
    for (_, label) in &mut labels {
        label.text = label.text.take().filter(is_of_words);
    }
    labels.extend(exercise.hide.iter().filter(|word| is_key(&word.value)).map(|word| {
        let hidden = LabelOverride { hide: true, ..LabelOverride::default() };
        (word.clone(), hidden)
    }));
    let mut query = scene.query.clone();
    query.expected = None;
    Scene {
        title: scene.title.clone().filter(is_of_words),
        alt: None,
        headline: None,
        caption: None,
        panels: if is_bare { usual(&scene.query.span, exercise) } else { panels },
        labels,
        query,
        steps: Vec::new(),
        variant: Variant::Question,
        ..scene.clone()
    }
}

/// Whether a text has no value of the answer in it.
fn is_of_words(text: &Spanned<String>) -> bool {
    !text.value.contains(VALUE)
}

/// A panel without what shows the answer; `None` where nothing is left, or where its moment is one that only
/// the answer knows.
fn asking(panel: &Panel, exercise: &Exercise) -> Option<Panel> {
    if !panel.when.as_ref().is_none_or(|when| is_given(&when.value)) {
        return None;
    }
    let layers = match &panel.layers {
        None => usual(&panel.span, exercise)
            .into_iter()
            .flat_map(|panel| panel.layers.unwrap_or_default())
            .collect(),
        Some(layers) => given(layers, exercise),
    };
    let is_empty = layers.is_empty();
    let title = panel.title.clone().filter(is_of_words);
    let asking =
        Panel { title, caption: None, layers: Some(layers), inset: None, inset_at: None, ..panel.clone() };
    (!is_empty).then_some(asking)
}

/// The panels of a scene that leaves them to the answer.
fn usual(at: &Range<usize>, exercise: &Exercise) -> Vec<Panel> {
    let mut panels = panels_of_text(PANELS, at);
    for layers in panels.iter_mut().filter_map(|panel| panel.layers.as_mut()) {
        *layers = given(layers, exercise);
    }
    panels
}

/// Whether the scene itself says when a moment is.
fn is_given(when: &When) -> bool {
    match when {
        When::Time(_) | When::Start | When::End => true,
        When::Hit | When::Closest | When::Bound | When::Step(_) => false,
    }
}

/// The layers that tell of nothing that was found, less those that the exercise hides, without options that
/// name a value.
fn given(layers: &[LayerSpec], exercise: &Exercise) -> Vec<LayerSpec> {
    let is_hidden = |name: &str| exercise.hide.iter().any(|hidden| hidden.value == name);
    let is_given = |spec: &&LayerSpec| {
        find(&spec.name.value).is_some_and(|layer| layer.tells != Tells::Found && !is_hidden(layer.name))
    };
    let without_values = |spec: &LayerSpec| {
        let options = spec.options.iter().filter(|(_, value)| !names_a_value(&value.value)).cloned();
        LayerSpec { name: spec.name.clone(), options: options.collect() }
    };
    layers.iter().filter(is_given).map(without_values).collect()
}

/// Whether a text of an option has a value of the answer in it.
fn names_a_value(value: &Value) -> bool {
    match value {
        Value::Text(text) => text.contains(VALUE),
        Value::List(items) => items.iter().any(|item| names_a_value(&item.value)),
        Value::Bool(_) | Value::Number(_) => false,
    }
}
