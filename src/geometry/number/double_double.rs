//! Double-double arithmetic: a number as the unevaluated sum of two doubles, about 32 decimal digits.
//!
//! The building blocks are the error-free sum (Knuth, *The Art of Computer Programming* 2, 1969, §4.2.2) and
//! the error-free product (Dekker, *A Floating-Point Technique for Extending the Available Precision*, 1971);
//! the operations and their bounds are those of Joldes, Muller, Popescu, *Tight and Rigorous Error Bounds for
//! Basic Building Blocks of Double-Word Arithmetic*, 2017 (sum: algorithm 6, product: 10, quotient: 17) and
//! Lefèvre, Louvet, Muller, Picot, Rideau, *Accurate Calculation of Euclidean Norms Using Double-Word
//! Arithmetic*, 2023 (square root). With u = ε/2 their relative errors are at most
//!
//! ```text
//! sum 3u² + 13u³     product 8u²     quotient 15u² + 56u³     square root 25u²/8
//! ```
//!
//! so that [`Dd::ROUNDING`] = 5 ε² = 20u² covers each (the quotient here uses the shorter product with a
//! double, which adds at most 2u²). The product is Dekker's and not a fused multiply-add, which is a slow
//! call where the processor is not known to have one. Neither overflow nor underflow may happen: the callers
//! scale by a power of two, and [`crate::geometry::Ball`] widens where a product comes near 2⁻⁹⁶⁹.

use std::ops::{Add, Mul, Neg, Sub};

/// The unevaluated sum hi + lo with |lo| ≤ ulp(hi)/2.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Dd {
    /// The double nearest to the number.
    pub(crate) hi: f64,
    /// What `hi` leaves out.
    pub(crate) lo: f64,
}

/// Dekker's splitter 2²⁷ + 1.
const SPLITTER: f64 = 134_217_729.0;

/// a + b = sum + error, exactly (Knuth): of two doubles, or of each component of two vectors, which the
/// processor can do side by side.
#[inline]
#[must_use]
pub(crate) fn two_sum<N: Copy + Add<Output = N> + Sub<Output = N>>(a: N, b: N) -> (N, N) {
    let sum = a + b;
    let bb = sum - a;
    (sum, (a - (sum - bb)) + (b - bb))
}

/// a + b = sum + error, exactly, where |a| ≥ |b| or a = 0 (Dekker).
#[inline]
pub(crate) fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The two halves of a double, or of each component of a vector, 26 bits each (Veltkamp).
#[inline]
fn split<N: Copy + Sub<Output = N> + Mul<f64, Output = N>>(a: N) -> (N, N) {
    let c = a * SPLITTER;
    let hi = c - (c - a);
    (hi, a - hi)
}

/// a · b = product + error, exactly (Dekker), where neither overflows and the product is 0 or above 2⁻⁹⁶⁹; of
/// two doubles, or of each component of two vectors.
#[inline]
#[must_use]
pub(crate) fn two_product<N>(a: N, b: N) -> (N, N)
where
    N: Copy + Add<Output = N> + Sub<Output = N> + Mul<Output = N> + Mul<f64, Output = N>,
{
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

/// The power of two that brings `x` ≠ 0 into [1, 2) (denormals into [2⁻⁷⁴, 2⁻²²)); 1 for 0.
#[inline]
#[must_use]
pub(crate) fn taming_power(x: f64) -> f64 {
    /// Exponent field of a double.
    const FIELD: u64 = 0x7ff;
    let exponent = (x.to_bits() >> 52) & FIELD;
    if x == 0.0 {
        1.0
    } else if exponent == 0 {
        f64::from_bits((1023 + 1000) << 52)
    } else {
        f64::from_bits((2046_u64.saturating_sub(exponent)).max(1) << 52)
    }
}

impl Dd {
    /// The number 0.
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    /// The number 1.
    pub(crate) const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    /// Bound on the relative error of every operation here: 5 ε² = 20u². See the head of this file.
    pub(crate) const ROUNDING: f64 = 5.0 * f64::EPSILON * f64::EPSILON;

    /// A double, exactly.
    #[inline]
    #[must_use]
    pub(crate) const fn new(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    /// a + b, exactly.
    #[inline]
    #[must_use]
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// a − b, exactly.
    #[inline]
    #[must_use]
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// a · b, exactly (see [`two_product`] for when).
    #[inline]
    #[must_use]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        Self { hi, lo }
    }

    /// The nearest double.
    #[inline]
    #[must_use]
    pub(crate) fn to_f64(self) -> f64 {
        self.hi + self.lo
    }

    /// x · y for a double y.
    #[inline]
    #[must_use]
    pub(crate) fn scale(self, y: f64) -> Self {
        let (p, e) = two_product(self.hi, y);
        let (hi, lo) = fast_two_sum(p, e + self.lo * y);
        Self { hi, lo }
    }

    /// x · 2ᵏ for `factor` = 2ᵏ, exactly where nothing underflows.
    #[inline]
    #[must_use]
    pub(crate) fn scale_by_power_of_two(self, factor: f64) -> Self {
        Self { hi: self.hi * factor, lo: self.lo * factor }
    }

    /// x + y for a double y.
    #[inline]
    #[must_use]
    pub(crate) fn add_f64(self, y: f64) -> Self {
        let (s, e) = two_sum(self.hi, y);
        let (hi, lo) = fast_two_sum(s, e + self.lo);
        Self { hi, lo }
    }

    /// The quotient x / y.
    #[inline]
    #[must_use]
    pub(crate) fn div(self, y: Self) -> Self {
        let q = self.hi / y.hi;
        let r = y.scale(q);
        let rest = (self.hi - r.hi) + (self.lo - r.lo);
        let (hi, lo) = fast_two_sum(q, rest / y.hi);
        Self { hi, lo }
    }

    /// √x for x ≥ 0.
    #[inline]
    #[must_use]
    pub(crate) fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        let s = self.hi.sqrt();
        let (p, e) = two_product(s, s);
        let rest = ((self.hi - p) - e) + self.lo;
        let (hi, lo) = fast_two_sum(s, rest / (2.0 * s));
        Self { hi, lo }
    }
}

/// a x + b y, within [`COMBINED_ERROR`] · (|a x| + |b y|): one rounding of the lower halves instead of four.
#[inline]
#[must_use]
pub(crate) fn combined(a: Dd, x: Dd, b: Dd, y: Dd) -> Dd {
    let (p, e) = two_product(a.hi, x.hi);
    let (q, f) = two_product(b.hi, y.hi);
    let (s, g) = two_sum(p, q);
    let low = (e + f) + ((a.hi * x.lo + a.lo * x.hi) + (b.hi * y.lo + b.lo * y.hi));
    let (hi, lo) = two_sum(s, g + low);
    Dd { hi, lo }
}

/// Error of [`combined`], relative to |a x| + |b y|: the lower terms are together below 2.5ε of it and meet
/// at most four roundings of ε/2, and lo · lo, which is left out, is below ε²/2 for both: 6 ε².
#[cfg(test)]
pub(crate) const COMBINED_ERROR: f64 = 6.0 * f64::EPSILON * f64::EPSILON;

impl Add for Dd {
    type Output = Self;
    #[inline]
    fn add(self, y: Self) -> Self {
        let (s, e) = two_sum(self.hi, y.hi);
        let (t, f) = two_sum(self.lo, y.lo);
        let (s, e) = fast_two_sum(s, e + t);
        let (hi, lo) = fast_two_sum(s, e + f);
        Self { hi, lo }
    }
}

impl Neg for Dd {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Dd {
    type Output = Self;
    #[inline]
    fn sub(self, y: Self) -> Self {
        self + -y
    }
}

impl Mul for Dd {
    type Output = Self;
    #[inline]
    fn mul(self, y: Self) -> Self {
        let (p, e) = two_product(self.hi, y.hi);
        let (hi, lo) = fast_two_sum(p, e + (self.hi * y.lo + self.lo * y.hi));
        Self { hi, lo }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The relative distance of two double-doubles, to first order.
    fn relative(a: Dd, b: Dd) -> f64 {
        ((a - b).to_f64() / b.to_f64()).abs()
    }

    #[test]
    fn a_sum_loses_nothing() {
        let x = Dd::sum(1.0, 1e-20) - Dd::new(1.0);
        assert_eq!(x.to_f64(), 1e-20);
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend() {
        for k in 1..200 {
            let x = Dd::sum(f64::from(k), 1e-17 / f64::from(k));
            let y = Dd::sum(7.0 / f64::from(k), 3e-18);
            assert!(relative(x.div(y) * y, x) <= 2.0 * Dd::ROUNDING, "{k}");
        }
    }

    #[test]
    fn a_root_squared_is_the_radicand() {
        for k in 1..200 {
            let x = Dd::sum(f64::from(k) / 7.0, 1e-18);
            let root = x.sqrt();
            assert!(relative(root * root, x) <= 3.0 * Dd::ROUNDING, "{k}");
        }
    }

    #[test]
    fn sums_and_products_of_doubles_lose_nothing() {
        assert_eq!(two_sum(1.0, 1e-30), (1.0, 1e-30));
        assert_eq!(two_product(0.1, 10.0), (1.0, 5.551_115_123_125_783e-17));
        assert_eq!(taming_power(-12.0), 0.125);
    }

    #[test]
    fn thirds_and_roots_are_good_to_32_digits() {
        let third = Dd::ONE.div(Dd::new(3.0));
        assert_eq!(third.scale(3.0).to_f64(), 1.0);
        let whole = combined(third, Dd::new(2.0), third, Dd::ONE);
        assert!((whole - Dd::ONE).to_f64().abs() < 1e-31);
        let root = Dd::new(2.0).sqrt();
        assert!(((root * root) - Dd::new(2.0)).to_f64().abs() < 1e-30);
    }
}
