//! The edges of B and the mirrored edges of A as vectors from one point, sorted by direction: the order in
//! which the merge takes them into B ⊖ A, numbered by it.

use std::f64::consts::TAU;

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::cue::Cue;
use crate::figure::sketch::{
    Anchor, Label, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch, Weight, angle_of, on_circle,
};
use crate::geometry::{DVec2, Side};
use crate::trace::{Event, phrase};

use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of};

/// Opacity of an edge that is not taken yet.
const LATER: f64 = 0.35;

/// Width of a cased arrow, page pixels: as an outline's, at which its gap is seen.
const CASED: f64 = 2.25;

/// Radius of the arc that shows the order, in parts of the shortest edge, and at most, page pixels.
const RING: f64 = 0.55;
const WIDEST: f64 = 44.0;

pub(super) const LAYER: Layer = Layer {
    name: "edge-fan",
    in_words: phrase([
        "edge-fan",
        "Kanten nach ihrer Richtung",
        "arêtes par direction",
        "aristas por dirección",
    ]),
    about: "edges of B and mirrored edges of A as vectors from O, in the order of their directions",
    shows: Shows::Configuration,
    tells: Tells::Built,
    options: &[OptionSpec {
        name: "step",
        takes: Takes::Number,
        default: "all",
        about: "up to which edge they are taken, from 1; later ones are faint",
    }],
    labels: &[
        LabelKey { key: "step", about: "the edge's number in the order of directions" },
        LabelKey {
            key: "order",
            about: "at the arc: that the numbers are the order in which edges are taken",
        },
    ],
    needs: "the algorithm \"merge\" and bodies with edges",
    fed: |context, _| Fed::by_the_scene(!merged(context).is_empty()),
    draw,
};

/// A choice that the merge made.
#[derive(Clone, Copy)]
pub(super) struct Merged {
    /// The body whose edge was taken.
    pub(super) taken: Side,
    /// The vertex of B ⊖ A where it begins.
    pub(super) at: DVec2,
    /// The edge as a vector.
    pub(super) edge: DVec2,
    /// The other body's next edge as a vector, where it has more.
    pub(super) other: Option<DVec2>,
    /// With what it comes.
    pub(super) cue: Cue,
}

/// The edges in the order in which the algorithm took them, at the panel's moment; none for another one.
pub(super) fn merged(context: &Context) -> Vec<Merged> {
    let Some(run) = context.difference_at(context.difference_time()) else { return Vec::new() };
    let cues = run.cues(|event| matches!(event, Event::EdgesMerged { .. }).then_some(()));
    let told = run.told(|event| match *event {
        Event::EdgesMerged { taken, at, edge, other } => Some((taken, at, edge, other)),
        _ => None,
    });
    told.zip(cues)
        .map(|((taken, at, edge, other), (cue, ()))| Merged { taken, at, edge, other, cue })
        .collect()
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let step = options.number("step").unwrap_or(f64::INFINITY);
    let all = merged(context);
    for (k, &Merged { taken, edge, cue, .. }) in (1..).zip(&all) {
        let role = Role::from(taken);
        let opacity = if number_of(k) <= step { 1.0 } else { LATER };
        let pen = Pen::vector(role).opacity(opacity);
        sketch.since((opacity == 1.0).then_some(cue));
        sketch.part(super::part("edge", taken));
        // B's are cased as in B ⊖ A, for those who don't see the colour.
        match taken {
            Side::A => sketch.arrow(DVec2::ZERO, edge, pen),
            Side::B => sketch.cased_arrow(DVec2::ZERO, edge, pen.width(CASED)),
        };
        let label = Label::new("step", k.to_string(), Anchor::tip(DVec2::ZERO, edge), role);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    // Over the shafts, which run into each other there.
    sketch.since(None).part("hub").marker(DVec2::ZERO, Marker::Disc, Role::Ink, SMALL_MARKER);
    order(sketch, &all);
}

/// Draws an arc arrow about O from the direction of the first edge to that of the last: the order in which
/// they are taken.
fn order(sketch: &mut Sketch, all: &[Merged]) {
    let ([first, ..], [.., last]) = (all, all) else { return };
    let (start, end) = (angle_of(first.edge), angle_of(last.edge));
    let sweep = (end - start).rem_euclid(TAU);
    let shortest = all.iter().map(|m| m.edge.length()).fold(f64::INFINITY, f64::min);
    let radius = (RING * shortest).min(sketch.px(WIDEST));
    sketch.since(last.cue);
    if sweep > 0.0 {
        sketch.part("order").weight(Weight::Light);
        sketch.arc_arrow(DVec2::ZERO, radius, start, sweep, Pen::dimension(Role::Ink));
        sketch.marker(on_circle(DVec2::ZERO, radius, start), Marker::Disc, Role::Ink, 0.8 * SMALL_MARKER);
        let arc = Anchor::Arc { center: DVec2::ZERO, radius, start, sweep };
        let label = Label::new("order", "order", arc, Role::Ink);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
}
