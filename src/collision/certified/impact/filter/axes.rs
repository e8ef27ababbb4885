//! Which axis to follow from a moment on: the one that seems to last longest.
//!
//! Of the axes that separate the bodies at a moment, the one that lasts longest is the best, not the one with
//! the widest gap: no axis lasts longer than contact, and that of the contact lasts until it. So where two
//! vertices are closest, the edges that meet in them are tried before the direction between them. Where a
//! vertex comes down beside the edge of a round body, the edges next to that are looked over, once, before a
//! distance query is made.
//!
//! All of it is a guess in doubles; only that the gap is open at the moment is sure.

use crate::collision::certified::distance::filter::descent::{ANYWHERE, Guess, SupportPair, search};
use crate::collision::certified::impact::axis::Axis;
use crate::collision::certified::impact::filter::gap_series::{Instant, OpenAxis, first_root};
use crate::collision::certified::impact::filter::{BAND, Finder};
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::geometry::{Side, perp};

/// A vertex that comes down beside an edge is looked for over the edges next to it, up to one in this many of
/// all edges: of cores with fewer edges none, where a distance query costs as little. Neither half nor twice
/// is noticed.
const NEIGHBOURHOOD: usize = 16;

impl Finder<'_, '_> {
    /// An axis of the closest features at a moment, which a distance query finds, starting at another axis.
    pub(super) fn axis_of_closest(&mut self, at: &Instant, from: Option<&OpenAxis>) -> Option<OpenAxis> {
        let open = match self.closest_features(at, from)? {
            DifferenceFeature::Edge(DifferenceEdge { source: owner, edge, vertex }) => {
                let axis = self.axis_of_edge(owner, edge, vertex);
                OpenAxis { axis, gap: axis.turned_gap(self.pair, at, vertex)? }
            }
            DifferenceFeature::Vertex(vertices) => self.axis_of_vertices(vertices, at)?,
        };
        (open.gap.value >= BAND.end * self.error).then_some(open)
    }

    /// An axis that separates the bodies at a moment at which another is used up by a vertex beside its edge:
    /// that of the owner's feature which is next to the vertex, if nothing else came nearer.
    pub(super) fn axis_beside(&self, axis: &Axis, vertex: usize, at: &Instant) -> Option<OpenAxis> {
        let (owner, other) = (axis.owner, axis.owner.other());
        let (own, q) = (self.pair.hull(owner), self.pair.hull(other).vertices[vertex]);
        let d = if owner == Side::A { at.apart } else { -at.apart };
        let x = at.rotations[owner as usize].undo(d + at.rotations[other as usize].apply(q));
        let (mut k, mut way) = (axis.own, 0);
        for _ in 0..own.edges.len() / NEIGHBOURHOOD {
            let edge = own.edges[k];
            let along = (x - own.vertices[k]).dot(edge);
            let (step, met, next) = if along < 0.0 {
                (-1, k, own.previous(k))
            } else if along > edge.dot(edge) {
                (1, own.next(k), own.next(k))
            } else {
                let found = self.axis_of_edge(owner, k, vertex);
                let gap = found.turned_gap(self.pair, at, vertex)?;
                let is_open = axis.edge != Some(k) && gap.value >= BAND.end * self.error;
                return is_open.then_some(OpenAxis { axis: found, gap });
            };
            if way + step == 0 {
                return self.axis_of_vertices(a_then_b(owner, met, vertex), at);
            }
            (k, way) = (next, step);
        }
        None
    }

    /// The closest features at a moment, in doubles, looked for from those of another axis on.
    fn closest_features(&mut self, at: &Instant, from: Option<&OpenAxis>) -> Option<DifferenceFeature> {
        if self.queries >= self.limit {
            return None;
        }
        self.queries += 1;
        let (a, b) = (self.pair.hull(Side::A), self.pair.hull(Side::B));
        let [of_a, of_b] = at.rotations;
        let (center, rotation) = (of_a.undo(at.apart), of_b.then(of_a.inverse()));
        let supports = SupportPair { a, b, center, rotation };
        let (toward, vertices) = match from {
            Some(OpenAxis { axis, gap }) if axis.owner == Side::A => (axis.n, (axis.own, gap.lowest)),
            Some(OpenAxis { axis, gap }) => (-rotation.apply(axis.n), (gap.lowest, axis.own)),
            None => (center, ANYWHERE),
        };
        match search(&supports, toward, vertices) {
            Guess::Apart(feature) => Some(feature),
            _ => None,
        }
    }

    /// The axis square to an edge, whose supporting vertex is `facing`.
    fn axis_of_edge(&self, owner: Side, edge: usize, facing: usize) -> Axis {
        let hull = self.pair.hull(owner);
        let n = hull.normals[edge];
        Axis { owner, n: *n, support: n.dot(hull.vertices[edge]), own: edge, facing, edge: Some(edge) }
    }

    /// An axis of two vertices [i, j] that are closest: of sharp bodies rather one of the edges that meet in
    /// them, of round ones rather one through both.
    fn axis_of_vertices(&self, [i, j]: [usize; 2], at: &Instant) -> Option<OpenAxis> {
        let of_edges = || {
            [(Side::A, i, j), (Side::B, j, i)].into_iter().flat_map(|(owner, k, facing)| {
                let hull = self.pair.hull(owner);
                let count = if hull.edges.is_empty() { 0 } else { 2 };
                let edges = [k, hull.previous(k)].into_iter().take(count);
                edges.map(move |edge| self.axis_of_edge(owner, edge, facing))
            })
        };
        let through = || self.axes_through([i, j], at).into_iter().flatten();
        if self.pair.radius.hi == 0.0 {
            self.longest(of_edges(), at).or_else(|| self.longest(through(), at))
        } else {
            self.longest(through(), at).or_else(|| self.longest(of_edges(), at))
        }
    }

    /// The axis that seems to last longest, of those that separate the bodies at a moment.
    fn longest(&self, axes: impl Iterator<Item = Axis>, at: &Instant) -> Option<OpenAxis> {
        let mut best: Option<(OpenAxis, f64)> = None;
        for axis in axes {
            let Some(gap) = axis.turned_gap(self.pair, at, axis.facing) else { continue };
            if gap.value >= BAND.end * self.error {
                let until = first_root(&gap.series(self.pair, axis.owner), 1.0 - at.t).unwrap_or(1.0);
                if best.as_ref().is_none_or(|(_, latest)| until > *latest) {
                    best = Some((OpenAxis { axis, gap }, until));
                }
            }
        }
        best.map(|(open, _)| open)
    }

    /// The axes through two vertices [i, j]: as they are, and as they are when they will touch, or be
    /// closest, if they go on as they move.
    fn axes_through(&self, [i, j]: [usize; 2], at: &Instant) -> [Option<Axis>; 2] {
        let pair = self.pair;
        let owner = pair.slower_turning();
        let arm = |side: Side, k: usize| at.rotations[side as usize].apply(pair.hull(side).vertices[k]);
        let (x, y) = (arm(Side::A, i), arm(Side::B, j));
        let (_, v) = pair.offset(Side::A, 0.0);
        let p = at.apart + y - x;
        let w = v + perp(y) * pair.rate[1] - perp(x) * pair.rate[0] - perp(p) * pair.rate[owner as usize];
        let (squared, along) = (w.length_squared(), p.dot(w));
        let c = p.length_squared() - pair.radius.hi * pair.radius.hi;
        let discriminant = along * along - squared * c;
        let h = if along >= 0.0 {
            0.0
        } else if discriminant > 0.0 {
            c / (discriminant.sqrt() - along)
        } else {
            -along / squared
        };
        let hull = pair.hull(owner);
        let [own, facing] = a_then_b(owner, i, j);
        [p, p + w * h].map(|toward| {
            let direction = toward / toward.length_squared().sqrt();
            let n = at.rotations[owner as usize].undo(if owner == Side::A { direction } else { -direction });
            let own = hull.highest(n, own);
            let support = n.dot(hull.vertices[own]);
            n.is_finite().then_some(Axis { owner, n, support, own, facing, edge: None })
        })
    }
}
