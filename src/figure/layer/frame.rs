//! A body's own axes: the frame in which an oriented box is an AABB; and the angle by which it is turned,
//! from the world's x axis to its own.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Sketch, Weight, angle_of};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

/// Drawn length of an axis where the scene does not say, world units.
const LENGTH: f64 = 1.6;

/// Where the angle is drawn, as a part of the axis' length: its arc clear of the axis' head.
const MARK: f64 = 0.7;

/// The least angle that is drawn, radians: less can't be seen.
const SEEN: f64 = 0.02;

pub(super) const LAYER: Layer = Layer {
    name: "frame",
    in_words: phrase(["frame", "Bezugssystem eines Körpers", "repère d’un corps", "sistema de un cuerpo"]),
    about: "the axes of a body's own frame",
    shows: Shows::World,
    tells: Tells::Given,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "the first", about: "which bodies" },
        OptionSpec { name: "length", takes: Takes::Number, default: "1.6", about: "world units" },
        OptionSpec {
            name: "angle",
            takes: Takes::Flag,
            default: "false",
            about: "the angle by which it is turned, and no second axis",
        },
        OptionSpec {
            name: "back",
            takes: Takes::Flag,
            default: "false",
            about: "the angle the other way, from the body's own axis to the world's: how it is turned back",
        },
    ],
    labels: &[
        LabelKey { key: "angle", about: "the angle by which the body is turned" },
        LabelKey { key: "axis", about: "the body's own axis, with `angle`" },
    ],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let length = options.number("length").unwrap_or(LENGTH);
    let pen = Pen::vector(options.role(Role::Muted));
    for side in options.of(&[Side::A]) {
        let Some(pose) = context.pose(side, context.time) else { continue };
        let turned = options.flag("angle", false);
        for axis in [DVec2::X, DVec2::Y].into_iter().take(if turned { 1 } else { 2 }) {
            sketch.part(part("frame", side)).arrow(pose.position, pose.point(axis * length), pen);
        }
        if turned {
            let (from, tip) = (pose.position, pose.point(DVec2::X * length));
            let text = format!("$x$ of {}", context.name(side));
            sketch.label(Label::new("axis", text, Anchor::tip(from, tip), pen.role).rank(Rank::Word));
            let sweep = angle_of(pose.vector(DVec2::X));
            let turn = if options.flag("back", false) { (sweep, -sweep) } else { (0.0, sweep) };
            angle(sketch, pose.position, turn, length);
        }
    }
}

/// Draws the world's x axis and an angle from `start`, both in radians, about a body's origin.
fn angle(sketch: &mut Sketch, center: DVec2, (start, sweep): (f64, f64), length: f64) {
    let level = center + DVec2::X * length;
    sketch.part("level").weight(Weight::Light).line(center, level, Pen::construction());
    sketch.unnamed(Anchor::middle(center, level));
    if sweep.abs() < SEEN {
        return;
    }
    let radius = MARK * length;
    sketch.part("angle").arc_arrow(center, radius, start, sweep, Pen::dimension(Role::Ink).width(1.5));
    let text = format!("${}°$", number(sweep.to_degrees()));
    let label = Label::new("angle", text, Anchor::Arc { center, radius, start, sweep }, Role::Ink);
    sketch.label(label.rank(Rank::Measure));
}
