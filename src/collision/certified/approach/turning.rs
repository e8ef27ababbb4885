//! The closest approach of two bodies of which one turns: the best moment that is found, and a proof that no
//! other is much better.
//!
//! Bodies that are L apart at all times are bodies that do not touch when their radii are grown by L. So a
//! lower bound of the separation is proved as a miss is: by axes, followed one after the other, each as long
//! as the grown bodies stay apart along it ([`crate::collision::certified::impact`]). L is the least
//! separation found so far, less a margin. Where the grown bodies are about to touch, the separation is less
//! than L: from there a better moment is looked for, and the walk begins again.
//!
//! Work is counted. Where it does not do for the narrowest margin (each axis of two discs that turn side by
//! side lasts for the root of it), a wider one is taken; what is proved holds whatever was found. Before
//! that, moments as dense as the bodies turn are looked at, and a bound is always left that needs no walk:
//! however a body turns, it stays within the circle about its origin that reaches as far.

use crate::collision::answer::Separation;
use crate::collision::certified::approach::least::least;
use crate::collision::certified::approach::straight;
use crate::collision::certified::impact::MovingPair;
use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::closest::{closest_features, separation_at};
use crate::collision::certified::impact::gap::Precision;
use crate::collision::feature::{DifferenceFeature, a_then_b};
use crate::geometry::{Angle, Body, Dd, Shape, Side};

/// Moments besides the start at which the separation is looked at first. Each minimum that they miss costs
/// another walk.
const SAMPLES: f64 = 4.0;

/// Moments for each radian that the bodies turn, and how many at most, where the work did not do for a proof:
/// a body of four vertices has a minimum in each 1.6.
const DENSE: f64 = 16.0;
/// At most so many.
const MOST_DENSE: f64 = 4096.0;

/// How exactly the moment is looked for, in radians of turning and in parts of the motion: the separation is
/// off by half of its square times the reach, about a rounding.
const MOMENT: f64 = 1e-8;

/// Margins between the separation found and the one that is proved, as parts of the pair's size: 1.5e-11,
/// 2.3e-10, 6e-8, 1.5e-5 and 4e-3. The first is wide enough for doubles, and for axes that last.
const MARGINS: [f64; 5] = [power(36), power(32), power(24), power(16), power(8)];

/// Parts of the separation found that are tried where no margin can be proved.
const PARTS: [f64; 3] = [0.5, 0.25, 0.0625];

/// First step towards a better moment, in radians of turning and in parts of the motion; each is twice the
/// one before.
const FIRST_STEP: f64 = 1e-4;

/// Better moments that a walk may lead to.
const BETTER_MOMENTS: usize = 32;

/// Work in vertices looked at, of some 20 ns each, and distance queries that it brings besides: a pair that
/// turns ten times takes a tenth of it.
const WORK: usize = 1 << 17;
/// Distance queries, each of which looks at every vertex.
const QUERIES: usize = 1 << 9;

/// When the bodies are closest, as far as is found, how they stand then, and a proved lower bound of their
/// separation at any time in [0, 1]; lengths in world units.
pub(crate) fn closest(pair: &MovingPair) -> (f64, Separation, f64) {
    let mut approach = Approach::sampled(pair);
    let level = approach.proved_level();
    let [a, b] = pair.bodies;
    let at = |time: f64| (time, separation_at(a, b, time, closest_features(pair, time).0));
    // What a search leaves of the start or the end is no moment of its own.
    let ends = [at(0.0), at(approach.best.time), at(1.0)].into_iter();
    let nearer = |p: (f64, Separation), q: (f64, Separation)| {
        if q.1.separation < p.1.separation { q } else { p }
    };
    let (time, contact) = ends.reduce(nearer).unwrap_or_else(|| at(0.0));
    // The radii are grown by this and what their sum may have lost to rounding.
    let slack = Dd::ROUNDING * (pair.radius.hi + level);
    let proved = ((level - slack) / pair.unit).next_down();
    let is_wide = contact.bounds.hi - proved > MARGINS[1] * pair.size() / pair.unit;
    let least = if is_wide { proved.max(between_circles(a, b)) } else { proved };
    (time, contact, least)
}

/// A lower bound of the separation at any time in [0, 1], world units, however the bodies turn: that of what
/// does not turn, and of circles about the origins of those that do.
fn between_circles(a: &Body, b: &Body) -> f64 {
    let mut still = [a.clone(), b.clone()];
    for body in still.iter_mut().filter(|body| body.turns()) {
        // Its reach is known to a few roundings.
        let reach = (body.shape.hull.reach + body.shape.radius) * (1.0 + 8.0 * f64::EPSILON);
        let Ok(circle) = Shape::circle(reach) else { return f64::NEG_INFINITY };
        (body.shape, body.spin) = (circle, Angle::Degrees(0.0));
    }
    straight::closest(&still[0], &still[1]).2
}

/// A moment and the separation then, in doubles and scaled.
#[derive(Clone, Copy, Debug)]
struct Closest {
    /// The moment.
    time: f64,
    /// The separation.
    separation: f64,
}

/// A search for the least separation.
struct Approach<'p, 'q> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// The closest that was found.
    best: Closest,
    /// Vertices that may still be looked at.
    left: usize,
    /// Whether moments have been looked at as dense as the bodies turn.
    is_dense: bool,
}

/// How a walk from t = 0 along axes ends.
enum Walk {
    /// The grown bodies stay apart.
    Apart,
    /// They are about to touch at this moment.
    Nearer(f64),
    /// Its share of the work is done.
    Spent,
}

impl<'p, 'q> Approach<'p, 'q> {
    /// The search after a first look.
    fn sampled(pair: &'p MovingPair<'q>) -> Self {
        let left = WORK + QUERIES * vertices(pair);
        let best = Closest { time: 0.0, separation: f64::INFINITY };
        let mut approach = Self { pair, best, left, is_dense: false };
        approach.look_evenly(SAMPLES);
        approach
    }

    /// A look at the start and so many moments after it, and at what is about the nearest of them.
    fn look_evenly(&mut self, count: f64) {
        let (mut k, mut nearest) = (0.0, None);
        while k <= count {
            if self.offer(self.look(k / count)) {
                nearest = Some(k);
            }
            k += 1.0;
        }
        if let Some(k) = nearest {
            self.descend([k - 1.0, k + 1.0].map(|k| (k / count).clamp(0.0, 1.0)));
        }
    }

    /// A look at moments as dense as the bodies turn, with a quarter of the work that is left: once.
    fn look_densely(&mut self) {
        if !self.is_dense {
            self.is_dense = true;
            let turned = self.pair.rate[0].abs() + self.pair.rate[1].abs();
            let affordable =
                u32::try_from(self.left / 4 / vertices(self.pair).max(1)).map_or(MOST_DENSE, f64::from);
            self.look_evenly((DENSE * turned).min(MOST_DENSE).min(affordable).floor().max(SAMPLES));
        }
    }

    /// The separation at a moment, in doubles; never less than the least, but for rounding.
    fn look(&self, time: f64) -> Closest {
        let (near, distance) = closest_features(self.pair, time);
        let mut separation = distance - self.pair.radius.hi;
        // They never touch: on the line of a segment the features were guessed wrong.
        if separation <= self.pair.rounding {
            let [a, b] = self.pair.bodies;
            separation = separation_at(a, b, time, near).separation * self.pair.unit;
        }
        Closest { time, separation }
    }

    /// Takes a moment if the bodies are closer then.
    fn offer(&mut self, found: Closest) -> bool {
        self.left = self.left.saturating_sub(vertices(self.pair));
        let better = found.separation < self.best.separation;
        if better {
            self.best = found;
        }
        better
    }

    /// Looks for the closest moment in an interval.
    fn descend(&mut self, within: [f64; 2]) {
        let rates = self.pair.rate[0].abs() + self.pair.rate[1].abs();
        let (time, _) = least(|t| self.look(t).separation, within, MOMENT / (1.0 + rates));
        self.offer(self.look(time));
    }

    /// The largest separation that is proved of all moments, scaled; 0 where none is.
    fn proved_level(&mut self) -> f64 {
        let size = self.pair.size();
        for margin in MARGINS {
            for _ in 0..BETTER_MOMENTS {
                let (level, before) = (self.best.separation - margin * size, self.best);
                if level <= 0.0 {
                    break;
                }
                match self.walk(level) {
                    Walk::Apart => return level,
                    Walk::Spent => break,
                    Walk::Nearer(t) => self.descend_from(t),
                }
                if self.best.separation >= before.separation {
                    break;
                }
            }
            self.look_densely();
        }
        let parts = PARTS.map(|part| part * self.best.separation);
        parts.into_iter().find(|&level| matches!(self.walk(level), Walk::Apart)).unwrap_or(0.0)
    }

    /// Looks for the closest moment after `t`, at which the separation is less than the least that was found
    /// before: where it first rises again.
    fn descend_from(&mut self, t: f64) {
        let rates = self.pair.rate[0].abs() + self.pair.rate[1].abs();
        let mut step = FIRST_STEP / (1.0 + rates);
        let (mut before, mut last) = (t, self.look(t));
        self.offer(last);
        while last.time < 1.0 {
            let next = self.look((last.time + step).min(1.0));
            self.offer(next);
            if next.separation >= last.separation {
                self.descend([before, next.time]);
                return;
            }
            (before, last, step) = (last.time, next, 2.0 * step);
        }
    }

    /// Walks along axes while the bodies, grown by `level`, stay apart; with half of the work that is left.
    fn walk(&mut self, level: f64) -> Walk {
        let pair = self.pair.grown(level);
        let reserve = self.left / 2;
        let mut t = 0.0;
        loop {
            let (near, _) = closest_features(&pair, t);
            self.left = self.left.saturating_sub(vertices(&pair));
            let mut until = self.follow(&pair, axes(&pair, near, t), t, reserve);
            if until <= t {
                until = self.follow(&pair, self.axis_along_normal(level, near, t), t, reserve);
            }
            if until >= 1.0 {
                return Walk::Apart;
            } else if until <= t {
                return Walk::Nearer(t);
            } else if self.left <= reserve {
                return Walk::Spent;
            }
            t = until;
        }
    }

    /// Follows axes from `t` on, with all but a reserve of the work that is left; until when the longest of
    /// them lasts.
    fn follow<const N: usize>(
        &mut self,
        pair: &MovingPair,
        axes: [Option<Axis>; N],
        t: f64,
        reserve: usize,
    ) -> f64 {
        axes.into_iter().flatten().fold(t, |until, axis| {
            let most = self.left.saturating_sub(reserve);
            let followed = axis.follow(pair, t, Precision::Doubles, most);
            self.left = self.left.saturating_sub(followed.work);
            until.max(followed.until)
        })
    }

    /// The axis along the proved normal at `t`, where the bodies are farther apart then than `level`: the
    /// guess of their closest features was wrong.
    fn axis_along_normal(&self, level: f64, near: DifferenceFeature, t: f64) -> [Option<Axis>; 1] {
        let [a, b] = self.pair.bodies;
        let proved = separation_at(a, b, t, near);
        let is_apart = proved.bounds.lo * self.pair.unit > level + self.pair.rounding;
        [is_apart.then(|| Axis::along(self.pair, *proved.normal, t)).flatten()]
    }
}

/// The axes that may separate a pair for a while from `t` on: those through its closest features, and where
/// these are two vertices, fixed in either body.
fn axes(pair: &MovingPair, near: DifferenceFeature, t: f64) -> [Option<Axis>; 3] {
    let through = Axis::through(pair, near, t);
    let DifferenceFeature::Vertex([a, b]) = near else { return [through, None, None] };
    let owner = pair.slower_turning().other();
    let [own, facing] = a_then_b(owner, a, b);
    let pose = pair.relative_pose(owner, t, &pair.rotations(owner, t));
    let apart = pose.point(pair.vertex(owner.other(), facing)) - pair.vertex(owner, own);
    let other = Axis::new(pair, owner, apart).map(|axis| Axis { facing, ..axis });
    [through, other, Axis::ahead(pair, near, t)]
}

/// The power of two 2⁻ᵏ.
const fn power(k: u64) -> f64 {
    f64::from_bits((1023 - k) << 52)
}

/// How many vertices a distance query looks at.
fn vertices(pair: &MovingPair) -> usize {
    pair.hull(Side::A).vertices.len() + pair.hull(Side::B).vertices.len()
}
