//! The bodies at the panel's moment, filled and named; with `centers`, these marked.
//!
//! Bodies that the query is not about are context: muted, under the others, and named where they are in view.
//! Those that would make the pair small do not count for the fit of the view.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Outline, Pen, Rank, Size, Sketch, Wash, Weight};
use crate::geometry::{DVec2, Side};
use crate::trace::phrase;

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, part};
use super::{ghosts, held};

/// Opacity of the fill of context.
const FAINT: f64 = 0.08;

/// How much larger than the pair on its whole way a view may become for a body of the context. At 1 a body
/// beside the pair is cut off; at 4 the pair is a quarter of the panel for the sake of something else.
const GROWTH: f64 = 3.0;

pub(super) const LAYER: Layer = Layer {
    name: "shapes",
    in_words: phrase(["shapes", "Körper", "corps", "cuerpos"]),
    about: "the bodies at the panel's moment, with their names",
    shows: Shows::World,
    tells: Tells::Given,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "all of the query's", about: "which bodies" },
        OptionSpec {
            name: "centers",
            takes: Takes::Flag,
            default: "false",
            about: "marks the bodies' origins, and of a circle its centre",
        },
        OptionSpec {
            name: "context",
            takes: Takes::Flag,
            default: "true, but false with `of`",
            about: "the bodies that the query is not about, muted",
        },
        OptionSpec {
            name: "dotted",
            takes: Takes::Flag,
            default: "false",
            about: "those as dotted outlines in the colour of the first body: how it could be instead",
        },
        OptionSpec {
            name: "text",
            takes: Takes::Lines,
            default: "its name",
            about: "lines of the label of each body in this panel",
        },
    ],
    labels: &[
        LabelKey { key: "A", about: "name of the first body" },
        LabelKey { key: "B", about: "name of the second body" },
        LabelKey { key: "a", about: "centre of the first body, with centers" },
        LabelKey { key: "b", about: "centre of the second body, with centers" },
        LabelKey { key: "overlap", about: "where two bodies overlap; only where a scene gives it a text" },
        LabelKey { key: "context", about: "name of a body that the query is not about" },
    ],
    needs: "nothing",
    fed: |_, _| Fed::Yes,
    draw,
};

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let sides = options.of(&context.sides());
    let centers = options.flag("centers", false);
    if shows_context(&LAYER, options) {
        bystanders(sketch, context, options.flag("dotted", false));
    }
    let before = sketch.regions().len();
    for &side in &sides {
        body(sketch, context, options, side);
    }
    for &side in &sides {
        name(sketch, context, options, side, centers);
    }
    // Elsewhere it is no thing that a label could seem to name.
    let names = context.scene.labels.iter().any(|(key, own)| key.value == "overlap" && own.text.is_some());
    let regions = sketch.regions().get(before..).filter(|_| names).unwrap_or_default().to_vec();
    for region in &regions {
        let label = Label::new("overlap", "", Anchor::inside(region), Role::Ink);
        sketch.part("overlap").label(label.rank(Rank::Word).size(Size::Note));
    }
}

/// Whether a layer is this one and shows the bodies that the query is not about.
pub(crate) fn shows_context(layer: &Layer, options: &Options) -> bool {
    layer.name == LAYER.name && options.flag("context", !options.gives("of"))
}

/// Draws a body.
fn body(sketch: &mut Sketch, context: &Context, options: &Options, side: Side) {
    let Some(outline) = context.outline(side, context.time) else { return };
    let role = options.role(side.into());
    sketch.part(part("body", side)).body(side, &outline, role);
    held::body(sketch, context, side);
}

/// Names a body inside it; with `center`, marks its own.
fn name(sketch: &mut Sketch, context: &Context, options: &Options, side: Side, center: bool) {
    let Some(outline) = context.outline(side, context.time) else { return };
    let role = options.role(side.into());
    let key = if side == Side::A { "A" } else { "B" };
    let pose = context.pose(side, context.time).filter(|_| center);
    let label = Label::new(key, context.name(side), Anchor::inside(&outline), role).rank(Rank::Name);
    sketch.part(part("body", side)).label(match options.words("text") {
        Some(lines) => label.given(lines).size(Size::Note),
        None => label.size(Size::Name),
    });
    if let Some((pose, body)) = pose.zip(context.body(side)) {
        let position = pose.point(body.center());
        let marker = if side == Side::A { Marker::Disc } else { Marker::Square };
        let key = if side == Side::A { "a" } else { "b" };
        sketch.part(part("center", side)).marker(position, marker, role, MARKER);
        sketch.label(Label::new(key, "", Anchor::point(position), role).rank(Rank::Point));
    }
}

/// Draws the bodies that the query is not about; dotted, as what the first body could be.
fn bystanders(sketch: &mut Sketch, context: &Context, dotted: bool) {
    let role = if dotted { Role::A } else { Role::Muted };
    let pair = extent_of_the_pair(context);
    for (i, (index, name, outline)) in context.bystanders().enumerate() {
        let Some(own) = extent(context, &outline) else { continue };
        let (lo, hi) = pair.map_or(own, |pair| (pair.0.min(own.0), pair.1.max(own.1)));
        let near = pair.is_none_or(|(a, b)| (hi - lo).max_element() <= GROWTH * (b - a).max_element());
        let (from, to) = sketch.visible();
        let seen = own.0.cmple(to).all() && own.1.cmpge(from).all();
        if !seen && !near {
            continue;
        }
        let weight = if near { Weight::Light } else { Weight::Background };
        let (wash, pen) = if dotted {
            (Some(Wash::faint(role, ghosts::FAINT)), Pen::ghost(role))
        } else {
            (Some(Wash::faint(role, FAINT)), Pen::outline(role).width(1.0))
        };
        sketch.part(format!("context-{}", i + 1)).weight(weight);
        sketch.area(&outline, wash, Some(pen));
        held::bystander(sketch, context, index);
        if seen {
            let anchor = Anchor::inside(&outline);
            sketch.label(Label::new("context", name, anchor, role).rank(Rank::Word).size(Size::Note));
        }
    }
}

/// The smallest and largest coordinates of an outline, in the panel's space; `None` where it has no point.
fn extent(context: &Context, outline: &Outline) -> Option<(DVec2, DVec2)> {
    let points = outline.sampled().into_iter().map(|p| context.in_space(p));
    points.map(|p| (p, p)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// The smallest and largest coordinates of the query's bodies at the start, at the panel's moment and at the
/// end, in the panel's space.
fn extent_of_the_pair(context: &Context) -> Option<(DVec2, DVec2)> {
    let times = [0.0, context.time, 1.0].into_iter();
    let outlines = times.flat_map(|t| context.sides().into_iter().filter_map(move |s| context.outline(s, t)));
    outlines.filter_map(|o| extent(context, &o)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}
