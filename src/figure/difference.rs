//! B ⊖ A put together from what an algorithm told: its edges in order, with the body that each comes from.
//!
//! An algorithm finds the edges in the order that suits it: the article's goes through A's edges, then B's.
//! Each runs counter-clockwise, so the outline is the chain in which one edge begins where another ends.
//! Where edges of both bodies lie on one line, B's comes first (`DifferenceEdgeFound` says so).

use crate::geometry::{DVec2, Side, sorted};
use crate::trace::Event;

use super::sketch::Outline;

/// Ends of edges of the same outline agree up to this part of its size. They are differences of the same
/// vertices, rounded in different order: off by some ε of the coordinates. A thousand times more would still
/// be far below a pixel.
const JOINED: f64 = 1e-12;

/// An edge of B ⊖ A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    /// The body whose edge it is.
    pub(crate) source: Side,
    /// The number of the edge on that body, in the file's order.
    pub(crate) index: usize,
    /// The number of the supporting vertex of the other body.
    pub(crate) vertex: usize,
    /// Start, in configuration space, counter-clockwise.
    pub(crate) from: DVec2,
    /// End, in configuration space.
    pub(crate) to: DVec2,
    /// Outward unit normal.
    pub(crate) normal: DVec2,
    /// Signed distance of the origin from its line, positive outside.
    pub(crate) distance: f64,
}

/// B ⊖ A at one moment: a convex core and the radius of the disc that sweeps it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Difference {
    /// Edges of the core, counter-clockwise; none where it is a point.
    pub(crate) edges: Vec<Edge>,
    /// The core where it is a point.
    pub(crate) center: Option<DVec2>,
    /// `r_A` + `r_B`, in world units; 0 for sharp bodies.
    pub(crate) radius: f64,
}

impl Difference {
    /// The first difference that events tell of; `None` where they tell none.
    #[must_use]
    pub(crate) fn of<'e>(events: impl Iterator<Item = &'e Event>) -> Option<Self> {
        let mut found: Vec<Edge> = Vec::new();
        // At most two normals a number, those of a segment's two edges.
        let mut known: [Vec<Vec<DVec2>>; 2] = Default::default();
        let (mut center, mut radius) = (None, 0.0);
        for event in events {
            match *event {
                Event::Started { .. } if !found.is_empty() || center.is_some() => break,
                Event::DifferenceEdgeFound { source, edge, vertex, from, to, normal, distance } => {
                    // A segment's two edges, there and back, bear one number.
                    let of_side = &mut known[usize::from(source == Side::B)];
                    of_side.resize(of_side.len().max(edge + 1), Vec::new());
                    let normals = &mut of_side[edge];
                    if !normals.iter().any(|n| n.dot(normal) > 0.0) {
                        normals.push(normal);
                        found.push(Edge { source, index: edge, vertex, from, to, normal, distance });
                    }
                }
                Event::DifferenceRounded { center: c, radius: r } => (center, radius) = (c, r),
                _ => {}
            }
        }
        if found.is_empty() && center.is_none() {
            return None;
        }
        Some(Self { edges: chain(found), center, radius })
    }

    /// The outline, in configuration space: arcs about the core's vertices where it is round.
    #[must_use]
    pub(crate) fn outline(&self) -> Outline {
        let vertices: Vec<DVec2> = match self.center {
            Some(center) if self.edges.is_empty() => vec![center],
            _ => self.edges.iter().map(|e| e.from).collect(),
        };
        Outline::rounded(&vertices, self.radius)
    }

    /// The ends of an edge as it is drawn: moved outward by the radius.
    #[must_use]
    pub(crate) fn drawn(&self, edge: &Edge) -> (DVec2, DVec2) {
        let out = edge.normal * self.radius;
        (edge.from + out, edge.to + out)
    }

    /// How far a point of configuration space is outside, at least: the signed distance from the line of its
    /// farthest edge; negative inside.
    #[must_use]
    pub(crate) fn outside(&self, p: DVec2) -> f64 {
        let from_core = match self.center {
            Some(center) if self.edges.is_empty() => p.distance(center),
            _ => self.edges.iter().map(|e| e.normal.dot(p - e.from)).fold(f64::NEG_INFINITY, f64::max),
        };
        from_core - self.radius
    }

    /// The mean of the core's vertices, in configuration space.
    #[must_use]
    pub(crate) fn middle(&self) -> DVec2 {
        #[expect(clippy::cast_precision_loss, reason = "a count of edges is far below 2^53")]
        let count = self.edges.len().max(1) as f64;
        let sum = self.edges.iter().map(|e| e.from).sum::<DVec2>();
        self.center.filter(|_| self.edges.is_empty()).unwrap_or(sum / count)
    }

    /// Where an edge of A and an edge of B that lie on one line meet as they are drawn, nearest the origin's
    /// foot.
    #[must_use]
    pub(crate) fn joint(&self) -> Option<DVec2> {
        self.aligned().map(|[e, _]| self.drawn(&e).1)
    }

    /// The edges of A and of B that lie on one line, one after the other, nearest the origin's foot: both
    /// bodies' supporting edges face each other there. `None` where no edges are aligned at the nearest one.
    #[must_use]
    pub(crate) fn aligned(&self) -> Option<[Edge; 2]> {
        let nearest = self.edges.iter().map(|e| e.distance).fold(f64::NEG_INFINITY, f64::max);
        let size = self.size();
        let n = self.edges.len();
        (0..n).map(|i| [self.edges[i], self.edges[(i + 1) % n]]).find(|[e, f]| {
            let aligned = e.source != f.source && e.normal.distance(f.normal) <= JOINED;
            let near = (e.distance - nearest).abs() <= JOINED * size
                && (f.distance - nearest).abs() <= JOINED * size;
            aligned && near
        })
    }

    /// How many ways out are as short as the shortest, as far as doubles tell: directions of the edges that
    /// are nearest the origin where that is in the core, and from the core's nearest point else, of which a
    /// convex one has one. 0 where the core is a point: out of it all ways are as long.
    pub(crate) fn ways_out(&self) -> usize {
        let nearest = self.edges.iter().map(|e| e.distance).fold(f64::NEG_INFINITY, f64::max);
        let near = JOINED * self.size();
        if nearest > near {
            return 1;
        }
        let mut ways: Vec<DVec2> = Vec::new();
        for edge in self.edges.iter().filter(|e| nearest - e.distance <= near) {
            if !ways.iter().any(|n| n.distance(edge.normal) <= JOINED) {
                ways.push(edge.normal);
            }
        }
        ways.len()
    }

    /// The largest coordinate, the measure of rounding errors.
    fn size(&self) -> f64 {
        size(&self.edges)
    }
}

/// The largest coordinate of edges, in units of configuration space.
fn size(edges: &[Edge]) -> f64 {
    edges.iter().map(|e| e.from.abs().max(e.to.abs()).max_element()).fold(0.0, f64::max)
}

/// The edges end to end. Starts with an edge of B if there is one, so that an edge shared by both is not
/// entered at its middle.
fn chain(found: Vec<Edge>) -> Vec<Edge> {
    let close = JOINED * size(&found);
    let Some(first) =
        found.iter().position(|e| e.source == Side::B).or(if found.is_empty() { None } else { Some(0) })
    else {
        return found;
    };
    let mut left = Left::new(&found, close);
    let mut chained = Vec::with_capacity(found.len());
    let mut next = Some(first);
    while let Some(i) = next {
        left.take(i);
        chained.push(found[i]);
        next = left.after(found[i].to);
    }
    chained
}

/// Edges that are not in the chain yet, found by where they begin.
struct Left<'e> {
    /// All edges, in the order in which they were told.
    edges: &'e [Edge],
    /// How far apart two ends may be that are the same vertex, in units of configuration space.
    close: f64,
    /// Numbers of edges by the x of their start; ties in the order in which they were told.
    by_start: Vec<usize>,
    /// For each edge whether it is in the chain.
    taken: Vec<bool>,
}

impl<'e> Left<'e> {
    /// All edges, before any is taken.
    fn new(edges: &'e [Edge], close: f64) -> Self {
        let by_start = sorted(edges.len(), &|i, j| edges[i].from.x.total_cmp(&edges[j].from.x));
        Self { edges, close, by_start, taken: vec![false; edges.len()] }
    }

    /// Puts an edge into the chain.
    fn take(&mut self, i: usize) {
        self.taken[i] = true;
    }

    /// The edge that begins at `end`, B's first; where none does, the one that begins nearest.
    fn after(&self, end: DVec2) -> Option<usize> {
        let x = |i: usize| self.edges[i].from.x;
        let from = self.by_start.partition_point(|&i| x(i) < end.x - self.close);
        let near = self.by_start[from..].iter().copied().take_while(|&i| x(i) <= end.x + self.close);
        let gap = |i: usize| self.edges[i].from.distance(end);
        let touching = near.filter(|&i| !self.taken[i] && gap(i) <= self.close);
        let second = |i: usize| self.edges[i].source == Side::A;
        touching.min_by_key(|&i| (second(i), i)).or_else(|| {
            let left = (0..self.edges.len()).filter(|&i| !self.taken[i]);
            left.min_by(|&i, &j| gap(i).total_cmp(&gap(j)).then(second(i).cmp(&second(j))))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(source: Side, index: usize, from: (f64, f64), to: (f64, f64)) -> Event {
        let (from, to) = (DVec2::from(from), DVec2::from(to));
        let along = (to - from).normalize();
        let normal = DVec2::new(along.y, -along.x);
        Event::DifferenceEdgeFound {
            source,
            edge: index,
            vertex: 0,
            from,
            to,
            normal,
            distance: -normal.dot(from),
        }
    }

    #[test]
    fn edges_told_body_by_body_become_one_chain() {
        // Two unit squares, vertex on vertex at the origin; B's edge comes first on each shared edge.
        let told = [
            edge(Side::A, 0, (2.0, 2.0), (1.0, 2.0)),
            edge(Side::A, 1, (0.0, 1.0), (0.0, 0.0)),
            edge(Side::A, 2, (1.0, 0.0), (2.0, 0.0)),
            edge(Side::A, 3, (2.0, 1.0), (2.0, 2.0)),
            edge(Side::B, 0, (0.0, 0.0), (1.0, 0.0)),
            edge(Side::B, 1, (2.0, 0.0), (2.0, 1.0)),
            edge(Side::B, 2, (1.0, 2.0), (0.0, 2.0)),
            edge(Side::B, 3, (0.0, 2.0), (0.0, 1.0)),
        ];
        let difference = Difference::of(told.iter()).unwrap();
        let n = difference.edges.len();
        assert_eq!(n, 8);
        for i in 0..n {
            assert_eq!(
                difference.edges[i].to,
                difference.edges[(i + 1) % n].from,
                "edge {i} leads to the next"
            );
        }
        assert_eq!(difference.edges[0].from, DVec2::ZERO);
        assert_eq!(difference.edges[0].source, Side::B);
    }

    #[test]
    fn a_segment_gives_both_of_its_edges() {
        // A point at the origin and a segment.
        let told = [edge(Side::B, 0, (1.0, 0.0), (3.0, 0.0)), edge(Side::B, 0, (3.0, 0.0), (1.0, 0.0))];
        assert_eq!(Difference::of(told.iter()).unwrap().edges.len(), 2);
    }

    #[test]
    fn events_without_a_difference_tell_none() {
        assert_eq!(Difference::of([Event::Finished { outcome: "apart" }].iter()), None);
    }

    #[test]
    fn a_joint_is_only_where_both_bodies_share_the_nearest_edge() {
        let told = [
            edge(Side::B, 0, (-2.0, -1.0), (0.0, -1.0)),
            edge(Side::A, 2, (0.0, -1.0), (3.0, -1.0)),
            edge(Side::B, 1, (3.0, -1.0), (3.0, 5.0)),
            edge(Side::B, 2, (3.0, 5.0), (-2.0, 5.0)),
            edge(Side::B, 3, (-2.0, 5.0), (-2.0, -1.0)),
        ];
        assert_eq!(Difference::of(told.iter()).unwrap().joint(), Some(DVec2::new(0.0, -1.0)));
        assert_eq!(Difference::of(told[2..].iter()).unwrap().joint(), None);
    }
}
