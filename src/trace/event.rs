//! The one vocabulary of events for all algorithms.
//!
//! Facts own their data and are in world space and world units or, where said, in configuration space
//! (B ⊖ A = {b − a}).

use serde::Serialize;

use crate::geometry::{DVec2, Enclosure, Feature, Side};

use super::vocabulary::{EventField, EventKind, vocabulary};

/// A vertex that is farthest along a direction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SupportVertex {
    /// Index in the order in which the scene file writes the vertices.
    pub index: usize,
    /// World position, at the time of the query.
    pub point: DVec2,
}

/// What a candidate is the best of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Goal {
    /// The signed distance nearest to zero from below: the depth so far, for bodies that overlap.
    LeastPenetrating,
    /// The smallest positive distance: the distance so far, for bodies apart.
    LeastPositive,
}

/// Why a ray was not tested against an edge, or what came of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Culling {
    /// The edge faces away from the ray; it was skipped.
    BackFacing,
    /// The ray crosses the edge's line outside the edge, or beyond its end.
    Missed,
    /// The ray enters here.
    Hit,
}

/// A moment in [0, 1] and where the moving pair is then.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Moment {
    /// Time in [0, 1].
    pub time: f64,
    /// Angle of A then, in degrees.
    pub angle_a: f64,
    /// Angle of B then, in degrees.
    pub angle_b: f64,
}

vocabulary! {
/// Something an algorithm did or found.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum Event {
    /// An algorithm began, with the pair as it is at a moment. An advancement begins a distance query each
    /// step.
    Started {
        /// The algorithm's name in the table of algorithms.
        algorithm: &'static str,
        /// The moment it looks at.
        at: Moment,
    },
    /// The centres and radii of two circles were compared.
    CirclesCompared {
        /// World centres of A and B.
        centers: [DVec2; 2],
        /// Radii r₁ of A and r₂ of B.
        radii: [f64; 2],
        /// ‖A − B‖², the squared distance of the centres.
        distance_squared: f64,
        /// (r₁ + r₂)², which the squared distance is compared with.
        radii_squared: f64,
        /// Whether the squared test alone settled the question.
        early_out: bool,
    },
    /// The penetration of two circles was measured: p = ‖A − B‖ − (r₁ + r₂), N = (A − B)/‖A − B‖, P = N p.
    PenetrationMeasured {
        /// The signed distance p; negative when the circles overlap.
        p: f64,
        /// Unit vector from B to A, the article's N.
        direction: DVec2,
        /// The vector that moves B until they just touch.
        vector: DVec2,
    },
    /// The smallest and largest coordinates of a body were found.
    BoundsFound {
        /// Which of the query's bodies; None for the union.
        of: Option<Side>,
        /// Corner of smallest coordinates.
        min: DVec2,
        /// Corner of largest coordinates.
        max: DVec2,
        /// Vertices that touch each side: left, bottom, right, top.
        touching: [Vec<SupportVertex>; 4],
    },
    /// The extents of two AABBs were compared axis by axis: D = |`c_B` − `c_A`| − (`h_A` + `h_B`).
    ExtentsCompared {
        /// Centres of A and B.
        centers: [DVec2; 2],
        /// Half-extents of A and B.
        half_extents: [DVec2; 2],
        /// The gap D by component; negative where the boxes overlap on that axis.
        gap: DVec2,
    },
    /// A circle's centre was clamped to a box, in the box's frame.
    Clamped {
        /// The body that is the box.
        body: Side,
        /// The vector V, from the box's centre to the circle's, in the box's frame.
        v: DVec2,
        /// The box's half-extents.
        half_extents: DVec2,
        /// V clamped to the half-extents, in the box's frame.
        clamped: DVec2,
        /// The point `B_c` in the world: the point of the box closest to the circle; where the circle's
        /// centre is inside, the point of the nearest side.
        closest: DVec2,
        /// The vector D = B − `B_c` in the world.
        d: DVec2,
        /// What comes off ‖D‖: the circle's radius, and the box's where that is rounded.
        radius: f64,
    },
    /// The supporting vertices along a direction were found, all of them when they tie.
    SupportFound {
        /// The body that was asked.
        body: Side,
        /// The direction, in the world.
        direction: DVec2,
        /// One vertex, or two when an edge is square to the direction.
        vertices: Vec<SupportVertex>,
    },
    /// An edge of B ⊖ A was found. Each is told once a run, in the order in which the algorithm finds it; its
    /// end is another's start, to the bit. Where edges of both bodies lie on one line, B's comes first. The
    /// two sides of a segment, there and back, bear the same number.
    DifferenceEdgeFound {
        /// The body whose edge it is.
        source: Side,
        /// Index of that edge on its body.
        edge: usize,
        /// Index of the supporting vertex of the other body.
        vertex: usize,
        /// Where the edge starts in configuration space, counter-clockwise.
        from: DVec2,
        /// Where it ends.
        to: DVec2,
        /// Outward unit normal of B ⊖ A.
        normal: DVec2,
        /// Signed distance of the origin from the edge's line: positive when the origin is outside it.
        distance: f64,
    },
    /// The one that turns less of the next edges of both bodies, as they run in B ⊖ A, was taken.
    EdgesMerged {
        /// The body whose edge was taken.
        taken: Side,
        /// The vertex of B ⊖ A where it begins, in configuration space.
        at: DVec2,
        /// The edge, as a vector: A's is mirrored.
        edge: DVec2,
        /// The next edge of the other body; None where it has no more.
        other: Option<DVec2>,
    },
    /// B ⊖ A is round: its core is a point, or it has a radius. Emitted once, beside the edges of the core.
    DifferenceRounded {
        /// The centre of the disc, where the core is a point; else `None`.
        center: Option<DVec2>,
        /// The radius `r_A` + `r_B` around the core.
        radius: f64,
    },
    /// The origin was projected onto an edge or disc of B ⊖ A.
    OriginProjected {
        /// The foot of the projection, in configuration space.
        foot: DVec2,
        /// Signed distance from the origin to the foot.
        distance: f64,
    },
    /// A better answer than before was found.
    CandidateImproved {
        /// What it is the best of.
        goal: Goal,
        /// Signed distance of the candidate.
        distance: f64,
        /// Where the origin projects, in configuration space.
        foot: DVec2,
        /// The body whose edge or vertex carries it, with its feature.
        source: (Side, Feature),
    },
    /// The pair was projected on an axis (separating-axis test).
    AxisTested {
        /// The unit axis: out of an edge of A, or into one of B.
        axis: DVec2,
        /// The body whose edge gave it.
        source: (Side, Feature),
        /// A's interval along the axis.
        interval_a: Enclosure,
        /// B's interval along the axis.
        interval_b: Enclosure,
        /// From A's upper end to B's lower one along the axis: positive, the gap of the intervals; negative,
        /// the depth of the other body's support behind the edge's line.
        gap: f64,
    },
    /// An axis separates the pair; a test for overlap may stop here.
    SeparatingAxisFound {
        /// Unit vector from A to B.
        normal: DVec2,
        /// Positive gap along it.
        gap: f64,
    },
    /// GJK chose a new simplex.
    SimplexUpdated {
        /// Vertices of the simplex in B ⊖ A, one to three.
        vertices: Vec<DVec2>,
        /// The point of the simplex closest to the origin.
        closest: DVec2,
        /// The support direction that follows.
        direction: DVec2,
    },
    /// EPA looked beyond the edge of its polytope that is nearest to the origin.
    PolytopeExpanded {
        /// Vertices of the polytope, counter-clockwise, in B ⊖ A.
        vertices: Vec<DVec2>,
        /// Distance of the nearest edge from the origin.
        nearest: f64,
        /// Index in `vertices` of the vertex at which the nearest edge begins.
        edge: usize,
        /// Outward unit normal of that edge: the direction of the search.
        normal: DVec2,
        /// The vertex w of B ⊖ A that is farthest along it.
        support: DVec2,
        /// How far that vertex is beyond the edge's line. Where it is not above 0 the search ends: the edge
        /// is one of B ⊖ A.
        beyond: f64,
    },
    /// The ray from the origin along the relative velocity was held against an edge or vertex disc of B ⊖ A.
    RayClipped {
        /// The body whose edge it is, with its feature.
        source: (Side, Feature),
        /// Start of the edge (offset by the radius), or the disc's centre twice.
        from: DVec2,
        /// End of the edge.
        to: DVec2,
        /// What came of the test.
        outcome: Culling,
        /// Time at which the ray meets the edge's line, where it was computed.
        time: Option<f64>,
    },
    /// An advancement took one step.
    Advanced {
        /// Number of the step, from 1.
        step: usize,
        /// The moment before the step.
        at: Moment,
        /// Signed separation at that moment.
        separation: f64,
        /// Unit normal from A to B.
        normal: DVec2,
        /// Witness points on A and B.
        points: [DVec2; 2],
        /// Closest point of B ⊖ A, in configuration space at that moment (for `ray-clipping`: at t = 0, where
        /// the estimate moves instead).
        closest: DVec2,
        /// The estimate on the ray, in the same space: the origin, or t v for `ray-clipping`.
        estimate: DVec2,
        /// Closing speed v·n of the bodies as they move, without their turning.
        closing_speed: f64,
        /// Bound on the approach used: v·n + `r_A|ω_A`| + `r_B|ω_B`|.
        bound: f64,
        /// Time after the step; None where the algorithm stopped here.
        next: Option<f64>,
    },
    /// The swept axis: for all of [from, to] the pair is apart along an axis that turns with a body.
    AxisSwept {
        /// Start of the covered time.
        from: f64,
        /// End of the covered time.
        to: f64,
        /// The body in whose frame the axis is fixed. The frame of a body whose core is its own origin does
        /// not turn: it is the world's.
        owner: Side,
        /// Axis in that body's frame, from the owner to the other. Of length 1 but for rounding; at least ½
        /// where only an exact direction will do.
        normal: DVec2,
    },
    /// The moment was found at which bodies that never touch are closest, over t in [0, 1].
    ClosestApproachFound {
        /// When they are closest.
        at: Moment,
        /// Separation at that moment, world units.
        separation: f64,
        /// Encloses the least separation over [0, 1], world units.
        bounds: Enclosure,
        /// Unit normal from A to B at that moment.
        normal: DVec2,
        /// Witness points on A and B at that moment.
        points: [DVec2; 2],
    },
    /// What someone else answered was held against the bounds of the answer. Numbers are None where it does
    /// not say them, or where there is nothing to hold them against.
    ExpectationCompared {
        /// S of the pair, world units.
        size: f64,
        /// What came out there and here, in words; None where either is open.
        outcome: Option<[&'static str; 2]>,
        /// How far the separation is outside the bounds, world units.
        separation: Option<f64>,
        /// How far the time is outside the bounds.
        time: Option<f64>,
        /// Angle between the normals, in degrees.
        normal_deg: Option<f64>,
        /// Distance of the points on A and B from where such points may be, world units.
        points: Option<[f64; 2]>,
    },
    /// The farthest a point of a body can move was bounded: L = θ r.
    MotionBounded {
        /// The body that was looked at.
        body: Side,
        /// Distance of its farthest point from its origin.
        radius: f64,
        /// The angle θ that the body turns by, |ω| over the time, in radians.
        theta: f64,
        /// The arc L = θ r, in world units.
        arc: f64,
        /// Length of the path of the body's origin.
        linear: f64,
        /// Every vertex at that distance from the origin.
        vertices: Vec<SupportVertex>,
    },
    /// The edges were chosen that face each other in a contact, without the bodies' radii.
    EdgesFaced {
        /// The body of the reference edge, which the other body's edge is clipped against.
        body: Side,
        /// The reference edge.
        reference: Feature,
        /// The other body's edge, the incident one.
        incident: Feature,
        /// Where the reference edge starts in the world, counter-clockwise on its body.
        from: DVec2,
        /// Where it ends.
        to: DVec2,
        /// Its outward unit normal.
        normal: DVec2,
        /// The ends of the incident edge in the world, in the order in which they lie along the reference
        /// edge.
        ends: [DVec2; 2],
    },
    /// An end of the incident edge was cut off, at the plane through an end of the reference edge.
    EdgeCut {
        /// The end of the reference edge, in the world.
        plane: DVec2,
        /// The end that was cut off.
        end: DVec2,
        /// Where the incident edge ends now.
        at: DVec2,
    },
    /// An end of what was left of the incident edge was held against the reference edge.
    ContactFound {
        /// The points of A and B over each other, in the world.
        points: [DVec2; 2],
        /// Their separation, world units: minus the depth.
        separation: f64,
        /// The features of A and B that carry them.
        features: [Feature; 2],
        /// Whether it is a point of contact: its separation is not above 0.
        touches: bool,
    },
    /// An algorithm ended.
    Finished {
        /// How it ended, in a short word for the story, as "hit" or "separating axis".
        outcome: &'static str,
    },
}
}
