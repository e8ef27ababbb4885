//! The outline of B ⊖ A = {b − a}, edge by edge: the shape that all distance and sweep algorithms ask about.
//!
//! The bodies overlap exactly when it holds the origin, and its distance from the origin is theirs. Each edge
//! is an edge of one body and a vertex of the other: edge (bₖ, bₖ₊₁) of B with A's supporting vertex a gives
//! bₖ − a → bₖ₊₁ − a, and edge (aₖ, aₖ₊₁) of A with b gives b − aₖ → b − aₖ₊₁; both run counter-clockwise.
//! Round bodies add a disc of radius `r_A` + `r_B` around it.
//!
//! Source: Firth, "Collision detection for dummies", section OBB vs OBB. The merge is
//! [`crate::collision::algorithm::merge`].

use crate::collision::algorithm::view::{PairView, Turning};
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{DVec2, Side, length, perp};
use crate::trace::{Event, Tracer};

/// Where the origin lies from one edge of B ⊖ A, in A's frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projection {
    /// The edge that the origin is projected onto.
    pub(crate) edge: DifferenceEdge,
    /// Outward unit normal of B ⊖ A, which points from B to A.
    pub(crate) outward: DVec2,
    /// Signed distance of the origin from the edge's line, positive outside.
    pub(crate) line: f64,
    /// The point of the edge closest to the origin.
    pub(crate) foot: DVec2,
    /// ± the distance of the foot from the origin, with the sign of `line`; never −0.
    pub(crate) distance: f64,
    /// Where the foot is on the edge: 0 at its start, 1 at its end.
    pub(crate) along: f64,
    /// Whether the foot is within the edge or one of its ends.
    pub(crate) span: Span,
}

/// Where the origin's foot on an edge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Span {
    /// Between its ends: the foot is square to the edge.
    Within,
    /// Before its start or after its end: the foot is that end.
    Beyond,
}

impl DifferenceEdge {
    /// Start and end in A's frame.
    pub(crate) fn ends(self, pair: &PairView) -> [DVec2; 2] {
        let other = self.source.other();
        let next = pair.next(self.source, self.edge);
        let (from, to) = (pair.vertex(self.source, self.edge), pair.vertex(self.source, next));
        let vertex = pair.vertex(other, self.vertex);
        match self.source {
            Side::A => [vertex - from, vertex - to],
            Side::B => [from - vertex, to - vertex],
        }
    }

    /// Outward unit normal of B ⊖ A, in A's frame.
    pub(crate) fn outward(self, pair: &PairView) -> DVec2 {
        // A's edges are mirrored in B ⊖ A, and so are their normals.
        let outward = pair.outward(self.source, self.edge);
        if self.source == Side::A { -outward } else { outward }
    }

    /// Projects the origin onto the edge.
    ///
    /// Not inlined: whether the compiler did so hung on how many callers there are, traced ones included, and
    /// cost the untraced ones 2 %.
    #[inline(never)]
    pub(crate) fn project(self, pair: &PairView) -> Projection {
        let [from, to] = self.ends(pair);
        let outward = self.outward(pair);
        let line = -outward.dot(from);
        let tangent = perp(outward);
        let along = -from.dot(tangent) / (to - from).dot(tangent);
        // Within the span the foot is the origin moved to the line, which keeps the digits of a small
        // distance.
        let span = if (0.0..=1.0).contains(&along) { Span::Within } else { Span::Beyond };
        let foot = if span == Span::Within {
            outward * -line
        } else if along > 0.0 {
            to
        } else {
            from
        };
        let far = if span == Span::Within { line.abs() } else { length(foot) };
        let distance = if line < 0.0 { -far } else { far };
        Projection { edge: self, outward, line, foot, distance, along: along.clamp(0.0, 1.0), span }
    }

    /// The edge as an event: in configuration space, with the file's numbers.
    pub(crate) fn found(self, pair: &PairView) -> Event {
        let [from, to] = self.ends(pair);
        let outward = self.outward(pair);
        Event::DifferenceEdgeFound {
            source: self.source,
            edge: pair.file_edge(self.source, self.edge),
            vertex: pair.file_vertex(self.source.other(), self.vertex),
            from: pair.world_vector(from),
            to: pair.world_vector(to),
            normal: pair.world_vector(outward),
            distance: -outward.dot(from),
        }
    }
}

/// Visits the edges of B ⊖ A counter-clockwise, in O(n + m).
///
/// They are the edges of both bodies in the order of their directions, B's first of two that are parallel.
/// See [`crate::collision::algorithm::merge`] for the idea.
pub(crate) fn each_edge(pair: &PairView, mut visit: impl FnMut(DifferenceEdge)) {
    let (n, m) = (pair.edges(Side::A), pair.edges(Side::B));
    let mut b = if n == 0 { 0 } else { pair.supports_of_edge(Side::A, 0).0 };
    let mut a = if n == 0 { pair.support(Side::A, DVec2::ZERO) } else { 0 };
    let (mut left_a, mut left_b) = (n, m);
    while left_a > 0 || left_b > 0 {
        let turn = if left_b == 0 {
            Turning::Left
        } else if left_a == 0 {
            Turning::Right
        } else {
            pair.turning_of(Side::A, a, b)
        };
        if matches!(turn, Turning::Right | Turning::Along) {
            visit(DifferenceEdge { source: Side::B, edge: b, vertex: a });
            b = pair.next(Side::B, b);
            left_b -= 1;
        }
        if turn != Turning::Right {
            visit(DifferenceEdge { source: Side::A, edge: a, vertex: b });
            a = pair.next(Side::A, a);
            left_a -= 1;
        }
    }
}

/// Visits the edges of B ⊖ A that share a line: an edge of B, and the edge of A that goes on from its end.
pub(crate) fn each_two_on_one_line(pair: &PairView, mut visit: impl FnMut([DifferenceEdge; 2])) {
    let mut before: Option<DifferenceEdge> = None;
    each_edge(pair, |edge| {
        if let Some(first) = before.replace(edge)
            && (first.source, edge.source) == (Side::B, Side::A)
            && pair.turning_of(Side::A, edge.edge, first.edge) == Turning::Along
        {
            visit([first, edge]);
        }
    });
}

/// The one of two edges of B ⊖ A on one line that holds a point of it, in A's frame; where they meet,
/// the first.
pub(crate) fn holding(pair: &PairView, [first, second]: [DifferenceEdge; 2], point: DVec2) -> DifferenceEdge {
    let [joint, end] = second.ends(pair);
    if (point - joint).dot(end - joint) > 0.0 { second } else { first }
}

/// Tells B ⊖ A at the pair's moment: its edges counter-clockwise, and that it is round where it is.
///
/// Any algorithm may call it at any time; it costs nothing where nobody listens.
pub(crate) fn tell(pair: &PairView, tracer: &mut impl Tracer) {
    if tracer.listens() {
        each_edge(pair, |edge| tracer.record(|| edge.found(pair)));
        tell_rounding(pair, tracer);
    }
}

/// Tells that B ⊖ A is round, if it is: for algorithms that tell the edges themselves.
pub(crate) fn tell_rounding(pair: &PairView, tracer: &mut impl Tracer) {
    let center = center(pair);
    if pair.radius() > 0.0 || center.is_some() {
        tracer.record(|| Event::DifferenceRounded { center, radius: pair.radius() });
    }
}

/// The point that B ⊖ A is without its radius, in configuration space, where both cores are points.
fn center(pair: &PairView) -> Option<DVec2> {
    let point = pair.edges(Side::A) == 0 && pair.edges(Side::B) == 0;
    point.then(|| pair.world_vector(pair.vertex(Side::B, 0) - pair.vertex(Side::A, 0)))
}
