//! Points of contact by clipping: the reference edge with its normal n, the planes through its ends, what
//! they leave of the incident edge, and at each end of that the depth below the reference edge.
//!
//! What a plane cuts off is grey and crossed out. An end above the reference edge, no contact, is hollow.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, LARGE_MARKER, Label, MARKER, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch, Weight, left_of,
};
use crate::figure::text::number;
use crate::geometry::{DVec2, Side, perp};
use crate::scene::NOTES;
use crate::trace::{Event, phrase};

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

/// What was clipped, in the world, at the bodies' surfaces.
struct Clipping {
    /// The body of the reference edge.
    body: Side,
    /// The reference edge, counter-clockwise.
    reference: [DVec2; 2],
    /// Its outward unit normal.
    normal: DVec2,
    /// The incident edge.
    incident: [DVec2; 2],
    /// Each end that was cut off, and where the edge ends instead.
    cuts: Vec<[DVec2; 2]>,
    /// Each end of what is left.
    points: Vec<Point>,
}

/// An end of what is left of the incident edge.
struct Point {
    /// The point on the incident body.
    at: DVec2,
    /// The point of the reference edge's line over it.
    over: DVec2,
    /// Minus the depth.
    separation: f64,
    /// Whether it is a contact.
    touches: bool,
}

/// What the algorithm told of the panel's moment; `None` where nothing was clipped.
fn shown(context: &Context) -> Option<Clipping> {
    let run = context.run();
    let radius = |side: Side| context.body(side).map_or(0.0, |body| body.shape.radius);
    let mut found = run.find_told(|event| match *event {
        Event::EdgesFaced { body, from, to, normal, ends, .. } => {
            let (out, inward) = (normal * radius(body), normal * radius(body.other()));
            let (reference, incident) = ([from + out, to + out], ends.map(|end| end - inward));
            Some(Clipping { body, reference, normal, incident, cuts: Vec::new(), points: Vec::new() })
        }
        _ => None,
    })?;
    let other = found.body.other();
    let inward = found.normal * radius(other);
    found.cuts = run
        .told(|event| match *event {
            Event::EdgeCut { end, at, .. } => Some([end - inward, at - inward]),
            _ => None,
        })
        .collect();
    found.points = ends_told(context)
        .into_iter()
        .map(|(points, separation, touches)| {
            let [over, at] = if other == Side::B { points } else { [points[1], points[0]] };
            Point { at, over, separation, touches }
        })
        .collect();
    Some(found)
}

/// The points of A and B at each end, their separation, and whether it is a contact.
fn ends_told(context: &Context) -> Vec<([DVec2; 2], f64, bool)> {
    let told = |event: &Event| match *event {
        Event::ContactFound { points, separation, touches, .. } => Some((points, separation, touches)),
        _ => None,
    };
    context.run().told(told).collect()
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
    sketch.since(known(|event| matches!(event, Event::EdgesFaced { .. })));
    let [edges, planes, cut, depths] = PARTS.map(|part| options.shows("show", part, true));
    if planes {
        side_planes(sketch, &found);
    }
    if edges {
        let left = if cut || depths { left(&found) } else { found.incident };
        // The ends of what is left have names of their own, and the depths stand between the edges.
        both_edges(sketch, &found, (left, cut || !depths), options);
        if planes && !depths {
            reference_normal(sketch, &found, options);
            if !cut {
                facing(sketch, &found);
            }
        }
    }
    if cut {
        let faced = known(|event| matches!(event, Event::EdgesFaced { .. }));
        sketch.since(known(|event| matches!(event, Event::EdgeCut { .. })).or(faced));
        for [end, at] in &found.cuts {
            let pen = Pen::highlighted(Role::Muted).width(EDGE);
            sketch.part("cut-off").weight(Weight::Light).line(*at, *end, pen);
            let label = Label::new("cut", "cut off", Anchor::middle(*at, *end), Role::Muted);
            sketch.label(label.rank(Rank::Word).size(Size::Note));
            sketch.part("cut").marker(*end, Marker::Cross, Role::Muted, LARGE_MARKER);
        }
        // What is left has two ends, cut or not.
        for end in left(&found) {
            sketch.part("left").marker(end, of(found.body.other()), found.body.other().into(), MARKER);
        }
    }
    if depths {
        sketch.since(known(|event| matches!(event, Event::ContactFound { .. })));
        ends(sketch, context, &found, options);
    }
}

/// The marker of a body's points.
fn of(side: Side) -> Marker {
    if side == Side::A { Marker::Disc } else { Marker::Square }
}

/// The incident edge without what was cut off.
fn left(found: &Clipping) -> [DVec2; 2] {
    found.incident.map(|end| found.cuts.iter().find(|[cut, _]| *cut == end).map_or(end, |[_, at]| *at))
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

/// Draws both edges; of the incident edge what is `left`, named or not.
fn both_edges(
    sketch: &mut Sketch,
    found: &Clipping,
    (left, is_named): ([DVec2; 2], bool),
    options: &Options,
) {
    let role = options.role(Role::Now);
    let [p, q] = found.reference;
    sketch.part("incident").line(left[0], left[1], Pen::highlighted(found.body.other().into()).width(EDGE));
    let beside = Anchor::middle(left[0], left[1]);
    // One word: beside a slanted line a longer one stands farther off.
    let word = Label::new("incident", "incident", beside, found.body.other().into());
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
        depth(sketch, point, key, (other, inward), options);
        let (key, number) = if key == "d_1" { ("c_1", 1) } else { ("c_2", 2) };
        let label = Label::new(key, format!("contact {number}"), Anchor::point(point.at), other.into());
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    for point in found.points.iter().filter(|point| !point.touches) {
        sketch.since(known(point));
        let hollow = if other == Side::A { Marker::HollowDisc } else { Marker::HollowSquare };
        sketch.part("above").marker(point.at, hollow, other.into(), LARGE_MARKER);
        let label = Label::new("no-contact", "no contact", Anchor::point(point.at), Role::Muted);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
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
