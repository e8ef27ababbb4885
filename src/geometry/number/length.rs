//! Length of a vector without overflow or underflow of its square.

use glam::DVec2;

/// Squares that neither overflow nor lose digits to underflow, on either coordinate that counts.
const SAFE_SQUARES: std::ops::Range<f64> = 1e-280..1e280;

/// Length of a vector, to 2 ε of itself, however large or small its coordinates are.
#[inline]
pub(crate) fn length(v: DVec2) -> f64 {
    let squared = v.length_squared();
    if SAFE_SQUARES.contains(&squared) { squared.sqrt() } else { by_hypot(v) }
}

/// Length of a vector whose square overflows or underflows: apart, so that callers need not make room for it.
#[cold]
fn by_hypot(v: DVec2) -> f64 {
    libm::hypot(v.x, v.y)
}
