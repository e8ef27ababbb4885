//! Axes that turn with one of the bodies, and which of them are worth following: through the closest
//! features, or ahead of two vertices that approach each other.
//!
//! Let R own the axis n, O be the other body, h the farthest that R's core reaches along n. While the gap
//! along any axis is open, nothing touches: [`crate::collision::certified::impact::gap`] says how wide it
//! is, [`crate::collision::certified::impact::follow`] how long it stays so.

use crate::collision::certified::impact::moving_pair::MovingPair;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{DVec2, Side, perp};

/// An axis fixed in the frame of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    /// The body in whose frame it is fixed: R.
    pub(crate) owner: Side,
    /// Its direction in R's frame, from R to O: n, of length 1 but for rounding.
    pub(crate) n: DVec2,
    /// How far R's core reaches along n, in scaled units and doubles: h.
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
    /// The axis, fixed in its owner's frame.
    pub(crate) axis: Axis,
    /// Start of the span.
    pub(crate) from: f64,
    /// End of the span.
    pub(crate) to: f64,
}

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
}
