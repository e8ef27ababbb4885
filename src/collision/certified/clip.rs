//! The points of contact of a pair, proved: an edge of one body clipped to the ends of the edge that faces
//! it.
//!
//! The nearest edge of B ⊖ A, as the separation proves it, is an edge of one body: the reference edge, from
//! p₀ to p₁, with outward unit normal m. Of the other body the vertex that faces it is known too; of the two
//! edges there, the one that is most nearly against m is the incident edge, from q₀ to q₁. With t = p₁ − p₀
//!
//! ```text
//! inside   t · (q − p₀) ≥ 0    and    t · (p₁ − q) ≥ 0     the planes through the reference edge's ends
//! cut      q = q₀ + λ (q₁ − q₀)       λ = f₀ / (f₀ − f₁),   f the plane's value at q₀ and q₁
//! depth    s = m · (q − p₀) − ρ       contact where s ≤ 0
//! ```
//!
//! all in balls, so that s is enclosed. Where a ball does not tell on which side of a plane an end lies, the
//! end is kept, and s widened by what it changes up to where the plane may be.
//!
//! Source: Sutherland and Hodgman, "Reentrant polygon clipping" (1974); Catto, "Contact manifolds" (GDC
//! 2007), for reference and incident edge.

use crate::collision::answer::{Contact, ContactPoint, Separation};
use crate::collision::certified::distance::balls::{BallPair, dot, minus, reversed};
use crate::collision::certified::distance::witnesses::{self, Carrier};
use crate::collision::certified::distance::{Pair, proved};
use crate::collision::feature::{DifferenceEdge, a_then_b};
use crate::geometry::{Ball, DVec2, Feature, Side};

/// The contact of a pair, and how it was clipped.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clipped {
    /// What comes of it.
    pub(crate) contact: Contact,
    /// The edges; None where nothing was clipped.
    pub(crate) edges: Option<ClippedEdges>,
}

/// An edge clipped against another: both without radii, in the world.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClippedEdges {
    /// The reference edge, counter-clockwise on its body.
    pub(crate) reference: [DVec2; 2],
    /// What became of the two ends of the incident edge, in the order of the contact's points.
    pub(crate) ends: [ClippedEnd; 2],
}

/// An end of the incident edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClippedEnd {
    /// Where it is.
    pub(crate) end: DVec2,
    /// Where the edge ends after clipping: there, or on a plane.
    pub(crate) kept: DVec2,
    /// The end of the reference edge, 0 or 1, whose plane cut it off; None where none did.
    pub(crate) plane: Option<usize>,
    /// The point that it makes; it is no contact where its separation is above 0.
    pub(crate) point: ContactPoint,
}

/// Reference and incident edge, counted along the cores, of a pair in balls.
struct Facing<'b, 'p, 's> {
    /// The pair.
    pair: &'p Pair<'s>,
    /// The pair in balls.
    balls: &'b BallPair<'p, 's>,
    /// The body of the reference edge.
    body: Side,
    /// The reference edge.
    reference: usize,
    /// The incident edge.
    incident: usize,
}

/// The contact of a pair.
#[cold]
pub(crate) fn clipped(pair: &Pair) -> Clipped {
    let found = proved(pair, None);
    let separation = witnesses::answer(pair, &found);
    let nothing = Contact { separation, reference: None, incident: None, points: [None; 2] };
    if separation.bounds.lo > 0.0 {
        return Clipped { contact: nothing, edges: None };
    }
    let balls = BallPair::new(pair);
    let witness = Contact { points: [Some(point_of(&separation)), None], ..nothing };
    let Some(facing) = Facing::of(pair, &balls, &found.carrier) else {
        return Clipped { contact: witness, edges: None };
    };
    let Some(edges) = facing.clip(&separation) else {
        return Clipped { contact: witness, edges: None };
    };
    let points = edges.ends.map(|end| Some(end.point).filter(|point| point.bounds.lo <= 0.0));
    let [reference, incident] = facing.features(&edges);
    let contact = Contact { reference: Some(reference), incident: Some(incident), points, ..nothing };
    Clipped { contact, edges: Some(edges) }
}

/// The point that the separation itself has for a witness.
fn point_of(s: &Separation) -> ContactPoint {
    ContactPoint { separation: s.separation, bounds: s.bounds, points: s.points, features: s.features }
}

impl<'b, 'p, 's> Facing<'b, 'p, 's> {
    /// Both edges behind the nearest feature of B ⊖ A; None where that is of two vertices, or a body has no
    /// edges. Of parallel edges A's is the reference.
    fn of(pair: &'p Pair<'s>, balls: &'b BallPair<'p, 's>, carrier: &Carrier) -> Option<Self> {
        let of = |body, reference, incident| Some(Self { pair, balls, body, reference, incident });
        match *carrier {
            Carrier::Vertex(_) => None,
            Carrier::ParallelEdges(DifferenceEdge { source, edge, .. }, partner) => {
                let [reference, incident] = a_then_b(source, edge, partner);
                of(Side::A, reference, incident)
            }
            Carrier::Edge(DifferenceEdge { source, edge, vertex }) => {
                let other = source.other();
                let hull = pair.hull(other);
                if hull.edges.is_empty() {
                    return None;
                }
                // Both normals point from A to B: the more alike, the more nearly the edges face each other.
                let normal = balls.normal(source, edge);
                let [ahead, behind] = [vertex, hull.previous(vertex)].map(|k| balls.normal(other, k));
                let is_behind = dot(&normal, &minus(&behind, &ahead)).is_positive();
                of(source, edge, if is_behind { hull.previous(vertex) } else { vertex })
            }
        }
    }

    /// The incident edge clipped to the ends of the reference edge; None where nothing of it is left.
    fn clip(&self, separation: &Separation) -> Option<ClippedEdges> {
        let (balls, other) = (self.balls, self.body.other());
        let next = |side: Side, k: usize| self.pair.hull(side).next(k);
        let [p0, p1] = [self.reference, next(self.body, self.reference)].map(|k| balls.vertex(self.body, k));
        let ends = [self.incident, next(other, self.incident)];
        // Its own direction: between its ends, which may be far from A, a short edge's is lost in rounding.
        let along = balls.edge(self.body, self.reference);
        // The value of each plane at each end: planes[plane][end].
        let q = ends.map(|k| balls.vertex(other, k));
        let planes = [q.map(|q| dot(&along, &minus(&q, &p0))), q.map(|q| dot(&along, &minus(&p1, &q)))];
        if planes.iter().any(|at| at.iter().all(|value| value.is_negative())) {
            return None;
        }
        let outward = match self.body {
            Side::A => balls.normal(Side::A, self.reference),
            Side::B => reversed(&balls.normal(Side::B, self.reference)),
        };
        let gaps = q.map(|q| dot(&outward, &minus(&q, &p0)));
        let made = [0, 1].map(|end| self.end(end, &ends, &planes, &gaps, separation));
        // The planes' values grow from one end to the other as the reference edge runs.
        let is_along = dot(&along, &minus(&q[1], &q[0])).value.hi >= 0.0;
        let reference = [self.reference, next(self.body, self.reference)]
            .map(|k| self.world(self.body, self.core(self.body, k)));
        let [first, second] = made;
        let ends = if is_along { [first, second] } else { [second, first] };
        Some(ClippedEdges { reference, ends })
    }

    /// One end of the incident edge, 0 or 1, and the point that it makes.
    fn end(
        &self,
        end: usize,
        vertices: &[usize; 2],
        planes: &[[Ball; 2]; 2],
        gaps: &[Ball; 2],
        separation: &Separation,
    ) -> ClippedEnd {
        let other = self.body.other();
        let slope = gaps[1 - end] - gaps[end];
        let plane = planes.iter().position(|at| at[end].is_negative());
        let (share, gap) = match plane {
            Some(k) => {
                let (here, there) = (planes[k][end], planes[k][1 - end]);
                let share = here.over(here - there);
                // Between the ends wherever the plane is, however little is known of it.
                let share = match share.value.hi {
                    _ if share.radius > 0.5 => Ball::new(0.5).widen(0.5),
                    x if x < 0.0 => Ball::ZERO.widen(share.radius),
                    x if x > 1.0 => Ball::ONE.widen(share.radius),
                    _ => share,
                };
                (share, gaps[end] + share * slope)
            }
            None => (Ball::ZERO, gaps[end].widen(doubt(end, planes) * slope.magnitude())),
        };
        let [from, to] = [end, 1 - end].map(|e| self.core(other, vertices[e]));
        let kept = self.world(other, from + (to - from) * share.value.hi);
        let (core, s) = (gap.value.hi, gap - Ball::exact(self.pair.radius));
        let bounds = s.enclosure_scaled(self.pair.unscale());
        let value = (s.value.hi * self.pair.unscale()).max(bounds.lo).min(bounds.hi);
        let point = ContactPoint {
            separation: value,
            bounds,
            points: self.witnesses(kept, core * self.pair.unscale(), separation),
            features: self.carriers(vertices[end], plane, [kept, self.foot(kept)]),
        };
        ClippedEnd { end: self.world(other, from), kept, plane, point }
    }

    /// The points of A and B over each other, for the point `kept` of the incident core and its gap.
    fn witnesses(&self, kept: DVec2, core: f64, separation: &Separation) -> [DVec2; 2] {
        let n = *separation.normal;
        let outward = if self.body == Side::A { n } else { -n };
        let [own, others] = [self.body, self.body.other()].map(|side| self.pair.shape(side).radius);
        a_then_b(self.body, kept - outward * (core - own), kept - outward * others)
    }

    /// What carries a point: the incident vertex over the reference edge, or the reference edge's end under
    /// the incident edge.
    fn carriers(&self, vertex: usize, plane: Option<usize>, [kept, foot]: [DVec2; 2]) -> [Feature; 2] {
        let (own, others) = (self.pair.shape(self.body), self.pair.shape(self.body.other()));
        let [here, over] = match plane {
            None => {
                [own.edge_feature(self.reference, self.local(self.body, foot)), others.vertex_feature(vertex)]
            }
            Some(k) => {
                let hull = self.pair.hull(self.body);
                let at = if k == 0 { self.reference } else { hull.next(self.reference) };
                let local = self.local(self.body.other(), kept);
                [own.vertex_feature(at), others.edge_feature(self.incident, local)]
            }
        };
        a_then_b(self.body, here, over)
    }

    /// Reference and incident edge as answers number them, at the middle of what is left of the latter.
    fn features(&self, edges: &ClippedEdges) -> [(Side, Feature); 2] {
        let middle = 0.5 * (edges.ends[0].kept + edges.ends[1].kept);
        let (body, other) = (self.body, self.body.other());
        let foot = self.local(body, self.foot(middle));
        [
            (body, self.pair.shape(body).edge_feature(self.reference, foot)),
            (other, self.pair.shape(other).edge_feature(self.incident, self.local(other, middle))),
        ]
    }

    /// The point of the reference edge's line that is nearest to a point; both in the world.
    fn foot(&self, p: DVec2) -> DVec2 {
        let next = self.pair.hull(self.body).next(self.reference);
        let [from, to] = [self.reference, next].map(|k| self.world(self.body, self.core(self.body, k)));
        let along = (to - from).normalize_or_zero();
        from + along * along.dot(p - from)
    }

    /// A core's vertex in its body's frame, as in its file.
    fn core(&self, side: Side, k: usize) -> DVec2 {
        self.pair.hull(side).vertices[k]
    }

    /// A point of a body's frame in the world; worked out to scale, so that nothing overflows.
    fn world(&self, side: Side, local: DVec2) -> DVec2 {
        let (pose, scale) = (self.pair.pose(side), self.pair.scale);
        (pose.position * scale + pose.vector(local * scale)) * self.pair.unscale()
    }

    /// A point of the world in a body's frame.
    fn local(&self, side: Side, p: DVec2) -> DVec2 {
        self.pair.pose(side).inverse_point(p)
    }
}

/// The share of the edge, from one of its ends, within which a plane may cut it though no ball tells so.
fn doubt(end: usize, planes: &[[Ball; 2]; 2]) -> f64 {
    let of = |at: &[Ball; 2]| {
        if at[end].sign().is_some() {
            return 0.0;
        }
        let cut = at[end].over(at[end] - at[1 - end]);
        (cut.value.hi.abs() + cut.radius).min(1.0)
    };
    planes.iter().map(of).fold(0.0, f64::max)
}
