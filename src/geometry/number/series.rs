//! Sine and cosine of less than half a degree to twice the precision of a double, without waiting for lower
//! halves.
//!
//! Only the upper halves of z = x² and of the sums go on into the next product, so that no step waits for the
//! lower half of the one before; the lower halves are carried beside them in doubles. With x = h + l:
//!
//! ```text
//! z = h²
//! sin h = h + h z (−1/3! + z/5! − z²/7! + …)        cos h − 1 = −z/2 + z² (1/4! − z/6! + z²/8! − …)
//! sin(h + l) = sin h + l cos h                      cos(h + l) = cos h − l sin h
//! ```
//!
//! What is left out in the last line is l² < 10⁻³⁶. In the brackets the terms from z² on, below 1.2·10⁻¹²,
//! are doubles only: times ε and what stands before the bracket (10⁻⁶ and 10⁻⁸) they lose less than 10⁻³³.

use crate::geometry::Dd;
use crate::geometry::fast_two_sum;
use crate::geometry::two_product;
use crate::geometry::two_sum;

/// The constant −1/6.
const SIXTH: Dd = Dd { hi: -1.0 / 6.0, lo: -9.251_858_538_542_97e-18 };
/// The constant 1/120.
const HUNDRED_TWENTIETH: Dd = Dd { hi: 1.0 / 120.0, lo: 1.156_482_317_317_871_4e-19 };
/// The constant 1/720.
const SEVEN_HUNDRED_TWENTIETH: Dd = Dd { hi: 1.0 / 720.0, lo: -5.300_543_954_373_577e-20 };
/// The constant 1/24.
const TWENTY_FOURTH: Dd = Dd { hi: 1.0 / 24.0, lo: 2.312_964_634_635_742_7e-18 };

/// sin x and cos x − 1 for |x| ≤ 0.0088, each within ε²/20.
#[inline]
pub(crate) fn series(x: Dd) -> (Dd, Dd) {
    let h = x.hi;
    let (z, z_low) = two_product(h, h);
    // cos h − 1 = −z/2 + z² u
    let far = z * z * (1.0 / 40_320.0 - z * (1.0 / 3_628_800.0));
    let u = bracket(TWENTY_FOURTH, -SEVEN_HUNDRED_TWENTIETH, (z, z_low), far);
    let square = longer((z, z_low), longer((z, z_low), u));
    let cos = fast_two_sum(-0.5 * z, square.0);
    // sin h = h + h z u
    let far = z * z * (-1.0 / 5040.0 + z * (1.0 / 362_880.0 - z * (1.0 / 39_916_800.0)));
    let u = bracket(SIXTH, HUNDRED_TWENTIETH, (z, z_low), far);
    let cube = longer((h, 0.0), longer((z, z_low), u));
    let sin = fast_two_sum(h, cube.0);
    let sin_low = sin.1 + (cube.1 + (x.lo + x.lo * cos.0));
    let cos_low = cos.1 + (square.1 - 0.5 * z_low - x.lo * sin.0);
    (Dd { hi: sin.0, lo: sin_low }, Dd { hi: cos.0, lo: cos_low })
}

/// a + b z + far, where far is below 10⁻¹¹.
#[inline]
fn bracket(a: Dd, b: Dd, (z, z_low): (f64, f64), far: f64) -> (f64, f64) {
    let (p, e) = two_product(b.hi, z);
    let (s, f) = fast_two_sum(a.hi, p);
    (s, f + (a.lo + (far + (e + (b.hi * z_low + b.lo * z)))))
}

/// The product of two numbers in halves; the lower one is not folded into the upper.
#[inline]
fn longer(x: (f64, f64), y: (f64, f64)) -> (f64, f64) {
    let (p, e) = two_product(x.0, y.0);
    (p, e + (x.0 * y.1 + x.1 * y.0))
}

/// s + a x + b y, where the products are together below |s|, or s is 0.
#[inline]
pub(crate) fn onto(s: Dd, [(a, x), (b, y)]: [(Dd, Dd); 2]) -> Dd {
    let (p, q) = (longer((a.hi, a.lo), (x.hi, x.lo)), longer((b.hi, b.lo), (y.hi, y.lo)));
    let (t, e) = two_sum(p.0, q.0);
    let (t, f) = fast_two_sum(s.hi, t);
    let (hi, lo) = fast_two_sum(t, f + (s.lo + (e + (p.1 + q.1))));
    Dd { hi, lo }
}
