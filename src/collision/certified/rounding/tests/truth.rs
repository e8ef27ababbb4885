//! A pair at a moment in 320 bits.

use tracefig_reference::float::Real;
use tracefig_reference::point::{self, Point};

use crate::geometry::{Body, DVec2, Dd, Rotation, Side};

pub(super) fn real(x: f64) -> Real {
    Real::from(x)
}

pub(super) fn exact(x: Dd) -> Real {
    real(x.hi) + real(x.lo)
}

pub(super) fn point(v: DVec2) -> Point {
    Point::of([v.x, v.y])
}

pub(super) fn exact_point(v: [Dd; 2]) -> Point {
    Point { x: exact(v[0]), y: exact(v[1]) }
}

pub(super) fn exact_rotation(r: Rotation<Dd>) -> point::Rotation {
    point::Rotation { cos: exact(r.cos), sin: exact(r.sin) }
}

/// |computed − truth| as a share of a bound.
pub(super) fn share_of(computed: Real, truth: Real, bound: f64) -> f64 {
    (computed - truth).abs().over(real(bound)).to_f64()
}

/// A pair at a moment in A's frame, exactly.
pub(super) struct Truth {
    /// Vertices of both cores.
    pub(super) cores: [Vec<Point>; 2],
    /// The closing velocity: `v_A` − `v_B`.
    pub(super) closing: Point,
    /// From the world to A's frame and from B's frame to A's.
    pub(super) frame: point::Rotation,
    pub(super) relative: point::Rotation,
    pub(super) radius: Real,
}

impl Truth {
    pub(super) fn of(a: &Body, b: &Body, t: f64) -> Self {
        let angle = |body: &Body| real(body.angle.degrees()) + real(body.spin.degrees()) * real(t);
        let frame = point::Rotation::of_degrees(angle(a));
        let relative = point::Rotation::of_degrees(angle(b) - angle(a));
        let at = |body: &Body| point(body.position).plus(point(body.velocity).times(real(t)));
        let center = at(b).minus(at(a)).turned_back(frame);
        let core = |body: &Body| body.shape.hull.vertices.iter().map(|&v| point(v)).collect::<Vec<_>>();
        let of_b = core(b).iter().map(|q| q.turned(relative).plus(center)).collect();
        let closing = point(a.velocity).minus(point(b.velocity)).turned_back(frame);
        let radius = real(a.shape.radius) + real(b.shape.radius);
        Self { cores: [core(a), of_b], closing, frame, relative, radius }
    }

    pub(super) fn core(&self, side: Side) -> &[Point] {
        &self.cores[side as usize]
    }

    /// An edge of a core.
    pub(super) fn edge(&self, side: Side, k: usize) -> Point {
        let core = self.core(side);
        core[(k + 1) % core.len()].minus(core[k])
    }

    /// The outward unit normal of an edge of a core.
    pub(super) fn outward(&self, side: Side, k: usize) -> Point {
        self.edge(side, k).perp().reversed().unit()
    }

    /// How far a vertex of the other core is outside the line of an edge.
    pub(super) fn height(&self, side: Side, k: usize, vertex: usize) -> Real {
        self.core(side.other())[vertex].minus(self.core(side)[k]).dot(self.outward(side, k))
    }

    /// The gap along the normal of an edge.
    pub(super) fn gap(&self, side: Side, k: usize) -> Real {
        let count = self.core(side.other()).len();
        (1..count).fold(self.height(side, k, 0), |least, j| least.min(self.height(side, k, j)))
    }
}

/// Both sides with the numbers of their edges.
pub(super) fn edges(a: &Body, b: &Body) -> Vec<(Side, usize)> {
    let of = |side: Side, body: &Body| {
        (0..body.shape.hull.edges.len()).map(move |k| (side, k)).collect::<Vec<_>>()
    };
    [of(Side::A, a), of(Side::B, b)].concat()
}

pub(super) fn size(v: DVec2) -> f64 {
    v.x.abs() + v.y.abs()
}
