//! S of a pair: the size that the rounding of its numbers is measured by; and whether its sizes are near
//! enough each other for anything to be proved.

use crate::geometry::{Body, DVec2};

/// Largest ratio of a pair's coordinates, and where it moves its distance and speed, also by turning, to its
/// shortest edge or least radius other than 0: beyond it products of the small ones underflow where the large
/// ones are 1, and bounds prove nothing. The least ratio at which fuzzing found a false bound is 1e128.
const MAX_RATIO: f64 = 1e100;

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

/// Whether the sizes of two bodies, and over a motion their distance and speeds, are near enough each other
/// for bounds to be proved.
///
/// # Errors
/// The least and the largest of them, in world units, where they are not.
pub(crate) fn of_one_scale(a: &Body, b: &Body, over_the_motion: bool) -> Result<(), [f64; 2]> {
    let vertices = [a, b].into_iter().flat_map(|body| &body.shape.vertices).copied();
    let moved = [b.position - a.position, b.velocity - a.velocity];
    let moved = if over_the_motion { moved } else { [DVec2::ZERO; 2] };
    let turned = if over_the_motion { [a, b].map(turning_speed) } else { [0.0; 2] };
    let radii = [a.shape.radius, b.shape.radius];
    let lengths = vertices.chain(moved).map(|v| v.abs().max_element());
    let largest = lengths.chain(radii).chain(turned).fold(0.0, f64::max);
    let sizes = [a, b].into_iter().flat_map(edges).chain(radii);
    let least = sizes.filter(|&x| x > 0.0).fold(f64::INFINITY, f64::min);
    // Halves of the exponent each, as the ratio itself may overflow.
    let is_near = least == f64::INFINITY || largest.sqrt() / least.sqrt() <= MAX_RATIO.sqrt();
    if is_near { Ok(()) } else { Err([least, largest]) }
}

/// How fast the farthest vertex of a body's core goes by turning, a component of its place for its distance,
/// in world units per unit of time.
fn turning_speed(body: &Body) -> f64 {
    let reach = body.shape.vertices.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    body.spin.arc(reach)
}

/// The larger component of each edge of a body's core, in world units.
fn edges(body: &Body) -> impl Iterator<Item = f64> {
    let core = body.shape.core.iter().filter_map(|&i| body.shape.vertices.get(i));
    let next = core.clone().cycle().skip(1);
    core.zip(next).map(|(p, q)| (*q - *p).abs().max_element())
}
