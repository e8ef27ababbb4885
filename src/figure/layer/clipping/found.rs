//! What the algorithm told of a clipped edge, where the layer draws it.

use crate::figure::context::Context;
use crate::geometry::{DVec2, Side};
use crate::trace::Event;

/// The sine of the angle between two edges, up to which they are level with each other: a degree.
const LEVEL: f64 = 0.017;
/// What was clipped, in the world, at the bodies' surfaces.
pub(super) struct Clipping {
    /// The body of the reference edge.
    pub(super) body: Side,
    /// The reference edge, counter-clockwise.
    pub(super) reference: [DVec2; 2],
    /// Its outward unit normal.
    pub(super) normal: DVec2,
    /// The incident edge.
    pub(super) incident: [DVec2; 2],
    /// From a point to the core's edge, where that is what is drawn of the incident body; 0 where it is its
    /// surface's.
    pub(super) reach: DVec2,
    /// From the incident edge, as it is drawn, to that of its core, which is what is clipped.
    pub(super) inward: DVec2,
    /// Each end that was cut off, and where the edge ends instead.
    pub(super) cuts: Vec<[DVec2; 2]>,
    /// Each end of what is left.
    pub(super) points: Vec<Point>,
}

/// An end of what is left of the incident edge.
pub(super) struct Point {
    /// The point on the incident body.
    pub(super) at: DVec2,
    /// The point of the reference edge's line over it.
    pub(super) over: DVec2,
    /// Minus the depth.
    pub(super) separation: f64,
    /// Whether it is a contact.
    pub(super) touches: bool,
}

/// What the algorithm told of the panel's moment; `None` where nothing was clipped.
pub(super) fn shown(context: &Context) -> Option<Clipping> {
    let run = context.run();
    let radius = |side: Side| context.body(side).map_or(0.0, |body| body.shape.radius);
    let mut found = run.find_told(|event| match *event {
        Event::EdgesFaced { body, from, to, normal, ends, .. } => {
            let out = normal * radius(body);
            let across = normal * radius(body.other());
            let (inward, reach) =
                if is_level(ends, normal) { (across, DVec2::ZERO) } else { (DVec2::ZERO, across) };
            let (reference, incident) = ([from + out, to + out], ends.map(|end| end - inward));
            let (cuts, points) = (Vec::new(), Vec::new());
            Some(Clipping { body, reference, normal, incident, reach, inward, cuts, points })
        }
        _ => None,
    })?;
    let (other, inward) = (found.body.other(), found.inward);
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

/// Whether an incident edge is as good as square to the reference normal, so that of a round body its surface
/// has such an edge too: of a steep one the surface that matters is round, and the core's edge is shown.
fn is_level([from, to]: [DVec2; 2], normal: DVec2) -> bool {
    (to - from).try_normalize().is_none_or(|along| along.dot(normal).abs() < LEVEL)
}

/// The points of A and B at each end, their separation, and whether it is a contact.
pub(super) fn ends_told(context: &Context) -> Vec<([DVec2; 2], f64, bool)> {
    let told = |event: &Event| match *event {
        Event::ContactFound { points, separation, touches, .. } => Some((points, separation, touches)),
        _ => None,
    };
    context.run().told(told).collect()
}
