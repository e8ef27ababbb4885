//! The ray along the relative velocity against B ⊖ A: it enters when the bodies touch.
//!
//! It is the origin's way over t in [0, 1] as seen from B ⊖ A: in a panel of a later moment it starts behind
//! the origin. In a figure that plays, a dot is where the origin has come to.
//!
//! Where a body turns, B ⊖ A changes on the way, and there is no such ray.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, Size, Sketch};
use crate::geometry::{DVec2, Side};
use crate::scene::When;

use super::velocity::{label_of_hit, text, underlay};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};

pub(super) const LAYER: Layer = Layer {
    name: "ray",
    about: "the origin's way along the relative velocity, and where it hits",
    shows: Shows::Configuration,
    tells: Tells::Found,
    options: &[
        OptionSpec {
            name: "cut",
            takes: Takes::Word(&[When::HIT]),
            default: "none",
            about: "ends soon after the hit",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the components of the relative velocity",
        },
        OptionSpec {
            name: "free",
            takes: Takes::Flag,
            default: "true",
            about: "a band under the way that is free, up to the hit",
        },
        OptionSpec {
            name: "parts",
            takes: Takes::Flag,
            default: "false",
            about: "where both bodies move, A's velocity and then B's reversed, which lead to the same tip",
        },
    ],
    labels: &[
        LabelKey { key: "v", about: "the relative velocity" },
        LabelKey { key: "part.A", about: "velocity of the first body, as a part of it" },
        LabelKey { key: "part.B", about: "velocity of the second body, reversed, as a part of it" },
        LabelKey { key: "t", about: "time of the hit" },
    ],
    needs: "a question for the first contact of bodies that move relative to each other and do not turn",
    fed: |context, _| {
        let still = context.closing_velocity() == DVec2::ZERO;
        Fed::by_the_scene(context.asks_for_a_hit() && !context.turns() && !still)
    },
    draw,
};

/// How much farther than the hit a ray reaches that is cut there.
const PAST: f64 = 1.5;

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let v = context.closing_velocity();
    let role = options.role(Role::Ink);
    let hit = context.hit_time();
    let cut =
        hit.filter(|_| options.word("cut", "") == When::HIT).map_or(1.0, |time| 1.0_f64.min(PAST * time.lo));
    let from = -v * context.difference_time();
    let tip = from + v * cut;
    if let Some(time) = hit.filter(|_| options.flag("free", true)) {
        // Under the arrow, which stays one vector from its tail to its tip.
        sketch.since(context.answered()).part("until-hit").line(from, from + v * time.lo, underlay());
    }
    if options.flag("parts", false) {
        parts(sketch, context, options, from);
    }
    sketch.since(None).part("ray").arrow(from, tip, Pen::vector(role));
    sketch.label(Label::new("v", text("$v$", v, options), Anchor::tip(from, tip), role));
    if let Some(time) = hit {
        let hit = from + v * time.lo;
        sketch.since(context.answered());
        sketch.label(label_of_hit(time, Anchor::middle(from, hit)));
        sketch.part("hit").marker(hit, Marker::Diamond, Role::Now, LARGE_MARKER);
    }
    if let Some(now) = context.now {
        sketch.since(None).part("now").marker(from + v * now, Marker::Disc, role, MARKER);
    }
}

/// Draws the velocities that make up the relative one, `v_A` and then −`v_B`, where both bodies move.
fn parts(sketch: &mut Sketch, context: &Context, options: &Options, from: DVec2) {
    let [a, b] = [Side::A, Side::B].map(|side| context.body(side).map_or(DVec2::ZERO, |body| body.velocity));
    if a == DVec2::ZERO || b == DVec2::ZERO {
        return;
    }
    let reversed = context.symbol("v", Side::B).replacen('$', "$-", 1);
    let ways = [("part.A", Side::A, context.symbol("v", Side::A), a), ("part.B", Side::B, reversed, -b)];
    let mut tail = from;
    for (key, side, symbol, way) in ways {
        sketch.since(None).part(part("ray", side)).arrow(tail, tail + way, Pen::vector(side.into()));
        let anchor = Anchor::middle(tail, tail + way);
        let label = Label::new(key, text(&symbol, way, options), anchor, side.into());
        sketch.label(label.rank(Rank::Measure).size(Size::Note));
        tail += way;
    }
}
