//! Sums of doubles without rounding: expansions.
//!
//! A number is kept as a sum of doubles that do not overlap; each sum of two of them goes on as the rounded
//! sum and what that leaves out (Shewchuk, *Adaptive Precision Floating-Point Arithmetic*, 1997, theorem 10).

use crate::geometry::Dd;
use crate::geometry::two_product;
use crate::geometry::two_sum;

/// A sum of doubles without rounding, as long as there is room: parts that do not overlap, none of
/// them 0, the smallest first.
pub(crate) struct Expansion<const N: usize> {
    /// The parts, of which the first `count` are in use.
    parts: [f64; N],
    /// How many parts there are.
    count: usize,
    /// Bound on what was left out for want of room, or before it came here.
    pub(crate) error: f64,
}

impl<const N: usize> Default for Expansion<N> {
    fn default() -> Self {
        Self { parts: [0.0; N], count: 0, error: 0.0 }
    }
}

impl<const N: usize> Expansion<N> {
    /// Adds `x`, exactly (Shewchuk's GROW-EXPANSION with zero elimination).
    #[inline]
    pub(crate) fn grow(&mut self, x: f64) {
        let (mut carry, mut kept) = (x, 0);
        for k in 0..self.count {
            let (sum, rest) = two_sum(self.parts[k], carry);
            carry = sum;
            if rest != 0.0 {
                self.parts[kept] = rest;
                kept += 1;
            }
        }
        self.count = kept;
        if carry == 0.0 {
            return;
        }
        if self.count == N {
            // The smallest part gives way.
            self.error += self.parts[0].abs();
            self.parts.copy_within(1.., 0);
            self.count -= 1;
        }
        self.parts[self.count] = carry;
        self.count += 1;
    }

    /// The parts, the largest first.
    #[inline]
    pub(crate) fn largest_first(&self) -> impl Iterator<Item = f64> {
        self.parts.iter().take(self.count).rev().copied()
    }

    /// Its value, to a few ulp.
    #[inline]
    pub(crate) fn approximate(&self) -> f64 {
        self.parts.iter().take(self.count).sum()
    }

    /// Its value as a double-double and a bound on what that leaves out.
    #[inline]
    pub(crate) fn rounded(&self) -> (Dd, f64) {
        let (mut top, mut error) = (Dd::ZERO, 0.0);
        for part in self.largest_first() {
            if top.lo != 0.0 {
                error += Dd::ROUNDING * (top.hi.abs() + part.abs());
            }
            top = top.add_f64(part);
        }
        (top, error)
    }
}

/// x · y = p + e, and a bound on what is lost to underflow.
pub(crate) fn exact_product(x: f64, y: f64) -> (f64, f64, f64) {
    /// Above this the splitting of a product could overflow; 2¹⁰⁰ comes off first and goes back exactly.
    const HUGE: f64 = 1e270;
    /// Below this the low half may underflow.
    const TINY: f64 = 1e-270;
    /// The power of two that comes off: 2¹⁰⁰.
    const STEP: f64 = f64::from_bits((1023 + 100) << 52);
    if x.abs() > HUGE {
        let (p, e) = two_product(x / STEP, y);
        return (p * STEP, e * STEP, 0.0);
    }
    let (p, e) = two_product(x, y);
    (p, e, if p.abs() < TINY && x != 0.0 && y != 0.0 { TINY } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_and_its_opposite_leave_nothing() {
        let terms = [1.0, 1e-30, -3.5e-200, 1e30, 0.1];
        let mut sum = Expansion::<8>::default();
        for term in terms {
            sum.grow(term);
        }
        for term in terms {
            sum.grow(-term);
        }
        assert_eq!((sum.largest_first().count(), sum.error), (0, 0.0));
    }

    #[test]
    fn what_finds_no_room_is_an_error() {
        let mut sum = Expansion::<2>::default();
        for term in [1.0, 1e-30, 1e30] {
            sum.grow(term);
        }
        assert_eq!(sum.largest_first().collect::<Vec<_>>(), [1e30, 1.0]);
        assert_eq!(sum.error, 1e-30);
    }

    #[test]
    fn products_are_exact_to_the_ends_of_the_range() {
        for (x, y) in [(0.1, 0.3), (1e300, 57.3), (-1e290, 1e-5)] {
            let (p, e, lost) = exact_product(x, y);
            assert!(p == x * y && e.abs() <= p.abs() * f64::EPSILON && lost == 0.0, "{x} {y}");
        }
        assert!(exact_product(1e-200, 1e-90).2 > 0.0);
    }
}
