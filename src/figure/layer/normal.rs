//! The unit normal n from A to B along which B moves apart; turned round it is the N of the article's
//! circles.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch};
use crate::geometry::{DVec2, Side};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes};

/// Drawn length of the unit vector where the scene does not say, world units: its own.
const LENGTH: f64 = 1.0;

pub(super) const LAYER: Layer = Layer {
    name: "normal",
    about: "the unit normal from A to B",
    shows: Shows::World,
    options: &[
        OptionSpec {
            name: "from",
            takes: Takes::Word(&["contact", "A", "B"]),
            default: "\"contact\"",
            about: "starts at the closest point of A, or at the origin of a body",
        },
        OptionSpec { name: "flip", takes: Takes::Flag, default: "false", about: "from B to A instead" },
        OptionSpec { name: "length", takes: Takes::Number, default: "1", about: "drawn length, world units" },
    ],
    labels: &[
        LabelKey { key: "n", about: "the normal from A to B" },
        LabelKey { key: "N", about: "the normal from B to A, with flip" },
    ],
    needs: "a separation or a hit",
    fed: |context, _| Fed::by_the_scene(contact(context).is_some()),
    draw,
};

/// The pair at the hit of a motion, else at the panel's moment.
fn contact(context: &Context) -> Option<Separation> {
    context
        .hit()
        .map(|(_, contact)| contact)
        .or_else(|| context.separation_at(context.time)?.separation().copied())
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(answer) = contact(context) else { return };
    let Some(from) = start(context, options, &answer) else { return };
    let flip = options.flag("flip", false);
    let n = if flip { -answer.normal } else { answer.normal };
    let tip = from + n * options.number("length").unwrap_or(LENGTH);
    let role = options.role(Role::Ink);
    sketch.part("normal").arrow(from, tip, Pen::vector(role));
    let (key, text) = if flip { ("N", "$N$") } else { ("n", "$n$") };
    sketch.label(Label::new(key, text, Anchor::tip(from, tip), role));
}

/// Where the arrow starts, in the world.
fn start(context: &Context, options: &Options, answer: &Separation) -> Option<DVec2> {
    let origin = |side| context.pose(side, context.time).map(|pose| pose.position);
    match options.word("from", "contact") {
        "A" => origin(Side::A),
        "B" => origin(Side::B),
        _ => Some(answer.points[0]),
    }
}
