//! What a search for the first contact is allowed to leave open and to spend.

/// Width of a hit's time bounds times the closing speed, in tolerances, that doubles may leave.
///
/// The filter needs 8 roundings of a gap, about 120 ε Σ ([`super::MovingPair::rounding`]): with the usual
/// 1e-12 it takes pairs up to Σ = 150 long. At half of it, pairs half as long go by balls; at twice, bounds
/// are that much wider than what was asked.
const ALLOWED_TOLERANCES: f64 = 4.0;

/// Work that each distance query which is allowed brings with it, in vertices looked at along an axis.
///
/// Some 20 ns each: the usual 20,000 queries come to a tenth of a second. A pair in reach of each other takes
/// an evaluation of some twenty for each radian that it turns, so that they do for 30,000 turns. At a tenth
/// of it, 36,000° a unit of time would end unresolved where the scene allows 100 queries.
const WORK_OF_QUERY: usize = 200;

/// The limits of a search.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// How near the bodies must be for contact, in world units.
    pub(crate) tolerance: f64,
    /// Distance queries after which the search gives up; and, since an axis may be followed for any number of
    /// turns, the work that they bring.
    pub(crate) max_queries: usize,
}

impl Limits {
    /// How wide a hit's time bounds times the closing speed may be, in world units, where contact is proved
    /// in doubles; balls leave less whatever the tolerance.
    pub(crate) fn allowed(&self) -> f64 {
        ALLOWED_TOLERANCES * self.tolerance
    }

    /// Vertices that may be looked at along axes.
    pub(crate) fn work(&self) -> usize {
        self.max_queries.saturating_mul(WORK_OF_QUERY)
    }
}
