//! A direction: a vector of length 1, but for the rounding of its two components.
//!
//! It comes from a vector's direction, from a normal that was divided by its length, or from another
//! direction by turning it, so that a normal in hand needs no test of its length. What is computed with it is
//! an ordinary vector.

use std::ops::{Deref, Mul, Neg};

use glam::DVec2;

use crate::geometry::Rotation;

/// A vector of length 1; each component is within ε of that of the exact direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitVector(DVec2);

impl UnitVector {
    /// The direction of the x axis.
    pub const X: Self = Self(DVec2::X);

    /// The direction of a vector of any size; None where it is 0 or not finite.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, UnitVector};
    /// assert_eq!(*UnitVector::along(DVec2::new(3e-200, -4e-200)).unwrap(), DVec2::new(0.6, -0.8));
    /// assert_eq!(UnitVector::along(DVec2::ZERO), None);
    /// ```
    #[must_use]
    pub fn along(v: DVec2) -> Option<Self> {
        let length = libm::hypot(v.x, v.y);
        (length > 0.0 && length.is_finite()).then(|| Self(v / length))
    }

    /// A vector that whoever made it divided by its length.
    #[inline]
    #[must_use]
    pub(crate) const fn normalized(v: DVec2) -> Self {
        Self(v)
    }

    /// The direction, turned.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Rotation, UnitVector};
    /// assert_eq!(*UnitVector::X.turned(Rotation { cos: 0.0, sin: 1.0 }), DVec2::Y);
    /// ```
    #[inline]
    #[must_use]
    pub fn turned(self, by: Rotation<f64>) -> Self {
        Self(by.apply(self.0))
    }
}

impl Deref for UnitVector {
    type Target = DVec2;

    #[inline]
    fn deref(&self) -> &DVec2 {
        &self.0
    }
}

impl PartialEq<DVec2> for UnitVector {
    #[inline]
    fn eq(&self, v: &DVec2) -> bool {
        self.0 == *v
    }
}

impl Neg for UnitVector {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Mul<f64> for UnitVector {
    type Output = DVec2;

    #[inline]
    fn mul(self, length: f64) -> DVec2 {
        self.0 * length
    }
}
