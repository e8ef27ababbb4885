//! What the fuzz target `figure` holds of any choices: all layers and options, texts and formulas, views,
//! numbers to the ends of a double.

use std::ops::Range;

use tracefig::figure::plan;
use tracefig::scene::{Scene, Spanned, open_text};

use super::choices::Choices;
use super::{render, scene};

/// Times that a scene is mended: each takes out all that is refused, and what is left may be refused anew.
const TIMES: usize = 4;

/// Whatever scene the bytes choose, it is refused with a reason, or drawn in every format, twice the same.
pub(crate) fn holds(bytes: &[u8]) {
    let text = Choices::new(bytes).scene();
    scene::holds(&text);
    let Ok(file) = open_text("fuzz", &text) else { return };
    render::scene_holds(&mended(file.scene));
}

/// The scene without what it can't show, so that the rest is drawn.
fn mended(mut scene: Scene) -> Scene {
    for _ in 0..TIMES {
        let Err(problems) = plan(&scene).map(|_| ()) else { break };
        let is_in = |span: &Range<usize>| {
            problems.iter().any(|p| p.span.start < span.end.max(span.start + 1) && span.start < p.span.end)
        };
        let text_stays = |text: &Spanned<String>| !is_in(&text.span);
        scene.title = scene.title.filter(text_stays);
        scene.caption = scene.caption.filter(text_stays);
        for panel in &mut scene.panels {
            panel.title = panel.title.take().filter(text_stays);
            panel.caption = panel.caption.take().filter(text_stays);
            panel.when = panel.when.take().filter(|when| !is_in(&when.span));
            panel.view = panel.view.take().filter(|view| !is_in(&view.span));
            for layer in panel.layers.iter_mut().flatten() {
                layer.options.retain(|(key, value)| !is_in(&key.span) && !is_in(&value.span));
            }
            if let Some(layers) = &mut panel.layers {
                layers.retain(|layer| !is_in(&layer.name.span));
            }
        }
        scene.labels.retain(|(key, label)| {
            !is_in(&key.span) && label.text.as_ref().is_none_or(|text| !is_in(&text.span))
        });
    }
    scene
}
