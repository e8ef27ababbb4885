//! What the article does: one algorithm a file, traced, and one row in [`ALGORITHMS`].
//!
//! A file is named as its algorithm is in a scene (`ray_cast.rs` is `ray-cast`) and holds the row that the
//! table takes from it, `ALGORITHM`. To add one, write the file, its `mod` line and its line in the table:
//! scenes, `tracefig list`, the figures and the report follow the table.
//!
//! An algorithm for one moment has this way:
//!
//! ```text
//! view.rs       the two bodies from A's frame; event `started`
//! outline.rs    tells B ⊖ A, whose distance from the origin is the bodies'; projects the origin on its edges
//! its own file  finds which features face each other, and tells how
//! candidate.rs  hands them down to `certified/`, tells what was proved, answers; event `finished`
//! ```
//!
//! What several share stands beside them: `nearest_edge.rs` (which of two edges is better), `early_out.rs`
//! (when a test for overlap may stop), `simplex.rs` (of GJK and EPA), `advancement.rs` (steps through time),
//! `miss.rs` (how near a miss came). No number of an answer is computed here, but those of `extremes`, `arc`
//! and the early-outs, which round them outward themselves.

mod advancement;
mod arc;
mod candidate;
mod circles;
mod clamp;
mod clip;
mod closest_features;
mod conservative_advancement;
mod early_out;
mod epa;
mod extents;
pub(super) mod extremes;
mod gjk;
mod merge;
mod minkowski;
mod motion;
mod nearest_edge;
mod outline;
mod ray_cast;
mod ray_clipping;
mod separating_axes;
mod simplex;
mod swept_axis;
pub(super) mod view;

pub use motion::closest_approach;

use crate::collision::{Answer, Query, QueryKind};
use crate::geometry::Body;
#[cfg(not(tracefig_page))]
use crate::trace::NoTrace;
use crate::trace::Trace;

/// A row in the table of algorithms.
///
/// ```
/// use tracefig::collision::{ALGORITHMS, Answer, Query, QueryKind, Stops};
/// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
/// use tracefig::trace::{Event, Trace};
/// let disc = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
/// let at = |x, speed| Body {
///     shape: disc.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(0.0),
///     velocity: DVec2::new(speed, 0.0), spin: Angle::Degrees(0.0),
/// };
/// let (a, b) = (at(0.0, 8.0), at(6.0, 0.0));
/// let query = Query {
///     kind: QueryKind::LinearSweep, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100,
/// };
/// let ray_cast = ALGORITHMS.iter().find(|algorithm| algorithm.takes(&query)).unwrap();
/// assert_eq!((ray_cast.name, ray_cast.stops), ("ray-cast", Stops::Exactly));
/// let mut trace = Trace::default();
/// let answer = (ray_cast.traced)(&query, &mut trace);
/// let Answer::Impact(impact) = &answer else { panic!() };
/// // The gap of 4 closes at 8.
/// assert_eq!(impact.outcome.word(), "hit");
/// assert!(matches!(trace.events.last(), Some(Event::Finished { outcome: "hit" })));
/// // Listening changes nothing, and nor does having placed the bodies beforehand.
/// assert_eq!(Some(&answer), ray_cast.answer(&query).as_ref());
/// let ready = ray_cast.ready.unwrap()(&query);
/// assert_eq!(answer, ready());
/// ```
pub struct Algorithm {
    /// Its word in a scene file.
    pub name: &'static str,
    /// One line for `tracefig list`, with the source.
    pub about: &'static str,
    /// The questions it answers.
    pub kinds: &'static [QueryKind],
    /// Whether it takes the bodies of this query; the error says which it takes, as "takes two circles".
    pub shapes: fn(&Query) -> Result<(), &'static str>,
    /// Whether [`Query::tolerance`] has a say in its answer.
    pub stops: Stops,
    /// Answers without a trace.
    #[cfg(not(tracefig_page))]
    pub quiet: fn(&Query, &mut NoTrace) -> Answer,
    /// Answers, and records what it did.
    pub traced: fn(&Query, &mut Trace) -> Answer,
    /// Prepares a query to be asked again and again, where poses, cosines and sines can be worked out
    /// beforehand; None where each answer starts from the scene's numbers.
    #[cfg(not(tracefig_page))]
    pub ready: Option<for<'q> fn(&Query<'q>) -> Ready<'q>>,
}

/// A query whose bodies are placed already: each call searches anew and answers it.
#[cfg(not(tracefig_page))]
pub type Ready<'q> = Box<dyn Fn() -> Answer + 'q>;

/// What ends an algorithm's search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stops {
    /// It ends by itself, with bounds as narrow as rounding allows: it never looks at [`Query::tolerance`].
    Exactly,
    /// It ends where the bodies are within [`Query::tolerance`], or where that is all that is left undecided.
    AtTolerance,
}

impl Algorithm {
    /// Answers a query, and keeps what it did; `None` where it does not [take](Self::takes) that.
    ///
    /// ```
    /// use tracefig::{scene::open_text, trace::Event};
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let scene = open_text("s.toml", text)?.scene;
    /// let (answer, trace) = scene.query().algorithm.answer_traced(&scene.query_of_bodies()).unwrap();
    /// assert_eq!(answer, tracefig::solve(&scene));
    /// assert!(trace.events.iter().any(|event| matches!(event, Event::BoundsFound { .. })));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn answer_traced(&self, query: &Query) -> Option<(Answer, Trace)> {
        self.takes(query).then(|| {
            let mut trace = Trace::default();
            let answer = (self.traced)(query, &mut trace);
            (answer, trace)
        })
    }

    /// Answers a query without a trace; `None` where it does not [take](Self::takes) that.
    ///
    /// ```
    /// use tracefig::collision::{ALGORITHMS, Answer, Query, QueryKind};
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let body = Body {
    ///     shape: Shape::of_kind("circle", &[("radius", FieldValue::Number(0.5))]).unwrap(),
    ///     position: DVec2::new(2.0, 1.0), angle: Angle::ZERO, velocity: DVec2::ZERO, spin: Angle::ZERO,
    /// };
    /// let query = Query {
    ///     kind: QueryKind::Bounds, a: &body, b: None, time: 0.0, tolerance: 0.0, max_iterations: 1,
    /// };
    /// let extremes = ALGORITHMS.iter().find(|algorithm| algorithm.takes(&query)).unwrap();
    /// let Some(Answer::Bounds(found)) = extremes.answer(&query) else { panic!() };
    /// assert_eq!((found.min, found.max), (DVec2::new(1.5, 0.5), DVec2::new(2.5, 1.5)));
    /// // It knows no distances.
    /// assert_eq!(extremes.answer(&Query { kind: QueryKind::Separation, b: Some(&body), ..query }), None);
    /// ```
    #[must_use]
    pub fn answer(&self, query: &Query) -> Option<Answer> {
        self.takes(query).then(|| self.ask(query))
    }

    /// Answers a query that it takes.
    pub(crate) fn ask(&self, query: &Query) -> Answer {
        #[cfg(not(tracefig_page))]
        return (self.quiet)(query, &mut NoTrace);
        #[cfg(tracefig_page)]
        return (self.traced)(query, &mut Trace::default());
    }

    /// Whether it answers this kind of question about these bodies, whose numbers must be finite, at a finite
    /// time and with a tolerance that is not negative.
    ///
    /// ```
    /// use tracefig::collision::{ALGORITHMS, Query, QueryKind};
    /// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
    /// let body = Body {
    ///     shape: Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap(),
    ///     position: DVec2::ZERO, angle: Angle::ZERO, velocity: DVec2::ZERO, spin: Angle::Degrees(90.0),
    /// };
    /// let query = Query {
    ///     kind: QueryKind::MotionBound, a: &body, b: None, time: 0.0, tolerance: 0.0, max_iterations: 1,
    /// };
    /// let takers: Vec<&str> = ALGORITHMS.iter().filter(|a| a.takes(&query)).map(|a| a.name).collect();
    /// assert_eq!(takers, ["arc"]);
    /// ```
    #[must_use]
    pub fn takes(&self, query: &Query) -> bool {
        self.kinds.contains(&query.kind) && (self.shapes)(query).is_ok() && query.is_finite()
    }
}

impl Query<'_> {
    /// The answer of the first algorithm that takes it, in world units; `None` where none does, as with
    /// numbers that are not finite.
    ///
    /// ```
    /// use tracefig::collision::{Answer, Query, QueryKind};
    /// use tracefig::geometry::{Body, DVec2, Shape};
    /// let ball = |x| Body::at_rest(Shape::circle(1.0).unwrap(), DVec2::new(x, 0.0));
    /// let apart = |x| {
    ///     let (kind, a, b) = (QueryKind::Separation, ball(0.0), ball(x));
    ///     let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100 };
    ///     match query.answer()? {
    ///         Answer::Separation(found) => Some(found.separation),
    ///         _ => None,
    ///     }
    /// };
    /// assert_eq!([apart(5.0), apart(1.5), apart(f64::NAN)], [Some(3.0), Some(-0.5), None]);
    /// ```
    #[must_use]
    pub fn answer(&self) -> Option<Answer> {
        ALGORITHMS.iter().find(|algorithm| algorithm.takes(self)).map(|algorithm| algorithm.ask(self))
    }
}

/// Every algorithm; the first that takes a query is its default.
pub static ALGORITHMS: &[Algorithm] = &[
    closest_features::ALGORITHM,
    circles::ALGORITHM,
    extents::ALGORITHM,
    clamp::ALGORITHM,
    merge::ALGORITHM,
    minkowski::ALGORITHM,
    separating_axes::ALGORITHM,
    gjk::ALGORITHM,
    extremes::ALGORITHM,
    arc::ALGORITHM,
    ray_cast::ALGORITHM,
    ray_clipping::ALGORITHM,
    swept_axis::ALGORITHM,
    conservative_advancement::ALGORITHM,
    clip::ALGORITHM,
];

/// The questions about two bodies at one moment.
const DISCRETE: &[QueryKind] = &[QueryKind::Separation, QueryKind::Overlap];

/// Takes two bodies that have a convex core: all but outlines.
fn convex_pair(query: &Query) -> Result<(), &'static str> {
    let convex = |body: &Body| !body.shape.core.is_empty();
    match query.b {
        Some(b) if convex(query.a) && convex(b) => Ok(()),
        _ => Err("takes two convex bodies"),
    }
}

/// Takes two convex bodies that do not turn.
fn unturning_pair(query: &Query) -> Result<(), &'static str> {
    convex_pair(query)?;
    if query.a.turns() || query.b.is_some_and(Body::turns) {
        Err("takes bodies that do not turn")
    } else {
        Ok(())
    }
}
