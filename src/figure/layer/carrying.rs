//! The edges that carry a witness point.

use crate::collision::Separation;
use crate::figure::context::Context;
use crate::figure::sketch::Sketch;
use crate::geometry::{DVec2, Feature, Side};

/// An edge that carries a witness point: whose it is, that point, and from end to end, moved out by the
/// radius, in the world.
pub(super) type Carrying = (Side, DVec2, [DVec2; 2]);

/// The edges that carry a witness point.
pub(super) fn edges(context: &Context, time: f64, answer: &Separation) -> Vec<Carrying> {
    let edge = |(side, feature, point): (Side, Feature, DVec2)| {
        let (Feature::Edge(i), Some(body), Some(pose)) =
            (feature, context.body(side), context.pose(side, time))
        else {
            return None;
        };
        let outward = if side == Side::A { answer.normal } else { -answer.normal };
        let ends = body.shape.edge_ends(i)?;
        let ends =
            ends.map(|k| body.shape.vertices.get(k).map(|&v| pose.point(v) + outward * body.shape.radius));
        Some((side, point, [ends[0]?, ends[1]?]))
    };
    let [a, b] = answer.features;
    let [p, q] = answer.points;
    [(Side::A, a, p), (Side::B, b, q)].into_iter().filter_map(edge).collect()
}

/// The edges with a witness point that are drawn: of bodies that stand as in the panel, or beside ghosts.
pub(super) fn drawn(sketch: &Sketch, context: &Context, time: f64, answer: &Separation) -> Vec<Carrying> {
    let mut all = edges(context, time, answer);
    let stands = |side| context.pose(side, time) == context.pose(side, context.time);
    all.retain(|&(side, ..)| stands(side) || sketch.has_layer(super::ghosts::LAYER.name));
    all
}
