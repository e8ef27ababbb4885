//! The separation of a pair at one moment, proved: how far apart two bodies are, or how deep inside each
//! other.
//!
//! It is the distance of the origin from B ⊖ A = {b − a}, less ρ, negative inside. The files, in the order in
//! which a question goes through them:
//!
//! ```text
//! pair         both bodies in A's frame: the doubles, double-doubles and bounds that all of it starts from
//! filter/      a guess in doubles, proved in doubles: nearly every pair ends here
//!   conditions   when a feature of B ⊖ A is surely the nearest
//!   gaps         the gap along the normal of every edge, O(n + m)
//!   refine       the distance of a known feature in double-doubles
//! search       what the filter leaves open: the nearest feature in balls, ties, exact zeros
//!   balls        the pair in balls
//!   boundary     a walk along B ⊖ A to its nearest point
//! exact        where balls leave open whether the bodies touch: polynomials without any rounding
//! witnesses    from the proof to the answer: normal, witness points and features in the world
//! ```

pub(super) mod balls;
mod boundary;
pub(super) mod conditions;
pub(super) mod exact;
pub(super) mod filter;
pub(super) mod gaps;
pub(super) mod pair;
pub(super) mod refine;
pub(super) mod search;
pub(super) mod witnesses;

pub use pair::Pair;

use crate::collision::answer::Separation;
use crate::collision::feature::DifferenceFeature;
use crate::geometry::Enclosure;

/// The certified separation of a pair; `hint` is a feature of B ⊖ A that may be nearest the origin.
///
/// Of directions that tie, the hinted one is taken.
#[inline]
pub(crate) fn certify(pair: &Pair, hint: Option<DifferenceFeature>) -> Separation {
    witnesses::answer(pair, &proved(pair, hint))
}

/// [`certify`] in A's frame, with the feature of B ⊖ A that carries the separation.
#[inline]
pub(super) fn proved(pair: &Pair, hint: Option<DifferenceFeature>) -> witnesses::Proved {
    filter::proved(pair).unwrap_or_else(|| settled(pair, hint))
}

/// [`certify`] without the filter: as true, and slower.
///
/// To be asked at once where the pair is so near touching that the filter would hardly ever be tight enough.
#[cold]
pub(super) fn settle(pair: &Pair, hint: Option<DifferenceFeature>) -> Separation {
    witnesses::answer(pair, &settled(pair, hint))
}

/// The separation by balls; where they leave open whether the bodies touch, by exact arithmetic, and by balls
/// in the other body's frame: so that a pair is judged alike whichever body is called A.
#[cold]
fn settled(pair: &Pair, hint: Option<DifferenceFeature>) -> witnesses::Proved {
    let mut proved = search::proved(pair, hint);
    let is_open = |bounds: Enclosure| bounds.lo <= 0.0 && bounds.hi > 0.0;
    if !is_open(proved.bounds) {
        return proved;
    }
    if let Some(bounds) = exact::bounds(pair, &proved.carrier) {
        proved.narrow(bounds);
    }
    // In both frames without the hint: what it leads to may be the wrong feature, where doubles lose a body's
    // size beside the other's.
    let unhinted = hint.map(|_| (pair.a, pair.b));
    for (a, b) in std::iter::once((pair.b, pair.a)).chain(unhinted) {
        if !is_open(proved.bounds) {
            break;
        }
        let again = Pair::refined_at(a, b, pair.time);
        let other = search::proved(&again, None);
        proved.narrow(other.bounds);
        if let Some(bounds) = exact::bounds(&again, &other.carrier) {
            proved.narrow(bounds);
        }
    }
    proved
}

impl Pair<'_> {
    /// Signed separation with its witnesses, in world units, negative inside.
    ///
    /// The bounds enclose the exact separation of the bodies as their doubles say it. Of bodies that are not
    /// convex, or have numbers that are not finite, nothing is known: NaN, between the infinities.
    ///
    /// ```
    /// use tracefig::collision::Pair;
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
    /// let moving = |x, v| Body {
    ///     shape: shape.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(0.0),
    ///     velocity: DVec2::new(v, 0.0), spin: Angle::Degrees(0.0),
    /// };
    /// let (a, b) = (moving(0.0, 4.0), moving(4.0, 0.0));
    /// let found = Pair::at(&a, &b, 0.0).separation();
    /// assert_eq!((found.separation, *found.normal), (2.0, DVec2::X));
    /// ```
    #[must_use]
    pub fn separation(&self) -> Separation {
        let is_known = self.a.can_touch() && self.b.can_touch() && self.time.is_finite();
        if is_known { certify(self, None) } else { Separation::UNKNOWN }
    }
}
