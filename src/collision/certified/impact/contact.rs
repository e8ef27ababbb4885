//! Proofs that two bodies touch: what turns the end of a certificate into a hit.
//!
//! A separating axis proves that a pair is apart; that no axis is found proves nothing. Three facts do, given
//! that the pair is apart at `lo`:
//!
//! ```text
//! depth     the separation at hi is certainly at most 0
//! discs     two core vertices are at most ρ = r_A + r_B apart at hi
//! crossing  a point x of one core is outside the line of the other core's edge, moved out by ρ, at lo, on it
//!           or inside at hi, and its projection stays on the edge all the while: it met the edge in between
//! ```
//!
//! The last one needs no interior, and so settles points, segments and parallel segments, whose separation is
//! never negative. All arithmetic is in balls, so that each fact holds for the exact reals.

use crate::collision::certified::distance::balls::rescaled;
use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::closest::{closest_features, separation_at};
use crate::collision::certified::impact::moving_pair::{MovingPair, RelativePose};
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::geometry::{Ball, DVec2, Side, perp};

/// Two bodies that are apart at a moment.
pub(crate) struct Before<'p, 'q> {
    /// The two bodies in motion.
    pair: &'p MovingPair<'q>,
    /// The moment, at which they are proved to be apart.
    lo: f64,
    /// The closest features at `lo`: where there is no interior, they may be others at `hi`, behind them.
    near: DifferenceFeature,
}

impl<'p, 'q> Before<'p, 'q> {
    /// The pair at `lo`, where it is apart and these are its closest features.
    pub(crate) fn new(pair: &'p MovingPair<'q>, lo: f64, near: DifferenceFeature) -> Self {
        Self { pair, lo, near }
    }

    /// Whether contact in (lo, hi] is proved.
    pub(crate) fn touches_by(&self, hi: f64) -> bool {
        if hi <= self.lo {
            return false;
        }
        let after = closest_features(self.pair, hi).0;
        self.by_features(self.near, hi)
            || (after != self.near && self.by_features(after, hi))
            || self.depth(hi)
    }

    /// Whether discs or a crossing prove it, which look at two features only.
    fn by_features(&self, near: DifferenceFeature, hi: f64) -> bool {
        match near {
            DifferenceFeature::Vertex([i, j]) => self.discs(i, j, hi),
            DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex }) => {
                // A segment's two edges are one line: rounding may have taken the one that faces away.
                let back = self.pair.hull(owner).next(edge);
                self.crossing(owner, edge, vertex, hi)
                    || (self.pair.hull(owner).vertices.len() == 2 && self.crossing(owner, back, vertex, hi))
            }
        }
    }

    /// Whether the depth at `hi` proves it.
    fn depth(&self, hi: f64) -> bool {
        let [a, b] = self.pair.bodies;
        separation_at(a, b, hi, self.near).bounds.hi <= 0.0
    }

    /// Whether core vertices i of A and j of B are at most ρ apart at `hi`.
    fn discs(&self, i: usize, j: usize, hi: f64) -> bool {
        let pair = self.pair;
        let pose = pair.relative_pose_in_balls(Side::A, hi);
        let x = pose.point(pair.vertex_in_balls(Side::B, j));
        let q = pair.vertex_in_balls(Side::A, i);
        let (dx, dy) = (x[0] - q[0], x[1] - q[1]);
        let radius = Ball::exact(pair.radius);
        is_at_most_zero(dx * dx + dy * dy - radius * radius)
    }

    /// Whether the other core crosses an edge of `owner`: at its vertex, or between it and a neighbour.
    fn crossing(&self, owner: Side, edge: usize, vertex: usize, hi: f64) -> bool {
        let pair = self.pair;
        let other = owner.other();
        let line = EdgeLine::of(pair, owner, edge);
        let poses = [pair.relative_pose_in_balls(owner, self.lo), pair.relative_pose_in_balls(owner, hi)];
        let travel = pair.speed(owner) * (hi - self.lo) * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE;
        let x = pair.vertex_in_balls(other, vertex);
        if line.is_crossed(&poses, x, travel) {
            return true;
        }
        [pair.hull(other).previous(vertex), pair.hull(other).next(vertex)]
            .into_iter()
            .filter(|&k| k != vertex)
            .filter_map(|k| line.middle_of_span(&poses[1], x, pair.vertex_in_balls(other, k)))
            .any(|middle| line.is_crossed(&poses, middle, travel))
    }
}

/// Whether discs or a crossing prove a touch in (lo, hi] already in doubles, given an axis that separates the
/// pair at `lo`.
pub(crate) fn touches_in_doubles(
    pair: &MovingPair,
    axis: &Axis,
    near: DifferenceFeature,
    (lo, hi): (f64, f64),
) -> bool {
    let error = pair.rounding;
    match near {
        DifferenceFeature::Vertex([i, j]) => {
            let pose = pair.relative_pose(Side::A, hi, &pair.rotations(Side::A, hi));
            let apart = pose.point(pair.vertex(Side::B, j)) - pair.vertex(Side::A, i);
            apart.length() <= pair.radius.hi - error
        }
        // The axis is the edge's normal, so that every vertex is outside the edge's line at `lo`.
        DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex })
            if axis.owner == owner && axis.edge == Some(edge) =>
        {
            let hull = pair.hull(owner);
            let (from, to) = (pair.vertex(owner, edge), pair.vertex(owner, hull.next(edge)));
            let pose = pair.relative_pose(owner, hi, &pair.rotations(owner, hi));
            let along = perp(axis.n);
            let end = (to - from).dot(along);
            let margin = pair.speed(owner) * (hi - lo) + error;
            let place = |k: usize| pose.point(pair.vertex(owner.other(), k)) - from;
            let depth = |x: DVec2| pair.radius.hi - axis.n.dot(x);
            let x = place(vertex);
            let crosses = |x: DVec2| {
                let at = x.dot(along);
                depth(x) >= error && at >= margin && at <= end - margin
            };
            // Where an edge of the other core lies along this one, the middle of what they share may be above
            // this one though neither of its ends is.
            let other = pair.hull(owner.other());
            let shared = |k: usize| {
                let y = place(k);
                let (u, w) = (x.dot(along), y.dot(along));
                let middle = 0.5 * (u.min(w).max(0.0) + u.max(w).min(end));
                let part = (middle - u) / (w - u);
                part > 0.0 && part < 1.0 && crosses(x + (y - x) * part)
            };
            crosses(x)
                || (other.vertices.len() > 1
                    && (shared(other.next(vertex)) || shared(other.previous(vertex))))
        }
        DifferenceFeature::Edge(_) => false,
    }
}

/// An edge of a core and its line, in its body's frame.
struct EdgeLine {
    /// The edge's first vertex.
    from: [Ball; 2],
    /// The edge as a vector.
    along: [Ball; 2],
    /// The edge's length.
    length: Ball,
    /// ρ, by which the line is moved out.
    radius: Ball,
}

impl EdgeLine {
    fn of(pair: &MovingPair, owner: Side, edge: usize) -> Self {
        let along = pair.hull(owner).edge_in_balls(edge).map(|x| rescaled(x, pair.unit));
        let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
        Self { from: pair.vertex_in_balls(owner, edge), along, length, radius: Ball::exact(pair.radius) }
    }

    /// Projection on the edge and offset outward from its moved line, both times the edge's length.
    fn coordinates(&self, x: &[Ball; 2]) -> (Ball, Ball) {
        let (dx, dy) = (x[0] - self.from[0], x[1] - self.from[1]);
        let projection = dx * self.along[0] + dy * self.along[1];
        let offset = dx * self.along[1] - dy * self.along[0];
        (projection, offset - self.radius * self.length)
    }

    /// Whether the point x of the other body goes from outside to inside while its projection stays on the
    /// edge; between the two poses it travels at most `travel`.
    fn is_crossed(&self, [before, after]: &[RelativePose<Ball>; 2], x: [Ball; 2], travel: f64) -> bool {
        let (_, start) = self.coordinates(&before.point(x));
        let (projection, end) = self.coordinates(&after.point(x));
        let reach = self.length.scale(travel);
        start.is_positive()
            && is_at_most_zero(end)
            && is_at_most_zero(reach - projection)
            && is_at_most_zero(projection + reach - self.length * self.length)
    }

    /// The point of the other body's edge from x to y that is in the middle of what both edges cover of the
    /// line.
    fn middle_of_span(&self, pose: &RelativePose<Ball>, x: [Ball; 2], y: [Ball; 2]) -> Option<[Ball; 2]> {
        let whole = self.length.value.hi * self.length.value.hi;
        let (u, w) =
            (self.coordinates(&pose.point(x)).0.value.hi, self.coordinates(&pose.point(y)).0.value.hi);
        let middle = 0.5 * (u.min(w).max(0.0) + u.max(w).min(whole));
        let part = (middle - u) / (w - u);
        let mix = |k: usize| x[k] + (y[k] - x[k]).scale(part);
        (part > 0.0 && part < 1.0).then(|| [mix(0), mix(1)])
    }
}

/// Whether x ≤ 0 is certain.
fn is_at_most_zero(x: Ball) -> bool {
    matches!(x.sign(), Some(-1 | 0))
}
