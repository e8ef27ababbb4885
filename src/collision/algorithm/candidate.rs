//! From the features that face each other to the answer: how every algorithm for one moment ends.
//!
//! An algorithm finds a [`Candidate`]: which feature of A faces which feature of B, and along which normal.
//! What the article's readers ask for, "the closest feature pair", is that edge of B ⊖ A that is nearest the
//! origin, and the book-keeping of which edge and vertex made it (Firth, "Collision detection for dummies",
//! the comments).
//!
//! An algorithm computes in doubles, so that its candidate may be a neighbour of the right one. Its numbers
//! are not the answer: [`conclude`] hands the candidate down to [`crate::collision::certified::distance`],
//! which proves the separation from there, and tells what was proved, so that all algorithms give the same
//! answer of the same pair.

use crate::collision::algorithm::outline::{Projection, Span, each_two_on_one_line, holding};
use crate::collision::algorithm::view::{PairView, Turning};
use crate::collision::certified::distance::certify;
use crate::collision::feature::{DifferenceEdge, DifferenceFeature, a_then_b};
use crate::collision::{Answer, Overlap, QueryKind, Separation};
use crate::geometry::{DVec2, Feature, Side, length};
use crate::trace::{Event, Goal, SupportVertex, Tracer};

/// A vertex or an edge of a core, counted along the core; a [`Feature`] counts in the file's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CoreFeature {
    /// This vertex of the core.
    Vertex(usize),
    /// The edge from this vertex of the core to the next.
    Edge(usize),
}

/// What an algorithm found: the features that face each other, and how far apart the cores are there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    /// Signed distance of the cores, without the radii, in world units.
    pub(crate) distance: f64,
    /// Unit vector from A to B, in A's frame.
    pub(crate) normal: DVec2,
    /// A's feature and B's.
    pub(crate) features: [CoreFeature; 2],
}

impl CoreFeature {
    /// The vertex of a box that lies in the quadrant of `direction`, in the box's frame.
    pub(crate) fn box_vertex(direction: DVec2) -> Self {
        // They count counter-clockwise from (−, −).
        Self::Vertex(match (direction.x >= 0.0, direction.y >= 0.0) {
            (false, false) => 0,
            (true, false) => 1,
            (true, true) => 2,
            (false, true) => 3,
        })
    }

    /// The edge of a box whose outward normal points as `direction` does, along an axis of the box's frame.
    pub(crate) fn box_edge(direction: DVec2) -> Self {
        // Edge k runs from vertex k: bottom, right, top, left.
        Self::Edge(if direction.x > 0.0 {
            1
        } else if direction.x < 0.0 {
            3
        } else if direction.y > 0.0 {
            2
        } else {
            0
        })
    }
}

impl Candidate {
    /// The features behind a projection of the origin onto an edge of B ⊖ A.
    pub(crate) fn of_projection(pair: &PairView, p: &Projection) -> Self {
        let DifferenceEdge { source, edge, vertex } = p.edge;
        if p.distance < 0.0 || p.span == Span::Within {
            let facing = partner(pair, p.edge).map_or(CoreFeature::Vertex(vertex), CoreFeature::Edge);
            let own = CoreFeature::Edge(edge);
            return Self { distance: p.line, normal: -p.outward, features: a_then_b(source, own, facing) };
        }
        let end = if p.along > 0.5 { pair.next(source, edge) } else { edge };
        let [a, b] = a_then_b(source, end, vertex);
        Self::of_vertices(pair, a, b)
    }

    /// Two vertices that face each other.
    ///
    /// Where they coincide no direction is better than another, and the normal is the world's x axis.
    pub(crate) fn of_vertices(pair: &PairView, a: usize, b: usize) -> Self {
        let v = pair.vertex(Side::B, b) - pair.vertex(Side::A, a);
        let distance = length(v);
        let normal = if distance > 0.0 { v / distance } else { pair.local_vector(DVec2::X) };
        Self { distance, normal, features: [CoreFeature::Vertex(a), CoreFeature::Vertex(b)] }
    }

    /// This candidate for the pair with A and B exchanged: `from` is the pair as it was, `to` the exchanged
    /// one.
    pub(crate) fn swapped(self, from: &PairView, to: &PairView) -> Self {
        let [a, b] = self.features;
        let normal = -to.local_vector(from.world_vector(self.normal));
        Self { distance: self.distance, normal, features: [b, a] }
    }
}

/// The other body's edge that lies along this edge of B ⊖ A, if one does.
fn partner(pair: &PairView, p: DifferenceEdge) -> Option<usize> {
    let other = p.source.other();
    if pair.edges(other) == 0 {
        return None;
    }
    [p.vertex, pair.previous(other, p.vertex)]
        .into_iter()
        .find(|&l| pair.turning_of(p.source, p.edge, l) == Turning::Along)
}

/// Proves a candidate and tells the answer.
pub(crate) fn conclude(pair: &PairView, c: &Candidate, tracer: &mut impl Tracer) -> Separation {
    let answer = separation(pair, c);
    tell(pair, &answer, tracer);
    answer
}

/// Tells an answer as every algorithm does, so that layers need not know who found it.
///
/// In this order: the supporting vertices of the edge that faces the other body, the point of B ⊖ A nearest
/// the origin, and the candidate that won.
pub(crate) fn tell(pair: &PairView, answer: &Separation, tracer: &mut impl Tracer) {
    let faces = match answer.features {
        [Feature::Edge(_), of_b] => Some((Side::B, -answer.normal, of_b)),
        [of_a, Feature::Edge(_)] => Some((Side::A, answer.normal, of_a)),
        _ => None,
    };
    if let Some((body, direction, feature)) = faces {
        tracer.record(|| Event::SupportFound {
            body,
            direction: *direction,
            vertices: ends(pair, body, feature),
        });
    }
    let (foot, distance) = (answer.normal * answer.separation, answer.separation);
    tracer.record(|| Event::OriginProjected { foot, distance });
    tracer.record(|| Event::CandidateImproved {
        goal: if distance < 0.0 { Goal::LeastPenetrating } else { Goal::LeastPositive },
        distance,
        foot,
        source: match answer.features {
            [Feature::Vertex(_), of_b @ Feature::Edge(_)] => (Side::B, of_b),
            [Feature::Edge(_), of_b @ Feature::Edge(_)] if is_on_edge_of_b(pair, answer) => (Side::B, of_b),
            [of_a, _] => (Side::A, of_a),
        },
    });
}

/// Where two edges face each other, whether the point of B ⊖ A nearest the origin is on B's: both are on one
/// line there, one after the other.
fn is_on_edge_of_b(pair: &PairView, answer: &Separation) -> bool {
    let normal = pair.local_vector(*answer.normal);
    let foot = normal * (answer.separation + pair.radius());
    let (mut of_b, mut most) = (false, 0.0);
    each_two_on_one_line(pair, |both| {
        let facing = -both[0].outward(pair).dot(normal);
        if facing > most {
            (of_b, most) = (holding(pair, both, foot).source == Side::B, facing);
        }
    });
    of_b
}

/// The vertex of a feature, or both ends of an edge, in the world.
fn ends(pair: &PairView, side: Side, feature: Feature) -> Vec<SupportVertex> {
    let body = pair.body(side);
    let pose = body.pose_at(pair.time());
    let indices = match feature {
        Feature::Vertex(i) => [Some(i), None],
        Feature::Edge(i) => body.shape.edge_ends(i).unwrap_or([i, i]).map(Some),
    };
    let told = |i: usize| Some(SupportVertex { index: i, point: pose.point(*body.shape.vertices.get(i)?) });
    indices.into_iter().flatten().filter_map(told).collect()
}

/// Proves a candidate, and tells the answer only where it says more than what was told of the cores: where a
/// body is round, or where both cores are points.
pub(crate) fn conclude_rounding(pair: &PairView, c: &Candidate, tracer: &mut impl Tracer) -> Separation {
    let points = pair.edges(Side::A) == 0 && pair.edges(Side::B) == 0;
    if pair.radius() > 0.0 || points { conclude(pair, c, tracer) } else { separation(pair, c) }
}

/// Proves a candidate: its features are where the proof begins, and of directions that tie it is the one
/// taken.
fn separation(pair: &PairView, c: &Candidate) -> Separation {
    let facing = |source, edge, vertex| DifferenceFeature::Edge(DifferenceEdge { source, edge, vertex });
    let hint = match c.features {
        [CoreFeature::Edge(edge), CoreFeature::Vertex(vertex) | CoreFeature::Edge(vertex)] => {
            facing(Side::A, edge, vertex)
        }
        [CoreFeature::Vertex(vertex), CoreFeature::Edge(edge)] => facing(Side::B, edge, vertex),
        [CoreFeature::Vertex(a), CoreFeature::Vertex(b)] => DifferenceFeature::Vertex([a, b]),
    };
    certify(&pair.certified, Some(hint))
}

/// Ends an algorithm: tells how the pair stands, and answers a query of either kind.
#[inline]
pub(crate) fn finish(kind: QueryKind, s: Separation, tracer: &mut impl Tracer) -> Answer {
    tracer.record(|| Event::Finished { outcome: s.word() });
    answer(kind, s)
}

/// A separation as the answer to a query for it, or for the verdict that it allows.
pub(crate) fn answer(kind: QueryKind, s: Separation) -> Answer {
    if kind == QueryKind::Overlap { Answer::Overlap(Overlap::from(&s)) } else { Answer::Separation(s) }
}
