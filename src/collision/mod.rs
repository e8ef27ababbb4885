//! One algorithm a file; a [`Query`] in, an [`Answer`] out, events on the way.

mod advancement;
mod answer;
mod axis_gap;
mod bounds;
mod certify;
mod circles;
mod clamp;
mod conservative_advancement;
mod contact;
mod difference;
mod expansion;
mod extents;
mod facing_chain;
mod few;
mod fine;
mod first_root;
mod gaps;
mod gjk;
mod guess;
mod impact_proof;
#[cfg(test)]
mod impact_properties;
mod inscribed;
mod last_digits;
mod merge;
mod minkowski;
mod motion_bound;
mod moving_pair;
mod nearest;
mod pair;
mod place;
mod quick;
mod quick_impact;
mod quick_ray;
mod quick_touch;
mod quick_turn;
mod ray_cast;
mod ray_clipping;
mod relative;
mod separating_axes;
mod separation;
#[cfg(test)]
mod storyboard;
#[cfg(test)]
mod storyboard_motion;
mod sweep;
#[cfg(test)]
mod sweep_properties;
mod swept_axis;
mod turned_gap;
mod walk;
mod witness;

pub use answer::{Answer, Bounds, Impact, MotionBound, Outcome, Overlap, Reason, Separation};
pub use difference::{Difference, DifferenceEdge, difference};
pub use moving_pair::MovingPair;
pub use pair::Pair;
pub use sweep::Sweep;

use crate::geometry::Body;
use crate::trace::{NoTrace, Trace};

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QueryKind {
    /// The AABB of one body, or of two together.
    Bounds,
    /// Whether two bodies overlap; touching counts.
    Overlap,
    /// Signed separation of two bodies.
    Separation,
    /// First contact of two bodies that do not turn.
    LinearSweep,
    /// First contact of two bodies that move and turn.
    TimeOfImpact,
    /// How far any point of a body can move.
    MotionBound,
}

impl QueryKind {
    /// All of them, in the order of `tracefig list`.
    pub const ALL: [Self; 6] = [
        Self::Bounds,
        Self::Overlap,
        Self::Separation,
        Self::LinearSweep,
        Self::TimeOfImpact,
        Self::MotionBound,
    ];

    /// Its word in scene files and answers.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Bounds => "bounds",
            Self::Overlap => "overlap",
            Self::Separation => "separation",
            Self::LinearSweep => "linear-sweep",
            Self::TimeOfImpact => "time-of-impact",
            Self::MotionBound => "motion-bound",
        }
    }
}

/// A question about one or two bodies.
#[derive(Clone, Copy, Debug)]
pub struct Query<'s> {
    /// What is asked.
    pub kind: QueryKind,
    /// Body A.
    pub a: &'s Body,
    /// Body B, where the question is about two.
    pub b: Option<&'s Body>,
    /// The moment, for bounds, overlap and separation.
    pub time: f64,
    /// As written, in world units; the one in force is in the answer.
    pub tolerance: f64,
    /// Step cap of the iterative algorithms.
    pub max_iterations: usize,
}

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
        name: separation::NAME,
        about: "closest features of B - A, proved by supports and witnesses in double-doubles (Toussaint 1983)",
        kinds: DISCRETE,
        shapes: convex_pair,
        quiet: separation::answer,
        traced: separation::answer,
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
        name: bounds::NAME,
        about: "smallest and largest coordinates of the vertices, and their union (Firth 2011, AABB vs AABB)",
        kinds: &[QueryKind::Bounds],
        shapes: bounds::shapes,
        quiet: bounds::answer,
        traced: bounds::answer,
    },
    Algorithm {
        name: motion_bound::NAME,
        about: "the arc of the extreme point, L = theta r (Mirtich 1996, 2.3.2)",
        kinds: &[QueryKind::MotionBound],
        shapes: motion_bound::shapes,
        quiet: motion_bound::answer,
        traced: motion_bound::answer,
    },
    Algorithm {
        name: ray_cast::NAME,
        about: "one ray against the edges of B - A that face it, direct (Firth 2011, Continuous)",
        kinds: &[QueryKind::LinearSweep],
        shapes: unturning_pair,
        quiet: ray_cast::answer,
        traced: ray_cast::answer,
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
        name: swept_axis::NAME,
        about: "separating axes that turn with a body, followed until they are used up; certified",
        kinds: &[QueryKind::TimeOfImpact],
        shapes: convex_pair,
        quiet: swept_axis::answer,
        traced: swept_axis::answer,
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
