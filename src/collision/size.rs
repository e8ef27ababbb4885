//! S of a pair: the size that the rounding of its numbers is measured by.

use crate::geometry::{Body, DVec2};

/// The size S of a pair in world units: the largest of a body's extent, of the distance that turning moves
/// it, and of its share of what lies between the bodies: half of how far they are apart, or move relative to
/// each other.
pub(crate) fn scale_of(a: &Body, b: &Body) -> f64 {
    let largest = |v: DVec2| v.x.abs().max(v.y.abs());
    let extent = |body: &Body| {
        let far = body.shape.vertices.iter().fold(0.0_f64, |s, &v| s.max(largest(v))) * body.shape.stretch();
        far.max(body.shape.radius).max(far * body.spin.radians().abs())
    };
    let shares =
        largest(b.position * 0.5 - a.position * 0.5).max(largest(b.velocity * 0.5 - a.velocity * 0.5));
    extent(a).max(extent(b)).max(shares)
}
