//! An angle as it stands in a file: exactly so many degrees, or exactly so many radians.
//!
//! Neither unit is turned into the other before the proofs: 30° has no double in radians, and 0.5 rad none in
//! degrees. What is asked for here is rounded, for drawing and for words.

use crate::geometry::Dd;
use crate::geometry::number::radians::DEGREES_PER_RADIAN;

/// An angle, positive counter-clockwise; of a spin, the angle in a unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Angle {
    /// A number of degrees.
    Degrees(f64),
    /// A number of radians.
    Radians(f64),
}

impl Default for Angle {
    fn default() -> Self {
        Self::ZERO
    }
}

impl Angle {
    /// No angle.
    pub const ZERO: Self = Self::Degrees(0.0);

    /// Whether it is a finite number.
    #[inline]
    pub(crate) fn is_finite(self) -> bool {
        let (Self::Degrees(number) | Self::Radians(number)) = self;
        number.is_finite()
    }

    /// Degrees, rounded where it is in radians.
    ///
    /// ```
    /// use tracefig::geometry::Angle;
    /// assert_eq!(Angle::Degrees(30.0).degrees(), 30.0);
    /// assert_eq!(Angle::Radians(std::f64::consts::PI).degrees(), 180.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn degrees(self) -> f64 {
        match self {
            Self::Degrees(degrees) => degrees,
            Self::Radians(radians) => radians.to_degrees(),
        }
    }

    /// Radians, within 2 ε where it is in degrees.
    ///
    /// ```
    /// use tracefig::geometry::Angle;
    /// assert_eq!(Angle::Radians(0.5).radians(), 0.5);
    /// assert_eq!(Angle::Degrees(180.0).radians(), std::f64::consts::PI);
    /// ```
    #[inline]
    #[must_use]
    pub fn radians(self) -> f64 {
        match self {
            Self::Degrees(degrees) => degrees.to_radians(),
            Self::Radians(radians) => radians,
        }
    }

    /// How long an arc of this angle is, in the units of `radius`, within 3 ε.
    ///
    /// ```
    /// use tracefig::geometry::Angle;
    /// assert_eq!(Angle::Radians(-0.5).arc(3.0), 1.5);
    /// assert_eq!(Angle::Degrees(180.0).arc(2.0), std::f64::consts::TAU);
    /// ```
    #[inline]
    #[must_use]
    pub fn arc(self, radius: f64) -> f64 {
        match self {
            // The product first: a tiny angle would lose its digits to underflow in radians.
            Self::Degrees(degrees) => (degrees.abs() * radius).to_radians(),
            Self::Radians(radians) => radians.abs() * radius,
        }
    }

    /// Whether it is no angle at all, exactly.
    ///
    /// ```
    /// use tracefig::geometry::Angle;
    /// assert!(Angle::Radians(-0.0).is_zero() && !Angle::Degrees(360.0).is_zero());
    /// ```
    #[inline]
    #[must_use]
    pub fn is_zero(self) -> bool {
        let (Self::Degrees(size) | Self::Radians(size)) = self;
        size == 0.0
    }

    /// Whether both are the same, whatever the unit that a 0 is written in.
    #[inline]
    pub(crate) fn is(self, other: Self) -> bool {
        self == other || (self.is_zero() && other.is_zero())
    }

    /// Degrees to twice the precision of a double, a few ε² of them off.
    #[inline]
    pub(crate) fn degrees_tailed(self) -> Dd {
        match self {
            Self::Degrees(degrees) => Dd::new(degrees),
            Self::Radians(radians) => {
                Dd { hi: DEGREES_PER_RADIAN[0], lo: DEGREES_PER_RADIAN[1] }.scale(radians)
            }
        }
    }
}
