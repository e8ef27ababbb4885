//! What `[labels]` means for a figure: which keys it has, those of the labels that its layers write and of
//! its bodies' names; and what it calls the bodies.

use crate::scene::{self, LayerSpec, NOTES, Scene, Space};

use super::called::{Called, KEYS, Replaced};
use super::context::Context;
use super::default_picture::layers_of_all;
use super::fault::{Fault, Problem};
use super::layer::{Fed, Layer, Options, find, is_key};
use super::panel::PanelPlan;
use super::play::Play;
use super::runs::Runs;
use super::text::{label_key, overridden};

/// Tells of keys of `[labels]` that no layer of the scene writes.
pub(super) fn label_keys(scene: &Scene, runs: &Runs, panels: &[PanelPlan], problems: &mut Vec<Problem>) {
    let written = panels.iter().flat_map(PanelPlan::labels);
    if scene.labels.is_empty() {
        return;
    }
    // A picture of ours is another one for another answer.
    let ours = scene.panels.is_empty() || scene.panels.iter().any(|panel| panel.layers.is_none());
    let of_ours = if ours { layers_of_all(scene) } else { Vec::new() };
    let possible = of_ours.iter().filter_map(|(space, spec)| fed(scene, runs, space, spec));
    let possible = possible.flat_map(|layer| layer.labels);
    let mut known: Vec<String> = Vec::new();
    for key in written.chain(possible) {
        if !known.iter().any(|k| k == key.key) {
            known.push(key.key.to_owned());
        }
    }
    // The text of a name is that of every label that is made of it.
    let of_names = || KEYS.iter().take(scene.query.of.len());
    let names = scene.shapes.iter().map(|(name, _)| &name.value);
    let by_name: Vec<String> = names
        .filter(|name| !is_key(name) && known.iter().any(|k| k == label_key(scene, name, is_key)))
        .cloned()
        .collect();
    let meant: Vec<&str> =
        scene.labels.iter().map(|(word, _)| label_key(scene, &word.value, is_key)).collect();
    for (i, (key, label)) in scene.labels.iter().enumerate() {
        if let Some(other) = meant[..i].iter().position(|&earlier| earlier == meant[i]) {
            let message = format!("`{}` and `{}` are the same label", scene.labels[other].0.value, key.value);
            let help = "keep one of the two".to_owned();
            problems.push(Problem::new(scene::Fault::Conflict { message, help }.into(), key.span.clone()));
        }
        let is_name = label.text.is_some() && of_names().any(|&k| k == meant[i]);
        if !is_name && !known.iter().any(|k| k == meant[i]) {
            let place = "`[labels]`: no layer of this scene writes it".to_owned();
            let fault = scene::Fault::UnknownKey {
                key: key.value.clone(),
                place,
                known: [&by_name[..], &known].concat(),
            };
            problems.push(Problem::new(fault.into(), key.span.clone()));
        }
    }
}

/// The layer of a default picture, where some answer to the scene's question has something for it.
fn fed(scene: &Scene, runs: &Runs, space: &Space, spec: &LayerSpec) -> Option<&'static Layer> {
    let layer = find(&spec.name.value)?;
    let options = Options::read(layer.options, spec, scene).ok()?;
    let context = Context { scene, space, time: scene.query.time, step: None, play: Play::No, runs };
    ((layer.fed)(&context, &options) != Fed::Never).then_some(layer)
}

/// What the picture of a scene calls its bodies.
pub(super) fn called(scene: &Scene) -> Called {
    Called::of(scene, |key| {
        let (_, label) = overridden(scene, key, is_key)?;
        Some(label.text.as_ref()?.value.as_str())
    })
}

/// A note for each name on the picture that another one stands for.
pub(super) fn replaced(scene: &Scene, called: &Called) -> Vec<Problem> {
    if !NOTES {
        return Vec::new();
    }
    let note = |replaced: Replaced| {
        let (name, shown) = (replaced.name.value.clone(), replaced.shown.to_owned());
        let fault = Fault::BadName { name, shown, key: replaced.key, reason: replaced.reason.to_owned() };
        Problem::new(fault, replaced.name.span.clone())
    };
    called.replaced(scene).map(note).collect()
}
