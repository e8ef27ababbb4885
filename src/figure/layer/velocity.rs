//! A body's velocity in the world; in configuration space the relative velocity `v_A` − `v_B` from the
//! origin.
//!
//! In the panel of a moving body's frame it is the velocity as seen from there. Over t in [0, 1] a body moves
//! by its velocity: its way from the panel's moment to the hit wears the accent.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{Anchor, Label, Outline, Pen, Rank, Sketch};
use crate::figure::text::{Quantity, in_panel, number};
use crate::geometry::{Body, DVec2, Enclosure, Side};
use crate::scene::{NOTES, Space, When};
use crate::trace::step::turned;
use crate::trace::{Event, phrase};

use super::held;
use super::normal::scaled;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

pub(super) const LAYER: Layer = Layer {
    name: "velocity",
    in_words: phrase(["velocity", "Geschwindigkeit", "vitesse", "velocidad"]),
    about: "velocities; the relative one in configuration space",
    shows: Shows::Anywhere,
    tells: Tells::Given,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "those that move", about: "which bodies" },
        OptionSpec {
            name: "from",
            takes: Takes::Word(&["center", "contact"]),
            default: "\"center\"",
            about: "starts at the body's origin, or a circle's centre that goes straight; or at the point \
                that touches at the hit",
        },
        OptionSpec {
            name: "accent",
            takes: Takes::Word(&[When::HIT]),
            default: "none",
            about: "the way from the panel's moment to the hit in the accent, with its time",
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
            about: "drawn length of a unit of velocity, world units; the label says it",
        },
        OptionSpec {
            name: "values",
            takes: Takes::Flag,
            default: "false",
            about: "writes the velocities' components, in the frame of the panel",
        },
        OptionSpec {
            name: "length",
            takes: Takes::Flag,
            default: "false",
            about: "writes how long they are: the way in a unit of time",
        },
    ],
    labels: &[
        LabelKey { key: "v", about: "the relative velocity" },
        LabelKey { key: "v_A", about: "velocity of the first body" },
        LabelKey { key: "v_B", about: "velocity of the second body" },
        LabelKey { key: "t", about: "time of the hit; with Δ the time until it, after the start" },
    ],
    needs: "a body that moves, as the panel shows it; for \"contact\" and \"hit\" a question for the first \
        contact",
    fed: |context, options| {
        let at_the_hit = [("from", "contact"), ("cut", When::HIT), ("accent", When::HIT)];
        // What needs a hit is found out before a page is made.
        let is_given = |(option, word): &(&'static str, &str)| NOTES && options.word(option, "") == *word;
        let given = at_the_hit.into_iter().find(is_given);
        // A motion without a hit is drawn whole.
        if given.is_some() && !context.asks_for_a_hit() {
            return Fed::Never;
        }
        let why = ["seen from the panel's frame nothing moves", "no body moves"];
        let fed = Fed::by_the_frame(!moving(context).is_empty(), context, why);
        fed.with_a_hit_for(given.map(|(option, _)| option), context)
    },
    draw,
};

/// The bodies that move, as the panel shows it.
fn moving(context: &Context) -> Vec<Side> {
    context.sides().into_iter().filter(|&side| seen(context, side) != DVec2::ZERO).collect()
}

/// The velocity of a body as the panel shows it.
fn seen(context: &Context, side: Side) -> DVec2 {
    let Some(body) = context.body(side) else { return DVec2::ZERO };
    context.moving_frame().map_or(body.velocity, |frame| frame.velocity(body))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let scale = options.number("scale").unwrap_or(1.0);
    let (hit, known) = (context.hit_time(), context.answered());
    if *context.space == Space::Configuration {
        let v = context.closing_velocity();
        let now = context.difference_time();
        let way = hit.map(|time| vec![DVec2::ZERO, v * (time.lo - now)]);
        arrow(
            sketch,
            options,
            &Motion {
                key: "v",
                text: text("$v$", v, options, scale),
                length: length("$v$", v, options),
                way,
                from: DVec2::ZERO,
                v,
                now,
                hit,
                scale,
                known,
                bounded: None,
            },
        );
        held::closing_velocity(sketch, context, (v * scale, scale));
        return;
    }
    for side in options.of(&moving(context)) {
        let (Some(pose), v) = (context.pose(side, context.time), seen(context, side)) else { continue };
        let local = start(context, options, side);
        let way = hit.map(|time| context.track(side, local, [context.time, time.lo]));
        let key = if side == Side::A { "v_A" } else { "v_B" };
        // Cut off at the hit it is what the body moves by until then, and says which part of v that is.
        let until = hit.filter(|_| options.word("cut", "") == When::HIT).map(|time| time.lo - context.time);
        let symbol = context.symbol("v", side);
        let text = text(&symbol, in_panel(context, v), options, scale * until.unwrap_or(1.0));
        let length = length(&symbol, v, options);
        let from = pose.point(local);
        // How far a body moves is what a question about its motion is after.
        let is_bound = |event: &Event| matches!(event, Event::MotionBounded { body, .. } if *body == side);
        let bounded = length.as_ref().and(context.cue(is_bound)).map(|cue| cue.part(turned::BOUND));
        let now = context.time;
        let motion = Motion { key, text, length, from, v, way, now, hit, bounded, scale, known };
        arrow(sketch, options, &motion);
        // An arrow that the hit cuts off ends there, whatever the velocity is.
        if !is_cut(options, &motion) {
            held::velocity(sketch, context, side, (from + v * scale, scale));
        }
    }
}

/// What the label of a velocity says: its symbol, the scale that it is drawn in, its components if wanted.
pub(super) fn text(symbol: &str, v: DVec2, options: &Options, scale: f64) -> String {
    let drawn = scaled(scale, symbol);
    let value = || format!("$= ({}, {})$", number(v.x), number(v.y));
    match (options.flag("values", false), drawn == symbol) {
        (false, _) => drawn,
        (true, true) => format!("{symbol} {}", value()),
        (true, false) => {
            let factor = drawn.strip_suffix(symbol).unwrap_or("").trim_end();
            format!("{symbol} {}, drawn at {factor}", value())
        }
    }
}

/// How long a velocity is, if wanted: "|v| = 5".
fn length(symbol: &str, v: DVec2, options: &Options) -> Option<String> {
    let letter = symbol.trim_matches('$');
    options.flag("length", false).then(|| format!("$|{letter}| = {}$", number(v.length())))
}

/// Where the arrow of a body starts, in the body's frame: at the point that is to touch; or at its origin,
/// the only point of a body that turns which goes straight. A circle that does not turn has it at its centre.
fn start(context: &Context, options: &Options, side: Side) -> DVec2 {
    let touching = || {
        let (time, contact) = context.hit()?;
        Some(context.pose(side, time)?.inverse_point(contact.points[usize::from(side == Side::B)]))
    };
    let contact = options.word("from", "center") == "contact";
    let going = context.body(side).filter(|body| body.spin.is_zero());
    let own = || going.map_or(DVec2::ZERO, Body::center);
    contact.then(touching).flatten().unwrap_or_else(own)
}

/// An arrow to draw, in the panel's space.
struct Motion {
    /// Key of its label.
    key: &'static str,
    /// Text of its label, markup.
    text: String,
    /// A second line of it: how long the velocity is.
    length: Option<String>,
    /// Tail.
    from: DVec2,
    /// The velocity.
    v: DVec2,
    /// The way from the panel's moment to the hit, where there is one.
    way: Option<Vec<DVec2>>,
    /// The panel's moment.
    now: f64,
    /// The time of the hit with its bounds, where there is one.
    hit: Option<Enclosure>,
    /// With what its label comes; none for one that is there from the start.
    bounded: Option<Cue>,
    /// Drawn length of a unit of velocity, world units.
    scale: f64,
    /// With what the hit is known.
    known: Cue,
}

impl Motion {
    /// The way to the hit as it is drawn, with the time of the hit; none where that is not ahead.
    fn ahead(&self) -> Option<(Vec<DVec2>, Enclosure)> {
        let hit = self.hit.filter(|hit| hit.lo > self.now)?;
        let way = self.way.as_ref()?;
        Some((way.iter().map(|&p| self.from + (p - self.from) * self.scale).collect(), hit))
    }
}

/// Whether the arrow is cut off at the hit.
fn is_cut(options: &Options, m: &Motion) -> bool {
    options.word("cut", "") == When::HIT && m.hit.is_some()
}

/// Draws an arrow; up to the hit in the accent, where the scene wants that.
fn arrow(sketch: &mut Sketch, options: &Options, m: &Motion) {
    let ahead = m.ahead();
    // A motion without a hit is drawn whole; a hit that is no longer ahead leaves nothing to draw.
    if is_cut(options, m) {
        let Some((way, _)) = ahead else { return };
        sketch.since(m.known);
        let role = options.role(Role::Now);
        sketch.part("velocity");
        if let [from, tip] = way[..] {
            sketch.arrow(from, tip, Pen::highlighted(role));
        } else {
            sketch.area(&Outline::polyline(&way), None, Some(Pen::highlighted(role)));
        }
        let anchor = along(&way);
        sketch.label(Label::new(m.key, m.text.clone(), anchor, role));
        return;
    }
    let role = options.role(Role::Ink);
    let (from, tip) = (m.from, m.from + m.v * m.scale);
    let until = ahead.filter(|_| options.word("accent", "") == When::HIT);
    sketch.since(None).part("velocity").arrow(from, tip, Pen::vector(role));
    if let Some((way, _)) = &until {
        let pen = until_hit();
        sketch.since(m.known).part("until-hit");
        if let [from, end] = way[..] {
            sketch.line(from, end, pen);
        } else {
            sketch.area(&Outline::polyline(way), None, Some(pen));
        }
    }
    sketch.since(m.bounded);
    let lines = std::iter::once(m.text.clone()).chain(m.length.clone()).collect();
    sketch.label(Label { lines, ..Label::new(m.key, "", Anchor::tip(from, tip), role) });
    if let Some((way, time)) = until {
        sketch.since(m.known);
        let label =
            if m.now > 0.0 { waiting(time, m.now, along(&way)) } else { label_of_hit(time, along(&way)) };
        sketch.label(label);
    }
}

/// The pen for the way to the hit, over the vector that it is part of: one line that is thick as far as
/// nothing is in the way.
pub(super) const fn until_hit() -> Pen {
    Pen::highlighted(Role::Now)
}

/// The anchor of a label of a way: beside its middle.
fn along(way: &[DVec2]) -> Anchor {
    match way {
        [from, to] => Anchor::middle(*from, *to),
        _ => Anchor::point(way.get(way.len() / 2).copied().unwrap_or(DVec2::ZERO)),
    }
}

/// The label of a way up to the hit, from the start: its time.
pub(super) fn label_of_hit(time: Enclosure, anchor: Anchor) -> Label {
    let time = Quantity::within(time).latex();
    Label::new("t", format!("$t = {time}$"), anchor, Role::Now).rank(Rank::Measure)
}

/// The label of a way up to the hit, from a later moment: the time that it takes.
fn waiting(time: Enclosure, now: f64, anchor: Anchor) -> Label {
    let time = Quantity::within(Enclosure { lo: time.lo - now, hi: time.hi - now }).latex();
    Label::new("t", format!(r"$\Delta t = {time}$"), anchor, Role::Now).rank(Rank::Measure)
}
