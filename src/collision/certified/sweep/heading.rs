//! Where a ray goes: the closing velocity of a pair, as the filter needs it.

use crate::collision::certified::distance::Pair;
use crate::geometry::{DVec2, Dd};

/// The closing velocity v = `v_A` − `v_B` in A's frame, to twice the precision of a double.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heading {
    /// The velocity v, in world units per unit of time.
    pub(crate) v: [Dd; 2],
    /// Its 1-norm, |v|₁.
    pub(crate) speed: f64,
    /// Bound on its error, as a vector.
    pub(crate) error: f64,
}

impl Heading {
    /// The heading of a pair at t = 0; None where products of its doubles may leave their range, or nothing
    /// moves.
    #[inline]
    pub(crate) fn of(pair: &Pair) -> Option<Self> {
        let (v, error) = pair.closing_tailed()?;
        let speed = v[0].hi.abs() + v[1].hi.abs();
        pair.is_tame().then_some(Self { v, speed, error })
    }

    /// The direction of the ray: v, rounded to doubles.
    #[inline]
    pub(crate) fn direction(&self) -> DVec2 {
        DVec2::new(self.v[0].hi, self.v[1].hi)
    }
}
