//! Second stage: the same quantities as balls of double-doubles, each with a proven radius.
//!
//! Everything is in A's frame, scaled as in [`super::pair`]. A sign that a ball does not tell is a sign that 106 bits
//! do not tell; the callers then keep both possibilities and widen.

use super::gaps::Facing;
use super::pair::{Pair, scaled};
use crate::geometry::{Ball, DVec2, Dd, Side};

/// A vector of balls.
pub(crate) type Vec2 = [Ball; 2];

/// A pair, to twice the precision of a double.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fine<'p, 's> {
    pair: &'p Pair<'s>,
    /// c, B's origin in A's frame.
    center: Vec2,
    /// Cosine and sine of B's turn in A's frame.
    turn: Vec2,
}

/// An edge of B ⊖ A with its gap.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way {
    /// The edge, with a corner that supports it as far as 106 bits tell.
    pub(crate) facing: Facing,
    /// The other body's side that is parallel to it and faces it, if one is (or may be, as far as 106 bits tell).
    pub(crate) partner: Option<usize>,
    /// Unit vector from A to B.
    pub(crate) normal: Vec2,
    /// Gap of the cores along it.
    pub(crate) gap: Ball,
}

/// x · y.
pub(crate) fn dot(x: &Vec2, y: &Vec2) -> Ball {
    x[0] * y[0] + x[1] * y[1]
}

/// x₁ y₂ − x₂ y₁.
pub(crate) fn cross(x: &Vec2, y: &Vec2) -> Ball {
    x[0] * y[1] - x[1] * y[0]
}

/// −x.
pub(crate) fn reversed(x: &Vec2) -> Vec2 {
    [-x[0], -x[1]]
}

/// x − y.
pub(crate) fn minus(x: &Vec2, y: &Vec2) -> Vec2 {
    [x[0] - y[0], x[1] - y[1]]
}

/// Turned by (cos, sin).
fn turned(by: &Vec2, v: &Vec2) -> Vec2 {
    if by[1] == Ball::ZERO && by[0] == Ball::ONE {
        return *v;
    }
    [by[0] * v[0] - by[1] * v[1], by[1] * v[0] + by[0] * v[1]]
}

/// The doubles nearest to a vector of balls.
pub(crate) fn rounded(v: &Vec2) -> DVec2 {
    DVec2::new(v[0].value.hi, v[1].value.hi)
}

impl<'p, 's> Fine<'p, 's> {
    /// Prepares the second stage.
    pub(crate) fn new(pair: &'p Pair<'s>) -> Self {
        let (cos, sin) = pair.frame.cos_sin_fine();
        let center = turned(&[cos, -sin], &pair.apart);
        let (cos, sin) = pair.turn.cos_sin_fine();
        Self { pair, center, turn: [cos, sin] }
    }

    /// A corner of a core, in A's frame.
    pub(crate) fn corner(&self, side: Side, k: usize) -> Vec2 {
        let q = self.pair.hull(side).corners[k];
        let local = [scaled(Dd::new(q.x), self.pair.scale), scaled(Dd::new(q.y), self.pair.scale)];
        match side {
            Side::A => local,
            Side::B => {
                let v = turned(&self.turn, &local);
                [self.center[0] + v[0], self.center[1] + v[1]]
            }
        }
    }

    /// Side k of a core as a vector, in A's frame.
    pub(crate) fn side(&self, side: Side, k: usize) -> Vec2 {
        let hull = self.pair.hull(side);
        let (from, to) = (hull.corners[k], hull.corners[hull.next(k)]);
        let along = [
            scaled(Dd::difference(to.x, from.x), self.pair.scale),
            scaled(Dd::difference(to.y, from.y), self.pair.scale),
        ];
        match side {
            Side::A => along,
            Side::B => turned(&self.turn, &along),
        }
    }

    /// The unit normal of a side, from A to B.
    pub(crate) fn normal(&self, side: Side, k: usize) -> Vec2 {
        let outward = self.pair.hull(side).fine_normal(k);
        match side {
            Side::A => outward,
            Side::B => reversed(&turned(&self.turn, &outward)),
        }
    }

    /// Corner j of B less corner i of A: a corner of B ⊖ A.
    pub(crate) fn between(&self, i: usize, j: usize) -> Vec2 {
        minus(&self.corner(Side::B, j), &self.corner(Side::A, i))
    }

    /// An edge of B ⊖ A measured: its supporting corner settled, its gap enclosed.
    pub(crate) fn measure(&self, mut facing: Facing) -> Way {
        let other = facing.source.other();
        let normal = self.normal(facing.source, facing.edge);
        // The direction along which the other body's nearest corner is lowest.
        let down = match other {
            Side::B => normal,
            Side::A => reversed(&normal),
        };
        let hull = self.pair.hull(other);
        let mut partner = None;
        // Each step goes strictly down: at most once round.
        for _ in 0..hull.sides.len() {
            let (here, back) = (facing.corner, hull.previous(facing.corner));
            let ahead = dot(&down, &self.side(other, here));
            if ahead.is_negative() {
                facing.corner = hull.next(here);
                continue;
            }
            let behind = dot(&down, &self.side(other, back));
            if behind.is_positive() {
                facing.corner = back;
                continue;
            }
            let is_level = |along: Ball| along.sign().is_none_or(|sign| sign == 0);
            partner = if is_level(ahead) { Some(here) } else { is_level(behind).then_some(back) };
            break;
        }
        let doubt = if partner.is_some() { self.drop_below(other, facing.corner, &down) } else { 0.0 };
        let [i, j] = match facing.source {
            Side::A => [facing.edge, facing.corner],
            Side::B => [facing.corner, facing.edge],
        };
        let gap = dot(&normal, &self.between(i, j)).widen(doubt);
        Way { facing, partner, normal, gap }
    }

    /// How far below the corner `k` along `down` the lowest corner may be: 0 where `k` is certainly lowest.
    pub(crate) fn drop_below(&self, side: Side, k: usize, down: &Vec2) -> f64 {
        let hull = self.pair.hull(side);
        let (mut ahead, mut behind) = (0.0, 0.0);
        let mut at = k;
        for _ in 0..hull.sides.len() {
            let step = dot(down, &self.side(side, at));
            if step.is_positive() {
                break;
            }
            ahead += step.magnitude();
            at = hull.next(at);
        }
        at = k;
        for _ in 0..hull.sides.len() {
            at = hull.previous(at);
            let step = dot(down, &self.side(side, at));
            if step.is_negative() {
                break;
            }
            behind += step.magnitude();
        }
        f64::max(ahead, behind) * (1.0 + hull_rounding(hull.sides.len()))
    }
}

/// Relative error of a sum of `count` positive doubles.
fn hull_rounding(count: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2⁵³")]
    let count = count as f64;
    count * f64::EPSILON
}
