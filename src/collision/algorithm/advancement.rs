//! Stepping through time by a safe bound: what [`super::ray_clipping`] and
//! [`super::conservative_advancement`] share.
//!
//! At each moment a distance query gives the separation s, and the unit normal n from A to B at the closest
//! points. Along n the gap shrinks at most at the rate
//!
//! ```text
//! bound = v·n + r_A |ω_A| + r_B |ω_B|         v = v_A − v_B, the closing velocity
//! ```
//!
//! where r is the largest distance of a core vertex from its body's origin (Mirtich, *Impulse-based Dynamic
//! Simulation of Rigid Body Systems*, 1996, section 2.3.2; Coumans, *Continuous Collision Detection and
//! Physics*, 2005). So nothing touches before t + s / bound, and a bound that is not positive means that the
//! bodies never meet.
//!
//! The sign is what the article's readers argued about: its `ray` is `v_B` − `v_A`, while its normal points
//! from A to B, so that its `rayN` is minus the closing speed and a step could lead backward in time. Neither
//! `fabs` nor a flipped test is the cure, but the closing velocity itself.

use crate::collision::algorithm::minkowski;
use crate::collision::algorithm::motion::{self, moment};
use crate::collision::algorithm::view::PairView;
use crate::collision::certified::impact::MovingPair;
use crate::collision::certified::sweep::Sweep;
use crate::collision::size::scale_of;
use crate::collision::{Impact, Outcome, Query, Reason, Separation};
use crate::geometry::{Body, DVec2, Enclosure, perp};
use crate::trace::{Event, Tracer};

/// Which of the two algorithms steps: it decides what is added to v·n, and where the estimate is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flavor {
    /// Nothing turns and nothing is added; the estimate moves along the ray, in B ⊖ A as it is at t = 0.
    RayClipping,
    /// Bodies turn and r |ω| of both is added; B ⊖ A changes with time, and the estimate stays at the origin.
    Conservative,
}

/// The tolerance in force is never below this times S: what a query in plain doubles can tell.
const TOLERANCE_FLOOR: f64 = 16.0 * f64::EPSILON;

/// Error of a bound on the closing speed, as a part of the sum of the magnitudes of the velocity and the
/// arms.
const BOUND_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What a separation is shortened by before a step, times S.
///
/// Its normal is rounded, so that the gap along it may be less than s by that.
const SEPARATION_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// One advancement of a pair.
struct Advancement<'q> {
    /// What is asked; its step cap holds.
    query: &'q Query<'q>,
    /// Body A.
    a: &'q Body,
    /// Body B.
    b: &'q Body,
    /// Which of the two algorithms steps.
    flavor: Flavor,
    /// Closing velocity `v_A` − `v_B`, world units per unit of time.
    v: DVec2,
    /// `r_A` |`ω_A`| + `r_B` |`ω_B`|, rounded up; 0 where nothing turns. World units per unit of time.
    arms: f64,
    /// The tolerance in force, world units.
    tolerance: f64,
    /// S of the pair, world units: see [`scale_of`].
    scale: f64,
}

/// What a distance query at one time allows.
enum Step {
    /// Nothing touches before this time: go on there.
    To(f64),
    /// The search is over; this is its outcome.
    Done(Outcome),
}

/// Answers a sweep or a time of impact by stepping.
pub(crate) fn advance<T: Tracer>(
    query: &Query,
    flavor: Flavor,
    name: &'static str,
    tracer: &mut T,
) -> Impact {
    let Some(b) = query.b else {
        return Impact { outcome: Outcome::Miss, tolerance: query.tolerance, iterations: 0 };
    };
    let a = query.a;
    let scale = scale_of(a, b);
    let arms = match flavor {
        Flavor::RayClipping => 0.0,
        Flavor::Conservative => (arm(a) + arm(b)) * (1.0 + BOUND_ROUNDING),
    };
    let tolerance = query.tolerance.max(TOLERANCE_FLOOR * scale);
    let run = Advancement { query, a, b, flavor, v: a.velocity - b.velocity, arms, tolerance, scale };
    let (outcome, iterations) = run.run(name, tracer);
    motion::finish(query, &outcome, tracer);
    Impact { outcome, tolerance, iterations }
}

impl Advancement<'_> {
    /// Steps until a verdict, and counts the distance queries.
    fn run<T: Tracer>(&self, name: &'static str, tracer: &mut T) -> (Outcome, usize) {
        let mut t = 0.0;
        for step in 0..self.query.max_iterations {
            let at = moment(self.a, self.b, t);
            tracer.record(|| Event::Started { algorithm: name, at });
            let near = minkowski::separation(&PairView::at(self.a, self.b, t), tracer);
            let closing = self.v.dot(*near.normal);
            let bound = closing + self.arms;
            let verdict = self.verdict(t, &near, bound);
            tracer.record(|| {
                let estimate = match self.flavor {
                    Flavor::RayClipping => self.v * t,
                    Flavor::Conservative => DVec2::ZERO,
                };
                Event::Advanced {
                    step: step + 1,
                    at,
                    separation: near.separation,
                    normal: *near.normal,
                    points: near.points,
                    closest: estimate + (near.points[1] - near.points[0]),
                    estimate,
                    closing_speed: closing,
                    bound,
                    next: if let Step::To(next) = verdict { Some(next) } else { None },
                }
            });
            match verdict {
                Step::To(next) => t = next,
                Step::Done(outcome) => return (outcome, step + 1),
            }
        }
        (Outcome::Unresolved { reason: Reason::IterationLimit, free_until: t }, self.query.max_iterations)
    }

    /// What a distance query at `t` allows.
    fn verdict(&self, t: f64, near: &Separation, bound: f64) -> Step {
        if t == 0.0 && near.bounds.lo <= 0.0 {
            return Step::Done(Outcome::at_start(near));
        }
        if near.separation <= self.tolerance {
            return Step::Done(self.arrived(t, near));
        }
        let bound = bound + BOUND_ROUNDING * (self.v.x.abs() + self.v.y.abs() + self.arms);
        if bound <= 0.0 {
            return Step::Done(Outcome::Miss);
        }
        let gap = near.bounds.lo - SEPARATION_ROUNDING * self.scale;
        // t + h rounds to nearest: the double before it is surely free.
        let next = (t + gap / bound * (1.0 - BOUND_ROUNDING)).next_down();
        if next >= 1.0 {
            Step::Done(Outcome::Miss)
        } else if next <= t {
            Step::Done(Outcome::Unresolved { reason: Reason::Stalled, free_until: t })
        } else {
            Step::To(next)
        }
    }

    /// The outcome where the bodies came within the tolerance: a hit only if contact is proved a little
    /// later, or, where bodies that don't turn only graze each other, at the moment that is proved for it. A
    /// miss of those by less than the tolerance is one, if it is proved.
    fn arrived(&self, t: f64, near: &Separation) -> Outcome {
        let speed = closing_speed(self.a, self.b, t, near);
        let later = if speed > 0.0 { (t + 2.0 * self.tolerance / speed).min(1.0) } else { 1.0 };
        let hit = |hi| Outcome::Hit { time: Enclosure { lo: t, hi }, contact: *near };
        if MovingPair::new(self.a, self.b).touches_between(t, later) {
            return hit(later);
        }
        match self.is_unturned().then(|| Sweep::new(self.a, self.b).first_contact()) {
            Some(Outcome::Hit { time, .. }) if time.hi > t => hit(time.hi),
            Some(Outcome::Miss) => Outcome::Miss,
            _ => Outcome::Unresolved { reason: Reason::WithinTolerance, free_until: t },
        }
    }

    /// Whether neither body turns.
    fn is_unturned(&self) -> bool {
        self.a.spin.is_zero() && self.b.spin.is_zero()
    }
}

/// How fast the witness points close along the normal, in world units per unit of time.
///
/// It is −ds/dt as long as the same features face each other.
fn closing_speed(a: &Body, b: &Body, t: f64, near: &Separation) -> f64 {
    let at = |body: &Body, p: DVec2| {
        body.velocity + perp(p - (body.position + body.velocity * t)) * body.spin.radians()
    };
    (at(a, near.points[0]) - at(b, near.points[1])).dot(*near.normal)
}

/// r |ω| of a body: the fastest that turning brings its boundary closer, in world units per unit of time.
///
/// The disc about a core vertex is carried, not turned: it comes no closer than its centre does, so that the
/// radius never counts.
fn arm(body: &Body) -> f64 {
    let far = body.shape.vertices.iter().fold(0.0_f64, |far, v| far.max(libm::hypot(v.x, v.y)));
    far * body.shape.stretch() * body.spin.radians().abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::asking::impact;
    use crate::collision::tests::bodies::{moving, placed, polygon};

    /// The discs of figure 6: at t = 0 they are 3.75 apart along (0.8, 0.6), and close at 6.
    fn discs() -> (Body, Body) {
        let disc = |radius| polygon(&[[0.0, 0.0]], radius);
        (moving(disc(3.0), [7.5, 0.0], 0.0), placed(disc(3.25), 8.0, 6.0, 0.0))
    }

    #[test]
    fn a_step_ends_before_the_tangent_and_loses_no_more_than_its_roundings() {
        let (a, b) = discs();
        let (_, trace) = impact("ray-clipping", &a, &b, 1e-9);
        let first = trace.events.iter().find_map(|event| match event {
            Event::Advanced { next, .. } => *next,
            _ => None,
        });
        let short = (0.625 - first.unwrap()) / (0.625 * f64::EPSILON);
        // Of the step: 16 |v|₁ / 6 and 16 by the bound, 8 S / 3.75 with S = 4 by the separation. Ten times
        // one of the two constants would make it more than 120.
        assert!(short > 0.0 && short < 60.0, "{short} ε");
    }

    #[test]
    fn discs_that_graze_are_a_hit_though_no_moment_is_inside() {
        let disc = |x, y| placed(polygon(&[[0.0, 0.0]], 1.0), x, y, 0.0);
        for v in [[2.0, 0.0], [8.0, 0.0]] {
            let (a, b) = (moving(disc(-1.0, -1.0), v, 0.0), disc(0.0, 1.0));
            for name in ["ray-clipping", "conservative-advancement"] {
                let (found, _) = impact(name, &a, &b, 1e-12);
                let Outcome::Hit { time, .. } = found.outcome else { panic!("{name}: {found:?}") };
                let touch = 1.0 / v[0];
                assert!(time.lo < touch && touch <= time.hi && time.hi - touch < 1e-15, "{name}: {time:?}");
            }
        }
    }

    #[test]
    fn boxes_that_miss_each_other_by_the_last_bit_miss() {
        let square = polygon(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.0);
        let b = placed(square.clone(), 4.0, 0.0, 0.0);
        for (y, word) in [(2.0, "hit"), (2.0_f64.next_up(), "miss")] {
            let a = Body { position: DVec2::new(0.0, y), ..moving(square.clone(), [3.0, 0.0], 0.0) };
            for name in ["ray-clipping", "conservative-advancement"] {
                assert_eq!(impact(name, &a, &b, 1e-12).0.outcome.word(), word, "{name} at {y}");
            }
        }
    }

    #[test]
    fn the_least_tolerance_is_what_plain_doubles_can_tell_and_is_enough_for_a_hit() {
        let (a, b) = discs();
        let (found, _) = impact("ray-clipping", &a, &b, 0.0);
        assert!(found.tolerance > 0.0 && found.tolerance < 100.0 * f64::EPSILON, "{found:?}");
        assert_eq!(found.outcome.word(), "hit", "{found:?}");
    }
}
