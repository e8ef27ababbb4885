//! Linear sweep as one ray against B ⊖ A: the default for bodies that do not turn.
//!
//! Seen from A, B moves by −v, v = `v_A` − `v_B`; so A meets B when the ray r(t) = t v from the origin enters
//! B ⊖ A. It can do so only through an edge that faces it, v·n > 0 (n from A to B), and of those through the
//! one whose line it meets last, or through the disc at one of that edge's ends. The numbers are proved by
//! [`Sweep`]; what is told here is what the article draws: each edge of B ⊖ A, moved out by ρ = `r_A` +
//! `r_B`, with the time at which the ray meets its line,
//!
//! ```text
//! t = (g − ρ) / (v·n)         g: the gap of the cores along n at t = 0
//! ```
//!
//! and whether it faces away, is missed, or is hit.
//!
//! Source: Paul Firth, "Collision detection for dummies" (2011), section Continuous.

use crate::collision::algorithm::outline::{self, each_edge, each_two_on_one_line, holding};
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, Stops, motion, unturning_pair};
use crate::collision::certified::sweep::Sweep;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature};
use crate::collision::{Answer, Impact, Outcome, Query, QueryKind};
use crate::geometry::{DVec2, Feature, Side};
use crate::trace::{Culling, Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "ray-cast",
    about: "one ray against the edges of B - A that face it, direct (Firth 2011, Continuous)",
    kinds: &[QueryKind::LinearSweep],
    shapes: unturning_pair,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: Some(|query| {
        let sweep = sweep_of(query);
        Box::new(move || impact(sweep.first_contact()))
    }),
};

/// Answers a linear sweep.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let sweep = sweep_of(query);
    let outcome = sweep.first_contact();
    if tracer.listens() {
        tell(query, &sweep, &outcome, tracer);
    }
    motion::finish(query, &outcome, tracer);
    impact(outcome)
}

/// The sweep that a query asks for.
fn sweep_of<'s>(query: &Query<'s>) -> Sweep<'s> {
    Sweep::new(query.a, query.b.unwrap_or(query.a))
}

/// An outcome as the answer to a query.
fn impact(outcome: Outcome) -> Answer {
    Answer::Impact(Impact { outcome, tolerance: 0.0, iterations: 1 })
}

/// Records what became of each edge of B ⊖ A, and of the disc that is hit.
fn tell(query: &Query, sweep: &Sweep, outcome: &Outcome, tracer: &mut impl Tracer) {
    let (a, b) = (query.a, query.b.unwrap_or(query.a));
    let pair = PairView::at(a, b, 0.0);
    tracer.record(|| Event::Started { algorithm: ALGORITHM.name, at: pair.moment() });
    outline::tell(&pair, tracer);
    let v = pair.local_vector(a.velocity - b.velocity);
    let hit = match outcome {
        Outcome::Hit { .. } | Outcome::Overlapping { .. } => sweep.entered(),
        Outcome::Miss | Outcome::Unresolved { .. } => None,
    };
    let starts_inside = matches!(outcome, Outcome::Overlapping { .. });
    let radius = pair.radius();
    let met = match hit {
        Some(DifferenceFeature::Edge(edge)) => Some(met(&pair, edge, v)),
        _ => None,
    };
    each_edge(&pair, |p| {
        let [from, to] = p.ends(&pair);
        let outward = p.outward(&pair);
        let faces = v.perp_dot(to - from) < 0.0;
        let time = faces.then(|| (outward.dot(from) + radius) / outward.dot(v) + 0.0);
        let culling = match faces {
            false => Culling::BackFacing,
            // A ray that starts inside has entered before; one that starts on the edge enters there.
            true if starts_inside && time != Some(0.0) => Culling::Missed,
            true if met.is_some_and(|edge| is_same(edge, p)) => Culling::Hit,
            true => Culling::Missed,
        };
        tracer.record(|| Event::RayClipped {
            source: (p.source, Feature::Edge(pair.file_edge(p.source, p.edge))),
            from: pair.world_vector(from + outward * radius),
            to: pair.world_vector(to + outward * radius),
            outcome: culling,
            time,
        });
    });
    if let (Some(DifferenceFeature::Vertex(vertex)), Outcome::Hit { time, .. }) = (hit, outcome) {
        tell_disc(&pair, vertex, time.lo, tracer);
    }
}

/// Records that the ray enters through the disc at a vertex of B ⊖ A.
fn tell_disc(pair: &PairView, [i, j]: [usize; 2], time: f64, tracer: &mut impl Tracer) {
    let center = pair.world_vector(pair.vertex(Side::B, j) - pair.vertex(Side::A, i));
    let source = (Side::B, Feature::Vertex(pair.file_vertex(Side::B, j)));
    let (outcome, time) = (Culling::Hit, Some(time));
    tracer.record(|| Event::RayClipped { source, from: center, to: center, outcome, time });
}

/// The edge of B ⊖ A that the ray along `v` meets on the line of an edge: that one, or the other body's that
/// goes on from it.
fn met(pair: &PairView, edge: DifferenceEdge, v: DVec2) -> DifferenceEdge {
    let ([from, _], outward) = (edge.ends(pair), edge.outward(pair));
    let point = v * ((outward.dot(from) + pair.radius()) / outward.dot(v)) - outward * pair.radius();
    let mut met = edge;
    each_two_on_one_line(pair, |both| {
        if both.iter().any(|p| is_same(*p, edge)) {
            met = holding(pair, both, point);
        }
    });
    met
}

/// Whether two edges of B ⊖ A are made by the same edge of the same body.
fn is_same(p: DifferenceEdge, q: DifferenceEdge) -> bool {
    (p.source, p.edge) == (q.source, q.edge)
}
