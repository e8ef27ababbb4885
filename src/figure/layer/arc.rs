//! The arc that the extreme point of a turning body travels about its origin: L = θ r, from p to p′; no point
//! of the body goes farther. It is drawn about where the origin is at the panel's moment; with it, where it
//! is asked for, the shorter arc of a nearer vertex q.

use std::f64::consts::TAU;

use crate::collision::Answer;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{
    Anchor, Label, MARKER, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight, angle_of,
    on_circle,
};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side, perp};
use crate::scene::NOTES;
use crate::trace::step::turned;
use crate::trace::{Event, phrase};

use super::half_extents::ON_LINE;
use super::turn::{BELOW, FAN, ON_THE_WAY, SECTOR, Turn, rungs};
use super::unrolled::unrolled;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Radius of the angle mark, as a part of r: inside the body, clear of its centre.
const MARK: f64 = 0.32;

/// Radius of the angle mark of a nearer vertex, as a part of that vertex' distance.
const NEARER_MARK: f64 = 0.45;

/// How much farther than usual the length stands off the arc, page pixels: half the arc's wide line.
const CLEAR: f64 = 3.0;

pub(super) const LAYER: Layer = Layer {
    name: "arc",
    in_words: phrase(["arc", "Bogen", "arc", "arco"]),
    about: "the arc of the extreme point of a turning body",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "the first that turns", about: "which body" },
        OptionSpec {
            name: "vertex",
            takes: Takes::Number,
            default: "the first",
            about: "which vertex, where several are farthest",
        },
        OptionSpec {
            name: "sector",
            takes: Takes::Flag,
            default: "false",
            about: "fills the sector and names its measures",
        },
        OptionSpec {
            name: "unrolled",
            takes: Takes::Flag,
            default: "false",
            about: "instead of the turn the sector's arcs straightened, each upright where its point is, \
                    by distance from the origin",
        },
        OptionSpec {
            name: "fan",
            takes: Takes::Flag,
            default: "false",
            about: "faint arcs of points on the outer half of the way to p",
        },
        OptionSpec {
            name: "around",
            takes: Takes::Flag,
            default: "false",
            about: "the whole circle of the extreme point, which no point of the body leaves",
        },
        OptionSpec {
            name: "nearer",
            takes: Takes::Counts,
            default: "none",
            about: "another vertex, whose shorter arc is drawn too; with sector in p's direction",
        },
        OptionSpec {
            name: "inner",
            takes: Takes::Point,
            default: "none",
            about: "instead of a nearer vertex a point of the body, in the body's frame",
        },
    ],
    labels: &[
        LabelKey { key: "theta", about: "the angle" },
        LabelKey { key: "r", about: "distance of the extreme point, with sector or unrolled" },
        LabelKey { key: "L", about: "length of the arc" },
        LabelKey { key: "p", about: "the extreme point" },
        LabelKey { key: "p'", about: "the extreme point after the turn" },
        LabelKey { key: "q", about: "a nearer vertex" },
        LabelKey { key: "q'", about: "the nearer vertex after the turn" },
        LabelKey { key: "r_q", about: "distance of the nearer vertex, with sector or unrolled" },
        LabelKey { key: "L_q", about: "length of its arc, with sector or unrolled" },
        LabelKey { key: "slope", about: "the line that every straightened arc ends on, unrolled" },
        LabelKey { key: "others", about: "another point that is as far" },
    ],
    needs: "a query for the motion bound of a body that turns, and a panel of a frame that rests",
    fed: |context, options| {
        let Some(t) = turn(context, options) else {
            let is_moving = context.moving_frame().is_some();
            return if is_moving { Fed::not_here("the panel's frame moves") } else { Fed::Never };
        };
        if NOTES && wants_another(context, options) {
            return Fed::Without { option: "vertex", why: "that vertex is none of the farthest" };
        }
        if NOTES && options.counts("nearer").is_some() && nearer(context, options, &t).is_none() {
            return Fed::Without { option: "nearer", why: "that vertex is as far as p, or the origin" };
        }
        Fed::Yes
    },
    draw,
};

/// The turn that the algorithm told, of the body and vertex that the scene wants.
fn turn(context: &Context, options: &Options) -> Option<Turn> {
    let wanted = options.of(&context.sides());
    let run = context.run();
    if !matches!(run.answer, Answer::MotionBound(_)) || context.moving_frame().is_some() {
        return None;
    }
    run.find_told(|event| match event {
        Event::MotionBounded { body, radius, theta, arc, vertices, .. }
            if wanted.contains(body) && *theta > 0.0 =>
        {
            let chosen = vertices.iter().find(|v| is_wanted(v.index, options)).or(vertices.first())?;
            let begin = context.pose(*body, 0.0)?.position;
            let arm = chosen.point - begin;
            let center = context.pose(*body, context.time)?.position;
            let start = angle_of(arm);
            let sweep = theta.copysign(context.body(*body)?.spin.degrees());
            let others = vertices.iter().filter(|v| v.index != chosen.index);
            let others = others.map(|v| center + (v.point - begin).normalize_or_zero() * *radius).collect();
            Some(Turn { side: *body, center, radius: *radius, start, sweep, arc: *arc, others })
        }
        _ => None,
    })
}

/// Whether a scene wants the arc of a vertex.
fn is_wanted(index: usize, options: &Options) -> bool {
    options.number("vertex").is_some_and(|i| u32::try_from(index).is_ok_and(|k| f64::from(k) == i))
}

/// Whether a scene wants the arc of a vertex that is not among the farthest.
fn wants_another(context: &Context, options: &Options) -> bool {
    let wanted = options.of(&context.sides());
    let farthest = context.run().find_told(|event| match event {
        Event::MotionBounded { body, vertices, .. } if wanted.contains(body) => {
            Some(vertices.iter().any(|v| is_wanted(v.index, options)))
        }
        _ => None,
    });
    options.number("vertex").is_some() && farthest == Some(false)
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(t) = turn(context, options) else { return };
    let sector = options.flag("sector", false);
    let cue = context.cue(|event| matches!(event, Event::MotionBounded { body, .. } if *body == t.side));
    let at = |part| cue.map(|cue| cue.part(part));
    if options.flag("unrolled", false) {
        let arm = nearer(context, options, &t).map(DVec2::length);
        return unrolled(sketch.since(at(turned::BOUND)), options, &t, arm);
    }
    let [far, turns] = [turned::FARTHEST, turned::ARC].map(at);
    sketch.since(turns);
    let after = t.after();
    // Each of two bodies has its own.
    let is_one = context.sides().len() == 1;
    let name = if is_one { "p".to_owned() } else { context.numbered("p", t.side) };
    if sector {
        let slice = Outline::sector(t.center, t.radius, t.start, t.sweep);
        sketch.part("sector").area(&slice, Some(Wash::faint(Role::Muted, SECTOR)), None);
    }
    for (end, comes) in [(t.before(), far), (after, turns)] {
        sketch.since(comes).part("radii").weight(Weight::Light).line(t.center, end, Pen::construction());
    }
    // The head ends at the marker's rim, not under it.
    let rim = (sketch.px(MARKER + 1.0) / t.radius).min(t.sweep.abs()).copysign(t.sweep);
    if options.flag("around", false) && t.sweep.abs() < TAU {
        let rest = TAU.copysign(t.sweep) - t.sweep;
        sketch.part("way-around").weight(Weight::Light);
        sketch.arc(t.center, t.radius, t.start + t.sweep, rest, Pen::construction());
    }
    let accent = Pen::highlighted(options.role(Role::Now));
    sketch.part("arc").arc_arrow(t.center, t.radius, t.start, t.sweep - rim, accent);
    let (role, marker) = (Role::from(t.side), if t.side == Side::A { Marker::Disc } else { Marker::Square });
    sketch.since(far);
    if !sector {
        as_far(sketch, &t, &name);
    }
    for (point, comes) in [(t.before(), far), (after, turns)] {
        sketch.since(comes).part("extreme-point").marker(point, marker, role, MARKER);
    }
    sketch.since(far).part("center").marker(t.center, Marker::Disc, Role::Ink, SMALL_MARKER);
    sketch.since(turns);
    if options.flag("fan", false) {
        fan(sketch, &t, nearer(context, options, &t));
    }
    points(sketch, (&t, &name), [far, turns]);
    let arm = nearer(context, options, &t);
    measures(sketch, options, &t, (sector, arm.is_some()), [far, turns, at(turned::BOUND)]);
    if let Some(arm) = arm {
        shorter(sketch.since(turns), &t, arm, sector);
    }
}

/// Draws arcs of points on the way to p, faint, but that which is drawn anyway.
fn fan(sketch: &mut Sketch, t: &Turn, drawn: Option<DVec2>) {
    sketch.part("fan").weight(Weight::Light);
    for radius in rungs(t, drawn.map(DVec2::length)) {
        sketch.arc(t.center, radius, t.start, t.sweep, Pen::dimension(t.side.into()).opacity(FAN));
    }
}

/// From the body's origin to the vertex or point whose arc is drawn too, in the world at the start.
fn nearer(context: &Context, options: &Options, t: &Turn) -> Option<DVec2> {
    if let Some(inner) = options.point("inner") {
        let arm = context.pose(t.side, 0.0)?.vector(inner);
        return (arm.length() > 0.0).then_some(arm);
    }
    let &index = options.counts("nearer")?.first()?;
    let (begin, vertex) = (context.pose(t.side, 0.0)?.position, context.vertex(t.side, index, 0.0)?);
    let core = vertex - begin;
    let arm = core + core.normalize_or_zero() * context.body(t.side)?.shape.radius;
    let is_nearer = arm.length() < t.radius * (1.0 - ON_THE_WAY);
    (arm.length() > 0.0 && is_nearer).then_some(arm)
}

/// Draws the turn of a nearer vertex: at its place, or with the sector in the direction of the extreme point,
/// where the lengths can be compared.
fn shorter(sketch: &mut Sketch, t: &Turn, arm: DVec2, sector: bool) {
    let radius = arm.length();
    // On the way to p its radii and angle are there already.
    let ahead = on_circle(DVec2::ZERO, radius, t.start).distance(arm) <= ON_THE_WAY * t.radius;
    let start = if sector || ahead { t.start } else { angle_of(arm) };
    let [from, to] = [start, start + t.sweep].map(|angle| on_circle(t.center, radius, angle));
    let (role, marker) = (Role::from(t.side), if t.side == Side::A { Marker::Disc } else { Marker::Square });
    if !sector && !ahead {
        for end in [from, to] {
            sketch.part("nearer").weight(Weight::Light).line(t.center, end, Pen::construction());
        }
        angle(sketch, t, (start, NEARER_MARK * radius), r"$\theta$".to_owned());
    }
    let rim = (sketch.px(MARKER + 1.0) / radius).min(t.sweep.abs()).copysign(t.sweep);
    sketch.part("nearer-arc").arc_arrow(t.center, radius, start, t.sweep - rim, Pen::vector(role));
    for (key, text, point) in [("q", "$q$", from), ("q'", "$q'$", to)] {
        sketch.part("nearer-point").marker(point, marker, role, MARKER);
        let out = (point - t.center).normalize_or_zero();
        // In the sector on the outer side of its two radii.
        let aside = if key == "q" { -perp(out) } else { perp(out) } * t.sweep.signum();
        let anchor = Anchor::point_toward(point, if sector || ahead { aside } else { out });
        sketch.label(Label::new(key, text, anchor, Role::Ink).rank(Rank::Point));
    }
    if sector {
        measured(sketch, t, from, ("r_q", format!("$r_q = {}$", number(radius)), BELOW[0]));
        let path = Anchor::Arc { center: t.center, radius, start, sweep: t.sweep };
        let length = format!(r"$\theta\,r_q = {}$", number(radius * t.sweep.abs()));
        sketch.label(Label::new("L_q", length, path, role));
    }
}

/// Marks the other points that are as far from the origin as the extreme point; the first is named.
fn as_far(sketch: &mut Sketch, t: &Turn, name: &str) {
    let marker = if t.side == Side::A { Marker::HollowDisc } else { Marker::HollowSquare };
    for &point in &t.others {
        sketch.part("as-far").marker(point, marker, t.side.into(), SMALL_MARKER);
    }
    if let Some(&first) = t.others.first() {
        let anchor = Anchor::point_toward(first, first - t.center);
        let label = Label::new("others", format!("as far as ${name}$"), anchor, Role::Muted);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// Names the extreme point before and after, each with what it comes with.
fn points(sketch: &mut Sketch, (t, name): (&Turn, &str), [far, turns]: [Option<Cue>; 2]) {
    let both = [("p", format!("${name}$"), t.before(), far), ("p'", format!("${name}'$"), t.after(), turns)];
    for (key, text, point, comes) in both {
        let anchor = Anchor::point_toward(point, point - t.center);
        sketch.since(comes).label(Label::new(key, text, anchor, Role::Ink).rank(Rank::Point));
    }
}

/// Draws and names the angle of the turn, from a direction on, at a distance from the origin.
fn angle(sketch: &mut Sketch, t: &Turn, (start, radius): (f64, f64), text: String) {
    let (center, sweep) = (t.center, t.sweep);
    let mark = Outline::arc(center, radius, start, sweep);
    sketch.part("angle").area(&mark, None, Some(Pen::dimension(Role::Ink).width(1.5)));
    sketch.label(Label::new("theta", text, Anchor::Arc { center, radius, start, sweep }, Role::Ink));
}

/// The ends of a radius, so that its outer side is on the left: seen from the centre on its right, where the
/// turn is counter-clockwise.
fn below(t: &Turn, end: DVec2) -> (DVec2, DVec2) {
    if t.sweep > 0.0 { (end, t.center) } else { (t.center, end) }
}

/// Draws a dimension line below the lower radius, from the centre to a point on it.
fn measured(sketch: &mut Sketch, t: &Turn, end: DVec2, (key, text, off): (&'static str, String, f64)) {
    let offset = sketch.fitted(off);
    let pen = Pen::dimension(Role::Ink);
    sketch.part("radius").dimension(t.center, end, -offset.copysign(t.sweep), pen);
    let (from, to) = below(t, end);
    sketch.label(Label::new(key, text, Anchor::Beside { from, to, offset }, Role::Ink));
}

/// Names the angle and the arc, and with the sector writes its radius and the arc's length; a radius that
/// is divided by a nearer vertex has a dimension line over its whole length. Radius, angle and the sector's
/// length come with what tells them.
fn measures(
    sketch: &mut Sketch,
    options: &Options,
    t: &Turn,
    (sector, divided): (bool, bool),
    [far, turns, bound]: [Option<Cue>; 3],
) {
    sketch.since(turns);
    let theta = if sector {
        // In radians too, by which r is multiplied.
        let (degrees, radians) = (number(t.sweep.abs().to_degrees()), number(t.sweep.abs()));
        format!(r"$\theta = {degrees}° = {radians}$ rad")
    } else {
        r"$\theta$".to_owned()
    };
    angle(sketch, t, (t.start, MARK * t.radius), theta);
    let outside = t.radius + sketch.px(CLEAR);
    let path = Anchor::Arc { center: t.center, radius: outside, start: t.start, sweep: t.sweep };
    let length = if sector { format!(r"$L = \theta\,r = {}$", number(t.arc)) } else { "$L$".to_owned() };
    let mut lines = vec![length];
    // A circle that is gone round three times looks like one.
    if t.sweep.abs() > TAU {
        lines.push(format!("(${}$ turns)", number(t.sweep.abs() / TAU)));
    }
    sketch.since(if sector { bound } else { turns });
    sketch.label(Label { lines, ..Label::new("L", "", path, options.role(Role::Now)) });
    if sector {
        sketch.since(far);
        let r = format!("$r = {}$", number(t.radius));
        if divided {
            measured(sketch, t, t.before(), ("r", r, BELOW[1]));
        } else {
            let (from, to) = below(t, t.before());
            sketch.label(Label::new("r", r, Anchor::Beside { from, to, offset: ON_LINE }, Role::Ink));
        }
    }
}

#[cfg(test)]
mod tests;
