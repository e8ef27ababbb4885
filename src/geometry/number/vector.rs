//! Error-free sums and products of both components of a vector at once, which the processor can do side by
//! side.

use glam::DVec2;

use crate::geometry::number::double_double::SPLITTER;

/// a + b = sum + error in each component (Knuth); see [`crate::geometry::two_sum`].
#[inline]
pub(crate) fn two_sum_each(a: DVec2, b: DVec2) -> (DVec2, DVec2) {
    let sum = a + b;
    let bb = sum - a;
    (sum, (a - (sum - bb)) + (b - bb))
}

/// The two halves of each component (Veltkamp).
#[inline]
fn split_each(a: DVec2) -> (DVec2, DVec2) {
    let c = a * SPLITTER;
    let hi = c - (c - a);
    (hi, a - hi)
}

/// a · b = product + error in each component (Dekker); see [`crate::geometry::two_product`].
#[inline]
pub(crate) fn two_product_each(a: DVec2, b: DVec2) -> (DVec2, DVec2) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split_each(a), split_each(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}
