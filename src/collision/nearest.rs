//! A guess, in plain doubles, of the features by which two cores are closest: whatever follows from it is proved
//! elsewhere, so a wrong guess costs time and nothing else.

use super::difference::{Projection, walk};
use super::minkowski::is_better;
use super::relative::Relative;
use crate::geometry::{Body, Side};

/// The closest features of two cores, counted along the cores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Nearest {
    /// An edge of `owner` and a vertex of the other.
    Edge {
        /// The body whose edge it is.
        owner: Side,
        /// The edge.
        edge: usize,
        /// The other body's vertex.
        vertex: usize,
    },
    /// A vertex of A and a vertex of B.
    Vertices(usize, usize),
}

/// The closest features of two bodies at time `t`, and the signed distance of the cores. O(n + m).
pub(super) fn nearest(a: &Body, b: &Body, t: f64) -> (Nearest, f64) {
    let pair = Relative::at(a, b, t);
    let mut best: Option<Projection> = None;
    walk(&pair, |pairing| {
        let p = pairing.project(&pair);
        if best.is_none_or(|b| is_better(p.distance, b.distance)) {
            best = Some(p);
        }
    });
    let Some(p) = best else {
        let d = pair.vertex(Side::B, 0) - pair.vertex(Side::A, 0);
        return (Nearest::Vertices(0, 0), libm::hypot(d.x, d.y));
    };
    let (owner, edge, vertex) = (p.pairing.source, p.pairing.edge, p.pairing.vertex);
    if p.distance <= 0.0 || (p.along > 0.0 && p.along < 1.0) {
        return (Nearest::Edge { owner, edge, vertex }, p.distance);
    }
    let end = if p.along > 0.5 { pair.next(owner, edge) } else { edge };
    let found =
        if owner == Side::A { Nearest::Vertices(end, vertex) } else { Nearest::Vertices(vertex, end) };
    (found, p.distance)
}

/// The certified separation at time `t`.
pub(super) fn certified(a: &Body, b: &Body, t: f64) -> super::Separation {
    super::Pair::at(a, b, t).separation()
}
