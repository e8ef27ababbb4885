//! Points and rotations to 300 bits.
//!
//! Degrees are reduced by the nearest multiple of 90 without rounding, and only the rest, |r| ≤ 45, meets
//! π/180. So multiples of 90° are exact; so are cos 60° and sin 30°.

use crate::float::Real;

/// A point or vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// To the right.
    pub x: Real,
    /// Up.
    pub y: Real,
}

impl Point {
    /// The origin.
    pub const ZERO: Self = Self { x: Real::ZERO, y: Real::ZERO };

    /// The point of two doubles, exactly.
    #[must_use]
    pub fn of(pair: [f64; 2]) -> Self {
        Self { x: Real::from(pair[0]), y: Real::from(pair[1]) }
    }

    /// The sum.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }

    /// The difference.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }

    /// The multiple.
    #[must_use]
    pub fn times(self, factor: Real) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(self, other: Self) -> Real {
        self.x * other.x + self.y * other.y
    }

    /// x₁ y₂ − y₁ x₂.
    #[must_use]
    pub fn cross(self, other: Self) -> Real {
        self.x * other.y - self.y * other.x
    }

    /// A quarter turn counter-clockwise.
    #[must_use]
    pub fn perp(self) -> Self {
        Self { x: -self.y, y: self.x }
    }

    /// The length.
    #[must_use]
    pub fn length(self) -> Real {
        self.dot(self).sqrt()
    }

    /// The unit vector; zero for zero.
    #[must_use]
    pub fn unit(self) -> Self {
        self.times(self.length().recip())
    }

    /// The opposite vector.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }

    /// Turned by a rotation.
    #[must_use]
    pub fn turned(self, by: Rotation) -> Self {
        Self { x: by.cos * self.x - by.sin * self.y, y: by.sin * self.x + by.cos * self.y }
    }

    /// Turned back by a rotation.
    #[must_use]
    pub fn turned_back(self, by: Rotation) -> Self {
        self.turned(Rotation { cos: by.cos, sin: -by.sin })
    }
}

/// A rotation by its cosine and sine.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// Cosine.
    pub cos: Real,
    /// Sine.
    pub sin: Real,
}

impl Rotation {
    /// By an angle in degrees.
    #[must_use]
    pub fn of_degrees(degrees: Real) -> Self {
        let quarters = degrees.over_int(90).round();
        let rest = degrees - quarters * Real::from(90.0);
        let (cos, sin) = small(rest);
        match quarters.modulo_four() {
            0 => Self { cos, sin },
            1 => Self { cos: -sin, sin: cos },
            2 => Self { cos: -cos, sin: -sin },
            _ => Self { cos: sin, sin: -cos },
        }
    }
}

/// Degrees of radians; nothing is lost of 0.
#[must_use]
pub fn degrees_of(radians: Real) -> Real {
    if radians.is_zero() { Real::ZERO } else { (radians * Real::from(180.0)).over(Real::pi()) }
}

/// Radians of degrees.
#[must_use]
pub fn radians(degrees: Real) -> Real {
    (degrees * Real::pi()).over_int(180)
}

/// Cosine and sine of at most 45° by their series.
fn small(degrees: Real) -> (Real, Real) {
    let x = radians(degrees);
    let square = -x.squared();
    let (mut cos, mut sin) = (Real::ZERO, Real::ZERO);
    let (mut even, mut odd) = (Real::one(), x);
    let negligible = Real::power_of_two(-330);
    let mut k = 0;
    while even.abs() > negligible {
        cos = cos + even;
        sin = sin + odd;
        even = (even * square).over_int((k + 1) * (k + 2));
        odd = (odd * square).over_int((k + 2) * (k + 3));
        k += 2;
    }
    if degrees.abs() == Real::from(30.0) {
        let half = Real::from(0.5);
        sin = if degrees.signum() < 0 { -half } else { half };
    }
    (cos, sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_are_exact_where_rational_and_on_the_circle_elsewhere() {
        let half = Real::from(0.5);
        assert_eq!(Rotation::of_degrees(Real::from(-300.0)).cos, half);
        assert_eq!(Rotation::of_degrees(Real::from(150.0)).sin, half);
        assert!(Rotation::of_degrees(Real::from(90.0 + 360.0 * 1e6)).cos.is_zero());
        for degrees in [1e-20, 44.9, 17.0, 133.7, -1e9, 123_456.789] {
            let turn = Rotation::of_degrees(Real::from(degrees));
            let rest = turn.cos.squared() + turn.sin.squared() - Real::one();
            assert!(rest.abs() < Real::power_of_two(-310), "{degrees}: {rest}");
        }
    }

    #[test]
    fn known_cosines_come_out() {
        let root = Real::from(0.75).sqrt();
        assert!((Rotation::of_degrees(Real::from(30.0)).cos - root).abs() < Real::power_of_two(-312));
        let known = Real::from_decimal(
            "0.838670567945424029637590941804547894039500265095923824922012902922635169534380677513473984",
        )
        .expect("a number");
        let ours = Rotation::of_degrees(Real::from(33.0)).cos;
        assert!((ours - known).abs() < Real::power_of_two(-290), "{ours}");
    }
}
