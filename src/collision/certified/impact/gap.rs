//! The gap of a moving pair along an axis that turns with one of the bodies: how wide it is at a moment, how
//! fast it closes, and how long it surely stays open.
//!
//! Let R own the axis n (a unit vector in R's frame), O be the other body. With D = `c_O` − `c_R`, V = `v_O`
//! − `v_R`, Δω = `ω_O` − `ω_R`, h = max n·q over R's core, `n_w` = n in the world, `x_j` = O's vertex j
//! turned into R's frame, and perp(a) = (−`a_y`, `a_x`):
//!
//! ```text
//! f_j   = n_w·D + n·x_j − h − ρ                       ρ = r_A + r_B
//! f_j'  = ω_R perp(n_w)·D + n_w·V + Δω n·perp(x_j)
//! f_j'' = −ω_R² n_w·D + 2 ω_R perp(n_w)·V − Δω² n·x_j
//! |f_j'''| ≤ |ω_R|³ |D| + 3 ω_R² |V| + |Δω|³ |q_j|
//! ```
//!
//! since `n_w`' = `ω_R` perp(`n_w`), `x_j`' = Δω perp(`x_j`) and perp(perp(a)) = −a. The least `f_j` is the
//! gap along n, and a gap along any axis is a lower bound of the separation: while every `f_j` is positive,
//! nothing touches. However O turns, n·`x_j` ≥ −(its reach), which gives one more lower bound, of any number
//! of turns.
//!
//! The Taylor polynomial of `f_j`, less the bound on the third derivative, says how long it stays positive.
//! The least of all values is the gap along the axis, the shortest of all times how long nothing touches.
//! Only vertices low enough to come first within that time are looked at.

use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::certified::impact::taylor::{Taylor, positive_until};
use crate::collision::certified::rounding::DERIVATIVE_ERROR;
use crate::geometry::{Ball, DVec2, Hull, Side, perp};

/// How precisely a gap is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    /// In doubles, less the bound on their rounding.
    Doubles,
    /// In balls where doubles leave the gap within a few roundings of 0.
    Balls,
}

/// The gap along an axis at a moment, as far as it is proved.
pub(crate) struct Gap {
    /// Lower bound of the gap, in scaled units.
    pub(crate) least: f64,
    /// Lower bound of the rate at which it changes, scaled units per unit of time.
    pub(crate) slope: f64,
    /// How long after the moment it is proved to stay open.
    pub(crate) ahead: f64,
    /// What it took to find it, in vertices looked at in doubles.
    pub(crate) work: usize,
}

/// Work of a moment besides its vertices: cosines, sines and what all vertices share take about as long as
/// eight vertices.
const WORK_OF_MOMENT: usize = 8;

/// How many times as long balls take.
const WORK_OF_BALLS: usize = 16;

/// A gap in doubles below this many roundings is evaluated again in balls, where asked for. Half costs 1 %
/// more balls, twice changes nothing.
const BALLS_BELOW: f64 = 32.0;

impl Axis {
    /// The gap at `t`. The search for the lowest vertex of the other body starts at `lowest`, which becomes
    /// that vertex.
    pub(crate) fn gap(&self, pair: &MovingPair, t: f64, precision: Precision, lowest: &mut usize) -> Gap {
        let (owner, other) = (self.owner, self.owner.other());
        let rotations = pair.rotations(owner, t);
        let (d, v) = pair.offset(owner, t);
        let common = Common::new(pair, self, t, (rotations.seen_by_owner(d), rotations.seen_by_owner(v)));
        // However the other body turns, none of its vertices is farther down than its reach.
        let circle = common.circle(pair.reach[other as usize] + pair.rounding);
        let whatever =
            if common.spin != 0.0 && circle.value > 0.0 { positive_until(circle, 1.0 - t) } else { 0.0 };
        let mut look = Look {
            pair,
            other,
            down: rotations.relative.undo(self.n),
            common,
            balls: (precision == Precision::Balls).then(|| BallGap::new(pair, self, t)),
            gap: Gap { least: f64::INFINITY, slope: 0.0, ahead: 1.0 - t, work: WORK_OF_MOMENT },
        };
        if precision == Precision::Balls {
            look.gap.work *= WORK_OF_BALLS;
        }
        look.from(lowest);
        Gap { ahead: look.gap.ahead.max(whatever), ..look.gap }
    }

    /// Whether the axis separates at `t`.
    pub(crate) fn separates(&self, pair: &MovingPair, t: f64) -> bool {
        self.gap(pair, t, Precision::Balls, &mut 0).least > 0.0
    }
}

/// A look at the vertices of the other body at a moment.
struct Look<'p, 'q> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// The body whose vertices are looked at: O.
    other: Side,
    /// n in O's frame, along which its lowest vertex is closest.
    down: DVec2,
    /// What all vertices share.
    common: Common,
    /// The gap in balls, where asked for.
    balls: Option<BallGap>,
    /// The gap of the vertices looked at so far.
    gap: Gap,
}

impl Look<'_, '_> {
    /// How high a vertex of O is along the axis: n·x.
    fn height(&self, k: usize) -> f64 {
        self.down.dot(self.pair.vertex(self.other, k))
    }

    /// Looks at every vertex that matters, from the lowest upward both ways round.
    ///
    /// Heights along the axis fall to one minimum around a convex core: what is too high to matter ends the
    /// look.
    fn from(&mut self, lowest: &mut usize) {
        let hull = self.pair.hull(self.other);
        let mut heights = 0;
        *lowest = descend(hull, *lowest, |k| {
            heights += 1;
            self.height(k)
        });
        self.gap.work += heights;
        self.at(*lowest);
        let fall = self.common.fall(self.pair.reach[self.other as usize], self.gap.ahead);
        let too_high = self.height(*lowest).max(fall - self.common.value) + 2.0 * self.pair.rounding;
        let mut left = hull.vertices.len() - 1;
        for step in [Hull::next as fn(&Hull, usize) -> usize, Hull::previous] {
            let mut k = step(hull, *lowest);
            while left > 0 && self.height(k) <= too_high {
                self.at(k);
                k = step(hull, k);
                left -= 1;
            }
        }
    }

    /// Looks at one vertex.
    fn at(&mut self, k: usize) {
        let (q, along, spin) = (self.pair.vertex(self.other, k), self.height(k), self.common.spin);
        let mut taylor = self.common.taylor(self.common.value + along, spin * perp(q).dot(self.down), along);
        taylor.value -= self.pair.rounding;
        self.gap.work += 1;
        if let Some(balls) = &self.balls
            && taylor.value < BALLS_BELOW * self.pair.rounding
        {
            taylor.value = taylor.value.max(balls.lower(&self.pair.vertex_in_balls(self.other, k)));
            self.gap.work += WORK_OF_BALLS;
        }
        let gap = &mut self.gap;
        if taylor.value < gap.least {
            (gap.least, gap.slope) = (taylor.value, taylor.slope);
        }
        if taylor.value <= 0.0 {
            gap.ahead = 0.0;
        } else if !taylor.stays_positive(gap.ahead) {
            gap.ahead = positive_until(taylor, gap.ahead);
        }
    }
}

/// The parts of a gap in balls that do not depend on the vertex.
struct BallGap {
    /// The axis in O's frame.
    down: [Ball; 2],
    /// The gap but for n·x: `n_w·D − h − ρ`.
    rest: Ball,
}

impl BallGap {
    fn new(pair: &MovingPair, axis: &Axis, t: f64) -> Self {
        let n = axis.n;
        let pose = pair.relative_pose_in_balls(axis.owner, t);
        // The length of n may exceed 1 by rounding: ρ |n| ≤ ρ (1 + 2ε) exactly, so that ρ is scaled by the
        // exact length.
        let length = (Ball::product(n.x, n.x) + Ball::product(n.y, n.y)).sqrt();
        let rest = pose.offset[0].scale(n.x) + pose.offset[1].scale(n.y)
            - support_in_balls(pair, axis)
            - Ball::exact(pair.radius) * length;
        Self { down: pose.rotation.undo([Ball::new(n.x), Ball::new(n.y)]), rest }
    }

    /// Lower bound of the gap at vertex q.
    fn lower(&self, q: &[Ball; 2]) -> f64 {
        (self.rest + self.down[0] * q[0] + self.down[1] * q[1]).enclosure().lo
    }
}

/// h in balls: the greatest of the owner's vertices that doubles can't tell apart.
fn support_in_balls(pair: &MovingPair, axis: &Axis) -> Ball {
    let n = axis.n;
    let all = pair.vertices(axis.owner).enumerate();
    let candidates = all.filter(|(_, q)| n.dot(*q) >= axis.support - pair.rounding);
    let heights = candidates.map(|(k, _)| {
        let [x, y] = pair.vertex_in_balls(axis.owner, k);
        x.scale(n.x) + y.scale(n.y)
    });
    // |max(x, y) − max(x', y')| ≤ max(|x − x'|, |y − y'|)
    let greatest = heights.reduce(|x, y| {
        let greater = if (x.value - y.value).hi >= 0.0 { x.value } else { y.value };
        Ball::within(greater, x.radius.max(y.radius))
    });
    greatest.unwrap_or(Ball::ZERO)
}

/// What all vertices share in the derivatives at a moment.
struct Common {
    /// The gap but for n·x: `n_w·D − h − ρ`.
    value: f64,
    /// The rate of the gap but for O's turning, less its rounding: `ω_R perp(n_w)·D + n_w·V`.
    slope: f64,
    /// The second derivative but for O's turning, less its rounding: `−ω_R² n_w·D + 2 ω_R perp(n_w)·V`.
    curvature: f64,
    /// Bound on the third but for O's turning, over the rest of the motion: `|ω_R|³ |D| + 3 ω_R² |V|`.
    third: f64,
    /// How fast O turns in R's frame: Δω.
    spin: f64,
    /// Bound on what O's turning adds to the third derivative: |Δω|³ times O's reach.
    third_of_turning: f64,
    /// Rounding of the parts that turning contributes to f' and f''.
    turning_rounding: [f64; 2],
}

impl Common {
    fn new(pair: &MovingPair, axis: &Axis, t: f64, (d, v): (DVec2, DVec2)) -> Self {
        let n = axis.n;
        let omega = pair.rate[axis.owner as usize];
        let rates = omega.abs() + pair.rate[axis.owner.other() as usize].abs();
        let spin = pair.rate[axis.owner.other() as usize] - omega;
        let w = omega.abs();
        let reach = pair.reach[axis.owner.other() as usize];
        let one_norm = |a: DVec2| a.x.abs() + a.y.abs();
        let (d1, v1) = (one_norm(d), one_norm(v));
        let far = d1 + v1 * (1.0 - t);
        let up = 1.0 + DERIVATIVE_ERROR;
        Self {
            value: n.dot(d) - axis.support - pair.radius.hi,
            slope: omega * perp(n).dot(d) + n.dot(v) - DERIVATIVE_ERROR * (w * d1 + v1),
            curvature: -w * w * n.dot(d) + 2.0 * omega * perp(n).dot(v)
                - DERIVATIVE_ERROR * (w * w * d1 + 2.0 * w * v1),
            third: (w * w * w * far + 3.0 * w * w * v1) * up,
            spin,
            third_of_turning: rates_cubed(spin, rates) * reach * up,
            turning_rounding: [
                2.0 * DERIVATIVE_ERROR * rates * reach,
                2.0 * DERIVATIVE_ERROR * rates * rates * reach,
            ],
        }
    }

    /// The Taylor polynomial at a vertex with n·x and Δω n·perp(x) given.
    fn taylor(&self, value: f64, turning: f64, along: f64) -> Taylor {
        Taylor {
            value,
            slope: self.slope + turning - self.turning_rounding[0],
            curvature: self.curvature - self.spin * self.spin * along - self.turning_rounding[1],
            third: self.third + self.third_of_turning,
        }
    }

    /// Bound on how far any vertex's gap falls within `h`.
    fn fall(&self, reach: f64, h: f64) -> f64 {
        let slope = self.slope - self.spin.abs() * reach - self.turning_rounding[0];
        let curvature = self.curvature - self.spin * self.spin * reach - self.turning_rounding[1];
        let third = self.third + self.third_of_turning;
        let fall = (-slope).max(0.0) + h * (0.5 * (-curvature).max(0.0) + h * third / 6.0);
        h * fall * (1.0 + DERIVATIVE_ERROR)
    }

    /// The polynomial of `n_w·D − h − ρ − reach`, in which the other body's turning does not occur.
    fn circle(&self, reach: f64) -> Taylor {
        Taylor { value: self.value - reach, slope: self.slope, curvature: self.curvature, third: self.third }
    }
}

/// The core vertex with the least `height`, from one near it.
fn descend(hull: &Hull, start: usize, mut height: impl FnMut(usize) -> f64) -> usize {
    let mut at = start;
    let mut least = height(at);
    for step in [Hull::next as fn(&Hull, usize) -> usize, Hull::previous] {
        for _ in 1..hull.vertices.len() {
            let k = step(hull, at);
            let lower = height(k);
            if lower >= least {
                break;
            }
            (at, least) = (k, lower);
        }
    }
    at
}

/// At least |Δω|³, where Δω is a rounded difference of rates whose magnitudes sum to `rates`.
fn rates_cubed(spin: f64, rates: f64) -> f64 {
    let w = spin.abs() + DERIVATIVE_ERROR * rates;
    w * w * w
}
