//! Distance by GJK, depth by EPA.
//!
//! GJK walks over B ⊖ A without building it, so that it tells no edge of it: a simplex of at most three of
//! its vertices, the point v of the simplex closest to the origin, and a new vertex w, the one farthest
//! towards the origin:
//!
//! ```text
//! w = s_B(−v) − s_A(v)      stop: ‖v‖² − v·w ≤ 0, no vertex is nearer      v = 0: the origin is inside
//! ```
//!
//! Inside, EPA (the expanding polytope) grows the triangle around the origin: the edge nearest the origin is
//! split by the vertex of B ⊖ A farthest along its outward normal, until there is none beyond it; that edge
//! is the way out.
//!
//! Both walk on vertices, counted, not on rounded points: a vertex is a pair of core vertices, so "w is not
//! new" is exact and no tolerance ends the search. The origin on the simplex itself (touching bodies, or a
//! difference without interior) starts EPA from a segment, whose far edge decides. A polytope that outgrows
//! its storage, and a walk that rounding turns in circles, are finished by the merge of
//! [`crate::collision::algorithm::merge`], which needs no storage and always ends.
//!
//! Source: Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance between complex objects in
//! three-dimensional space" (1988); van den Bergen, "Collision detection in interactive 3D environments"
//! (2003), sections 4.3 (GJK) and 4.3.8 (EPA); Catto, "Computing distance with GJK" (GDC 2010).

use crate::collision::algorithm::candidate::{self, Candidate};
use crate::collision::algorithm::epa;
use crate::collision::algorithm::nearest_edge::NearestEdge;
use crate::collision::algorithm::outline::each_edge;
use crate::collision::algorithm::simplex::{Simplex, Vertex};
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, DISCRETE, Stops, convex_pair};
use crate::collision::feature::DifferenceEdge;
use crate::collision::{Answer, Query};
use crate::geometry::{DVec2, Side};
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "gjk",
    about: "distance by GJK, depth by EPA (Gilbert et al. 1988; van den Bergen 2003, 4.3)",
    kinds: DISCRETE,
    shapes: convex_pair,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// How the search for the origin ended.
#[derive(Clone, Copy, Debug)]
enum Found {
    /// The origin is outside, and the closest point is this vertex.
    Vertex(Vertex),
    /// The origin is outside, and the closest point is on the edge between these.
    Edge(Vertex, Vertex),
    /// The origin is in the triangle, or on the simplex.
    Inside(Simplex),
    /// The walk did not end: rounding turned it in circles.
    Stalled,
}

/// Answers a query for overlap or separation.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    let candidate = match search(&pair, tracer) {
        Found::Vertex(v) => Some(Candidate::of_vertices(&pair, v.a, v.b)),
        Found::Edge(p, q) => of_edge(&pair, p, q),
        Found::Inside(simplex) => {
            epa::expand(&pair, simplex.vertices(), tracer).and_then(|[p, q]| of_edge(&pair, p, q))
        }
        Found::Stalled => None,
    };
    let candidate = candidate.unwrap_or_else(|| by_merging(&pair));
    let separation = candidate::conclude(&pair, &candidate, tracer);
    candidate::finish(query.kind, separation, tracer)
}

/// Walks towards the origin: the closest point of the simplex, the vertex beyond it, the simplex with it.
fn search(pair: &PairView, tracer: &mut impl Tracer) -> Found {
    // Any vertex of B ⊖ A would do, but it must be one: EPA's polytope has to be convex.
    let first = Vertex::farthest(pair, DVec2::X);
    let mut simplex = Simplex::point(first);
    // Each step takes a vertex closer to the origin, and there are n + m.
    for _ in 0..2 * (pair.count(Side::A) + pair.count(Side::B)) + 2 {
        let Some((reduced, v)) = simplex.closest() else {
            tell_simplex(pair, &simplex, DVec2::ZERO, tracer);
            return Found::Inside(simplex);
        };
        simplex = reduced;
        tell_simplex(pair, &simplex, v, tracer);
        if v == DVec2::ZERO {
            return Found::Inside(simplex);
        }
        let w = Vertex::farthest(pair, -v);
        let old = simplex.vertices().iter().any(|u| u.is(&w));
        if old || v.dot(v - w.point) <= 0.0 {
            return match *simplex.vertices() {
                // Counter-clockwise: the origin is to the right.
                [p, q] if (q.point - p.point).perp_dot(p.point) > 0.0 => Found::Edge(p, q),
                [p, q] => Found::Edge(q, p),
                _ => Found::Vertex(simplex.first()),
            };
        }
        simplex.push(w);
    }
    Found::Stalled
}

/// The candidate of an edge of B ⊖ A from one of its vertices to another, counter-clockwise.
///
/// It is made of an edge of one body or, where they are parallel, of both. None where rounding made it of
/// vertices that are not neighbours.
fn of_edge(pair: &PairView, p: Vertex, q: Vertex) -> Option<Candidate> {
    let of_a = p.a != q.a && pair.next(Side::A, p.a) == q.a;
    let of_b = p.b != q.b && pair.next(Side::B, p.b) == q.b;
    let edge_of_a = |vertex| of_a.then_some(DifferenceEdge { source: Side::A, edge: p.a, vertex });
    let edge_of_b = |vertex| of_b.then_some(DifferenceEdge { source: Side::B, edge: p.b, vertex });
    let mut nearest = NearestEdge::default();
    [edge_of_a(p.b), edge_of_a(q.b), edge_of_b(p.a), edge_of_b(q.a)].into_iter().flatten().for_each(|edge| {
        let p = edge.project(pair);
        nearest.offer(p.distance, p);
    });
    nearest.found().map(|p| Candidate::of_projection(pair, &p))
}

/// The candidate by looking at every edge of the outline.
fn by_merging(pair: &PairView) -> Candidate {
    let mut nearest = NearestEdge::default();
    each_edge(pair, |edge| {
        let p = edge.project(pair);
        nearest.offer(p.distance, p);
    });
    nearest.candidate(pair)
}

/// Tells a simplex, its closest point, and where the walk looks next.
fn tell_simplex(pair: &PairView, simplex: &Simplex, v: DVec2, tracer: &mut impl Tracer) {
    tracer.record(|| Event::SimplexUpdated {
        vertices: simplex.vertices().iter().map(|u| pair.world_vector(u.point)).collect(),
        closest: pair.world_vector(v),
        direction: pair.world_vector(-v),
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::tests::bodies::{boxed, placed, polygon};
    use crate::collision::{Answer, QueryKind};
    use crate::geometry::Body;
    use crate::geometry::length;
    use crate::trace::Trace;

    fn gjk(a: &Body, b: &Body) -> (f64, Vec<Event>) {
        let kind = QueryKind::Separation;
        let query = Query { kind, a, b: Some(b), time: 0.0, tolerance: 0.0, max_iterations: 1 };
        let mut trace = Trace::default();
        let Answer::Separation(s) = answer(&query, &mut trace) else { panic!("{trace:?}") };
        (s.separation, trace.events)
    }

    /// Distances of the closest points of the simplices, in order.
    fn walked(events: &[Event]) -> Vec<f64> {
        let closest = events.iter().filter_map(|e| match e {
            Event::SimplexUpdated { closest, .. } => Some(length(*closest)),
            _ => None,
        });
        closest.collect()
    }

    #[test]
    fn each_simplex_is_closer_than_the_one_before() {
        let a = polygon(&[[-3., -1.], [-1., -2.5], [1., -1.5], [0.5, 1.], [-2., 1.5]], 0.0);
        let b = polygon(&[[8.5, 3.5], [6.5, 7.], [3., 6.], [6., 2.]], 0.0);
        let (s, events) = gjk(&a, &b);
        let walked = walked(&events);
        assert!(walked.len() >= 3 && walked.windows(2).all(|w| w[1] < w[0]), "{walked:?}");
        assert!((walked.last().unwrap() - s).abs() < 1e-14);
    }

    #[test]
    fn the_polytope_grows_to_the_nearest_edge() {
        let (s, events) = gjk(&boxed("box", 3., 1.5), &placed(boxed("box", 2., 1.5), 1., 0.5, 10.));
        let nearest: Vec<f64> = events
            .iter()
            .filter_map(|e| match e {
                Event::PolytopeExpanded { nearest, .. } => Some(*nearest),
                _ => None,
            })
            .collect();
        assert!(nearest.len() >= 2 && nearest.windows(2).all(|w| w[1] >= w[0]), "{nearest:?}");
        assert!((nearest.last().unwrap() + s).abs() < 1e-14, "{nearest:?} {s}");
    }

    #[test]
    fn what_gjk_tells_is_what_it_did_and_no_edge_of_a_difference_that_it_never_builds() {
        for (b, found) in [(4.0, "simplex-updated"), (1.0, "polytope-expanded")] {
            let (_, events) = gjk(
                &polygon(&[[-1., -1.], [1., -1.], [0., 1.]], 0.25),
                &placed(boxed("box", 1., 1.), b, 0.5, 10.),
            );
            let name = |e: &Event| serde_json::to_value(e).unwrap()["event"].as_str().unwrap().to_owned();
            let told: Vec<String> = events.iter().map(name).collect();
            assert!(told.iter().any(|name| name == found), "{told:?}");
            assert!(!told.iter().any(|name| name.starts_with("difference-")), "{told:?}");
        }
    }

    #[test]
    fn a_polytope_that_outgrows_its_storage_is_finished_by_the_merge() {
        let vertex = |k: i32| {
            let angle = f64::from(k) * std::f64::consts::TAU / 512.0;
            [libm::cos(angle), libm::sin(angle)]
        };
        let round: Vec<[f64; 2]> = (0..512).map(vertex).collect();
        let (s, _) = gjk(&polygon(&round, 0.0), &polygon(&round, 0.0));
        // Twice the distance of an edge from the centre.
        assert!((s + 2.0 * libm::cos(std::f64::consts::PI / 512.0)).abs() < 1e-14, "{s}");
    }
}
