//! Lines of text at a corner of the panel: the one place for a formula with its numbers.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Corner, Label, Rank, Size, Sketch};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes};

pub(super) const LAYER: Layer = Layer {
    name: "note",
    about: "lines of text at a corner",
    shows: Shows::Anywhere,
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

fn draw(sketch: &mut Sketch, _context: &Context, options: &Options) {
    let Some(lines) = options.words("lines") else { return };
    let corner = Corner::of_word(options.word("at", "top-left")).unwrap_or(Corner::TopLeft);
    let label = Label::new("note", "", Anchor::Corner(corner), options.role(Role::Ink)).given(lines);
    sketch.label(label.rank(Rank::Note).size(Size::Note));
}
