//! The supporting vertices of the nearest edge, all of them: two where the bodies are exactly aligned.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, LARGE_MARKER, Label, Marker, Pen, Rank, Sketch, Weight};
use crate::geometry::{DVec2, Side};
use crate::scene::Space;
use crate::trace::{Event, SupportVertex};

use super::difference::difference;
use super::{Fed, LabelKey, Layer, Options, Shows};

/// How much a direction that is the normal's may differ from it: both are unit vectors rounded a few times. A
/// hundred million times more is still a thousandth of a degree.
const SAME_DIRECTION: f64 = 1e-12;

/// The case in which there is no nearest edge.
const NO_EDGE: &str = "the bodies are closest at a vertex of each, so that no edge faces the other body";

pub(super) const LAYER: Layer = Layer {
    name: "support",
    about: "all supporting vertices of the nearest edge; in configuration space, where its two parts join",
    shows: Shows::Anywhere,
    options: &[],
    labels: &[
        LabelKey { key: "a_1", about: "first supporting vertex, on A" },
        LabelKey { key: "a_2", about: "second supporting vertex, on A" },
        LabelKey { key: "b_1", about: "first supporting vertex, on B" },
        LabelKey { key: "b_2", about: "second supporting vertex, on B" },
    ],
    needs: "two convex bodies with edges",
    fed,
    draw,
};

/// Two vertices that face each other, or nothing at all where the bodies' distance is not measured from an
/// edge, leave nothing to mark.
fn fed(context: &Context, _: &Options) -> Fed {
    let edges = |side| context.body(side).is_some_and(|body| body.shape.core.len() > 1);
    if context.separation_at(context.time).is_none() || !context.sides().into_iter().any(edges) {
        return Fed::Never;
    }
    if supports(context).is_some() { Fed::Yes } else { Fed::NotHere(NO_EDGE) }
}

/// The body and its vertices that support the nearest edge: a tie first, then B's.
fn supports(context: &Context) -> Option<(Side, Vec<SupportVertex>)> {
    let run = context.separation_at(context.time)?;
    let normal = run.separation()?.normal;
    let found = |count: usize, side: Side| {
        let toward = if side == Side::B { -normal } else { normal };
        run.find_told(|event| match event {
            Event::SupportFound { body, direction, vertices }
                if *body == side
                    && vertices.len() == count
                    && direction.distance(*toward) < SAME_DIRECTION =>
            {
                Some((side, vertices.clone()))
            }
            _ => None,
        })
    };
    found(2, Side::B)
        .or_else(|| found(2, Side::A))
        .or_else(|| found(1, Side::B))
        .or_else(|| found(1, Side::A))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let role = options.role(Role::Now);
    if *context.space == Space::Configuration {
        if let Some(joint) = difference(context, context.time).and_then(|found| found.joint()) {
            sketch.since(context.separation_at(context.time).map(|run| run.nearest()));
            let joint = joint + context.estimate();
            sketch.part("support").marker(joint, Marker::Diamond, role, LARGE_MARKER);
        }
        return;
    }
    let Some((side, vertices)) = supports(context) else { return };
    sketch.since(context.separation_at(context.time).map(|run| run.nearest()));
    if let [p, q] = vertices.as_slice() {
        sketch.part("support").weight(Weight::Light).line(p.point, q.point, Pen::highlighted(role));
    }
    let middle = match vertices.as_slice() {
        [p, q] => 0.5 * (p.point + q.point),
        _ => vertices.first().map_or(DVec2::ZERO, |v| v.point),
    };
    let keys = if side == Side::A { ["a_1", "a_2"] } else { ["b_1", "b_2"] };
    for ((vertex, key), number) in vertices.iter().zip(keys).zip(1..) {
        let text = format!("${}$", context.named(side).point(number));
        let marker = if side == Side::A { Marker::HollowDisc } else { Marker::HollowSquare };
        sketch.part("support").marker(vertex.point, marker, role, LARGE_MARKER);
        let anchor = Anchor::point_toward(vertex.point, vertex.point - middle);
        sketch.label(Label::new(key, text, anchor, role).rank(Rank::Point));
    }
}
