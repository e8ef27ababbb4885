//! Sums and products of doubles without rounding, of any length: for signs that no fixed precision tells.
//!
//! A number is a sum of doubles that do not overlap, as in [`crate::geometry::number::expansion`]; here it
//! grows as it has to. Only underflow and overflow of a product can lose anything, and that is remembered.
//! Slow, and asked for only where double-doubles leave a sign open.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use crate::geometry::{two_product, two_sum};

/// An exact number, or one that has lost something.
#[derive(Clone, Debug, Default)]
pub(crate) struct Exact {
    /// Doubles that do not overlap, none of them 0, the smallest first.
    parts: Vec<f64>,
    /// Whether a product has lost something: then nothing is known of the number.
    lossy: bool,
}

/// 2⁻⁹⁶⁰: a product below it may lose its low half to underflow.
const LEAST_PRODUCT: f64 = f64::from_bits((1023 - 960) << 52);

/// 2⁹⁶⁰: the splitting of a factor above it may overflow.
const LARGEST_PRODUCT: f64 = f64::from_bits((1023 + 960) << 52);

impl Exact {
    /// A double.
    pub(crate) fn new(x: f64) -> Self {
        let mut exact = Self::default();
        exact.grow(x);
        exact
    }

    /// The product of a double with a power of two.
    pub(crate) fn scaled(x: f64, factor: f64) -> Self {
        let y = x * factor;
        Self { lossy: y / factor != x, ..Self::new(y) }
    }

    /// The sign; None where something was lost.
    pub(crate) fn sign(&self) -> Option<Ordering> {
        let top = self.parts.last().copied().unwrap_or(0.0);
        if self.lossy { None } else { top.partial_cmp(&0.0) }
    }

    /// The number, within 2 ε of itself.
    pub(crate) fn rounded(&self) -> f64 {
        self.parts.iter().sum()
    }

    /// Adds a double.
    fn grow(&mut self, x: f64) {
        let (mut carry, mut kept) = (x, 0);
        for k in 0..self.parts.len() {
            let (sum, rest) = two_sum(self.parts[k], carry);
            carry = sum;
            if rest != 0.0 {
                self.parts[kept] = rest;
                kept += 1;
            }
        }
        self.parts.truncate(kept);
        if carry != 0.0 {
            self.parts.push(carry);
        }
        self.lossy |= !carry.is_finite();
    }
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, other: &Exact) -> Exact {
        let mut sum = Exact { parts: self.parts.clone(), lossy: self.lossy || other.lossy };
        for &part in &other.parts {
            sum.grow(part);
        }
        sum
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { parts: self.parts.iter().map(|part| -part).collect(), lossy: self.lossy }
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, other: &Exact) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: &Exact) -> Exact {
        let mut product = Exact { lossy: self.lossy || other.lossy, ..Exact::default() };
        for &x in &self.parts {
            for &y in &other.parts {
                let (p, e) = two_product(x, y);
                if !(LEAST_PRODUCT..LARGEST_PRODUCT).contains(&p.abs()) {
                    product.lossy = true;
                }
                product.grow(e);
                product.grow(p);
            }
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tracefig_reference::float::Real;
    use tracefig_reference::random::Random;

    #[test]
    fn sums_and_products_lose_nothing() {
        let mut random = Random::new(12);
        for _ in 0..2_000 {
            let [a, b, c, d] =
                std::array::from_fn(|_| random.between(-1.0, 1.0) * random.magnitude(-12.0, 3.0));
            let exact = |x| Exact::new(x);
            let polynomial =
                &(&(&exact(a) * &exact(b)) - &(&exact(c) * &exact(d))) * &(&exact(a) + &exact(d));
            let real = (Real::from(a) * Real::from(b) - Real::from(c) * Real::from(d))
                * (Real::from(a) + Real::from(d));
            let parts = polynomial.parts.iter().fold(Real::ZERO, |sum, &part| sum + Real::from(part));
            assert!((parts - real).is_zero() && !polynomial.lossy, "{a} {b} {c} {d}");
            assert!((polynomial.rounded() - real.to_f64()).abs() <= 2.0 * f64::EPSILON * real.to_f64().abs());
        }
    }

    #[test]
    fn what_cancels_is_zero_and_what_underflows_is_unknown() {
        let third = &Exact::new(1.0 / 3.0) * &Exact::new(0.1);
        assert_eq!((&third - &third).sign(), Some(Ordering::Equal));
        assert_eq!((&third + &Exact::new(-1e-40)).sign(), Some(Ordering::Greater));
        assert_eq!((&Exact::new(1e-200) * &Exact::new(1e-200)).sign(), None);
        assert_eq!(Exact::scaled(5e-324, 0.5).sign(), None);
    }
}
