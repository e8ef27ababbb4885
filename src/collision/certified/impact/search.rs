//! First contact of two bodies that move and turn, by separating axes that turn with them.
//!
//! A distance query gives a separating axis. Fixed in the frame of the body that owns it, the axis goes on separating for a
//! while, and how long is known to third order ([`crate::collision::certified::impact::axis`]): follow it until it is used up, then ask for a new
//! one. The axes used, each with its span of time, are a certificate that nothing touches before the last; they are
//! recorded as they are found. Close to contact the gap is evaluated in balls, and contact just after the last proved
//! moment is proved by [`crate::collision::certified::impact::contact`].
//!
//! Mostly that is not needed: [`crate::collision::certified::impact::filter`] finds the contact in doubles without proof, and proves it and all
//! before it with a few axes afterwards. What follows is for what it leaves open: grazes, contacts of vertices, many turns,
//! tolerances below the rounding of doubles.
//!
//! The step is never longer than the truth, so the first contact is never missed, however many turns there are; it converges
//! cubically at a crossing, where the article's conservative advancement gains a constant factor each time.
//!
//! Source: the separating axis as the root that is advanced is Catto's, "Continuous Collision", Game Developers Conference 2013; the
//! certified Taylor step along it is this library's own.

use crate::collision::Answer;
use crate::collision::Impact;
use crate::collision::Outcome;
use crate::collision::Query;
use crate::collision::Reason;
use crate::collision::Separation;
use crate::collision::certified::impact::axis::{Axis, Precision, Swept};
use crate::collision::certified::impact::closest::{certified, nearest};
use crate::collision::certified::impact::contact::{self, Before, touches_plainly};
use crate::collision::certified::impact::filter::certificate::Leg;
use crate::collision::certified::impact::filter::touch;
use crate::collision::certified::impact::filter::{Found, QuickImpact};
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::certified::sweep::ray;
use crate::collision::feature::DifferenceFeature;
use crate::geometry::{Body, Enclosure};
use crate::trace::{Event, NoTrace, Tracer};

/// Its word in a scene file.
pub(crate) const NAME: &str = "swept-axis";

/// A plain separation below this many roundings is looked at in balls.
const CLOSE: f64 = 64.0;

/// An axis that lasts for this part of the rest of the motion is not compared with another one.
const GOOD_PROGRESS: f64 = 1.0 / 16.0;

/// Width of the time bounds times the closing speed, in tolerances, that contact proved in doubles may leave.
const ALLOWED_TOLERANCES: f64 = 4.0;

/// The first trial of proved contact in balls is this many roundings of doubles past the end of the gap: below 4 ε·S.
const ENOUGH: f64 = 1.0 / 32.0;

/// Trials of a time of proved contact, each four times as far beyond the last free moment as the one before.
const CONTACT_TRIALS: usize = 24;

/// Step cap of [`of_unturned`]: without turning, each axis halves what is left of a graze.
const UNTURNED_ITERATIONS: usize = 200;

/// Halvings of an interval that holds the first contact.
const BISECTIONS: usize = 60;

/// Answers a time-of-impact query.
pub(crate) fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = MovingPair::new(query.a, query.b.unwrap_or(query.a));
    Answer::Impact(first_contact(&pair, query.tolerance, query.max_iterations, tracer))
}

impl MovingPair<'_> {
    /// The first contact in [0, 1] and its proof's bounds: what the default algorithm answers to a time-of-impact query, with
    /// a `tolerance` in world units and at most about `max_iterations` distance queries. See [`MovingPair::new`] for an
    /// example.
    #[must_use]
    pub fn first_contact(&self, tolerance: f64, max_iterations: usize) -> Impact {
        first_contact(self, tolerance, max_iterations, &mut NoTrace)
    }
}

fn first_contact(
    pair: &MovingPair,
    tolerance: f64,
    max_iterations: usize,
    tracer: &mut impl Tracer,
) -> Impact {
    let mut search = Search::new(pair, tolerance, max_iterations);
    let outcome = search.run(tracer);
    tracer.record(|| Event::Finished { outcome: outcome.word() });
    Impact { outcome, tolerance, iterations: search.queries }
}

/// First contact of two bodies of which neither turns, where axes and proofs of contact decide it.
pub(crate) fn of_unturned(a: &Body, b: &Body) -> Option<Outcome> {
    let pair = MovingPair::new(a, b);
    let mut search = Search { pair: &pair, tolerance: 0.0, max_iterations: UNTURNED_ITERATIONS, queries: 0 };
    let outcome = search.run(&mut NoTrace);
    (!matches!(outcome, Outcome::Unresolved { .. })).then_some(outcome)
}

/// A search for the first contact.
pub(crate) struct Search<'p, 'q> {
    pair: &'p MovingPair<'q>,
    /// World units.
    tolerance: f64,
    max_iterations: usize,
    /// Distance queries made.
    queries: usize,
}

/// How closing in on a contact ended.
enum Closed {
    /// By the end of the search.
    By(Outcome),
    /// Not: the bodies part again at this time.
    Not(f64),
}

impl<'p, 'q> Search<'p, 'q> {
    /// A search with a tolerance in world units and a step cap.
    pub(crate) fn new(pair: &'p MovingPair<'q>, tolerance: f64, max_iterations: usize) -> Self {
        Self { pair, tolerance, max_iterations, queries: 0 }
    }

    fn run(&mut self, tracer: &mut impl Tracer) -> Outcome {
        tracer.record(|| Event::Started {
            algorithm: NAME,
            at: crate::collision::algorithm::advancement::moment(
                self.pair.bodies[0],
                self.pair.bodies[1],
                0.0,
            ),
        });
        self.quickly(tracer).unwrap_or_else(|| self.step_by_step(tracer))
    }

    /// The answer by certified steps.
    pub(crate) fn step_by_step(&mut self, tracer: &mut impl Tracer) -> Outcome {
        let (mut near, gap) = self.nearest(0.0);
        if gap < CLOSE * self.pair.rounding {
            let start = self.certified(0.0, near);
            if start.bounds.lo <= 0.0 {
                return contact::at_start(&start);
            }
        }
        let mut t = 0.0;
        loop {
            let followed = self.sweep(near, t, Precision::Plain, tracer);
            let until = followed.map_or(t, |(_, swept)| swept.until);
            if until >= 1.0 {
                return Outcome::Miss;
            }
            let stuck = until <= t;
            t = until;
            if self.queries >= self.max_iterations {
                return Outcome::Unresolved { reason: Reason::IterationLimit, free_until: t };
            }
            let gap;
            (near, gap) = self.nearest(t);
            if stuck || gap < CLOSE * self.pair.rounding {
                if let Some(hit) = followed.and_then(|followed| self.plain_contact(&followed, near)) {
                    return hit;
                }
                t = match self.close_in(near, t, tracer) {
                    Closed::Not(next) => next,
                    Closed::By(outcome) => return outcome,
                };
                near = self.nearest(t).0;
            }
        }
    }

    /// The answer of the first stage, its proof recorded.
    pub(crate) fn quickly(&mut self, tracer: &mut impl Tracer) -> Option<Outcome> {
        let mut quick = QuickImpact::new(self.pair, ALLOWED_TOLERANCES * self.tolerance, self.max_iterations);
        let found = quick.run();
        self.queries += quick.queries;
        let found = found?;
        for &Leg { axis: Axis { owner, n: normal, .. }, from, to } in quick.proof.legs() {
            tracer.record(|| Event::AxisSwept { from, to, owner, normal });
        }
        Some(match found {
            Found::Miss => Outcome::Miss,
            Found::Hit(time, near) => {
                let [a, b] = self.pair.bodies;
                let contact =
                    touch::separation(a, b, time.lo, near).unwrap_or_else(|| self.certified(time.lo, near));
                Outcome::Hit { time, contact }
            }
        })
    }

    /// Follows an axis of the given features from `t`, the one that lasts longer if there are two; records it.
    fn sweep(
        &self,
        near: DifferenceFeature,
        t: f64,
        precision: Precision,
        tracer: &mut impl Tracer,
    ) -> Option<(Axis, Swept)> {
        let ahead = self.follow(Axis::ahead(self.pair, near, t), t, precision);
        if ahead.is_some_and(|(_, swept)| swept.until > t + GOOD_PROGRESS * (1.0 - t)) {
            return Self::told(ahead, t, tracer);
        }
        let through = self.follow(Axis::through(self.pair, near, t), t, precision);
        let longest = match (ahead, through) {
            (Some(x), Some(y)) => Some(if x.1.until > y.1.until { x } else { y }),
            (x, y) => x.or(y),
        };
        Self::told(longest, t, tracer)
    }

    fn follow(&self, axis: Option<Axis>, t: f64, precision: Precision) -> Option<(Axis, Swept)> {
        axis.map(|axis| (axis, axis.sweep(self.pair, t, precision)))
    }

    /// What a followed axis proved from `t` on, recorded.
    fn told(followed: Option<(Axis, Swept)>, t: f64, tracer: &mut impl Tracer) -> Option<(Axis, Swept)> {
        if let Some((Axis { owner, n: normal, .. }, Swept { until, .. })) = followed
            && until > t
        {
            tracer.record(|| Event::AxisSwept { from: t, to: until, owner, normal });
        }
        followed
    }

    /// Contact proved in doubles, where their rounding is within what the tolerance allows.
    fn plain_contact(&self, (axis, swept): &(Axis, Swept), near: DifferenceFeature) -> Option<Outcome> {
        let speed = -swept.slope;
        if swept.gap <= 0.0 || speed <= 0.0 {
            return None;
        }
        // Three roundings past where the line through the last two derivatives says the gap is used up.
        let hi = (swept.at + (swept.gap + 4.0 * self.pair.rounding) / speed).min(1.0);
        let lo = swept.until;
        let allowed = ALLOWED_TOLERANCES * self.tolerance * self.pair.unit;
        if (hi - lo) * speed > allowed || !touches_plainly(self.pair, axis, near, (lo, hi)) {
            return None;
        }
        Some(Outcome::Hit { time: Enclosure { lo, hi }, contact: self.certified(lo, near) })
    }

    /// At a tiny gap, or where the features gave no axis: goes on in balls, and where that ends, proves contact.
    fn close_in(&mut self, near: DifferenceFeature, from: f64, tracer: &mut impl Tracer) -> Closed {
        let (mut t, mut near) = (from, near);
        let still = Swept { until: from, at: from, gap: 0.0, slope: 0.0 };
        loop {
            let mut swept = self.sweep(near, t, Precision::Fine, tracer).map_or(still, |(_, swept)| swept);
            if swept.until <= t {
                let proved = self.certified(t, near);
                if proved.bounds.lo * self.pair.unit > self.pair.rounding {
                    let axis = Axis::along(self.pair, proved.normal, t);
                    let followed = self.follow(axis, t, Precision::Fine);
                    swept = Self::told(followed, t, tracer).map_or(still, |(_, swept)| swept);
                }
            }
            if swept.until >= 1.0 {
                return Closed::By(Outcome::Miss);
            }
            let stuck = swept.until <= t;
            t = t.max(swept.until);
            let trials = if stuck { CONTACT_TRIALS } else { 1 };
            if let Some(hit) = self.prove_contact(t, near, (swept.gap, -swept.slope), trials) {
                return Closed::By(hit);
            }
            if stuck {
                return Closed::By(self.undecided(t, near, tracer));
            }
            let gap;
            (near, gap) = self.nearest(t);
            if gap > CLOSE * self.pair.rounding {
                return Closed::Not(t);
            }
        }
    }

    /// The closest features at `t` and the plain separation, in scaled units.
    fn nearest(&mut self, t: f64) -> (DifferenceFeature, f64) {
        self.queries += 1;
        let (features, distance) = nearest(self.pair, t);
        (features, distance - self.pair.radius.hi)
    }

    /// The certified separation at `t`, looked for at the given features first.
    fn certified(&self, t: f64, near: DifferenceFeature) -> Separation {
        let [a, b] = self.pair.bodies;
        certified(a, b, t, near)
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
        let mut width = if speed > 0.0 { (enough / speed).max(2.0 * ulp) } else { ulp };
        for trial in 0..trials {
            let hi = (lo + width).min(1.0);
            if before.touches_by(hi) {
                let hi = if trial == 0 { hi } else { Self::narrow(&before, lo, hi) };
                let contact = self.certified(lo, near);
                return Some(Outcome::Hit { time: Enclosure { lo, hi }, contact });
            }
            if hi >= 1.0 {
                break;
            }
            width *= 4.0;
        }
        None
    }

    /// A graze: decided exactly where neither body turns.
    fn undecided(&self, free_until: f64, near: DifferenceFeature, tracer: &mut impl Tracer) -> Outcome {
        let unresolved = Outcome::Unresolved { reason: Reason::WithinRounding, free_until };
        if !self.pair.is_linear() {
            return unresolved;
        }
        match ray::first_contact(self.pair.bodies[0], self.pair.bodies[1]) {
            Outcome::Hit { time: Enclosure { lo, hi }, .. } if lo >= free_until => {
                let contact = self.certified(free_until, near);
                Outcome::Hit { time: Enclosure { lo: free_until, hi }, contact }
            }
            Outcome::Unresolved { .. } => unresolved,
            Outcome::Miss => {
                let normal = self.certified(free_until, near).normal;
                // Without turning, a gap along a fixed axis is linear in time: positive between if it is at both ends.
                let axis = Axis::across(self.pair, normal)
                    .filter(|axis| [free_until, 1.0].iter().all(|&t| axis.separates(self.pair, t)));
                let until = Swept { until: 1.0, at: 1.0, gap: 0.0, slope: 0.0 };
                Self::told(axis.map(|axis| (axis, until)), free_until, tracer);
                Outcome::Miss
            }
            decided => decided,
        }
    }

    /// Brings the moment of proved contact closer to `lo` while it can be proved there too.
    fn narrow(before: &Before, lo: f64, hi: f64) -> f64 {
        let (mut bad, mut good) = (lo, hi);
        for _ in 0..BISECTIONS {
            let middle = bad + 0.5 * (good - bad);
            if good - bad <= 0.125 * (good - lo) || middle <= bad || middle >= good {
                break;
            }
            if before.touches_by(middle) { good = middle } else { bad = middle }
        }
        good
    }
}
