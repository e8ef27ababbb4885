//! Two bodies on their way without turning, ready to be asked when they meet.
//!
//! What stands ready is what a relative pose and a relative velocity are made of: where B is and how it is turned in A's
//! frame, and the ray's direction v = `v_A` − `v_B` there. Everything that is a search happens when the question is asked:
//! [`crate::collision::certified::sweep::filter`] first, the balls of [`crate::collision::certified::sweep::ray`] where doubles do not tell, and where even they do not,
//! separating axes and proofs of contact.

pub(crate) mod filter;
pub(crate) mod ray;

use crate::collision::Outcome;
use crate::collision::Reason;
use crate::collision::Separation;
use crate::collision::certified::distance::pair::Pair;
use crate::collision::certified::distance::search::{certify, settle};
use crate::collision::certified::distance::witnesses::{self, Proved};
use crate::collision::certified::impact::search;
use crate::collision::certified::sweep::filter::{Heading, Met, met};
use crate::collision::certified::sweep::ray::{Entry, Ray};
use crate::collision::feature::DifferenceFeature;
use crate::geometry::{Body, Enclosure};

/// Two bodies that move and do not turn, over t in [0, 1].
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'s> {
    /// Both at t = 0.
    pub(crate) pair: Pair<'s>,
    /// The ray, where doubles can cast it.
    heading: Option<Heading>,
}

impl<'s> Sweep<'s> {
    /// The two bodies at t = 0 and the direction of the ray, with cosines and sines to twice the precision of a double, which
    /// nearly every hit needs. Spins are not looked at.
    ///
    /// ```
    /// use tracefig::collision::{Outcome, Sweep};
    /// use tracefig::geometry::{Body, DVec2, Degrees, Shape, shape::FieldValue};
    /// let shape = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
    /// let body = |x, speed| Body {
    ///     shape: shape.clone(), position: DVec2::new(x, 0.5), angle: Degrees(30.0),
    ///     velocity: DVec2::new(speed, 0.0), spin: Degrees(0.0),
    /// };
    /// let (a, b) = (body(0.0, 0.0), body(4.0, -3.0));
    /// let Outcome::Hit { time, .. } = Sweep::new(&a, &b).first_contact() else { panic!() };
    /// // 4 less the width of a square at 30°, over 3.
    /// let exact = (4.0 - 4.0 / 3f64.sqrt()) / 3.0;
    /// assert!(time.lo <= exact + 1e-16 && exact - 1e-16 <= time.hi && time.hi - time.lo < 2e-16);
    /// ```
    #[must_use]
    pub fn new(a: &'s Body, b: &'s Body) -> Self {
        let pair = Pair::finely_at(a, b, 0.0);
        Self { heading: Heading::of(&pair), pair }
    }

    /// When and how the bodies meet first.
    ///
    /// Times are in [0, 1]; the bounds enclose the exact time of the bodies as their doubles say it, mostly between two
    /// neighbouring doubles. A contact is the pair at `time.lo`, in world units.
    #[must_use]
    pub fn first_contact(&self) -> Outcome {
        match self.quick() {
            Some(Met::At(_, time, proved)) if time.lo >= 0.0 => self.hit(time, &proved),
            Some(Met::Nothing) => Outcome::Miss,
            quick => self.after_all(quick),
        }
    }

    /// First contact by the ray alone.
    pub(crate) fn by_ray(&self) -> Outcome {
        self.outcome(&self.entry())
    }

    /// Around a vertex that no digits tell from the ray, axes and proofs of contact need not tell.
    #[cold]
    fn after_all(&self, quick: Option<Met>) -> Outcome {
        let outcome = self.outcome(&self.or_by_balls(quick));
        match outcome {
            Outcome::Unresolved { .. } => search::of_unturned(self.pair.a, self.pair.b).unwrap_or(outcome),
            decided => decided,
        }
    }

    /// Where the ray's line enters B ⊖ A, as far as doubles tell.
    #[inline]
    fn quick(&self) -> Option<Met> {
        self.heading.as_ref().and_then(|heading| met(&self.pair, heading))
    }

    /// Whether, where and when the ray's line enters B ⊖ A.
    pub(crate) fn entry(&self) -> Entry {
        self.or_by_balls(self.quick())
    }

    /// By balls where doubles do not tell.
    fn or_by_balls(&self, quick: Option<Met>) -> Entry {
        quick.map_or_else(|| Ray::new(&self.pair).entry(), Entry::Quick)
    }

    /// A hit that doubles proved.
    #[inline]
    fn hit(&self, time: Enclosure, proved: &Proved) -> Outcome {
        Outcome::Hit { time, contact: witnesses::answer(&self.pair.placed_at(time.lo), proved) }
    }

    /// The answer that an entry gives.
    fn outcome(&self, entry: &Entry) -> Outcome {
        match *entry {
            Entry::Quick(Met::At(_, time, ref proved)) if time.lo >= 0.0 => self.hit(time, proved),
            Entry::Quick(
                Met::At(piece, Enclosure { lo, hi }, _) | Met::Outside(piece, Enclosure { lo, hi }),
            ) => self.between(piece, lo, hi),
            Entry::Misses | Entry::Quick(Met::Nothing) => Outcome::Miss,
            Entry::Still => self.at_start(Outcome::Miss),
            Entry::Unsure => self.at_start(unsure(0.0)),
            Entry::At(piece, first, last) => self.between(piece, first.doubles().0, last.doubles().1),
        }
    }

    /// The answer where the ray's line enters through `piece` between two moments.
    fn between(&self, piece: DifferenceFeature, lo: f64, hi: f64) -> Outcome {
        if lo >= 1.0 {
            Outcome::Miss
        } else if lo < 0.0 {
            // The line enters at or before t = 0: the bodies overlap, or have passed each other.
            self.at_start(if hi < 0.0 { Outcome::Miss } else { unsure(0.0) })
        } else if hi <= 1.0 {
            Outcome::Hit { time: Enclosure { lo, hi }, contact: self.contact(piece, lo) }
        } else {
            unsure(lo)
        }
    }

    /// Overlap at t = 0, or else what is given.
    fn at_start(&self, apart: Outcome) -> Outcome {
        let start = certify(&self.pair, None);
        if start.bounds.hi <= 0.0 {
            Outcome::Overlapping { contact: start }
        } else if start.bounds.lo > 0.0 {
            apart
        } else {
            Outcome::Unresolved { reason: Reason::WithinRounding, free_until: 0.0 }
        }
    }

    /// The pair at `lo`, just before it touches: so near that the quick proof would hardly ever be tight enough.
    fn contact(&self, piece: DifferenceFeature, lo: f64) -> Separation {
        let pair = self.pair.unturned_at(lo);
        settle(&pair, Some(piece))
    }
}

fn unsure(free_until: f64) -> Outcome {
    Outcome::Unresolved { reason: Reason::WithinRounding, free_until }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::sweep_properties::Dice;

    #[test]
    fn a_contact_of_doubles_is_the_certified_separation_at_its_time() {
        let mut dice = Dice(17);
        for k in 0..1000 {
            let (a, b) = (dice.flying(0.0), dice.flying(0.0));
            let Outcome::Hit { time, contact } = Sweep::new(&a, &b).first_contact() else { continue };
            let at = settle(&Pair::at(&a, &b, time.lo), None);
            assert!(contact.bounds.lo <= at.bounds.hi && at.bounds.lo <= contact.bounds.hi, "{k}");
            assert!((contact.normal - at.normal).length() < 1e-9, "{k}: {contact:?} {at:?}");
            let apart =
                (contact.points[0] - at.points[0]).length() + (contact.points[1] - at.points[1]).length();
            assert!(apart < 1e-9 || contact.features != at.features, "{k}: {contact:?} {at:?}");
        }
    }
}
