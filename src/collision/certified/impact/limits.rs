//! What a search for the first contact is allowed to leave open and to spend.

/// Width of a hit's time bounds times the closing speed, in tolerances, that doubles may leave.
///
/// The filter needs 8 roundings of a gap, about 120 ε Σ ([`super::MovingPair::rounding`]): with the usual
/// 1e-12 it takes pairs up to Σ = 150 long. At half of it, pairs half as long go by balls; at twice, bounds
/// are that much wider than what was asked.
const ALLOWED_TOLERANCES: f64 = 4.0;

/// The limits of a search.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// How near the bodies must be for contact, in world units.
    pub(crate) tolerance: f64,
    /// Distance queries after which the search gives up.
    pub(crate) max_queries: usize,
}

impl Limits {
    /// How wide a hit's time bounds times the closing speed may be, in world units, where contact is proved
    /// in doubles; balls leave less whatever the tolerance.
    pub(crate) fn allowed(&self) -> f64 {
        ALLOWED_TOLERANCES * self.tolerance
    }
}
