//! Signed separation by the Minkowski difference, edge by edge, as the article does it.
//!
//! B ⊖ A = {b − a} holds the origin exactly when the bodies overlap, and its distance from the origin is theirs. Loop
//! over the edges of A with the vertices of B that support them, then over the edges of B with the vertices of A:
//! each pair is an edge of B ⊖ A. Project the origin onto it and keep the least penetrating distance, or, once the
//! origin is seen to be outside, the least positive one.
//!
//! ```text
//! s = supports of B along −N          N: outward normal of the edge v₀v₁ of A
//! edge of B ⊖ A: s − v₀ → s − v₁      dist = ± ‖foot‖, the sign that of (s − v₀)·N
//! ```
//!
//! Two edges that are exactly aligned have *two* supporting vertices; both are projected on ("re-project onto the edge
//! from the origin to make sure you don't accidentally pick the wrong edge-vertex pair").
//!
//! Two things differ from the article's listing. Its `Sign(0)` is 0, which calls a pair touching as soon as the origin
//! is on the *line* of an edge; here 0 counts as outside. And the round bodies that it leaves out are core and radius:
//! the distance of the cores less `r_A` + `r_B`. A core that is a point has no edges; two points have none between them,
//! and the one point of their difference is compared instead.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), sections OBB vs OBB and Poly vs Poly. O(n·m).

use crate::collision::Answer;
use crate::collision::Overlap;
use crate::collision::Query;
use crate::collision::QueryKind;
use crate::collision::Separation;
use crate::collision::algorithm::candidate::{self, Candidate};
use crate::collision::algorithm::outline::{Projection, record_rounding};
use crate::collision::algorithm::view::Relative;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::feature::DifferenceEdge;
use crate::geometry::{Feature, Side};
use crate::trace::{Event, Goal, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "minkowski",
    about: "B - A edge by edge with all supporting vertices, O(n m) (Firth 2011, OBB vs OBB)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    quiet: answer,
    traced: answer,
    ready: None,
};

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = Relative::of(query);
    tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: pair.at });
    if query.kind == QueryKind::Overlap {
        Answer::Overlap(overlap(&pair, tracer))
    } else {
        Answer::Separation(separation(&pair, tracer))
    }
}

/// Signed separation of a pair.
pub(crate) fn separation(pair: &Relative, tracer: &mut impl Tracer) -> Separation {
    let found = closest(pair, None, tracer).candidate(pair);
    let answer = candidate::conclude_rounding(pair, &found, tracer);
    tracer.record(|| Event::Finished { outcome: answer.word() });
    answer
}

/// Whether a pair overlaps: the search ends at the first edge that separates.
fn overlap(pair: &Relative, tracer: &mut impl Tracer) -> Overlap {
    let answer = match closest(pair, Some(Axis::certain(pair)), tracer) {
        Closest::Axis(p) => candidate::separated(pair, &p),
        found => Overlap::from(&candidate::conclude_rounding(pair, &found.candidate(pair), tracer)),
    };
    tracer.record(|| Event::Finished { outcome: answer.word() });
    answer
}

/// What ends a search that only asks for overlap.
#[derive(Clone, Copy, Debug)]
struct Axis {
    /// A line of B ⊖ A that is farther from the origin separates, whatever was rounded.
    beyond: f64,
}

impl Axis {
    fn certain(pair: &Relative) -> Self {
        Self { beyond: pair.radius() + pair.gap_error() }
    }
}

/// What the loop found.
enum Closest {
    /// The nearest edge.
    Edge(Projection),
    /// An edge that separates, where that is all that was asked.
    Axis(Projection),
    /// Both cores are points: there is no edge.
    Points,
}

impl Closest {
    /// The features that it found facing each other.
    fn candidate(&self, pair: &Relative) -> Candidate {
        match self {
            Self::Axis(p) | Self::Edge(p) => Candidate::of_projection(pair, p),
            Self::Points => Candidate::of_vertices(pair, 0, 0),
        }
    }
}

/// The edge of B ⊖ A nearest the origin: least positive if the origin is outside any, else least penetrating. With
/// `axis` the first edge whose line is beyond that ends the search.
fn closest(pair: &Relative, axis: Option<Axis>, tracer: &mut impl Tracer) -> Closest {
    record_rounding(pair, tracer);
    let mut best: Option<Projection> = None;
    for source in [Side::A, Side::B] {
        for edge in 0..pair.edges(source) {
            for pairing in pairings(pair, source, edge, tracer).into_iter().flatten() {
                let p = pairing.project(pair);
                tracer.record(|| Event::OriginProjected {
                    foot: pair.world_vector(p.foot),
                    distance: p.distance,
                });
                if axis.is_some_and(|axis| p.line > axis.beyond) {
                    let (normal, gap) = (pair.world_vector(-p.outward), p.line - pair.radius());
                    tracer.record(|| Event::SeparatingAxisFound { normal, gap });
                    return Closest::Axis(p);
                }
                if best.is_none_or(|b| is_better(p.distance, b.distance)) {
                    tracer.record(|| improved(pair, &p));
                    best = Some(p);
                }
            }
        }
    }
    match best {
        Some(p) => Closest::Edge(p),
        None => Closest::Points,
    }
}

/// Whether a signed distance beats another: any outside beats inside, then the nearer one wins.
pub(crate) fn is_better(distance: f64, than: f64) -> bool {
    match (distance >= 0.0, than >= 0.0) {
        (true, true) => distance < than,
        (outside, true) => outside,
        (_, false) => distance > than,
    }
}

/// A better candidate, as an event.
pub(crate) fn improved(pair: &Relative, p: &Projection) -> Event {
    let goal = if p.distance < 0.0 { Goal::LeastPenetrating } else { Goal::LeastPositive };
    let source = (p.pairing.source, Feature::Edge(pair.file_edge(p.pairing.source, p.pairing.edge)));
    Event::CandidateImproved { goal, distance: p.distance, foot: pair.world_vector(p.foot), source }
}

/// The edge with each vertex of the other body that supports it. The first, which is told as an edge of B ⊖ A, is the one
/// that stands in the outline where B's edges come first.
fn pairings(
    pair: &Relative,
    source: Side,
    edge: usize,
    tracer: &mut impl Tracer,
) -> [Option<DifferenceEdge>; 2] {
    let (first, second) = pair.supports_of_edge(source, edge);
    let other = source.other();
    tracer.record(|| Event::SupportFound {
        body: other,
        direction: pair.world_vector(-pair.outward(source, edge)),
        vertices: [Some(first), second].into_iter().flatten().map(|k| pair.told(other, k)).collect(),
    });
    let (outline, beside) = match (source, second) {
        (Side::A, Some(second)) => (second, Some(first)),
        _ => (first, second),
    };
    let of = |vertex| DifferenceEdge { source, edge, vertex };
    tracer.record(|| of(outline).found(pair));
    [Some(of(outline)), beside.map(of)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::storyboard::{boxed, placed};
    use crate::trace::Trace;

    #[test]
    fn a_test_for_overlap_stops_at_the_first_edge_that_separates() {
        let (a, b) = (boxed("box", 1., 1.), placed(boxed("box", 1., 1.), 4., 0.5, 30.));
        let kind = QueryKind::Overlap;
        let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let mut trace = Trace::default();
        let Answer::Overlap(found) = answer(&query, &mut trace) else { panic!("{trace:?}") };
        assert_eq!((found.overlap, found.separation_bounds.hi), (Some(false), f64::INFINITY));
        let edges = trace.events.iter().filter(|e| matches!(e, Event::DifferenceEdgeFound { .. })).count();
        // A's right side is its second.
        assert_eq!(edges, 2);
        assert_eq!(trace.events.last(), Some(&Event::Finished { outcome: "separating axis" }));
    }
}
