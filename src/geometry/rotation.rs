//! A rotation of the plane by its cosine and sine, in the three kinds of number that the proofs count in.
//!
//! ```text
//! apply   (x, y) → (cos x − sin y, sin x + cos y)          from a body's frame to the one it is turned in
//! undo    (x, y) → (cos x + sin y, cos y − sin x)          the way back
//! then    cos(α + β) = cos α cos β − sin α sin β           sin(α + β) = sin α cos β + cos α sin β
//! ```
//!
//! In doubles ([`f64`]) a component comes out within 1.5 ε of |x| + |y|, besides what cosine and sine are off
//! by; in double-doubles ([`Dd`]) within [`crate::geometry::number::COMBINED_ERROR`] of it; in balls
//! ([`Ball`]) the radius says it. No turn at all rounds nothing in any of them.

use std::ops::Neg;

use glam::DVec2;

use crate::geometry::{Ball, Dd, two_product, two_sum};

/// A rotation about the origin, counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<N> {
    /// Cosine of the angle.
    pub cos: N,
    /// Sine of the angle.
    pub sin: N,
}

impl<N: Neg<Output = N>> Rotation<N> {
    /// The rotation back.
    ///
    /// ```
    /// use tracefig::geometry::Rotation;
    /// let quarter = Rotation { cos: 0.0, sin: 1.0 };
    /// assert_eq!(quarter.inverse(), Rotation { cos: 0.0, sin: -1.0 });
    /// ```
    #[inline]
    #[must_use]
    pub fn inverse(self) -> Self {
        Self { cos: self.cos, sin: -self.sin }
    }

    /// The rotation after so many quarter turns more, which round nothing.
    #[inline]
    pub(crate) fn quarters_on(self, quarters: u8) -> Self {
        let Self { cos, sin } = self;
        match quarters & 3 {
            0 => Self { cos, sin },
            1 => Self { cos: -sin, sin: cos },
            2 => Self { cos: -cos, sin: -sin },
            _ => Self { cos: sin, sin: -cos },
        }
    }
}

impl Rotation<f64> {
    /// No rotation.
    pub const NONE: Self = Self { cos: 1.0, sin: 0.0 };

    /// The vector `v`, turned.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Rotation};
    /// let quarter = Rotation { cos: 0.0, sin: 1.0 };
    /// assert_eq!(quarter.apply(DVec2::new(2.0, 1.0)), DVec2::new(-1.0, 2.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn apply(self, v: DVec2) -> DVec2 {
        DVec2::new(self.cos * v.x - self.sin * v.y, self.sin * v.x + self.cos * v.y)
    }

    /// The vector that [`Self::apply`] turns into `v`.
    ///
    /// ```
    /// use tracefig::geometry::{DVec2, Rotation};
    /// let quarter = Rotation { cos: 0.0, sin: 1.0 };
    /// assert_eq!(quarter.undo(DVec2::new(-1.0, 2.0)), DVec2::new(2.0, 1.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn undo(self, v: DVec2) -> DVec2 {
        DVec2::new(self.cos * v.x + self.sin * v.y, self.cos * v.y - self.sin * v.x)
    }

    /// This rotation and then `next`.
    ///
    /// ```
    /// use tracefig::geometry::Rotation;
    /// let quarter = Rotation { cos: 0.0, sin: 1.0 };
    /// assert_eq!(quarter.then(quarter), Rotation { cos: -1.0, sin: 0.0 });
    /// ```
    #[inline]
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        Self {
            cos: self.cos * next.cos - self.sin * next.sin,
            sin: self.sin * next.cos + self.cos * next.sin,
        }
    }
}

impl Rotation<Dd> {
    /// The rotation in doubles: what the upper halves say.
    #[inline]
    pub(crate) fn rounded(self) -> Rotation<f64> {
        Rotation { cos: self.cos.hi, sin: self.sin.hi }
    }

    /// Whether it turns nothing.
    #[inline]
    fn is_none(self) -> bool {
        self.sin == Dd::ZERO && self.cos == Dd::ONE
    }

    /// The vector (x, y), turned; no factor is halved twice.
    #[inline]
    pub(crate) fn apply(self, v: [Dd; 2]) -> [Dd; 2] {
        self.inverse().undo(v)
    }

    /// The vector that [`Self::apply`] turns into (x, y); no factor is halved twice.
    #[inline]
    pub(crate) fn undo(self, [x, y]: [Dd; 2]) -> [Dd; 2] {
        if self.is_none() {
            return [x, y];
        }
        let Self { cos, sin } = self;
        let (cx, cy) = (two_product(cos.hi, x.hi), two_product(cos.hi, y.hi));
        let (sx, sy) = (two_product(sin.hi, x.hi), two_product(sin.hi, y.hi));
        let sum = |(p, e): (f64, f64), (q, f): (f64, f64), low: f64| {
            let (s, g) = two_sum(p, q);
            let (hi, lo) = two_sum(s, g + ((e + f) + low));
            Dd { hi, lo }
        };
        [
            sum(cx, sy, (cos.hi * x.lo + cos.lo * x.hi) + (sin.hi * y.lo + sin.lo * y.hi)),
            sum(cy, (-sx.0, -sx.1), (cos.hi * y.lo + cos.lo * y.hi) - (sin.hi * x.lo + sin.lo * x.hi)),
        ]
    }
}

impl Rotation<Ball> {
    /// Whether it certainly turns nothing.
    #[inline]
    fn is_none(self) -> bool {
        self.sin == Ball::ZERO && self.cos == Ball::ONE
    }

    /// The vector (x, y), turned.
    #[inline]
    pub(crate) fn apply(self, [x, y]: [Ball; 2]) -> [Ball; 2] {
        if self.is_none() {
            return [x, y];
        }
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// The vector that [`Self::apply`] turns into (x, y).
    #[inline]
    pub(crate) fn undo(self, [x, y]: [Ball; 2]) -> [Ball; 2] {
        if self.is_none() {
            return [x, y];
        }
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Angle, Turn};

    /// Angles all round, quarter turns among them.
    fn turns() -> impl Iterator<Item = Turn> {
        (-40..40).map(|k| Turn::at(Angle::Degrees(f64::from(k) * 7.5), Angle::Degrees(0.0), 0.0))
    }

    #[test]
    fn undo_takes_back_what_apply_did_in_every_kind_of_number() {
        let v = DVec2::new(3.0, -0.7);
        for turn in turns() {
            let back = turn.rotation().undo(turn.rotation().apply(v));
            assert!((back - v).length() <= 8.0 * f64::EPSILON * 3.7, "{turn:?}: {back}");
            let (tailed, error) = turn.rotation_tailed();
            let [x, y] = tailed.undo(tailed.apply([Dd::new(v.x), Dd::new(v.y)]));
            let off = (x - Dd::new(v.x)).to_f64().abs() + (y - Dd::new(v.y)).to_f64().abs();
            assert!(off <= 16.0 * error + 1e-30, "{turn:?}: {off:e}");
            let balls = turn.rotation_in_balls();
            let [x, y] = balls.undo(balls.apply([Ball::new(v.x), Ball::new(v.y)]));
            assert!([x - Ball::new(v.x), y - Ball::new(v.y)].iter().all(|d| d.value.hi.abs() <= d.radius));
        }
    }

    #[test]
    fn no_turn_rounds_nothing() {
        let third = Dd::ONE.div(Dd::new(3.0));
        let turn = Turn::NONE;
        assert_eq!(turn.rotation_tailed().0.apply([third, -third]), [third, -third]);
        let balls = [Ball::exact(third), Ball::exact(-third)];
        assert_eq!(turn.rotation_in_balls().undo(balls), balls);
    }

    #[test]
    fn a_rotation_then_another_is_that_of_both_angles() {
        for (one, two) in turns().zip(turns().skip(11)) {
            let v = DVec2::new(0.4, 2.0);
            let (x, y) = (one.rotation(), two.rotation());
            let apart = x.then(y).apply(v) - y.apply(x.apply(v));
            assert!(apart.length() <= 8.0 * f64::EPSILON * 2.4, "{one:?} {two:?}");
        }
    }
}
