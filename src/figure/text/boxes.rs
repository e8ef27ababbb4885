//! What texts say of boxes: corners, centre and half-extents.

use crate::figure::context::Context;
use crate::geometry::DVec2;
use crate::trace::Event;

use super::quantity::Quantity;

/// Half-extents of the box or of the bounds.
pub(super) fn half_extents(context: &Context) -> Option<DVec2> {
    let of_the_box = context.run().find_told(|event| match event {
        Event::Clamped { half_extents, .. } => Some(*half_extents),
        _ => None,
    });
    of_the_box.or_else(|| corners(context).map(|[min, max]| (max - min) / 2.0))
}

/// What `pick` takes of the corners of the bounds.
pub(super) fn bounds(context: &Context, pick: fn([DVec2; 2]) -> f64) -> Option<Quantity> {
    corners(context).map(pick).map(Quantity::exactly)
}

/// The smallest and the largest corner of the bounds that answer: those found last, as the boxes of single
/// bodies come before their union.
fn corners(context: &Context) -> Option<[DVec2; 2]> {
    context.run().find_last_told(|event| match event {
        Event::BoundsFound { min, max, .. } => Some([*min, *max]),
        _ => None,
    })
}

/// What lies halfway between two numbers.
pub(super) fn middle(lo: f64, hi: f64) -> f64 {
    0.5 * (lo + hi)
}
