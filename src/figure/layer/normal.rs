//! The unit normal n from A to B along which B moves apart; turned round it is the N of the article's
//! circles. It is one unit long; where that is far less or more than the bodies it says that it is not.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch};
use crate::geometry::{DVec2, Side};
use crate::scene::When;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes};

/// Drawn length of the unit vector where the scene does not say, world units: its own.
const LENGTH: f64 = 1.0;
/// Drawn length where its own is no length to be seen beside the bodies, page pixels.
const FITTED: f64 = 40.0;

pub(super) const LAYER: Layer = Layer {
    name: "normal",
    about: "the unit normal from A to B",
    shows: Shows::World,
    options: &[
        OptionSpec {
            name: "at",
            takes: Takes::When(&[When::START, When::HIT, When::CLOSEST, When::END]),
            default: "the panel's moment",
            about: "when the bodies are asked for their normal",
        },
        OptionSpec {
            name: "from",
            takes: Takes::Word(&["contact", "A", "B"]),
            default: "\"contact\"",
            about: "starts at the closest point of A, or at the origin of a body",
        },
        OptionSpec { name: "flip", takes: Takes::Flag, default: "false", about: "from B to A instead" },
        OptionSpec {
            name: "length",
            takes: Takes::Number,
            default: "1, or 40 px",
            about: "drawn length, world units",
        },
    ],
    labels: &[
        LabelKey { key: "n", about: "the normal from A to B" },
        LabelKey { key: "N", about: "the normal from B to A, with flip" },
    ],
    needs: "two convex bodies; for \"hit\" a question for the first contact",
    fed: |context, options| match options.when("at") {
        Some(When::Hit | When::Closest) => {
            Fed::by_the_answer(found(context, options).is_some(), context.asks_for_a_hit())
        }
        _ => Fed::by_the_scene(found(context, options).is_some()),
    },
    draw,
};

/// The moment that the scene wants, and the pair then.
fn found(context: &Context, options: &Options) -> Option<(f64, Separation)> {
    let time = match options.when("at") {
        Some(when) => context.moment(&when)?.time,
        None => context.time,
    };
    Some((time, context.separation_seen(time)?))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((time, answer)) = found(context, options) else { return };
    let Some(from) = start(context, options, time, &answer) else { return };
    let flip = options.flag("flip", false);
    let n = if flip { -answer.normal } else { answer.normal };
    let given = options.number("length");
    let to_scale = given.is_some() || sketch.is_legible(LENGTH);
    let tip = from + n * given.unwrap_or(if to_scale { LENGTH } else { sketch.px(FITTED) });
    let role = options.role(Role::Ink);
    sketch.part("normal").arrow(from, tip, Pen::vector(role));
    let (key, letter) = if flip { ("N", "$N$") } else { ("n", "$n$") };
    let text = if to_scale { letter.to_owned() } else { format!("{letter} (not to scale)") };
    sketch.label(Label::new(key, text, Anchor::tip(from, tip), role));
}

/// Where the arrow starts at `time`, in the world.
fn start(context: &Context, options: &Options, time: f64, answer: &Separation) -> Option<DVec2> {
    let origin = |side| context.pose(side, time).map(|pose| pose.position);
    match options.word("from", "contact") {
        "A" => origin(Side::A),
        "B" => origin(Side::B),
        _ => Some(answer.points[0]),
    }
}
