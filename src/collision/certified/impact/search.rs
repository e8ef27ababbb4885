//! The full search for the first contact: separating axes that turn with the bodies, followed one after
//! another.
//!
//! A distance query gives a separating axis. Fixed in the frame of the body that owns it, the axis goes on
//! separating for a while, and how long is known to third order
//! ([`crate::collision::certified::impact::gap`]): follow it until it is used up, then ask for a new one.
//! Close to contact the gap is evaluated in balls, and contact just after the last proved moment is proved by
//! [`crate::collision::certified::impact::contact`].
//!
//! The step is never longer than the truth, so the first contact is never missed, however many turns there
//! are; it converges cubically at a crossing, where the article's conservative advancement gains a constant
//! factor each time.
//!
//! Source: the separating axis as the root that is advanced is Catto's, "Continuous Collision", Game
//! Developers Conference 2013; the certified Taylor step along it is this library's own.

use crate::collision::answer::{Outcome, Reason, Separation};
use crate::collision::certified::impact::axis::{Axis, AxisSpan};
use crate::collision::certified::impact::closest::{closest_features, separation_at};
use crate::collision::certified::impact::contact::{Before, touches_in_doubles};
use crate::collision::certified::impact::follow::Followed;
use crate::collision::certified::impact::gap::Precision;
use crate::collision::certified::impact::limits::Limits;
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::feature::DifferenceFeature;
use crate::geometry::{Enclosure, Side};

/// A separation in doubles below this many roundings is looked at in balls. Half changes nothing; twice asks
/// for balls 9 % more often.
const CLOSE: f64 = 64.0;

/// An axis that lasts for this part of the rest of the motion is not compared with another one. Half saves 4
/// % of the gaps, twice costs 5 %.
const GOOD_PROGRESS: f64 = 1.0 / 16.0;

/// The first trial of proved contact in balls is this many roundings of doubles past the end of the gap:
/// below 4 ε·S. Half makes time bounds 7 % narrower, twice 8 % wider and leaves one more of the 426 hard
/// sweeps open to axes alone.
const ENOUGH: f64 = 1.0 / 32.0;

/// Trials of a time of proved contact, each four times as far beyond the last free moment as the one before:
/// the last is some hundredths of that time away, half as many would end at a billionth. Neither half nor
/// twice decides another pair.
const CONTACT_TRIALS: usize = 24;

/// Halvings of an interval that holds the first contact: a guard, since halving ends at [`NARROW`].
const BISECTIONS: usize = 60;

/// Part of the bounds' width below which an interval that holds the first contact is no longer halved. Half
/// and twice leave the bounds of random pairs as wide on average.
const NARROW: f64 = 0.125;

/// How a search ends.
pub(crate) enum Ended {
    /// Contact, its absence or a limit: an outcome.
    Decided(Outcome),
    /// At a graze: free until a moment near which neither an axis nor contact can be proved.
    Grazing {
        /// The last moment proved free.
        free_until: f64,
        /// The closest features there.
        near: DifferenceFeature,
    },
}

impl Ended {
    /// At a limit of the search: free until a moment, and no more is known.
    fn at_limit(free_until: f64) -> Self {
        Self::Decided(Outcome::Unresolved { reason: Reason::IterationLimit, free_until })
    }
}

/// How closing in on a contact ended.
enum Closed {
    /// The search is over.
    Ended(Ended),
    /// No contact yet: the gap has opened again by this time, go on from here.
    Reopened(f64),
}

/// A search for the first contact, which reports every axis as soon as it is proved.
pub(crate) struct Search<'p, 'q, F> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// When it may stop.
    limits: Limits,
    /// Distance queries made.
    queries: usize,
    /// Vertices looked at along axes.
    work: usize,
    /// Called with every axis that is proved.
    report: F,
}

impl<'p, 'q, F: FnMut(AxisSpan)> Search<'p, 'q, F> {
    /// A search that counts on from `queries` made before it.
    pub(crate) fn new(pair: &'p MovingPair<'q>, limits: Limits, queries: usize, report: F) -> Self {
        Self { pair, limits, queries, work: 0, report }
    }

    /// The end of the search, and the distance queries made.
    pub(crate) fn run(mut self) -> (Ended, usize) {
        let ended = self.step_by_step();
        (ended, self.queries)
    }

    /// Certified steps from t = 0 on.
    fn step_by_step(&mut self) -> Ended {
        let (mut near, gap) = self.closest(0.0);
        // Of two points at rest in one place nothing is rounded.
        let mut is_proved = gap <= CLOSE * self.pair.rounding;
        if is_proved && let Some(touching) = self.touching_at_start(near) {
            return Ended::Decided(touching);
        }
        let mut t = 0.0;
        loop {
            let followed = self.follow_longest(near, t, Precision::Doubles);
            let until = followed.map_or(t, |axis| axis.until);
            if until >= 1.0 {
                return Ended::Decided(Outcome::Miss);
            }
            let stuck = until <= t;
            // A wide gap of doubles is no proof that the bodies start apart, as an axis that separates is.
            if stuck
                && !is_proved
                && let Some(touching) = self.touching_at_start(near)
            {
                return Ended::Decided(touching);
            }
            is_proved = true;
            t = until;
            if self.queries >= self.limits.max_queries || self.is_spent() {
                return Ended::at_limit(t);
            }
            let gap;
            (near, gap) = self.closest(t);
            if stuck || gap < CLOSE * self.pair.rounding {
                if let Some(hit) = followed.and_then(|followed| self.contact_in_doubles(&followed, near)) {
                    return Ended::Decided(hit);
                }
                t = match self.close_in(near, t) {
                    Closed::Reopened(next) => next,
                    Closed::Ended(ended) => return ended,
                };
                near = self.closest(t).0;
            }
        }
    }

    /// The outcome where the bodies are not proved to be apart at t = 0.
    fn touching_at_start(&self, near: DifferenceFeature) -> Option<Outcome> {
        let start = self.separation_at(0.0, near);
        (start.bounds.lo <= 0.0).then(|| Outcome::at_start(&start))
    }

    /// Follows an axis of the given features from `t` and reports it; of two, the one that lasts longer.
    fn follow_longest(&mut self, near: DifferenceFeature, t: f64, precision: Precision) -> Option<Followed> {
        let ahead = self.follow(Axis::ahead(self.pair, near, t), t, precision);
        if ahead.is_some_and(|ahead| ahead.until > t + GOOD_PROGRESS * (1.0 - t)) {
            return self.reported(ahead, t);
        }
        let through = self.follow(Axis::through(self.pair, near, t), t, precision);
        let longest = match (ahead, through) {
            (Some(x), Some(y)) => Some(if x.until > y.until { x } else { y }),
            (x, y) => x.or(y),
        };
        self.reported(longest, t)
    }

    fn follow(&mut self, axis: Option<Axis>, t: f64, precision: Precision) -> Option<Followed> {
        let left = self.limits.work().saturating_sub(self.work);
        let followed = axis?.follow(self.pair, t, precision, left);
        self.work += followed.work;
        Some(followed)
    }

    /// Whether the search has done all the work along axes that it may.
    fn is_spent(&self) -> bool {
        self.work >= self.limits.work()
    }

    /// A followed axis, once what it proved from `t` on is reported.
    fn reported(&mut self, followed: Option<Followed>, t: f64) -> Option<Followed> {
        if let Some(Followed { axis, until, .. }) = followed
            && until > t
        {
            (self.report)(AxisSpan { axis, from: t, to: until });
        }
        followed
    }

    /// Contact proved in doubles, where their rounding is within what the tolerance allows.
    fn contact_in_doubles(&self, followed: &Followed, near: DifferenceFeature) -> Option<Outcome> {
        let speed = -followed.slope;
        if followed.gap <= 0.0 || speed <= 0.0 {
            return None;
        }
        // Three roundings past where the line through the last two derivatives says the gap is used up.
        let hi = (followed.at + (followed.gap + 4.0 * self.pair.rounding) / speed).min(1.0);
        let lo = followed.until;
        let allowed = self.limits.allowed() * self.pair.unit;
        if (hi - lo) * speed > allowed || !touches_in_doubles(self.pair, &followed.axis, near, (lo, hi)) {
            return None;
        }
        Some(Outcome::Hit { time: Enclosure { lo, hi }, contact: self.separation_at(lo, near) })
    }

    /// Goes on in balls, at a tiny gap or where the features gave no axis; where that ends, proves contact.
    fn close_in(&mut self, near: DifferenceFeature, from: f64) -> Closed {
        let (mut t, mut near) = (from, near);
        loop {
            let mut followed = self.follow_longest(near, t, Precision::Balls);
            if followed.is_none_or(|axis| axis.until <= t) {
                let proved = self.separation_at(t, near);
                if proved.bounds.lo * self.pair.unit > self.pair.rounding {
                    let along = self.follow(Axis::along(self.pair, *proved.normal, t), t, Precision::Balls);
                    followed = self.reported(along, t);
                }
            }
            let until = followed.map_or(t, |axis| axis.until);
            if until >= 1.0 {
                return Closed::Ended(Ended::Decided(Outcome::Miss));
            }
            let stuck = until <= t;
            t = t.max(until);
            let trials = if stuck { CONTACT_TRIALS } else { 1 };
            let closing = followed.map_or((0.0, 0.0), |axis| (axis.gap, -axis.slope));
            if let Some(hit) = self.prove_contact(t, near, closing, trials) {
                return Closed::Ended(Ended::Decided(hit));
            }
            if stuck {
                return Closed::Ended(Ended::Grazing { free_until: t, near });
            }
            if self.is_spent() {
                return Closed::Ended(Ended::at_limit(t));
            }
            let gap;
            (near, gap) = self.closest(t);
            if gap > CLOSE * self.pair.rounding {
                return Closed::Reopened(t);
            }
        }
    }

    /// The closest features at `t` and the separation there in doubles, in scaled units.
    fn closest(&mut self, t: f64) -> (DifferenceFeature, f64) {
        self.queries += 1;
        let (features, distance) = closest_features(self.pair, t);
        (features, distance - self.pair.radius.hi)
    }

    /// The certified separation at `t`, looked for at the given features first.
    fn separation_at(&self, t: f64, near: DifferenceFeature) -> Separation {
        let [a, b] = self.pair.bodies;
        separation_at(a, b, t, near)
    }

    /// Contact just after `lo`, the last moment proved free, where a gap closes at `speed`.
    fn prove_contact(
        &self,
        lo: f64,
        near: DifferenceFeature,
        (gap, speed): (f64, f64),
        trials: usize,
    ) -> Option<Outcome> {
        let before = Before::new(self.pair, lo, near);
        let ulp = lo.next_up() - lo;
        let enough = gap.max(0.0) + ENOUGH * self.pair.rounding;
        // Where no axis says how fast, at t = 0 an ulp is a time in which nothing moves.
        let speed = if speed > 0.0 { speed } else { self.pair.speed(Side::A) };
        let mut width = if speed > 0.0 { (enough / speed).max(2.0 * ulp) } else { ulp };
        for trial in 0..trials {
            let hi = (lo + width).min(1.0);
            if before.touches_by(hi) {
                let hi = if trial == 0 { hi } else { Self::narrow(&before, lo, hi) };
                let contact = self.separation_at(lo, near);
                return Some(Outcome::Hit { time: Enclosure { lo, hi }, contact });
            }
            if hi >= 1.0 {
                break;
            }
            width *= 4.0;
        }
        None
    }

    /// Brings the moment of proved contact closer to `lo` while it can be proved there too.
    fn narrow(before: &Before, lo: f64, hi: f64) -> f64 {
        let (mut bad, mut good) = (lo, hi);
        for _ in 0..BISECTIONS {
            let middle = bad + 0.5 * (good - bad);
            if good - bad <= NARROW * (good - lo) || middle <= bad || middle >= good {
                break;
            }
            if before.touches_by(middle) { good = middle } else { bad = middle }
        }
        good
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{moving, placed, polygon};

    #[test]
    fn two_points_at_rest_in_one_place_overlap_from_the_start() {
        let a = placed(polygon(&[[0., 0.]], 0.0), 0.5, 0.25, 0.0);
        let b = a.clone();
        let impact = MovingPair::new(&a, &b).first_contact(1e-12, 100);
        assert!(matches!(impact.outcome, Outcome::Overlapping { .. }), "{impact:?}");
    }

    #[test]
    fn turns_without_end_spend_what_the_limit_allows_and_no_more() {
        let a = placed(polygon(&[[0., -3.], [1., 0.], [0., 1.5], [-1., 0.]], 0.0), -7.0, -1.0, 0.0);
        let b = [[-2., -1.5], [1.5, -2.], [2.5, 0.], [2., 1.5], [-2., 1.5]];
        let b = placed(polygon(&b, 0.0), 7.5, -1.5, 0.0);
        let (a, b) = (moving(a, [10.0, 6.0], 180.0), moving(b, [-10.0, 6.0], 1e10));
        let pair = MovingPair::new(&a, &b);
        for max_queries in [1_000, 2_000] {
            let limits = Limits { tolerance: 1e-12, max_queries };
            let mut search = Search::new(&pair, limits, 0, |_| ());
            let ended = search.step_by_step();
            let Ended::Decided(Outcome::Unresolved { reason, free_until }) = ended else {
                panic!("decided, or a graze")
            };
            assert_eq!(reason, Reason::IterationLimit);
            assert!(free_until > 0.4 && free_until < 0.5, "{free_until}");
            let most = limits.work();
            assert!(search.work >= most && search.work < most + most / 10, "{} of {most}", search.work);
        }
    }
}
