//! Which edges of B ⊖ A the ray along the relative velocity can enter through: those that face it, v · n < 0.

use crate::figure::context::Context;
use crate::figure::difference::Edge;
use crate::geometry::{DVec2, Feature, Side};
use crate::trace::{Culling, Event};

/// The velocity `v_A` − `v_B` along which there is a ray: the bodies move relative to each other and don't
/// turn, and the question is for their first contact.
pub(super) fn velocity_along(context: &Context) -> Option<DVec2> {
    let v = context.closing_velocity();
    (context.asks_for_a_hit() && !context.turns() && v != DVec2::ZERO).then_some(v)
}

/// Which edges of B ⊖ A the ray can't enter through, v · n ≥ 0: those that the algorithm says it did not test
/// for that, else by their normals. None where there is no ray.
pub(super) fn faces_away(context: &Context) -> impl Fn(&Edge) -> bool + use<> {
    let skipped = |event: &Event| match *event {
        Event::RayClipped { source: (side, Feature::Edge(index)), from, to, outcome, .. } => {
            (outcome == Culling::BackFacing).then_some((side, index, to - from))
        }
        _ => None,
    };
    let (ray, told) = (velocity_along(context), context.run().told(skipped).collect::<Vec<_>>());
    move |edge| {
        // A segment's two edges, there and back, bear one number.
        let is_told = |&(side, index, along): &(Side, usize, DVec2)| {
            (side, index) == (edge.source, edge.index) && along.dot(edge.to - edge.from) > 0.0
        };
        let by_normal = |v: DVec2| edge.normal.dot(v) >= 0.0;
        ray.is_some_and(|v| if told.is_empty() { by_normal(v) } else { told.iter().any(is_told) })
    }
}
