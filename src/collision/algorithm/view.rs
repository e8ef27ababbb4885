//! The two bodies of a query at one moment, as an algorithm sees them: from A's frame, in doubles.
//!
//! A's vertices are then the file's own numbers, only B's are turned (by the *difference* of the angles) and
//! moved (by the *difference* of the positions): boxes at the same angle stay exactly aligned, and nothing is
//! lost when the pair is far from the world's origin.
//!
//! A body is its core polygon and a radius. Core vertices and edges are counted here along the core,
//! counter-clockwise; [`PairView::file_vertex`] and [`PairView::file_edge`] give the file's numbers back.
//!
//! What is looked up here is told and drawn. The proof of an answer sees the pair in its own way, as a
//! [`crate::collision::Pair`], with every digit that it needs.

use std::cmp::Ordering;

use crate::collision::algorithm::motion;
use crate::collision::certified::rounding::{DOT_ERROR, GAP_ERROR, TAME};
use crate::collision::{Pair, Query};
use crate::geometry::{Body, DVec2, Feature, Hull, Pose, Side, Turn};
use crate::trace::{Event, Moment, SupportVertex, Tracer};

/// Two bodies at one moment, seen from A's frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairView<'s> {
    /// Body A.
    pub(crate) a: &'s Body,
    /// Body B.
    pub(crate) b: &'s Body,
    /// A's frame to the world.
    frame: Pose,
    /// B's frame to A's frame.
    b_frame: Pose,
    /// The angle of `b_frame`, exactly.
    angle: Turn,
    /// The pair as the proof of an answer sees it.
    pub(crate) certified: Pair<'s>,
}

/// The direction of an edge as another edge sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turning {
    /// In the direction of that edge.
    Along,
    /// To the left, by less than half a turn.
    Left,
    /// Parallel to it, running the other way.
    Against,
    /// To the right, by less than half a turn.
    Right,
}

impl<'s> PairView<'s> {
    /// The pair of a query at the query's moment. A query about one body is answered with that body twice.
    pub(crate) fn of(query: &Query<'s>) -> Self {
        Self::at(query.a, query.b.unwrap_or(query.a), query.time)
    }

    /// The pair of a query, with the event that an algorithm starts.
    #[inline]
    pub(crate) fn start(query: &Query<'s>, algorithm: &'static str, tracer: &mut impl Tracer) -> Self {
        let pair = Self::of(query);
        tracer.record(|| Event::Started { algorithm, at: pair.moment() });
        pair
    }

    /// The pair at time `t` in [0, 1].
    pub(crate) fn at(a: &'s Body, b: &'s Body, t: f64) -> Self {
        let certified = Pair::at(a, b, t);
        let (frame, angle) = (certified.pose(Side::A), certified.turn);
        let rotation = certified.b_rotation.rounded();
        // Unscaled, which the pair is only where the scene is tame.
        let position = if certified.is_tame() {
            certified.center
        } else {
            let apart = (b.position - a.position) + (b.velocity - a.velocity) * t;
            frame.rotation.undo(apart)
        };
        Self { a, b, frame, b_frame: Pose { position, rotation }, angle, certified }
    }

    /// The moment's time.
    pub(crate) fn time(&self) -> f64 {
        self.certified.time
    }

    /// The moment, with both angles in the world, as events tell it.
    pub(crate) fn moment(&self) -> Moment {
        motion::moment(self.a, self.b, self.time())
    }

    /// One of the bodies.
    pub(crate) fn body(&self, side: Side) -> &'s Body {
        match side {
            Side::A => self.a,
            Side::B => self.b,
        }
    }

    /// The core of a body, in its own frame.
    fn hull(&self, side: Side) -> &'s Hull {
        &self.body(side).shape.hull
    }

    /// Number of vertices of a core.
    pub(crate) fn count(&self, side: Side) -> usize {
        self.hull(side).vertices.len()
    }

    /// Number of directed edges of a core: none for a point, two for a segment (there and back).
    pub(crate) fn edges(&self, side: Side) -> usize {
        self.hull(side).edges.len()
    }

    /// `r_A` + `r_B`, the radius of the disc that rounds B ⊖ A, in world units.
    pub(crate) fn radius(&self) -> f64 {
        self.a.shape.radius + self.b.shape.radius
    }

    /// Bound on the error of a gap between supports, or of a distance of vertices, in world units.
    ///
    /// Infinite where numbers are so large or small that there is none.
    pub(crate) fn gap_error(&self) -> f64 {
        let placed = (self.b.position - self.a.position).abs()
            + ((self.b.velocity - self.a.velocity) * self.time()).abs();
        let reaches = self.hull(Side::A).reach + self.hull(Side::B).reach;
        let size = placed.x + placed.y + reaches + self.radius();
        if TAME.contains(&size) { GAP_ERROR * size } else { f64::INFINITY }
    }

    /// The next vertex or edge of a core, counter-clockwise.
    pub(crate) fn next(&self, side: Side, k: usize) -> usize {
        if k + 1 >= self.count(side) { 0 } else { k + 1 }
    }

    /// The previous vertex or edge of a core, counter-clockwise.
    pub(crate) fn previous(&self, side: Side, k: usize) -> usize {
        if k == 0 { self.count(side).saturating_sub(1) } else { k - 1 }
    }

    /// Core vertex k in A's frame.
    pub(crate) fn vertex(&self, side: Side, k: usize) -> DVec2 {
        let local = vertex(self.hull(side), k);
        match side {
            Side::A => local,
            Side::B => self.b_frame.point(local),
        }
    }

    /// The origin of a body's frame, in A's frame.
    pub(crate) fn origin(&self, side: Side) -> DVec2 {
        match side {
            Side::A => DVec2::ZERO,
            Side::B => self.b_frame.position,
        }
    }

    /// Core edge k, from its vertex to the next, as a vector in A's frame.
    pub(crate) fn edge(&self, side: Side, k: usize) -> DVec2 {
        let along = self.hull(side).edges.get(k).copied().unwrap_or(DVec2::ZERO);
        match side {
            Side::A => along,
            Side::B => self.b_frame.vector(along),
        }
    }

    /// Outward unit normal of core edge k, in A's frame.
    pub(crate) fn outward(&self, side: Side, k: usize) -> DVec2 {
        let normal = self.hull(side).normals.get(k).map_or(DVec2::ZERO, |n| **n);
        match side {
            Side::A => normal,
            Side::B => self.b_frame.vector(normal),
        }
    }

    /// The edge k as it runs in B ⊖ A: A's edges are mirrored there.
    pub(crate) fn difference_edge(&self, side: Side, k: usize) -> DVec2 {
        match side {
            Side::A => -self.edge(side, k),
            Side::B => self.edge(side, k),
        }
    }

    /// How `other`'s edge l turns off from `side`'s edge k, both as they run in B ⊖ A.
    pub(crate) fn turning_of(&self, side: Side, k: usize, l: usize) -> Turning {
        let d = self.difference_edge(side, k);
        let e = self.difference_edge(side.other(), l);
        match sign_of_cross(d, e).unwrap_or_else(|| self.fine_sign_of_cross(side, k, l)) {
            Ordering::Greater => Turning::Left,
            Ordering::Less => Turning::Right,
            Ordering::Equal if d.dot(e) > 0.0 => Turning::Along,
            Ordering::Equal => Turning::Against,
        }
    }

    /// The sign of the same cross product in double-doubles; `Equal` where even they can't tell, which they
    /// always can where the bodies are parallel.
    fn fine_sign_of_cross(&self, side: Side, k: usize, l: usize) -> Ordering {
        let edge = |side: Side, k: usize| self.hull(side).edge_in_balls(k);
        // In A's frame, A's edge mirrored: the sign of −eₐ × R e_b.
        let (a, b) = if side == Side::A { (k, l) } else { (l, k) };
        let ([ax, ay], [bx, by]) = (edge(Side::A, a), edge(Side::B, b));
        let [x, y] = self.angle.rotation_in_balls().apply([bx, by]);
        let cross = ay * x - ax * y;
        let sign = cross.sign().unwrap_or(0).cmp(&0);
        if side == Side::A { sign } else { sign.reverse() }
    }

    /// The core vertex farthest along `direction` (A's frame); the first of several.
    pub(crate) fn support(&self, side: Side, direction: DVec2) -> usize {
        let direction = match side {
            Side::A => direction,
            Side::B => self.b_frame.rotation.undo(direction),
        };
        let mut best = (0, f64::NEG_INFINITY);
        for (k, vertex) in self.hull(side).vertices.iter().enumerate() {
            let reach = vertex.dot(direction);
            if reach > best.1 {
                best = (k, reach);
            }
        }
        best.0
    }

    /// The vertices of the other core that the edge k of `side` meets in B ⊖ A: the first and, where one of
    /// its edges runs the same way there, the second end of that edge.
    ///
    /// Not inlined, as [`crate::collision::feature::DifferenceEdge::project`].
    #[inline(never)]
    pub(crate) fn supports_of_edge(&self, side: Side, k: usize) -> (usize, Option<usize>) {
        let other = side.other();
        let mut at = self.support(other, -self.outward(side, k));
        if self.edges(other) == 0 {
            return (at, None);
        }
        // Rounding may have picked a neighbour: signs of cross products decide.
        for _ in 0..self.count(other) {
            if self.turning_of(side, k, at) == Turning::Right {
                at = self.next(other, at);
            } else if matches!(
                self.turning_of(side, k, self.previous(other, at)),
                Turning::Left | Turning::Along
            ) {
                at = self.previous(other, at);
            } else {
                break;
            }
        }
        let second = (self.turning_of(side, k, at) == Turning::Along).then(|| self.next(other, at));
        (at, second)
    }

    /// The file's index of core vertex k.
    pub(crate) fn file_vertex(&self, side: Side, k: usize) -> usize {
        self.body(side).shape.core.get(k).copied().unwrap_or(0)
    }

    /// The file's index of core edge k: where vertices on it were dropped, of the piece that holds its
    /// middle.
    pub(crate) fn file_edge(&self, side: Side, k: usize) -> usize {
        let hull = self.hull(side);
        let middle = vertex(hull, k) * 0.5 + vertex(hull, self.next(side, k)) * 0.5;
        let (Feature::Edge(i) | Feature::Vertex(i)) = self.body(side).shape.edge_feature(k, middle);
        i
    }

    /// A point of A's frame in the world.
    pub(crate) fn world_point(&self, p: DVec2) -> DVec2 {
        self.frame.point(p)
    }

    /// A vector of A's frame in the world, or a point of B ⊖ A in configuration space.
    pub(crate) fn world_vector(&self, v: DVec2) -> DVec2 {
        self.frame.vector(v)
    }

    /// A world vector in A's frame.
    pub(crate) fn local_vector(&self, v: DVec2) -> DVec2 {
        self.frame.rotation.undo(v)
    }

    /// A core vertex as events tell it.
    pub(crate) fn told(&self, side: Side, k: usize) -> SupportVertex {
        SupportVertex { index: self.file_vertex(side, k), point: self.world_point(self.vertex(side, k)) }
    }
}

/// Vertex k of a core; a shape without a core counts as its origin.
fn vertex(hull: &Hull, k: usize) -> DVec2 {
    hull.vertices.get(k).copied().unwrap_or(DVec2::ZERO)
}

/// The sign of u × v, or None where rounding hides it.
fn sign_of_cross(u: DVec2, v: DVec2) -> Option<Ordering> {
    let size = |v: DVec2| v.x.abs() + v.y.abs();
    let cross = u.perp_dot(v);
    if cross.abs() > DOT_ERROR * size(u) * size(v) { cross.partial_cmp(&0.0) } else { None }
}
