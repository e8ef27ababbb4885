//! B ⊖ A being built: the edges taken so far, numbered, and at the vertex that the merge has come to the next
//! edge of either body, of which it takes the one that turns less.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, MARKER, Marker, Pen, Rank, SMALL_MARKER, Size, Sketch};
use crate::geometry::Side;

use super::difference::draw_edge;
use super::edge_fan::{Merged, merged};
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, number_of, part};

/// Opacity of the edge that is not taken.
const REJECTED: f64 = 0.55;

pub(super) const LAYER: Layer = Layer {
    name: "merging",
    about: "B ⊖ A being built: the edges taken so far, and the next edge of either body",
    shows: Shows::Configuration,
    options: &[OptionSpec {
        name: "step",
        takes: Takes::Number,
        default: "the last",
        about: "which edge is taken, from 1",
    }],
    labels: &[
        LabelKey { key: "step", about: "the edge's number in the order of directions" },
        LabelKey { key: "e.A", about: "the next edge of A, mirrored" },
        LabelKey { key: "e.B", about: "the next edge of B" },
        LabelKey { key: "less", about: "beside the edge that is taken" },
    ],
    needs: "the algorithm \"merge\" and bodies with edges, and no more edges than they have",
    fed: |context, options| Fed::by_the_scene(shown(context, options).is_some()),
    draw,
};

/// The edges up to the one that the scene wants, else all.
fn shown(context: &Context, options: &Options) -> Option<Vec<Merged>> {
    let mut all = merged(context);
    if let Some(step) = options.number("step") {
        let count = (1..=all.len()).find(|&k| number_of(k) == step)?;
        all.truncate(count);
    }
    (!all.is_empty()).then_some(all)
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(all) = shown(context, options) else { return };
    let whole = !options.gives("step");
    let before = if whole { all.len() } else { all.len() - 1 };
    for (k, edge) in (1..).zip(&all[..before]) {
        let (from, to) = (edge.at, edge.at + edge.edge);
        let role = Role::from(edge.taken);
        sketch.part(part("taken", edge.taken));
        draw_edge(sketch, edge.taken, (from, to), Pen::outline(role));
        let label = Label::new("step", k.to_string(), Anchor::middle(from, to), role);
        sketch.label(label.rank(Rank::Word).size(Size::Small));
    }
    for edge in &all[..before] {
        sketch.part("vertices").marker(edge.at, Marker::Diamond, Role::Difference, SMALL_MARKER);
    }
    if let Some(next) = all.last().filter(|_| !whole) {
        choice(sketch, context, next);
    }
}

/// Draws the next edge of either body, and which is taken.
fn choice(sketch: &mut Sketch, context: &Context, next: &Merged) {
    let own = next.at + next.edge;
    if let Some(other) = next.other {
        let side = next.taken.other();
        let pen = Pen::vector(side.into()).opacity(REJECTED);
        sketch.part("rejected").arrow(next.at, next.at + other, pen);
        let anchor = Anchor::tip(next.at, next.at + other);
        sketch.label(Label::new(key(side), name(context, side), anchor, side.into()));
    }
    let role = Role::from(next.taken);
    sketch.part("chosen").arrow(next.at, own, Pen::highlighted(role));
    sketch.label(Label::new(key(next.taken), name(context, next.taken), Anchor::tip(next.at, own), role));
    if next.other.is_some() {
        let label = Label::new("less", "turns less", Anchor::middle(next.at, own), role);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    sketch.part("reached").marker(next.at, Marker::Diamond, Role::Now, MARKER);
}

/// The key of the label of a body's next edge.
fn key(side: Side) -> &'static str {
    if side == Side::A { "e.A" } else { "e.B" }
}

/// The name of a body's next edge as it runs in B ⊖ A: A's is mirrored.
fn name(context: &Context, side: Side) -> String {
    let edge = context.named(side).below("e");
    if side == Side::A { format!("$-{edge}$") } else { format!("${edge}$") }
}
