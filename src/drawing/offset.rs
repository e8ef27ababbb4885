//! Differences of page points.

use std::ops::{Add, Mul, Neg, Sub};

use super::Point;

/// From one page point to another, in pixels, x right, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Offset {
    /// Right.
    pub dx: f64,
    /// Down.
    pub dy: f64,
}

impl Offset {
    /// `dx` right and `dy` down.
    #[must_use]
    pub const fn new(dx: f64, dy: f64) -> Self {
        Self { dx, dy }
    }

    /// Its length in page pixels.
    #[must_use]
    pub fn length(self) -> f64 {
        libm::hypot(self.dx, self.dy)
    }

    /// The same direction, one pixel long; none where it has no direction.
    ///
    /// ```
    /// use tracefig::drawing::Offset;
    /// assert_eq!(Offset::new(0.0, 4.0).unit(), Some(Offset::new(0.0, 1.0)));
    /// assert_eq!(Offset::default().unit(), None);
    /// ```
    #[must_use]
    pub fn unit(self) -> Option<Self> {
        let length = self.length();
        (length > 0.0 && length.is_finite()).then(|| self * (1.0 / length))
    }

    /// A quarter turn to the left of who walks along it on the page: (dy, −dx).
    #[must_use]
    pub const fn left(self) -> Self {
        Self { dx: self.dy, dy: -self.dx }
    }

    /// The inner product.
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        self.dx * other.dx + self.dy * other.dy
    }

    /// The outer product: positive where `other` points to the right of `self` on the page.
    #[must_use]
    pub fn cross(self, other: Self) -> f64 {
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
