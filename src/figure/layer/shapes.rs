//! The bodies at the panel's moment, filled and named; with `centers`, their origins marked.

use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, Size, Sketch, Wash};
use crate::geometry::{Pose, Side};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, part};

pub(super) const LAYER: Layer = Layer {
    name: "shapes",
    about: "the bodies at the panel's moment, with their names",
    shows: Shows::World,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "all of the query's", about: "which bodies" },
        OptionSpec {
            name: "centers",
            takes: Takes::Flag,
            default: "false",
            about: "marks the bodies' origins",
        },
    ],
    labels: &[
        LabelKey { key: "A", about: "name of the first body" },
        LabelKey { key: "B", about: "name of the second body" },
        LabelKey { key: "a", about: "origin of the first body, with centers" },
        LabelKey { key: "b", about: "origin of the second body, with centers" },
    ],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let sides = options.of(&context.sides());
    let centers = options.flag("centers", false);
    for &side in &sides {
        body(sketch, context, options, side);
    }
    for &side in &sides {
        name(sketch, context, options, side, centers);
    }
}

/// Draws a body.
fn body(sketch: &mut Sketch, context: &Context, options: &Options, side: Side) {
    let Some(outline) = context.outline(side, context.time) else { return };
    let role = options.role(side.into());
    sketch.part(part("body", side)).area(&outline, Some(Wash::theme(role)), Some(Pen::outline(role)));
}

/// Names a body inside it; with `center`, marks its origin.
fn name(sketch: &mut Sketch, context: &Context, options: &Options, side: Side, center: bool) {
    let Some(outline) = context.outline(side, context.time) else { return };
    let role = options.role(side.into());
    let key = if side == Side::A { "A" } else { "B" };
    let pose = context.pose(side, context.time).filter(|_| center);
    sketch.part(part("body", side)).label(
        Label::new(key, context.name(side), Anchor::inside(&outline), role).rank(Rank::Name).size(Size::Name),
    );
    if let Some(Pose { position, .. }) = pose {
        let marker = if side == Side::A { Marker::Disc } else { Marker::Square };
        let key = if side == Side::A { "a" } else { "b" };
        sketch.part(part("center", side)).marker(position, marker, role, MARKER);
        sketch.label(Label::new(key, "", Anchor::point(position), role).rank(Rank::Point));
    }
}
