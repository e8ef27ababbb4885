//! Points of contact by clipping an edge against an edge.
//!
//! Bodies that touch share more than one point, and an engine that pushes them apart at one makes them rock.
//! So the edge nearest the other body, the reference edge, is held still; the edge of the other body that
//! faces it, the incident edge, is clipped by the two planes through the reference edge's ends; what is left
//! of it and lies below the reference edge is the contact: its two ends, each with its own depth.
//!
//! ```text
//! reference   the edge of the least depth; of two that are parallel and face each other, A's
//! incident    of the edges at the other body's deepest vertex the one most nearly against its normal; of two
//!             that are equally so, the one that begins at that vertex, counter-clockwise
//! contacts    ends of what is left with separation ≤ 0, along the reference edge
//! ```
//!
//! Rounded bodies are clipped by their cores, and touch where these are no farther apart than the radii.
//! Where vertices face each other, and where a body is a circle, there is one point and nothing to clip: it
//! is the one that witnesses the separation.
//!
//! Source: Sutherland and Hodgman, "Reentrant polygon clipping", Communications of the ACM 17 (1974); Catto,
//! "Contact manifolds", Game Developers Conference 2007. The numbers are those of
//! [`crate::collision::certified::clip`].

use crate::collision::algorithm::candidate;
use crate::collision::algorithm::view::PairView;
use crate::collision::algorithm::{Algorithm, Stops, convex_pair};
use crate::collision::answer::{Contact, ContactPoint};
use crate::collision::certified::clip::{Clipped, ClippedEdges, clipped};
use crate::collision::{Answer, Query, QueryKind};
use crate::geometry::Side;
use crate::trace::{Event, Tracer};

/// Its row in the table of algorithms.
pub(crate) const ALGORITHM: Algorithm = Algorithm {
    name: "clip",
    about: "the facing edge clipped to the ends of the reference edge (Sutherland, Hodgman 1974; Catto 2007)",
    kinds: &[QueryKind::Contact],
    shapes: convex_pair,
    stops: Stops::Exactly,
    #[cfg(not(tracefig_page))]
    quiet: answer,
    traced: answer,
    #[cfg(not(tracefig_page))]
    ready: None,
};

/// Answers a query for the contact.
fn answer(query: &Query, tracer: &mut impl Tracer) -> Answer {
    let pair = PairView::start(query, ALGORITHM.name, tracer);
    let Clipped { contact, edges } = clipped(&pair.certified);
    candidate::tell(&pair, &contact.separation, tracer);
    match &edges {
        Some(edges) => tell(&contact, edges, tracer),
        None => contact.found().for_each(|point| tracer.record(|| found(point))),
    }
    tracer.record(|| Event::Finished { outcome: contact.separation.word() });
    Answer::Contact(contact)
}

/// Tells the edges, what each plane cut off, and what became of each end.
fn tell(contact: &Contact, edges: &ClippedEdges, tracer: &mut impl Tracer) {
    let (Some((body, reference)), Some((_, incident))) = (contact.reference, contact.incident) else {
        return;
    };
    let n = *contact.separation.normal;
    tracer.record(|| Event::EdgesFaced {
        body,
        reference,
        incident,
        from: edges.reference[0],
        to: edges.reference[1],
        normal: if body == Side::A { n } else { -n },
        ends: edges.ends.map(|end| end.end),
    });
    for end in &edges.ends {
        if let Some(plane) = end.plane {
            tracer.record(|| Event::EdgeCut { plane: edges.reference[plane], end: end.end, at: end.kept });
        }
    }
    edges.ends.iter().for_each(|end| tracer.record(|| found(&end.point)));
}

/// An end, and whether it is a contact.
fn found(point: &ContactPoint) -> Event {
    let ContactPoint { separation, bounds, points, features } = *point;
    Event::ContactFound { points, separation, features, touches: bounds.lo <= 0.0 }
}
