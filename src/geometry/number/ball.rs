//! A double-double with a proven error: what doubles leave open is decided with these.
//!
//! A ball stands for an unknown real x with |x − value| ≤ radius. Every operation returns a ball that holds
//! the exact result for all reals of its operands:
//!
//! ```text
//! radius(x + y) = r_x + r_y + ROUNDING |x + y|
//! radius(x · y) = |x| r_y + |y| r_x + r_x r_y + ROUNDING |x · y|
//! ```
//!
//! (van der Hoeven, *Ball arithmetic*, 2009). Radii are themselves computed in doubles and pushed up by 8ε,
//! which covers the at most eight roundings of each formula. Sums and products of plain doubles are exact,
//! and their balls stay points: that is how an exact 0 is seen to be one.

use std::ops::{Add, Mul, Neg, Sub};

use crate::geometry::Dd;
use crate::geometry::Enclosure;

/// A real within `radius` of `value`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Ball {
    /// The centre.
    pub(crate) value: Dd,
    /// Bound on |x − value|.
    pub(crate) radius: f64,
}

/// Below this a product may lose its low half to underflow (2⁻⁹⁶⁹ rounded up to 2⁻⁹⁰⁰): its ball widens by
/// [`FLOOR`]. The callers scale scenes to about 1, so that this is far below any rounding that is seen.
const PRODUCT_FLOOR: f64 = 1.0 / SCALE_900;
/// The power 2⁹⁰⁰.
const SCALE_900: f64 = f64::from_bits((1023 + 900) << 52);
/// 2⁻⁹⁰⁰: what an underflowed product is widened by.
const FLOOR: f64 = PRODUCT_FLOOR;

/// 2⁻¹⁰⁷³: at least what a double loses, rounded twice among the denormals.
const DENORMAL: f64 = 2.0 * f64::MIN_POSITIVE * f64::EPSILON;

/// Rounds a radius up past the roundings of its own formula.
#[inline]
fn up(radius: f64) -> f64 {
    radius * (1.0 + 8.0 * f64::EPSILON)
}

impl Ball {
    /// The number 0, exactly.
    pub(crate) const ZERO: Self = Self { value: Dd::ZERO, radius: 0.0 };
    /// The number 1, exactly.
    pub(crate) const ONE: Self = Self { value: Dd::ONE, radius: 0.0 };

    /// A double, exactly.
    #[inline]
    #[must_use]
    pub(crate) const fn new(x: f64) -> Self {
        Self { value: Dd::new(x), radius: 0.0 }
    }

    /// A double-double, exactly.
    #[inline]
    #[must_use]
    pub(crate) const fn exact(value: Dd) -> Self {
        Self { value, radius: 0.0 }
    }

    /// A real within `radius` of a double-double.
    #[inline]
    #[must_use]
    pub(crate) const fn within(value: Dd, radius: f64) -> Self {
        Self { value, radius }
    }

    /// a − b of two doubles, exactly.
    #[inline]
    #[must_use]
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        Self::exact(Dd::difference(a, b))
    }

    /// a · b of two doubles.
    #[inline]
    #[must_use]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let value = Dd::product(a, b);
        Self { value, radius: underflow(value.hi, a, b) }
    }

    /// x · y for a double y.
    #[inline]
    #[must_use]
    pub(crate) fn scale(self, y: f64) -> Self {
        if self.value.lo == 0.0 && self.radius == 0.0 {
            return Self::product(self.value.hi, y);
        }
        let value = self.value.scale(y);
        let radius = self.radius * y.abs() + Dd::ROUNDING * value.hi.abs();
        Self { value, radius: up(radius) + underflow(value.hi, self.value.hi.abs() + self.radius, y) }
    }

    /// x · `factor` for a power of two; widened where it is so small that bits may be lost.
    #[inline]
    #[must_use]
    pub(crate) fn times_power_of_two(self, factor: f64) -> Self {
        let value = self.value.scale_by_power_of_two(factor);
        let lost = |y: f64, x: f64| factor < 1.0 && x != 0.0 && y.abs() < f64::MIN_POSITIVE;
        let vague = lost(value.hi, self.value.hi) || lost(value.lo, self.value.lo);
        let radius = if self.radius == 0.0 { 0.0 } else { (self.radius * factor).next_up() };
        Self { value, radius: if vague { radius + DENORMAL } else { radius } }
    }

    /// The quotient x / y; its radius is infinite where y may be 0, or the quotient beyond all doubles.
    #[inline]
    #[must_use]
    pub(crate) fn over(self, y: Self) -> Self {
        let anything = Self { value: Dd::ZERO, radius: f64::INFINITY };
        let least = y.value.hi.abs() * (1.0 - f64::EPSILON) - y.radius;
        if least <= 0.0 {
            return anything;
        }
        let value = self.value.div(y.value);
        let q = value.hi.abs();
        let radius = (self.radius + q * y.radius * (1.0 + f64::EPSILON)) / least + Dd::ROUNDING * q;
        let radius = up(radius) + underflow(q, self.value.hi.abs() + self.radius, 1.0);
        if radius.is_finite() { Self { value, radius } } else { anything }
    }

    /// √x; of the part of the ball that is not negative.
    #[inline]
    #[must_use]
    pub(crate) fn sqrt(self) -> Self {
        let x = self.value.hi;
        if x <= 0.0 || self.radius >= x {
            // 0 ≤ √x ≤ √(value + radius)
            let top = up((x.max(0.0) + self.radius).sqrt());
            return Self { value: Dd::ZERO, radius: if self.radius == 0.0 && x == 0.0 { 0.0 } else { top } };
        }
        let value = self.value.sqrt();
        // |√x − √v| ≤ |x − v| / √v
        Self { value, radius: up(self.radius / value.hi + Dd::ROUNDING * value.hi) }
    }

    /// Widens by `by` ≥ 0.
    #[inline]
    #[must_use]
    pub(crate) fn widen(self, by: f64) -> Self {
        Self { value: self.value, radius: if by == 0.0 { self.radius } else { up(self.radius + by) } }
    }

    /// Largest possible |x|.
    #[inline]
    #[must_use]
    pub(crate) fn magnitude(self) -> f64 {
        up(self.value.hi.abs() + self.radius)
    }

    /// The sign of x, where the ball tells it: `Some(0)` only if x is exactly 0, `None` if the ball holds 0.
    #[inline]
    #[must_use]
    pub(crate) fn sign(self) -> Option<i8> {
        let x = self.value.hi;
        // |lo| ≤ ε|hi|/2, so that |value| ≥ |hi| (1 − ε).
        if x.abs() * (1.0 - 2.0 * f64::EPSILON) > self.radius {
            Some(if x > 0.0 { 1 } else { -1 })
        } else if self.radius == 0.0 && x == 0.0 {
            Some(0)
        } else {
            None
        }
    }

    /// Whether x > 0 is certain.
    #[inline]
    #[must_use]
    pub(crate) fn is_positive(self) -> bool {
        self.sign() == Some(1)
    }

    /// Whether x < 0 is certain.
    #[inline]
    #[must_use]
    pub(crate) fn is_negative(self) -> bool {
        self.sign() == Some(-1)
    }

    /// Doubles around x, rounded outward; a point where x is a double.
    #[inline]
    #[must_use]
    pub(crate) fn enclosure(self) -> Enclosure {
        self.enclosure_scaled(1.0)
    }

    /// Doubles around x · `factor` for a power of two, rounded outward.
    #[must_use]
    pub(crate) fn enclosure_scaled(self, factor: f64) -> Enclosure {
        let Dd { hi, lo } = self.value;
        let centre = hi * factor;
        // x lies within `rest` ± `radius` of the centre; a denormal centre is itself rounded.
        let rest = (hi - centre / factor) + lo;
        let radius = up(self.radius + rest.abs() * f64::EPSILON);
        Enclosure { lo: -above(-centre, radius - rest, factor), hi: above(centre, radius + rest, factor) }
    }
}

/// A double that is not below `centre` + `by` · `factor`: the centre, its neighbour, or where it is farther
/// the sum.
fn above(centre: f64, by: f64, factor: f64) -> f64 {
    // `by` is the sum of two doubles; were it rounded down to 0, both would be 0.
    if by <= 0.0 {
        return centre;
    }
    let next = centre.next_up();
    // Both sides are exact: a division by a power of two that leads away from the denormals.
    if by <= (next - centre) / factor {
        return next;
    }
    (centre + (by * (1.0 + 4.0 * f64::EPSILON) * factor).next_up()).next_up()
}

/// What a product loses where it may have underflowed, its radius too; `a` and `b` are 0 only where a factor
/// is exactly 0.
#[inline]
fn underflow(product: f64, a: f64, b: f64) -> f64 {
    if product.abs() < PRODUCT_FLOOR && a != 0.0 && b != 0.0 { FLOOR } else { 0.0 }
}

impl Add for Ball {
    type Output = Self;
    #[inline]
    fn add(self, y: Self) -> Self {
        if self.value.lo == 0.0 && y.value.lo == 0.0 {
            return Self { value: Dd::sum(self.value.hi, y.value.hi), radius: up(self.radius + y.radius) };
        }
        let value = self.value + y.value;
        Self { value, radius: up(self.radius + y.radius + Dd::ROUNDING * value.hi.abs()) }
    }
}

impl Neg for Ball {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, radius: self.radius }
    }
}

impl Sub for Ball {
    type Output = Self;
    #[inline]
    fn sub(self, y: Self) -> Self {
        self + -y
    }
}

impl Mul for Ball {
    type Output = Self;
    #[inline]
    fn mul(self, y: Self) -> Self {
        if y.value.lo == 0.0 && y.radius == 0.0 {
            return self.scale(y.value.hi);
        }
        let value = self.value * y.value;
        let (a, b) = (self.value.hi.abs(), y.value.hi.abs());
        let radius = a * y.radius + b * self.radius + self.radius * y.radius + Dd::ROUNDING * value.hi.abs();
        Self { value, radius: up(radius) + underflow(value.hi, a + self.radius, b + y.radius) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_of_doubles_is_a_point() {
        let x = Ball::difference(1.0, 1e-25);
        assert_eq!((x.radius, x.sign()), (0.0, Some(1)));
    }

    #[test]
    fn an_undecided_sign_is_none() {
        let x = Ball::ONE.over(Ball::new(3.0)).scale(3.0) - Ball::ONE;
        assert_eq!(x.sign(), None);
        assert!(x.radius < 1e-30);
    }

    #[test]
    fn enclosures_hold_the_value_and_are_narrow() {
        let third = Ball::ONE.over(Ball::new(3.0)).enclosure();
        assert!(third.lo < third.hi && third.hi - third.lo <= f64::EPSILON / 4.0);
        let half = Ball::new(0.5).enclosure();
        assert_eq!((half.lo, half.hi), (0.5, 0.5));
        let wide = Ball::new(0.5).widen(0.25).enclosure();
        assert!(wide.lo <= 0.25 && wide.hi >= 0.75 && wide.hi < 0.750_000_1);
    }

    #[test]
    fn a_scaled_enclosure_holds_what_underflow_rounds_away() {
        let factor = f64::from_bits(1);
        let e = Ball::new(1.5).enclosure_scaled(factor);
        assert!(e.lo <= f64::from_bits(1) && e.hi >= f64::from_bits(2));
    }

    #[test]
    fn a_quotient_beyond_all_doubles_may_be_anything() {
        for least in [1e-304, f64::from_bits(1)] {
            let e = (-Ball::new(1e10)).over(Ball::new(least)).enclosure();
            assert_eq!((e.lo, e.hi), (f64::NEG_INFINITY, f64::INFINITY), "{least:e}");
        }
    }

    #[test]
    fn an_underflowed_product_is_not_taken_for_zero() {
        assert_eq!(Ball::product(1e-200, 1e-200).sign(), None);
        assert_eq!(Ball::product(0.0, 1e-200).sign(), Some(0));
        let vague = Ball::ZERO.widen(1e-200);
        assert_eq!(((vague * vague).sign(), (vague * Ball::ZERO).sign()), (None, Some(0)));
        assert_eq!((vague.scale(1e-200).sign(), vague.over(Ball::new(1e200)).sign()), (None, None));
    }

    #[test]
    fn a_sign_is_told_only_where_it_is_certain() {
        assert_eq!(Ball::difference(0.5, 0.25).sign(), Some(1));
        assert_eq!(Ball::difference(0.5, 0.5).sign(), Some(0));
        assert_eq!(Ball::new(0.5).widen(1.0).sign(), None);
    }
}
