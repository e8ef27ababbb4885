//! Differences of page points.

use std::ops::{Add, Mul, Neg, Sub};

use super::Point;

/// From one page point to another, in pixels, x right, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Offset {
    /// Pixels to the right.
    pub dx: f64,
    /// Pixels down.
    pub dy: f64,
}

impl Offset {
    /// The offset by `dx` to the right and `dy` down.
    ///
    /// ```
    /// use tracefig::drawing::{Offset, Point};
    /// assert_eq!(Point::new(1.0, 1.0) + Offset::new(2.0, 3.0) * 2.0, Point::new(5.0, 7.0));
    /// ```
    #[must_use]
    pub const fn new(dx: f64, dy: f64) -> Self {
        Self { dx, dy }
    }

    /// Its length in page pixels.
    #[must_use]
    pub(crate) fn length(self) -> f64 {
        libm::hypot(self.dx, self.dy)
    }

    /// The square of its length in page pixels: enough to compare two.
    #[must_use]
    pub(crate) fn square(self) -> f64 {
        self.dot(self)
    }

    /// One pixel in its direction; none where it has no direction.
    #[must_use]
    pub(crate) fn unit(self) -> Option<Self> {
        let length = self.length();
        (length > 0.0 && length.is_finite()).then(|| self * (1.0 / length))
    }

    /// A quarter turn to the left of who walks along it on the page: (dy, −dx).
    #[must_use]
    pub(crate) const fn left(self) -> Self {
        Self { dx: self.dy, dy: -self.dx }
    }

    /// The inner product.
    #[must_use]
    pub(crate) fn dot(self, other: Self) -> f64 {
        self.dx * other.dx + self.dy * other.dy
    }

    /// The outer product: positive where `other` points to the right of `self` on the page.
    #[must_use]
    pub(crate) fn cross(self, other: Self) -> f64 {
        self.dx * other.dy - self.dy * other.dx
    }
}

impl Sub for Point {
    type Output = Offset;
    fn sub(self, from: Self) -> Offset {
        Offset { dx: self.x - from.x, dy: self.y - from.y }
    }
}

impl Add<Offset> for Point {
    type Output = Self;
    fn add(self, by: Offset) -> Self {
        Self { x: self.x + by.dx, y: self.y + by.dy }
    }
}

impl Add for Offset {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { dx: self.dx + other.dx, dy: self.dy + other.dy }
    }
}

impl Sub for Offset {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul<f64> for Offset {
    type Output = Self;
    fn mul(self, k: f64) -> Self {
        Self { dx: self.dx * k, dy: self.dy * k }
    }
}

impl Neg for Offset {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_has_the_direction_and_an_offset_without_length_has_none() {
        assert_eq!(Offset::new(0.0, 4.0).unit(), Some(Offset::new(0.0, 1.0)));
        assert_eq!(Offset::default().unit(), None);
        assert_eq!(Offset::new(f64::INFINITY, 0.0).unit(), None);
    }
}
