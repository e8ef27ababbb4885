//! A body's own axes: the frame in which an oriented box is an AABB.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Pen, Sketch};
use crate::geometry::{DVec2, Side};

use super::{Fed, Layer, OptionSpec, Options, Shows, Takes, part};

/// Drawn length of an axis where the scene does not say, world units.
const LENGTH: f64 = 1.6;

pub(super) const LAYER: Layer = Layer {
    name: "frame",
    about: "the axes of a body's own frame",
    shows: Shows::World,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "the first", about: "which bodies" },
        OptionSpec { name: "length", takes: Takes::Number, default: "1.6", about: "world units" },
    ],
    labels: &[],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let length = options.number("length").unwrap_or(LENGTH);
    let pen = Pen::vector(options.role(Role::Muted));
    for side in options.of(&[Side::A]) {
        let Some(pose) = context.pose(side, context.time) else { continue };
        for axis in [DVec2::X, DVec2::Y] {
            sketch.part(part("frame", side)).arrow(pose.position, pose.point(axis * length), pen);
        }
    }
}
