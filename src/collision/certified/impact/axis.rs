//! The gap of a moving pair along an axis that turns with one of the bodies, and how long it stays open.
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

use crate::collision::certified::impact::gap::Precision;
use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{DVec2, Side, perp};

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

/// An axis that is proved to separate the bodies over a span of time: a link of the certificate that nothing
/// touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AxisSpan {
    /// The axis.
    pub(crate) axis: Axis,
    /// Start of the span.
    pub(crate) from: f64,
    /// End of the span.
    pub(crate) to: f64,
}

/// An axis that was followed from some moment on: until when it is proved to separate, and what was left of
/// the gap shortly before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Followed {
    /// The axis.
    pub(crate) axis: Axis,
    /// Apart from that moment to this one.
    pub(crate) until: f64,
    /// Where the gap was evaluated last.
    pub(crate) at: f64,
    /// Lower bound of the gap there, in scaled units; at most 0 where nothing could be proved at all.
    pub(crate) gap: f64,
    /// Its rate of change there.
    pub(crate) slope: f64,
}

/// An axis is used up, in doubles, when its gap is below this many roundings. Half costs 0.3 % more gaps,
/// twice saves 0.4 % and would ask for balls sooner.
const USED_UP: f64 = 16.0;

/// An axis is used up, in balls, when its gap is below this part of a rounding, about 2 ε·S: the derivatives
/// are rounded in doubles, so that what they could still prove are steps that move nothing by an ulp. Neither
/// half nor twice is noticed.
const EXHAUSTED: f64 = 1.0 / 64.0;

/// Evaluations along one axis before the closest features are asked for again: a guard. Convergence is cubic:
/// six suffice unless many turns are covered, where each covers about a radian.
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
                let owner = pair.slower_turning();
                let [own, other] = a_then_b(owner, a, b);
                let pose = pair.relative_pose(owner, t, &pair.rotations(owner, t));
                let apart = pose.point(pair.vertex(owner.other(), other)) - pair.vertex(owner, own);
                Some(Self { facing: other, ..Self::new(pair, owner, apart)? })
            }
        }
    }

    /// The axis along a world direction from A to B, at `t`.
    pub(crate) fn along(pair: &MovingPair, normal: DVec2, t: f64) -> Option<Self> {
        let owner = pair.slower_turning();
        let n = if owner == Side::A { normal } else { -normal };
        Self::new(pair, owner, pair.rotations(owner, t).seen_by_owner(n))
    }

    /// Where neither body turns: the axis across their relative velocity, the only one that separates a graze
    /// all along. Its direction is exact where the velocities are; its length, in [½, 1), keeps it so.
    pub(crate) fn across(pair: &MovingPair, normal: DVec2) -> Option<Self> {
        let owner = if pair.is_never_turned(Side::B) { Side::B } else { Side::A };
        let (_, v) = pair.offset(owner, 0.0);
        let (_, exponent) = libm::frexp(v.x.abs().max(v.y.abs()) * 2.0);
        let across = perp(v) * libm::ldexp(1.0, -exponent);
        let toward = if owner == Side::A { normal } else { -normal };
        let n =
            pair.rotations(owner, 0.0).seen_by_owner(if across.dot(toward) < 0.0 { -across } else { across });
        let support = pair.vertices(owner).map(|q| n.dot(q)).fold(f64::NEG_INFINITY, f64::max);
        n.is_finite().then_some(Self { owner, n, support, own: 0, facing: 0, edge: None })
    }

    /// Whether the axis separates at `t`.
    pub(crate) fn separates(&self, pair: &MovingPair, t: f64) -> bool {
        self.gap(pair, t, Precision::Balls, &mut 0).least > 0.0
    }

    /// For two vertices: the axis through them when they will touch, or be closest, if they go on as they
    /// move at `t`.
    ///
    /// With p from R's vertex to O's and w = p', that is at |p + w h| = ρ, or where p + w h is shortest. The
    /// axis through them at `t` itself is a tangent to the separation and would be used up halfway to a
    /// graze, again and again.
    pub(crate) fn ahead(pair: &MovingPair, near: DifferenceFeature, t: f64) -> Option<Self> {
        let DifferenceFeature::Vertex([a, b]) = near else { return None };
        let owner = pair.slower_turning();
        let [own, other] = a_then_b(owner, a, b);
        let rotations = pair.rotations(owner, t);
        let pose = pair.relative_pose(owner, t, &rotations);
        let q = pair.vertex(owner.other(), other);
        let p = pose.point(q) - pair.vertex(owner, own);
        let w = pair.velocity_of(owner, q, (&rotations, &pose));
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
    pub(crate) fn follow(&self, pair: &MovingPair, start: f64, precision: Precision) -> Followed {
        let mut t = start;
        let mut followed = Followed { axis: *self, until: start, at: start, gap: 0.0, slope: 0.0 };
        let mut lowest = self.facing;
        let exhausted = if precision == Precision::Balls { EXHAUSTED } else { 0.0 };
        for _ in 0..EVALUATIONS {
            let gap = self.gap(pair, t, precision, &mut lowest);
            followed = Followed { until: t, at: t, gap: gap.least, slope: gap.slope, ..followed };
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
            followed.until = t;
            if t < 1.0 && precision == Precision::Doubles && gap.least < USED_UP * pair.rounding {
                break;
            }
        }
        followed
    }
}
