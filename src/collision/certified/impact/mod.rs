//! First contact of two bodies that move and turn, proved.
//!
//! A question goes to the [`filter`] first: doubles find the contact, and prove it and all before it
//! afterwards. Where it leaves something open, the [`search`] proves its way forward from t = 0, step by
//! step, in balls where needed. At a graze the search stands still; then the ray of
//! [`crate::collision::certified::sweep`] decides, if neither body turns. The other way round, what the ray
//! leaves open the search may decide. Both ways out are here and nowhere else.
//!
//! # Words
//!
//! ```text
//! apart       at a moment: the separation is above 0
//! touch       at a moment: it is not, the bodies share a point
//! contact     the first moment in [0, 1] at which they touch; and the pair just before it
//! hit         an outcome: contact, enclosed between lo, until which they are proved apart, and hi, by which
//!             they are proved to have touched
//! gap         along an axis: how far apart the bodies' shadows on it are; positive, the axis separates them
//! used up     an axis, at the moment from which on its gap can no longer be proved positive
//! close in    go on in balls, where the gap is within a few roundings of doubles
//! graze       a contact, or a near miss, at which the gap hardly closes: its signs are below the rounding
//! ```
//!
//! # Numbers that steer
//!
//! Some constants here only decide how long an answer takes, and what is left to a slower way: none of them
//! can make it wrong. Their docs say what half and twice of each does to 2,000 random pairs of few vertices
//! that turn by up to 500° (a quarter of them 3,000°) and to 603 hard ones. As they are, the filter decides
//! 1,469 of the random pairs and 421 of the hard ones, with 19.5 gaps and 2.6 distance queries a random pair;
//! the search alone takes 15.9 gaps and 3.2 distance queries, and leaves time bounds 1e-14 wide (the
//! geometric mean).

pub(super) mod axis;
pub(super) mod closest;
mod contact;
pub(super) mod filter;
mod follow;
pub(super) mod gap;
mod limits;
mod moving_pair;
mod search;
pub(super) mod taylor;

pub(crate) use axis::AxisSpan;
pub use moving_pair::MovingPair;

use crate::collision::answer::{Impact, Outcome, Reason};
use crate::collision::certified::distance::Pair;
use crate::collision::certified::sweep::{balls, exact};
use crate::collision::feature::DifferenceFeature;
use crate::collision::size::of_one_scale;
use crate::geometry::{Body, Enclosure, length};
use axis::Axis;
use closest::{closest_features, separation_at};
use contact::Before;
use limits::Limits;
use search::{Ended, Search};

/// Step cap of [`by_axes`]: without turning, each axis halves what is left of a graze, so that 200 leave
/// nothing of it. Half and twice leave open the same 24 of the 426 hard sweeps.
const UNTURNED_QUERIES: usize = 200;

impl MovingPair<'_> {
    /// The first contact in [0, 1] and its proof's bounds: what the default algorithm answers to a
    /// time-of-impact query, with a `tolerance` in world units and at most about `max_iterations` distance
    /// queries. A contact is the pair at `time.lo`, in world units. Of bodies that turn so fast, or whose
    /// sizes differ so much, that products of them underflow (a factor of 1e100) nothing is decided; nor of
    /// bodies that are not convex, or of numbers that are not finite.
    ///
    /// ```
    /// use tracefig::collision::{MovingPair, Outcome};
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let square = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
    /// let turning = |x| Body {
    ///     shape: square.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(0.0),
    ///     velocity: DVec2::ZERO, spin: Angle::Degrees(90.0),
    /// };
    /// let (a, near, far) = (turning(0.0), turning(2.5), turning(3.0));
    /// // Turned alike by θ, the squares touch where 2.5 cos θ = 2.
    /// let impact = MovingPair::new(&a, &near).first_contact(1e-12, 100);
    /// let Outcome::Hit { time, .. } = impact.outcome else { panic!() };
    /// let exact = 0.8_f64.acos() / std::f64::consts::FRAC_PI_2;
    /// assert!(time.lo <= exact + 1e-15 && exact - 1e-15 <= time.hi && time.hi - time.lo < 1e-11);
    /// assert_eq!(MovingPair::new(&a, &far).first_contact(1e-12, 100).outcome, Outcome::Miss);
    /// ```
    #[must_use]
    pub fn first_contact(&self, tolerance: f64, max_iterations: usize) -> Impact {
        self.first_contact_told(tolerance, max_iterations, |_| ())
    }

    /// [`Self::first_contact`], which reports each axis that separates the bodies, in order of time, as soon
    /// as it is proved: together they cover all of the time before the first contact that axes can prove.
    pub(crate) fn first_contact_told(
        &self,
        tolerance: f64,
        max_iterations: usize,
        mut report: impl FnMut(AxisSpan),
    ) -> Impact {
        let [a, b] = self.bodies;
        if !(a.can_touch() && b.can_touch() && tolerance >= 0.0) {
            return Impact { outcome: Outcome::UNKNOWN, tolerance, iterations: 0 };
        }
        if self.is_lost() || !self.is_linear() && of_one_scale(a, b, true).is_err() {
            let outcome = Outcome::Unresolved { reason: Reason::WithinRounding, free_until: 0.0 };
            return Impact { outcome, tolerance, iterations: 0 };
        }
        let limits = Limits { tolerance, max_queries: max_iterations };
        let mut until = 0.0;
        let found = self.first_contact_in_order(limits, |span| {
            until = span.to;
            report(span);
        });
        if matches!(found.outcome, Outcome::Unresolved { reason: Reason::WithinRounding, .. }) {
            return self
                .the_other_way_round(limits, until, report)
                .or_else(|| self.without_rounding(limits.tolerance, found.iterations))
                .unwrap_or(found);
        }
        self.tightened(found, limits)
    }

    /// A first contact that axes left wide, as where flat bodies meet end on, or a vertex is grazed before
    /// the bodies meet: where neither body turns, the ray knows it better.
    #[inline]
    fn tightened(&self, found: Impact, limits: Limits) -> Impact {
        let Outcome::Hit { time, .. } = found.outcome else { return found };
        let [a, b] = self.bodies;
        let way = (time.hi - time.lo) * length(a.velocity - b.velocity);
        let is_wide = way > limits.allowed() + self.rounding / self.unit;
        if is_wide && self.is_linear() { self.met_by_ray(found) } else { found }
    }

    /// A first contact with the time of the ray's, where that is within its own.
    #[cold]
    fn met_by_ray(&self, found: Impact) -> Impact {
        let [a, b] = self.bodies;
        let pair = Pair::refined_at(a, b, 0.0);
        let by_ray = match balls::entry(&pair).outcome(&pair) {
            Outcome::Unresolved { .. } => exact::outcome(&pair),
            decided => Some(decided),
        };
        match (by_ray, &found.outcome) {
            (Some(outcome @ Outcome::Hit { time, .. }), Outcome::Hit { time: wide, .. })
                if wide.lo <= time.lo && time.hi <= wide.hi =>
            {
                Impact { outcome, ..found }
            }
            _ => found,
        }
    }

    /// The first contact of bodies of which neither turns, where only exact arithmetic tells it. Axes in
    /// doubles part the bodies no farther than they did.
    #[cold]
    fn without_rounding(&self, tolerance: f64, iterations: usize) -> Option<Impact> {
        let [a, b] = self.bodies;
        let outcome =
            if self.is_linear() { exact::outcome(&Pair::refined_at(a, b, 0.0))? } else { return None };
        Some(Impact { outcome, tolerance, iterations })
    }

    /// The first contact with A called A.
    #[inline]
    fn first_contact_in_order(&self, limits: Limits, mut report: impl FnMut(AxisSpan)) -> Impact {
        let filtered = filter::first_contact(self, limits, &mut report);
        match filtered.outcome {
            Some(outcome) => Impact { outcome, tolerance: limits.tolerance, iterations: filtered.queries },
            None => self.first_contact_by_search(limits, filtered.queries, report),
        }
    }

    /// The first contact if it can be decided with B called A, so that both ways round are judged alike; of
    /// its axes those are reported that separate after `until`.
    #[cold]
    fn the_other_way_round(
        &self,
        limits: Limits,
        until: f64,
        mut report: impl FnMut(AxisSpan),
    ) -> Option<Impact> {
        let [a, b] = self.bodies;
        let mut spans = Vec::new();
        let found = MovingPair::new(b, a).first_contact_in_order(limits, |span| spans.push(span));
        if matches!(found.outcome, Outcome::Unresolved { .. }) {
            return None;
        }
        for AxisSpan { axis, from, to } in spans.into_iter().filter(|span| span.to > until) {
            let axis = Axis { owner: axis.owner.other(), ..axis };
            report(AxisSpan { axis, from: from.max(until), to });
        }
        Some(Impact { outcome: found.outcome.swapped(), ..found })
    }

    /// The first contact without the filter, which has made so many distance queries.
    fn first_contact_by_search(
        &self,
        limits: Limits,
        queries: usize,
        mut report: impl FnMut(AxisSpan),
    ) -> Impact {
        let (ended, iterations) = Search::new(self, limits, queries, &mut report).run();
        let outcome = match ended {
            Ended::Decided(outcome) => outcome,
            Ended::Grazing { free_until, near } => self.by_ray(free_until, near, report),
        };
        Impact { outcome, tolerance: limits.tolerance, iterations }
    }

    /// Whether the bodies, which are apart at `lo`, are proved to touch at some moment in (lo, hi].
    pub(crate) fn touches_between(&self, lo: f64, hi: f64) -> bool {
        Before::new(self, lo, closest_features(self, lo).0).touches_by(hi)
    }

    /// A graze: where neither body turns the ray decides it exactly.
    #[cold]
    fn by_ray(&self, free_until: f64, near: DifferenceFeature, mut report: impl FnMut(AxisSpan)) -> Outcome {
        let unresolved = Outcome::Unresolved { reason: Reason::WithinRounding, free_until };
        if !self.is_linear() {
            return unresolved;
        }
        let [a, b] = self.bodies;
        let pair = Pair::refined_at(a, b, 0.0);
        match balls::entry(&pair).outcome(&pair) {
            Outcome::Hit { time: Enclosure { lo, hi }, .. } if lo >= free_until => {
                let contact = separation_at(a, b, free_until, near);
                Outcome::Hit { time: Enclosure { lo: free_until, hi }, contact }
            }
            Outcome::Unresolved { .. } => unresolved,
            Outcome::Miss => {
                let normal = separation_at(a, b, free_until, near).normal;
                // Without turning, a gap along a fixed axis is linear in time: positive between if it is at
                // both ends.
                let axis = Axis::across(self, *normal)
                    .filter(|axis| [free_until, 1.0].iter().all(|&t| axis.separates(self, t)));
                if let Some(axis) = axis
                    && free_until < 1.0
                {
                    report(AxisSpan { axis, from: free_until, to: 1.0 });
                }
                Outcome::Miss
            }
            decided => decided,
        }
    }
}

/// First contact of two bodies of which neither turns, where the ray leaves it open: around a vertex that no
/// digits tell from the ray, axes and proofs of contact need not tell. None where they leave it open too.
#[cold]
pub(crate) fn by_axes(a: &Body, b: &Body) -> Option<Outcome> {
    let pair = MovingPair::new(a, b);
    if pair.is_lost() {
        return None;
    }
    let limits = Limits { tolerance: 0.0, max_queries: UNTURNED_QUERIES };
    match Search::new(&pair, limits, 0, |_| ()).run().0 {
        Ended::Decided(Outcome::Unresolved { .. }) | Ended::Grazing { .. } => None,
        Ended::Decided(outcome) => Some(outcome),
    }
}
