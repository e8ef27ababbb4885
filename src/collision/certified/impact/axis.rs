//! The gap of a moving pair along an axis that turns with one of the bodies, and how long it stays open.
//!
//! Let R own the axis n (a unit vector in R's frame), O be the other body. With D = `c_O` − `c_R`, V = `v_O` − `v_R`,
//! Δω = `ω_O` − `ω_R`, h = max n·q over R's core, `n_w` = n in the world, `x_j` = O's vertex j turned into R's frame, and
//! perp(a) = (−`a_y`, `a_x`):
//!
//! ```text
//! f_j   = n_w·D + n·x_j − h − ρ                       ρ = r_A + r_B
//! f_j'  = ω_R perp(n_w)·D + n_w·V + Δω n·perp(x_j)
//! f_j'' = −ω_R² n_w·D + 2 ω_R perp(n_w)·V − Δω² n·x_j
//! |f_j'''| ≤ |ω_R|³ |D| + 3 ω_R² |V| + |Δω|³ |q_j|
//! ```
//!
//! since `n_w`' = `ω_R` perp(`n_w`), `x_j`' = Δω perp(`x_j`) and perp(perp(a)) = −a. The least `f_j` is the gap along n, and a gap along
//! any axis is a lower bound of the separation: while every `f_j` is positive, nothing touches. However O turns,
//! n·`x_j` ≥ −(its reach), which gives one more lower bound, of any number of turns.

use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::certified::impact::taylor::{Taylor, positive_until};
use crate::collision::certified::rounding::DERIVATIVE_ERROR;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{Ball, DVec2, Hull, Side, perp};

/// An axis fixed in the frame of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    /// R.
    pub(crate) owner: Side,
    /// n, from R to O, of length 1 but for rounding.
    pub(crate) n: DVec2,
    /// h, in doubles.
    pub(crate) support: f64,
    /// A vertex of R that is highest along n, or near it.
    pub(crate) own: usize,
    /// A vertex of O that is lowest along n, or nearly so: where to look first.
    pub(crate) facing: usize,
    /// The owner's edge that it is square to, if any.
    pub(crate) edge: Option<usize>,
}

/// An axis that is proved to separate the bodies over a span of time: a link of the certificate that nothing touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AxisSpan {
    /// The axis.
    pub(crate) axis: Axis,
    /// Start of the span.
    pub(crate) from: f64,
    /// End of the span.
    pub(crate) to: f64,
}

/// How precisely a gap is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    /// In doubles, less the bound on their rounding.
    Plain,
    /// In balls where doubles leave the gap within a few roundings of 0.
    Fine,
}

/// A time until which an axis is proved to separate, and what was left of the gap shortly before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Swept {
    /// Apart for all of [start, until].
    pub(crate) until: f64,
    /// Where the gap was evaluated last.
    pub(crate) at: f64,
    /// Lower bound of the gap there, in scaled units; at most 0 where nothing could be proved at all.
    pub(crate) gap: f64,
    /// Its rate of change there.
    pub(crate) slope: f64,
}

/// The gap at a moment, with everything that its future depends on.
struct Gap {
    /// Least `f_j`, less rounding.
    least: f64,
    /// Slope of the least.
    slope: f64,
    /// Proved time beyond the moment.
    ahead: f64,
}

/// A plain gap below this many roundings is evaluated again in balls, where asked for.
const FINE_BELOW: f64 = 32.0;

/// An axis is used up, in plain doubles, when its gap is below this many roundings.
const USED_UP: f64 = 16.0;

/// In balls, it is used up below this part of a rounding, about 2 ε·S: the derivatives are rounded in doubles, so that
/// what they could still prove are steps that move nothing by an ulp.
const EXHAUSTED: f64 = 1.0 / 64.0;

/// Evaluations along one axis before the closest features are asked for again. Convergence is cubic: six suffice unless
/// many turns are covered, where each covers about a radian.
const EVALUATIONS: usize = 4096;

impl Axis {
    /// The axis through the closest features at `t`; None where they coincide.
    pub(crate) fn through(pair: &MovingPair, near: DifferenceFeature, t: f64) -> Option<Self> {
        match near {
            DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex }) => {
                let hull = pair.hull(owner);
                let &n = hull.normals.get(edge)?;
                let support = n.dot(*hull.vertices.get(edge)?) * pair.unit;
                Some(Self { owner, n: *n, support, own: edge, facing: vertex, edge: Some(edge) })
            }
            DifferenceFeature::Vertex([a, b]) => {
                let owner = pair.calmer();
                let [own, other] = a_then_b(owner, a, b);
                let seen = pair.seen(owner, t, &pair.view(owner, t));
                let apart = seen.point(pair.vertex(owner.other(), other)) - pair.vertex(owner, own);
                Some(Self { facing: other, ..Self::new(pair, owner, apart)? })
            }
        }
    }

    /// The axis along a world direction from A to B, at `t`.
    pub(crate) fn along(pair: &MovingPair, normal: DVec2, t: f64) -> Option<Self> {
        let owner = pair.calmer();
        let n = if owner == Side::A { normal } else { -normal };
        Self::new(pair, owner, pair.view(owner, t).turned(n))
    }

    /// Where neither body turns: the axis across their relative velocity, the only one that separates a graze all along.
    /// Its direction is exact where the velocities are; its length, in [½, 1), keeps it so.
    pub(crate) fn across(pair: &MovingPair, normal: DVec2) -> Option<Self> {
        let owner = if pair.faces_the_world(Side::B) { Side::B } else { Side::A };
        let (_, v) = pair.offset(owner, 0.0);
        let (_, exponent) = libm::frexp(v.x.abs().max(v.y.abs()) * 2.0);
        let across = perp(v) * libm::ldexp(1.0, -exponent);
        let toward = if owner == Side::A { normal } else { -normal };
        let n = pair.view(owner, 0.0).turned(if across.dot(toward) < 0.0 { -across } else { across });
        let support = pair.vertices(owner).map(|q| n.dot(q)).fold(f64::NEG_INFINITY, f64::max);
        n.is_finite().then_some(Self { owner, n, support, own: 0, facing: 0, edge: None })
    }

    /// Whether the axis separates at `t`.
    pub(crate) fn separates(&self, pair: &MovingPair, t: f64) -> bool {
        self.gap(pair, t, Precision::Fine, &mut 0).least > 0.0
    }

    /// For two vertices: the axis through them when they will touch, or be closest, if they go on as they move at `t`.
    ///
    /// With p from R's vertex to O's and w = p', that is at |p + w h| = ρ, or where p + w h is shortest. The axis through
    /// them at `t` itself is a tangent to the separation and would be used up halfway to a graze, again and again.
    pub(crate) fn ahead(pair: &MovingPair, near: DifferenceFeature, t: f64) -> Option<Self> {
        let DifferenceFeature::Vertex([a, b]) = near else { return None };
        let owner = pair.calmer();
        let [own, other] = a_then_b(owner, a, b);
        let view = pair.view(owner, t);
        let seen = pair.seen(owner, t, &view);
        let q = pair.vertex(owner.other(), other);
        let p = seen.point(q) - pair.vertex(owner, own);
        let w = pair.velocity_of(owner, q, (&view, &seen));
        let (squared, along) = (w.length_squared(), p.dot(w));
        if along >= 0.0 {
            return None;
        }
        let c = p.length_squared() - pair.radius.hi * pair.radius.hi;
        let discriminant = along * along - squared * c;
        let h = if discriminant > 0.0 { c / (discriminant.sqrt() - along) } else { -along / squared };
        Some(Self { facing: other, ..Self::new(pair, owner, p + w * h)? })
    }

    /// An axis along `direction`, in the owner's frame.
    pub(crate) fn new(pair: &MovingPair, owner: Side, direction: DVec2) -> Option<Self> {
        let length = direction.length_squared().sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let n = direction / length;
        let support = pair.vertices(owner).map(|q| n.dot(q)).fold(f64::NEG_INFINITY, f64::max);
        Some(Self { owner, n, support, own: 0, facing: 0, edge: None })
    }

    /// Follows the gap from `start` until the axis is used up, or to the end of the motion.
    pub(crate) fn sweep(&self, pair: &MovingPair, start: f64, precision: Precision) -> Swept {
        let mut t = start;
        let mut swept = Swept { until: start, at: start, gap: 0.0, slope: 0.0 };
        let mut lowest = self.facing;
        let exhausted = if precision == Precision::Fine { EXHAUSTED } else { 0.0 };
        for _ in 0..EVALUATIONS {
            let gap = self.gap(pair, t, precision, &mut lowest);
            swept = Swept { until: t, at: t, gap: gap.least, slope: gap.slope };
            if t >= 1.0 || gap.least <= exhausted * pair.rounding {
                break;
            }
            // t + h rounds to nearest: the double before it is surely covered.
            let sum = t + gap.ahead;
            let next = if gap.ahead >= 1.0 - t { 1.0 } else { sum.next_down().min(1.0) };
            if next <= t {
                break;
            }
            t = next;
            swept.until = t;
            if t < 1.0 && precision == Precision::Plain && gap.least < USED_UP * pair.rounding {
                break;
            }
        }
        swept
    }

    /// The gap at `t`.
    fn gap(&self, pair: &MovingPair, t: f64, precision: Precision, lowest: &mut usize) -> Gap {
        let (owner, other) = (self.owner, self.owner.other());
        let n = self.n;
        let view = pair.view(owner, t);
        let (d, v) = pair.offset(owner, t);
        let (d, v) = (view.turned(d), view.turned(v));
        let m = view.relative.undo(n);
        let common = Common::new(pair, self, t, (d, v));
        let fine = (precision == Precision::Fine).then(|| self.fine(pair, t));
        // However the other body turns, none of its vertices is farther down than its reach.
        let circle = common.circle(pair.reach[other as usize] + pair.rounding);
        let whatever =
            if common.spin != 0.0 && circle.value > 0.0 { positive_until(circle, 1.0 - t) } else { 0.0 };
        let mut gap = Gap { least: f64::INFINITY, slope: 0.0, ahead: 1.0 - t };
        let mut look = |q: DVec2, along: f64| {
            let mut taylor = common.taylor(common.value + along, common.spin * perp(q).dot(m), along);
            taylor.value -= pair.rounding;
            if let Some(fine) = &fine
                && taylor.value < FINE_BELOW * pair.rounding
            {
                taylor.value = taylor.value.max(fine.lower(q));
            }
            if taylor.value < gap.least {
                gap.least = taylor.value;
                gap.slope = taylor.slope;
            }
            if taylor.value <= 0.0 {
                gap.ahead = 0.0;
            } else if !taylor.stays_positive(gap.ahead) {
                gap.ahead = positive_until(taylor, gap.ahead);
            }
            gap.ahead
        };
        // Heights along the axis fall to one minimum around a convex core: what is too high to matter ends the look.
        let hull = pair.hull(other);
        let height = |k: usize| m.dot(pair.vertex(other, k));
        *lowest = descend(hull, *lowest, height);
        let ahead = look(pair.vertex(other, *lowest), height(*lowest));
        let too_high = height(*lowest).max(common.fall(pair.reach[other as usize], ahead) - common.value)
            + 2.0 * pair.rounding;
        let mut left = hull.vertices.len() - 1;
        for step in [Hull::next as fn(&Hull, usize) -> usize, Hull::previous] {
            let mut k = step(hull, *lowest);
            while left > 0 && height(k) <= too_high {
                look(pair.vertex(other, k), height(k));
                k = step(hull, k);
                left -= 1;
            }
        }
        gap.ahead = gap.ahead.max(whatever);
        gap
    }

    /// The gap at `t` in balls, but for the vertex.
    fn fine(&self, pair: &MovingPair, t: f64) -> FineGap {
        let n = self.n;
        let seen = pair.seen_fine(self.owner, t);
        let m = seen.rotation.undo([Ball::new(n.x), Ball::new(n.y)]);
        let support = self.fine_support(pair);
        // |n| may exceed 1 by rounding: ρ |n| ≤ ρ (1 + 2ε) in exact terms, so ρ is scaled by the exact length.
        let length = (Ball::product(n.x, n.x) + Ball::product(n.y, n.y)).sqrt();
        let rest = seen.offset[0].scale(n.x) + seen.offset[1].scale(n.y)
            - support
            - Ball::exact(pair.radius) * length;
        FineGap { m, rest }
    }

    /// h in balls: the greatest of the vertices that doubles can't tell apart.
    fn fine_support(&self, pair: &MovingPair) -> Ball {
        let mut best: Option<Ball> = None;
        for q in pair.vertices(self.owner) {
            if self.n.dot(q) < self.support - pair.rounding {
                continue;
            }
            let along = Ball::product(self.n.x, q.x) + Ball::product(self.n.y, q.y);
            // |max(x, y) − max(x', y')| ≤ max(|x − x'|, |y − y'|)
            best = Some(match best {
                Some(b) => {
                    let greater = if (b.value - along.value).hi >= 0.0 { b.value } else { along.value };
                    Ball::within(greater, b.radius.max(along.radius))
                }
                None => along,
            });
        }
        best.unwrap_or(Ball::ZERO)
    }
}

/// The parts of a gap in balls that do not depend on the vertex.
struct FineGap {
    /// n in O's frame.
    m: [Ball; 2],
    /// `n_w·D − h − ρ`.
    rest: Ball,
}

impl FineGap {
    /// Lower bound of the gap at vertex q.
    fn lower(&self, q: DVec2) -> f64 {
        (self.rest + self.m[0].scale(q.x) + self.m[1].scale(q.y)).enclosure().lo
    }
}

/// What all vertices share in the derivatives at a moment.
struct Common {
    /// `n_w·D − h − ρ`.
    value: f64,
    /// `ω_R perp(n_w)·D + n_w·V`, less its rounding.
    slope: f64,
    /// `−ω_R² n_w·D + 2 ω_R perp(n_w)·V`, less its rounding.
    curvature: f64,
    /// `|ω_R|³ |D| + 3 ω_R² |V|`, over the rest of the motion.
    third: f64,
    /// Δω.
    spin: f64,
    /// |Δω|³ times the reach.
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
fn descend(hull: &Hull, start: usize, height: impl Fn(usize) -> f64) -> usize {
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
