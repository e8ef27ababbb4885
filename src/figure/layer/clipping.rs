//! Points of contact by clipping: the reference edge with its normal n, the planes through its ends, what
//! they leave of the incident edge, and at each end of that the depth below the reference edge.
//!
//! What a plane cuts off is grey and crossed out. An end above the reference edge, no contact, is hollow.

mod found;

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch, Weight, left_of,
};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side, perp};
use crate::scene::NOTES;
use crate::trace::{Event, phrase};

use found::{Clipping, Point, ends_told, shown};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// How far a plane reaches past the reference edge and past the incident edge, page pixels.
const PAST: f64 = 30.0;

/// Width of the edges, page pixels: more than an outline, which lies under them.
const EDGE: f64 = 4.5;

/// The shortest and the longest that n is drawn, page pixels, where one unit of the world is less or more.
const READABLE: [f64; 2] = [24.0, 48.0];

/// Where n stands on the reference edge, as a part of it: its name is in the middle.
const ASIDE: f64 = 0.8;

/// The words of the option `show`, in the order in which a reader needs them.
const PARTS: [&str; 4] = ["edges", "planes", "cut", "depths"];

/// Why of a circle only the depth is drawn.
const NOT_CLIPPED: &str = "the bodies touch at one point, and no edge is clipped";

pub(super) const LAYER: Layer = Layer {
    name: "clipping",
    in_words: phrase(["clipping", "Beschneiden", "découpage", "recorte"]),
    about: "points of contact: reference edge, side planes, what they cut off, depths",
    shows: Shows::World,
    tells: Tells::Found,
    options: &[OptionSpec {
        name: "show",
        takes: Takes::Words(&PARTS),
        default: "all",
        about: "which parts are drawn; without \"cut\" and \"depths\" the incident edge is whole",
    }],
    labels: &[
        LabelKey { key: "reference", about: "the reference edge" },
        LabelKey { key: "incident", about: "the incident edge" },
        LabelKey { key: "n", about: "the reference edge's normal, with planes, where nothing is measured" },
        LabelKey { key: "facing", about: "the incident edge's normal, where nothing is cut or measured" },
        LabelKey { key: "cut", about: "what a plane cuts off" },
        LabelKey { key: "d_1", about: "depth of the first contact along the reference edge" },
        LabelKey { key: "d_2", about: "depth of the second contact" },
        LabelKey { key: "c_1", about: "the first contact, with a depth" },
        LabelKey { key: "c_2", about: "the second contact, with a depth" },
        LabelKey { key: "no-contact", about: "an end above the reference edge" },
    ],
    needs: "a query for the contact",
    fed,
    draw,
};

/// Whether the answer has points of contact, and what the scene wants of them: a circle touches at one point,
/// and no edge is clipped.
fn fed(context: &Context, options: &Options) -> Fed {
    let asked = |part: &&&'static str| NOTES && options.shows("show", part, false);
    match shown(context) {
        Some(found) if asked(&&"cut") && found.cuts.is_empty() => {
            Fed::Without { option: "cut", why: "no plane cuts anything off" }
        }
        Some(_) => Fed::Yes,
        None if ends_told(context).is_empty() => {
            let ever = context.scene.query.algorithm.kinds.contains(&crate::collision::QueryKind::Contact);
            Fed::by_the_answer(false, ever)
        }
        None if !options.shows("show", "depths", true) => Fed::not_here(NOT_CLIPPED),
        None => match PARTS[..3].iter().find(asked) {
            Some(option) => Fed::Without { option, why: NOT_CLIPPED },
            None => Fed::Yes,
        },
    }
}

/// Draws the one point of bodies of which no edge was clipped.
fn single(sketch: &mut Sketch, context: &Context, options: &Options) {
    sketch.since(context.answered());
    for (points, separation, _) in ends_told(context) {
        let over = Point { at: points[1], over: points[0], separation, touches: true };
        let away = points[1] - points[0];
        depth(sketch, &over, "d_1", (Side::B, away), options);
    }
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(found) = shown(context) else {
        single(sketch, context, options);
        return;
    };
    let known = |is_so: fn(&Event) -> bool| context.cue(is_so);
    let faced = known(|event| matches!(event, Event::EdgesFaced { .. }));
    sketch.since(faced);
    let [edges, planes, cut, depths] = PARTS.map(|part| options.shows("show", part, true));
    if planes {
        side_planes(sketch, &found);
    }
    let mut stages = stages(context, &found, faced);
    if !(cut || depths) {
        stages.truncate(1);
    }
    let Some(&(last, left)) = stages.last() else { return };
    if edges {
        // The ends of what is left have names of their own, and the depths stand between the edges.
        incident(sketch.since(last), &found, left);
        sketch.since(faced);
        both_edges(sketch, &found, (left, cut || !depths), options);
        if planes && !depths {
            reference_normal(sketch, &found, options);
            if !cut {
                facing(sketch, &found);
            }
        }
    }
    if cut {
        for ([end, at], (cue, _)) in found.cuts.iter().zip(&stages[1..]) {
            sketch.since(*cue);
            let pen = Pen::highlighted(Role::Muted).width(EDGE);
            sketch.part("cut-off").weight(Weight::Light).line(*at, *end, pen);
            let label = Label::new("cut", "cut off", Anchor::middle(*at, *end), Role::Muted);
            sketch.label(label.rank(Rank::Word).size(Size::Note));
            sketch.part("cut").marker(*end, Marker::Cross, Role::Muted, LARGE_MARKER);
        }
        // What is left has two ends, cut or not: with the last cut, or else with the edge.
        sketch.since(last);
        for end in left {
            sketch.part("left").marker(end, of(found.body.other()), found.body.other().into(), MARKER);
        }
    }
    if depths {
        sketch.since(known(|event| matches!(event, Event::ContactFound { .. })));
        ends(sketch, context, &found, options);
    }
    for pair in stages.windows(2).filter(|_| edges) {
        if let [(Some(from), there), (Some(to), _)] = *pair {
            sketch.passing([from, to], |sketch| incident(sketch, &found, there));
        }
    }
}

/// What there is of the incident edge when the edges are known, and after each cut, with the cue of that.
fn stages(context: &Context, found: &Clipping, faced: Option<Cue>) -> Vec<(Option<Cue>, [DVec2; 2])> {
    let mut stages = vec![(faced, found.incident)];
    for &[end, at] in &found.cuts {
        let is_it =
            |event: &Event| matches!(event, Event::EdgeCut { end: told, .. } if told - found.inward == end);
        let left = stages.last().map_or(found.incident, |(_, left)| *left);
        stages.push((context.cue(is_it), left.map(|p| if p == end { at } else { p })));
    }
    stages
}

/// The marker of a body's points.
fn of(side: Side) -> Marker {
    if side == Side::A { Marker::Disc } else { Marker::Square }
}

/// Draws the incident edge, or what is left of it.
fn incident(sketch: &mut Sketch, found: &Clipping, [from, to]: [DVec2; 2]) {
    let pen = Pen::highlighted(found.body.other().into()).width(EDGE);
    sketch.part("incident").line(from, to, pen);
}

/// Draws the lines through the reference edge’s ends, square to it: they cut off what is beyond them.
fn side_planes(sketch: &mut Sketch, found: &Clipping) {
    let from = found.reference[0];
    let heights = found.incident.map(|end| found.normal.dot(end - from));
    let past = sketch.px(PAST);
    let low = heights[0].min(heights[1]).min(0.0) - past;
    let high = heights[0].max(heights[1]).max(0.0) + past;
    for end in found.reference {
        let (foot, top) = (end + found.normal * low, end + found.normal * high);
        sketch.part("plane").weight(Weight::Light).line(foot, top, Pen::construction());
    }
}

/// Draws the reference edge, and names both where they are to be named: the incident edge beside what is
/// `left` of it.
fn both_edges(
    sketch: &mut Sketch,
    found: &Clipping,
    (left, is_named): ([DVec2; 2], bool),
    options: &Options,
) {
    let role = options.role(Role::Now);
    let [p, q] = found.reference;
    let (beside, of_core) = (Anchor::middle(left[0], left[1]), found.reach != DVec2::ZERO);
    // One word: beside a slanted line a longer one stands farther off.
    let word = Label::new(
        "incident",
        if of_core { "incident, of the core" } else { "incident" },
        beside,
        found.body.other().into(),
    );
    if is_named {
        sketch.label(word.rank(Rank::Word).size(Size::Note));
    }
    sketch.part("reference").line(p, q, Pen::highlighted(role).width(EDGE));
    let word = Label::new("reference", "reference", Anchor::middle(p, q), role);
    if is_named {
        sketch.label(word.rank(Rank::Word).size(Size::Note));
    }
}

/// Draws the outward normal of the reference edge, beside its name.
fn reference_normal(sketch: &mut Sketch, found: &Clipping, options: &Options) {
    let [p, q] = found.reference;
    let foot = p + (q - p) * ASIDE;
    normal(sketch, ("reference-normal", foot, found.normal), ("n", "$n$", options.role(Role::Now)));
}

/// Draws the outward normal of the incident edge: of all the edges of its body, it has the one that is most
/// against n.
fn facing(sketch: &mut Sketch, found: &Clipping) {
    let [p, q] = found.incident;
    let Some(across) = perp(q - p).try_normalize() else { return };
    let out = if across.dot(found.normal) < 0.0 { across } else { -across };
    let words = ("facing", "its normal", found.body.other().into());
    normal(sketch, ("incident-normal", 0.5 * (p + q), out), words);
}

/// Draws the outward unit normal of an edge from a point of it, as long as can be read.
fn normal(
    sketch: &mut Sketch,
    (part, foot, out): (&'static str, DVec2, DVec2),
    (key, text, role): (&'static str, &'static str, Role),
) {
    let [least, most] = READABLE.map(|px| sketch.px(px));
    let tip = foot + out * 1.0_f64.max(least).min(most);
    sketch.part(part).arrow(foot, tip, Pen::vector(role));
    let label = Label::new(key, text, Anchor::tip(foot, tip), role);
    sketch.label(label.rank(Rank::Word).size(Size::Note));
}

/// Draws the ends of what is left, each contact with its depth.
fn ends(sketch: &mut Sketch, context: &Context, found: &Clipping, options: &Options) {
    let known = |point: &Point| {
        context.cue(|event| match event {
            Event::ContactFound { points, .. } => points.contains(&point.at) && points.contains(&point.over),
            _ => false,
        })
    };
    let other = found.body.other();
    let touching = found.points.iter().filter(|point| point.touches);
    let inward = left_of(found.reference[0], found.reference[1]);
    let [from, to] = found.reference;
    // Contacts may lie as near each other as the vertices of a fine outline.
    let spots: Vec<DVec2> = touching.clone().map(|point| point.at).collect();
    sketch.detail(&spots);
    for (point, key) in touching.zip(["d_1", "d_2"]) {
        sketch.since(known(point));
        let far = if point.over.distance_squared(from) > point.over.distance_squared(to) { from } else { to };
        sketch.part("right-angle").right_angle(point.over, far - point.over, point.at - point.over);
        from_the_core(sketch, found, point);
        depth(sketch, point, key, (other, inward), options);
        let (key, number) = if key == "d_1" { ("c_1", 1) } else { ("c_2", 2) };
        let label = Label::new(key, format!("contact {number}"), Anchor::point(point.at), other.into());
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    for point in found.points.iter().filter(|point| !point.touches) {
        sketch.since(known(point));
        let hollow = if other == Side::A { Marker::HollowDisc } else { Marker::HollowSquare };
        from_the_core(sketch, found, point);
        sketch.part("above").marker(point.at, hollow, other.into(), LARGE_MARKER);
        let label = Label::new("no-contact", "no contact", Anchor::point(point.at), Role::Muted);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// Joins a point to the end of the core's edge that it is the surface of, where that is what is drawn.
fn from_the_core(sketch: &mut Sketch, found: &Clipping, point: &Point) {
    if found.reach != DVec2::ZERO {
        let end = point.at + found.reach;
        sketch.part("reach").weight(Weight::Light).line(end, point.at, Pen::construction());
    }
}

/// Draws a contact of a body with its depth; where that is 0 its label stands in a direction.
fn depth(
    sketch: &mut Sketch,
    point: &Point,
    key: &'static str,
    (body, toward): (Side, DVec2),
    options: &Options,
) {
    let role = options.role(Role::Translation);
    sketch.detail(&[point.over, point.at]);
    sketch.part("depth").bar(point.over, point.at, 0.0, Pen::dimension(role).width(1.75));
    // A marker is as wide as a short depth is long, and would hide it.
    let is_short = sketch.on_page(point.over.distance(point.at)) < sketch.fitted(2.0 * MARKER);
    let size = if is_short { SMALL_MARKER } else { MARKER };
    sketch.part("contact-point").marker(point.at, of(body), body.into(), size);
    let anchor = if point.at == point.over {
        Anchor::point_toward(point.at, toward)
    } else {
        Anchor::middle(point.over, point.at)
    };
    sketch.label(Label::new(key, format!("${key} = {}$", number(-point.separation)), anchor, role));
}

#[cfg(test)]
mod tests;
