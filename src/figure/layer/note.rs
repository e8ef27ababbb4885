//! Lines of text at a corner of the panel: the one place for a formula with its numbers.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, Corner, Label, Rank, Size, Sketch};
use crate::trace::step::advanced;
use crate::trace::{Event, phrase};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// How a value in a line begins.
const VALUE: &str = "{=";

pub(super) const LAYER: Layer = Layer {
    name: "note",
    in_words: phrase(["note", "Text", "texte", "texto"]),
    about: "lines of text at a corner",
    shows: Shows::Anywhere,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "at",
            takes: Takes::Word(&Corner::WORDS),
            default: "\"top-left\"",
            about: "where",
        },
        OptionSpec {
            name: "lines",
            takes: Takes::Lines,
            default: "none",
            about: "markup, `{=…}` for values",
        },
    ],
    labels: &[LabelKey { key: "note", about: "the lines" }],
    needs: "lines",
    fed: |_, options| Fed::by_the_scene(options.words("lines").is_some()),
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(lines) = options.words("lines") else { return };
    sketch.since(known(context, lines));
    let corner = Corner::of_word(options.word("at", "top-left")).unwrap_or(Corner::TopLeft);
    let label = Label::new("note", "", Anchor::Corner(corner), options.role(Role::Ink)).given(lines);
    sketch.label(label.rank(Rank::Note).size(Size::Note));
}

/// With what the values in its lines are known: of a panel that shows a step, with that; of others, with the
/// answer. `None` for lines without a value.
fn known(context: &Context, lines: &[String]) -> Option<Cue> {
    let this = |event: &Event| matches!(event, Event::Advanced { step, .. } if Some(*step) == context.step);
    let is_valued = lines.iter().any(|line| line.contains(VALUE));
    is_valued.then(|| context.cue(this).map_or_else(|| context.answered(), |cue| cue.part(advanced::NEXT)))
}
