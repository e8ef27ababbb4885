//! Which way a body turns: an arc arrow around its origin.

use std::f64::consts::{PI, TAU};

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Marker, Pen, SMALL_MARKER, Sketch, angle_of};
use crate::geometry::Side;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, part};

/// Radius of the arrow where the scene does not say, world units.
const RADIUS: f64 = 0.6;

/// How far the arrow runs, radians: open enough to be no circle, and to let the velocity out.
const SWEEP: f64 = 0.6 * TAU;

pub(super) const LAYER: Layer = Layer {
    name: "spin",
    about: "an arc arrow for the angular velocity",
    shows: Shows::World,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "those that turn", about: "which bodies" },
        OptionSpec { name: "radius", takes: Takes::Number, default: "0.6", about: "world units" },
    ],
    labels: &[
        LabelKey { key: "omega_A", about: "angular velocity of the first body" },
        LabelKey { key: "omega_B", about: "angular velocity of the second body" },
    ],
    needs: "a body that turns",
    fed: |context, _| Fed::by_the_scene(!turning(context).is_empty()),
    draw,
};

/// The bodies that turn.
fn turning(context: &Context) -> Vec<Side> {
    let turns = |side: &Side| context.body(*side).is_some_and(|body| !body.spin.is_zero());
    context.sides().into_iter().filter(turns).collect()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let role = options.role(Role::Ink);
    let radius = options.number("radius").unwrap_or(RADIUS);
    for side in options.of(&turning(context)) {
        let (Some(body), Some(pose)) = (context.body(side), context.pose(side, context.time)) else {
            continue;
        };
        let sweep = SWEEP.copysign(body.spin.degrees());
        // The opening lies around the velocity, whose arrow starts here too.
        let away = angle_of(-body.velocity);
        let start = if body.velocity.length_squared() > 0.0 { away } else { PI } - 0.5 * sweep;
        let center = pose.position;
        sketch.part(part("spin", side)).marker(center, Marker::Disc, role, SMALL_MARKER);
        sketch.part(part("spin", side)).arc_arrow(center, radius, start, sweep, Pen::vector(role).width(1.5));
        let (key, text) =
            if side == Side::A { ("omega_A", r"$\omega_A$") } else { ("omega_B", r"$\omega_B$") };
        sketch.label(Label::new(key, text, Anchor::Arc { center, radius, start, sweep }, role));
    }
}
