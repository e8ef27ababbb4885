//! A pair in balls: vertices, edges, normals and gaps as double-doubles, each with a proven radius.
//!
//! Everything is in A's frame, scaled as in [`crate::collision::certified::distance::pair`]. A sign that a
//! ball does not tell is a sign that 106 bits do not tell; the callers then keep both possibilities and
//! widen.

use crate::collision::certified::distance::pair::{Pair, scaled};
use crate::collision::feature::{DifferenceEdge, a_then_b};
use crate::geometry::{Ball, DVec2, Rotation, Side};

/// A vector of balls.
pub(crate) type Vec2 = [Ball; 2];

/// A pair, to twice the precision of a double.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BallPair<'p, 's> {
    /// The pair in doubles.
    pair: &'p Pair<'s>,
    /// c, B's origin in A's frame.
    center: Vec2,
    /// From B's frame to A's.
    rotation: Rotation<Ball>,
}

/// An edge of B ⊖ A measured in balls: its supporting vertex, its normal and the gap along it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeasuredEdge {
    /// The edge, with a vertex that supports it as far as 106 bits tell.
    pub(crate) facing: DifferenceEdge,
    /// The other body's edge that is parallel to it and faces it, if one is (or may be, as far as 106 bits
    /// tell).
    pub(crate) partner: Option<usize>,
    /// Unit vector from A to B.
    pub(crate) normal: Vec2,
    /// Gap of the cores along it.
    pub(crate) gap: Ball,
}

/// x · scale for a power of two, as [`scaled`].
#[inline]
pub(crate) fn rescaled(x: Ball, scale: f64) -> Ball {
    let value = scaled(x.value, scale);
    if x.radius == 0.0 { value } else { value.widen((x.radius * scale).next_up()) }
}

/// Dot product.
pub(crate) fn dot(x: &Vec2, y: &Vec2) -> Ball {
    x[0] * y[0] + x[1] * y[1]
}

/// Cross product, x₁ y₂ − x₂ y₁: positive where y is to the left of x.
pub(crate) fn cross(x: &Vec2, y: &Vec2) -> Ball {
    x[0] * y[1] - x[1] * y[0]
}

/// The opposite vector.
pub(crate) fn reversed(x: &Vec2) -> Vec2 {
    [-x[0], -x[1]]
}

/// Difference of two vectors.
pub(crate) fn minus(x: &Vec2, y: &Vec2) -> Vec2 {
    [x[0] - y[0], x[1] - y[1]]
}

/// The doubles nearest to a vector of balls.
pub(crate) fn rounded(v: &Vec2) -> DVec2 {
    DVec2::new(v[0].value.hi, v[1].value.hi)
}

impl<'p, 's> BallPair<'p, 's> {
    /// The pair in balls.
    pub(crate) fn new(pair: &'p Pair<'s>) -> Self {
        let center = pair.frame.rotation_in_balls().undo(pair.apart);
        Self { pair, center, rotation: pair.turn.rotation_in_balls() }
    }

    /// A vector of a hull in the units of the pair.
    #[inline]
    fn rescaled(&self, [x, y]: Vec2) -> Vec2 {
        let scale = self.pair.scale;
        [rescaled(x, scale), rescaled(y, scale)]
    }

    /// A vertex of a core, in A's frame.
    pub(crate) fn vertex(&self, side: Side, k: usize) -> Vec2 {
        let local = self.rescaled(self.pair.hull(side).vertex_in_balls(k));
        match side {
            Side::A => local,
            Side::B => {
                let v = self.rotation.apply(local);
                [self.center[0] + v[0], self.center[1] + v[1]]
            }
        }
    }

    /// Edge k of a core as a vector, in A's frame.
    pub(crate) fn edge(&self, side: Side, k: usize) -> Vec2 {
        let along = self.rescaled(self.pair.hull(side).edge_in_balls(k));
        match side {
            Side::A => along,
            Side::B => self.rotation.apply(along),
        }
    }

    /// The unit normal of an edge, from A to B.
    pub(crate) fn normal(&self, side: Side, k: usize) -> Vec2 {
        let outward = self.pair.hull(side).normal_in_balls(k);
        match side {
            Side::A => outward,
            Side::B => reversed(&self.rotation.apply(outward)),
        }
    }

    /// The normal of an edge of B ⊖ A, from A to B and as long as the edge: its direction is known to more
    /// bits of the shorter component than that of the unit normal.
    pub(crate) fn across(&self, DifferenceEdge { source, edge, .. }: DifferenceEdge) -> Vec2 {
        let e = self.edge(source, edge);
        match source {
            Side::A => [e[1], -e[0]],
            Side::B => [-e[1], e[0]],
        }
    }

    /// Vertex j of B less vertex i of A: a vertex of B ⊖ A.
    pub(crate) fn between(&self, i: usize, j: usize) -> Vec2 {
        minus(&self.vertex(Side::B, j), &self.vertex(Side::A, i))
    }

    /// An edge of B ⊖ A measured: its supporting vertex settled, its gap enclosed.
    pub(crate) fn measure(&self, mut facing: DifferenceEdge) -> MeasuredEdge {
        let normal = self.normal(facing.source, facing.edge);
        let across = self.across(facing);
        let partner = self.support(&mut facing, &across);
        let gap = self.gap(facing, partner, &normal);
        MeasuredEdge { facing, partner, normal, gap }
    }

    /// The gap along a normal of an edge of B ⊖ A, which [`Self::support`] has settled, times its length.
    pub(crate) fn gap(&self, facing: DifferenceEdge, partner: Option<usize>, normal: &Vec2) -> Ball {
        let DifferenceEdge { source, vertex, .. } = facing;
        let [i, j] = facing.start();
        let mut gap = dot(normal, &self.between(i, j));
        if gap.radius > f64::EPSILON * gap.value.hi.abs() {
            // All of the line is as far along the normal, and its other end may be nearer.
            let [k, l] = self.end(facing);
            let other = dot(normal, &self.between(k, l));
            if other.radius < gap.radius {
                gap = other;
            }
        }
        match partner {
            Some(_) => gap.widen(self.drop_below(source.other(), vertex, &seen_by_other(source, normal))),
            None => gap,
        }
    }

    /// The vertices [i, j] of A and B that end an edge of B ⊖ A.
    pub(crate) fn end(&self, DifferenceEdge { source, edge, vertex }: DifferenceEdge) -> [usize; 2] {
        a_then_b(source, self.pair.hull(source).next(edge), vertex)
    }

    /// Settles which vertex of the other body supports an edge of B ⊖ A along a normal of it, from A to B, of
    /// any length: the edge of that body which is parallel to it and faces it, if one is (or may be, as far
    /// as 106 bits tell).
    pub(crate) fn support(&self, facing: &mut DifferenceEdge, normal: &Vec2) -> Option<usize> {
        let (other, down) = (facing.source.other(), seen_by_other(facing.source, normal));
        let hull = self.pair.hull(other);
        // Each step goes strictly down: at most once round.
        for _ in 0..hull.edges.len() {
            let (here, back) = (facing.vertex, hull.previous(facing.vertex));
            let ahead = dot(&down, &self.edge(other, here));
            if ahead.is_negative() {
                facing.vertex = hull.next(here);
                continue;
            }
            let behind = dot(&down, &self.edge(other, back));
            if behind.is_positive() {
                facing.vertex = back;
                continue;
            }
            let is_level = |along: Ball| along.sign().is_none_or(|sign| sign == 0);
            return if is_level(ahead) { Some(here) } else { is_level(behind).then_some(back) };
        }
        None
    }

    /// How far below the vertex `k` along `down` the lowest vertex may be: 0 where `k` is certainly lowest.
    pub(crate) fn drop_below(&self, side: Side, k: usize, down: &Vec2) -> f64 {
        let hull = self.pair.hull(side);
        let (mut ahead, mut behind) = (0.0, 0.0);
        let mut at = k;
        for _ in 0..hull.edges.len() {
            let step = dot(down, &self.edge(side, at));
            if step.is_positive() {
                break;
            }
            ahead += step.magnitude();
            at = hull.next(at);
        }
        at = k;
        for _ in 0..hull.edges.len() {
            at = hull.previous(at);
            let step = dot(down, &self.edge(side, at));
            if step.is_negative() {
                break;
            }
            behind += step.magnitude();
        }
        f64::max(ahead, behind) * (1.0 + hull_rounding(hull.edges.len()))
    }
}

/// The direction along which the nearest vertex of the body beside an edge of `source` is lowest, of a normal
/// of that edge from A to B.
fn seen_by_other(source: Side, normal: &Vec2) -> Vec2 {
    match source {
        Side::A => *normal,
        Side::B => reversed(normal),
    }
}

/// Relative error of a sum of `count` positive doubles.
fn hull_rounding(count: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2⁵³")]
    let count = count as f64;
    count * f64::EPSILON
}
