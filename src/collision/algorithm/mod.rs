//! What the article does: one algorithm a file, traced, and one row in [`ALGORITHMS`].

pub(crate) mod advancement;
pub(crate) mod arc;
pub(crate) mod candidate;
pub(crate) mod circles;
pub(crate) mod clamp;
pub(crate) mod closest_features;
pub(crate) mod conservative_advancement;
pub(crate) mod epa;
pub(crate) mod extents;
pub(crate) mod extremes;
pub(crate) mod gjk;
pub(crate) mod merge;
pub(crate) mod minkowski;
pub(crate) mod outline;
pub(crate) mod ray_clipping;
pub(crate) mod separating_axes;
pub(crate) mod view;

use crate::collision::{Answer, Query, QueryKind};
use crate::geometry::Body;
use crate::trace::{NoTrace, Trace};

/// A row in the table of algorithms.
pub struct Algorithm {
    /// Its word in a scene file.
    pub name: &'static str,
    /// One line for `tracefig list`, with the source.
    pub about: &'static str,
    /// The questions it answers.
    pub kinds: &'static [QueryKind],
    /// Whether it takes this pair of shapes; the text says which shapes it takes.
    pub shapes: fn(&Query) -> Result<(), &'static str>,
    /// Answers without a trace.
    pub quiet: fn(&Query, &mut NoTrace) -> Answer,
    /// Answers, and records what it did.
    pub traced: fn(&Query, &mut Trace) -> Answer,
}

impl Algorithm {
    /// Answers without a trace.
    #[must_use]
    pub fn answer(&self, query: &Query) -> Answer {
        (self.quiet)(query, &mut NoTrace)
    }
}

/// Every algorithm; the first that takes a query is its default.
pub static ALGORITHMS: &[Algorithm] = &[
    Algorithm {
        name: closest_features::NAME,
        about: "closest features of B - A, proved by supports and witnesses in double-doubles (Toussaint 1983)",
        kinds: DISCRETE,
        shapes: convex_pair,
        quiet: closest_features::answer,
        traced: closest_features::answer,
    },
    Algorithm {
        name: circles::NAME,
        about: "circle against circle: squared early-out, p, N and P (Firth 2011, Circle vs circle)",
        kinds: DISCRETE,
        shapes: circles::shapes,
        quiet: circles::answer,
        traced: circles::answer,
    },
    Algorithm {
        name: extents::NAME,
        about: "AABB against AABB: D by component and the minimum translation (Firth 2011, AABB vs AABB)",
        kinds: DISCRETE,
        shapes: extents::shapes,
        quiet: extents::answer,
        traced: extents::answer,
    },
    Algorithm {
        name: clamp::NAME,
        about: "circle against box: V clamped in the box's frame (Firth 2011, Circle vs AABB, Circle vs OBB)",
        kinds: DISCRETE,
        shapes: clamp::shapes,
        quiet: clamp::answer,
        traced: clamp::answer,
    },
    Algorithm {
        name: merge::NAME,
        about: "B - A with its edges merged by direction, O(n + m) (de Berg et al. 2008, 13.3)",
        kinds: DISCRETE,
        shapes: convex_pair,
        quiet: merge::answer,
        traced: merge::answer,
    },
    Algorithm {
        name: minkowski::NAME,
        about: "B - A edge by edge with all supporting vertices, O(n m) (Firth 2011, OBB vs OBB)",
        kinds: DISCRETE,
        shapes: convex_pair,
        quiet: minkowski::answer,
        traced: minkowski::answer,
    },
    Algorithm {
        name: separating_axes::NAME,
        about: "a gap along the normal of an edge (Gottschalk et al. 1996, section 5)",
        kinds: DISCRETE,
        shapes: convex_pair,
        quiet: separating_axes::answer,
        traced: separating_axes::answer,
    },
    Algorithm {
        name: gjk::NAME,
        about: "distance by GJK, depth by EPA (Gilbert et al. 1988; van den Bergen 2003, 4.3)",
        kinds: DISCRETE,
        shapes: convex_pair,
        quiet: gjk::answer,
        traced: gjk::answer,
    },
    Algorithm {
        name: extremes::NAME,
        about: "smallest and largest coordinates of the vertices, and their union (Firth 2011, AABB vs AABB)",
        kinds: &[QueryKind::Bounds],
        shapes: extremes::shapes,
        quiet: extremes::answer,
        traced: extremes::answer,
    },
    Algorithm {
        name: arc::NAME,
        about: "the arc of the extreme point, L = theta r (Mirtich 1996, 2.3.2)",
        kinds: &[QueryKind::MotionBound],
        shapes: arc::shapes,
        quiet: arc::answer,
        traced: arc::answer,
    },
    Algorithm {
        name: crate::collision::certified::sweep::ray::NAME,
        about: "one ray against the edges of B - A that face it, direct (Firth 2011, Continuous)",
        kinds: &[QueryKind::LinearSweep],
        shapes: unturning_pair,
        quiet: crate::collision::certified::sweep::ray::answer,
        traced: crate::collision::certified::sweep::ray::answer,
    },
    Algorithm {
        name: ray_clipping::NAME,
        about: "the ray clipped to the tangent at the closest point, again and again (van den Bergen 2004)",
        kinds: &[QueryKind::LinearSweep],
        shapes: unturning_pair,
        quiet: ray_clipping::answer,
        traced: ray_clipping::answer,
    },
    Algorithm {
        name: crate::collision::certified::impact::search::NAME,
        about: "separating axes that turn with a body, followed until they are used up; certified",
        kinds: &[QueryKind::TimeOfImpact],
        shapes: convex_pair,
        quiet: crate::collision::certified::impact::search::answer,
        traced: crate::collision::certified::impact::search::answer,
    },
    Algorithm {
        name: conservative_advancement::NAME,
        about: "steps by the distance over a bound on the closing speed (Mirtich 1996, Coumans 2005)",
        kinds: &[QueryKind::TimeOfImpact],
        shapes: convex_pair,
        quiet: conservative_advancement::answer,
        traced: conservative_advancement::answer,
    },
];

/// Two convex bodies that do not turn.
fn unturning_pair(query: &Query) -> Result<(), &'static str> {
    convex_pair(query)?;
    let turns = |body: &Body| body.spin.0 != 0.0;
    if turns(query.a) || query.b.is_some_and(turns) { Err("takes bodies that do not turn") } else { Ok(()) }
}

/// The questions of the discrete algorithms.
const DISCRETE: &[QueryKind] = &[QueryKind::Separation, QueryKind::Overlap];

/// Two bodies that have a core: all but outlines.
fn convex_pair(query: &Query) -> Result<(), &'static str> {
    let convex = |body: &Body| !body.shape.core.is_empty();
    match query.b {
        Some(b) if convex(query.a) && convex(b) => Ok(()),
        _ => Err("takes two convex bodies"),
    }
}
