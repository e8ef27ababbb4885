//! The ray from the origin along the relative velocity against B ⊖ A at t = 0: it enters when the bodies
//! touch.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, Marker, Pen, Sketch};
use crate::geometry::DVec2;

use super::velocity::{relative, until_hit};
use super::{Fed, LabelKey, Layer, Options, Shows};

pub(super) const LAYER: Layer = Layer {
    name: "ray",
    about: "the ray from the origin along the relative velocity, and where it hits",
    shows: Shows::Configuration,
    options: &[],
    labels: &[
        LabelKey { key: "v", about: "the relative velocity" },
        LabelKey { key: "t", about: "time of the hit" },
    ],
    needs: "a question for the first contact of bodies that move relative to each other and do not turn",
    fed: |context, _| {
        let turns = |side| context.body(side).is_some_and(|body| !body.spin.is_zero());
        let turning = context.sides().into_iter().any(turns);
        Fed::by_the_scene(context.asks_for_a_hit() && !turning && relative(context) != DVec2::ZERO)
    },
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let v = relative(context);
    let role = options.role(Role::Ink);
    sketch.part("ray").arrow(DVec2::ZERO, v, Pen::vector(role));
    sketch.label(Label::new("v", "$v$", Anchor::tip(DVec2::ZERO, v), role));
    if let Some((time, _)) = context.hit() {
        until_hit(sketch, DVec2::ZERO, v, time);
        sketch.part("hit").marker(v * time, Marker::Disc, Role::Now, LARGE_MARKER);
    }
}
