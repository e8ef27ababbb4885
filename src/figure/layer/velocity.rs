//! A body's velocity in the world; in configuration space the relative velocity `v_A` − `v_B` from the
//! origin.
//!
//! Over t in [0, 1] a body moves by its velocity, so that the arrow is its path; the part up to the hit wears
//! the accent.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Sketch};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side};
use crate::scene::{Space, When};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes};

pub(super) const LAYER: Layer = Layer {
    name: "velocity",
    about: "velocities; the relative one in configuration space",
    shows: Shows::Anywhere,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "those that move", about: "which bodies" },
        OptionSpec {
            name: "from",
            takes: Takes::Word(&["center", "contact"]),
            default: "\"center\"",
            about: "starts at the body's origin, or at the point that touches at the hit",
        },
        OptionSpec {
            name: "accent",
            takes: Takes::Word(&[When::HIT]),
            default: "none",
            about: "the part up to the hit in the accent, with its time",
        },
        OptionSpec {
            name: "cut",
            takes: Takes::Word(&[When::HIT]),
            default: "none",
            about: "ends at the hit, all in the accent",
        },
        OptionSpec {
            name: "scale",
            takes: Takes::Number,
            default: "1",
            about: "drawn length of a unit of velocity, world units",
        },
    ],
    labels: &[
        LabelKey { key: "v", about: "the relative velocity" },
        LabelKey { key: "v_A", about: "velocity of the first body" },
        LabelKey { key: "v_B", about: "velocity of the second body" },
        LabelKey { key: "t", about: "time of the hit" },
    ],
    needs: "a body that moves; for \"contact\" and \"hit\" a question for the first contact",
    fed: |context, options| {
        let hit = options.word("from", "center") == "contact"
            || options.word("cut", "") == When::HIT
            || options.word("accent", "") == When::HIT;
        // A motion without a hit is drawn whole.
        Fed::by_the_scene(!moving(context).is_empty() && (!hit || context.asks_for_a_hit()))
    },
    draw,
};

/// The bodies that move.
fn moving(context: &Context) -> Vec<Side> {
    let moves = |side: &Side| context.body(*side).is_some_and(|body| body.velocity != DVec2::ZERO);
    context.sides().into_iter().filter(moves).collect()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    if *context.space == Space::Configuration {
        let v = relative(context) * options.number("scale").unwrap_or(1.0);
        arrow(sketch, context, options, &Motion { key: "v", text: "$v$", from: DVec2::ZERO, v });
        return;
    }
    for side in options.of(&moving(context)) {
        let Some(body) = context.body(side) else { continue };
        let from = start(context, options, side);
        let v = body.velocity * options.number("scale").unwrap_or(1.0);
        let (key, text) = if side == Side::A { ("v_A", "$v_A$") } else { ("v_B", "$v_B$") };
        arrow(sketch, context, options, &Motion { key, text, from, v });
    }
}

/// The relative velocity `v_A` − `v_B`: the way the origin goes, seen from B ⊖ A.
pub(super) fn relative(context: &Context) -> DVec2 {
    let velocity = |side| context.body(side).map_or(DVec2::ZERO, |body| body.velocity);
    velocity(Side::A) - velocity(Side::B)
}

/// Where the arrow of a body starts at the panel's moment, in the world: at its origin, or at the point that
/// is to touch.
fn start(context: &Context, options: &Options, side: Side) -> DVec2 {
    let now = context.pose(side, context.time);
    let touching = || {
        let (time, contact) = context.hit()?;
        let local = context.pose(side, time)?.inverse_point(contact.points[usize::from(side == Side::B)]);
        Some(now?.point(local))
    };
    let center = now.map_or(DVec2::ZERO, |pose| pose.position);
    if options.word("from", "center") == "contact" { touching().unwrap_or(center) } else { center }
}

/// An arrow to draw, in the panel's space.
struct Motion {
    /// Key of its label.
    key: &'static str,
    /// Text of its label, markup.
    text: &'static str,
    /// Tail.
    from: DVec2,
    /// From tail to tip.
    v: DVec2,
}

/// Draws an arrow; up to the hit in the accent, where the scene wants that.
fn arrow(sketch: &mut Sketch, context: &Context, options: &Options, m: &Motion) {
    let hit = context.hit().map(|(time, _)| time);
    let role = options.role(Role::Ink);
    let (from, tip) = (m.from, m.from + m.v);
    if let (Some(time), When::HIT) = (hit, options.word("cut", "")) {
        let tip = from + m.v * time;
        sketch.part("velocity").arrow(from, tip, Pen::highlighted(options.role(Role::Now)));
        sketch.label(Label::new(m.key, m.text, Anchor::middle(from, tip), options.role(Role::Now)));
        return;
    }
    sketch.part("velocity").arrow(from, tip, Pen::vector(role));
    sketch.label(Label::new(m.key, m.text, Anchor::tip(from, tip), role));
    if let (Some(time), When::HIT) = (hit, options.word("accent", "")) {
        until_hit(sketch, from, m.v, time);
    }
}

/// Draws the part of a path up to the hit, in the accent, with its time.
pub(super) fn until_hit(sketch: &mut Sketch, from: DVec2, v: DVec2, time: f64) {
    let end = from + v * time;
    sketch.part("until-hit").line(from, end, Pen::highlighted(Role::Now));
    let text = format!("$t = {}$", number(time));
    sketch.label(Label::new("t", text, Anchor::middle(from, end), Role::Now).rank(Rank::Measure));
}
