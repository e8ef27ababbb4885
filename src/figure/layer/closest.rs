//! From the origin to the nearest point of B ⊖ A: the separation as a vector, `p_B` − `p_A` = s n. At a step
//! of a sweep, where the estimate moves and not the difference, from the estimate.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Pen, Sketch};
use crate::figure::text::distance_or_depth;
use crate::geometry::DVec2;
use crate::trace::Event;

use super::{Fed, LabelKey, Layer, Options, Shows};

pub(super) const LAYER: Layer = Layer {
    name: "closest",
    about: "from the origin, or a sweep's estimate, to the nearest point of B ⊖ A",
    shows: Shows::Configuration,
    options: &[],
    labels: &[LabelKey { key: "d", about: "distance or depth" }],
    needs: "two convex bodies",
    fed: |context, _| Fed::by_the_scene(nearest(context).is_some()),
    draw,
};

/// From the origin at the panel's moment to the nearest point of B ⊖ A then: the last, so the best, candidate
/// of the algorithm; for round bodies, whose radius candidates leave out, the answer's. And its label.
fn nearest(context: &Context) -> Option<(DVec2, String)> {
    let run = context.separation_at(context.time)?;
    let answer = *run.separation()?;
    let candidate = run.events().filter(|e| matches!(e, Event::CandidateImproved { .. })).last();
    if let Some(candidate) = candidate {
        run.tells(|event| std::ptr::eq(event, candidate));
    }
    let foot = match candidate {
        Some(Event::CandidateImproved { foot, distance, .. }) if *distance == answer.separation => *foot,
        _ => answer.normal * answer.separation,
    };
    Some((foot, distance_or_depth(&answer)))
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some((foot, text)) = nearest(context) else { return };
    let role = options.role(Role::Translation);
    let from = context.estimate();
    sketch.part("closest").double_arrow(from, from + foot, Pen::vector(role));
    sketch.label(Label::new("d", text, Anchor::middle(from, from + foot), role));
}
