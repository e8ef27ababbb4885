//! Which way a body turns: an arc arrow around its origin.

use std::f64::consts::{PI, TAU};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Marker, Pen, SMALL_MARKER, Sketch, angle_of};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

/// Radius of the arrow where the scene does not say, world units.
const RADIUS: f64 = 0.6;

/// The least and the largest radius of such an arrow, page pixels: bodies may be micrometres or kilometres
/// large. At half the least one the arrow's head fills it, at twice the largest it is taken for a body.
const READABLE: [f64; 2] = [14.0, 40.0];

/// How far the arrow runs, radians: open enough to be no circle, and to let the velocity out.
const SWEEP: f64 = 0.6 * TAU;

pub(super) const LAYER: Layer = Layer {
    name: "spin",
    in_words: phrase(["spin", "Drehung", "rotation", "giro"]),
    about: "an arc arrow for the angular velocity",
    shows: Shows::World,
    tells: Tells::Given,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "those that turn", about: "which bodies" },
        OptionSpec {
            name: "radius",
            takes: Takes::Number,
            default: "0.6",
            about: "world units, by default as large as is readable",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the degrees per unit of time",
        },
    ],
    labels: &[
        LabelKey { key: "omega_A", about: "angular velocity of the first body" },
        LabelKey { key: "omega_B", about: "angular velocity of the second body" },
    ],
    needs: "a body that turns, as the panel shows it",
    fed: |context, _| {
        let why = ["seen from the panel's frame nothing turns", "no body turns"];
        Fed::by_the_frame(!turning(context).is_empty(), context, why)
    },
    draw,
};

/// The bodies that turn, as the panel shows it.
fn turning(context: &Context) -> Vec<Side> {
    context.sides().into_iter().filter(|side| seen(context, *side).is_some()).collect()
}

/// How a body moves and turns as the panel shows it: its velocity, and its spin in degrees per unit of time;
/// `None` where it does not turn.
pub(super) fn seen(context: &Context, side: Side) -> Option<(DVec2, f64)> {
    let body = context.body(side)?;
    let own = (body.velocity, body.spin.degrees());
    let (velocity, spin) = context.moving_frame().map_or(own, |f| (f.velocity(body), f.spin(body)));
    (spin != 0.0).then_some((velocity, spin))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let role = options.role(Role::Ink);
    let radius = options.number("radius").unwrap_or_else(|| {
        let [least, most] = READABLE.map(|px| sketch.px(px));
        RADIUS.max(least).min(most)
    });
    for side in options.of(&turning(context)) {
        let (Some((velocity, spin)), Some(pose)) = (seen(context, side), context.pose(side, context.time))
        else {
            continue;
        };
        let sweep = SWEEP.copysign(spin);
        // The opening lies around the velocity, whose arrow starts here too.
        let away = angle_of(-velocity);
        let start = if velocity.length_squared() > 0.0 { away } else { PI } - 0.5 * sweep;
        let center = pose.position;
        sketch.part(part("spin", side)).marker(center, Marker::Disc, role, SMALL_MARKER);
        sketch.part(part("spin", side)).arc_arrow(center, radius, start, sweep, Pen::vector(role).width(1.5));
        let key = if side == Side::A { "omega_A" } else { "omega_B" };
        let symbol = context.symbol(r"\omega", side);
        let text =
            if options.flag("values", false) { format!("{symbol} $= {}°$", number(spin)) } else { symbol };
        sketch.label(Label::new(key, text, Anchor::Arc { center, radius, start, sweep }, role));
    }
}
