//! A body as naive methods see it: a core of vertices where it is at a moment, and a radius, in doubles.

use crate::geometry::{Body, DVec2};

/// A body at a moment.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    /// Vertices of the core in the world, counter-clockwise.
    pub(super) core: Vec<DVec2>,
    /// The radius around it, world units.
    pub(super) radius: f64,
}

impl Placed {
    /// A body at time `t`; `None` for one that is not convex.
    pub(super) fn at(body: &Body, t: f64) -> Option<Self> {
        let pose = body.pose_at(t);
        let core: Vec<DVec2> = body.shape.hull.vertices.iter().map(|&v| pose.point(v)).collect();
        (!core.is_empty()).then_some(Self { core, radius: body.shape.radius })
    }

    /// How far the core reaches along a direction: the largest product with it.
    pub(super) fn reach(&self, along: DVec2) -> f64 {
        self.core.iter().map(|v| along.dot(*v)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The vertex that is farthest along a direction.
    pub(super) fn support(&self, along: DVec2) -> DVec2 {
        let farther = |p: DVec2, q: DVec2| if along.dot(q) > along.dot(p) { q } else { p };
        self.core.iter().copied().reduce(farther).unwrap_or(DVec2::ZERO)
    }

    /// The mean of the vertices.
    pub(super) fn centre(&self) -> DVec2 {
        let count = f64::from(u32::try_from(self.core.len()).unwrap_or(1));
        self.core.iter().copied().sum::<DVec2>() / count
    }

    /// Outward normals of the edges, of length 1.
    pub(super) fn normals(&self) -> impl Iterator<Item = DVec2> {
        let next = self.core.iter().cycle().skip(1);
        let edges = self.core.iter().zip(next).map(|(p, q)| *q - *p);
        edges.filter(|edge| edge.length() > 0.0).map(|edge| DVec2::new(edge.y, -edge.x) / edge.length())
    }
}

/// The gap between the projections of A and B on a unit vector from A to B, negative where they overlap.
pub(super) fn gap([a, b]: &[Placed; 2], n: DVec2) -> f64 {
    -b.reach(-n) - a.reach(n) - a.radius - b.radius
}

/// Both bodies at time `t`.
pub(super) fn both([a, b]: [&Body; 2], t: f64) -> Option<[Placed; 2]> {
    Some([Placed::at(a, t)?, Placed::at(b, t)?])
}
