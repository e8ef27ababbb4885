//! The question: its kind, the one or two bodies it is about, and the moment or the limits that it names.
//!
//! A kind of question is one file of this folder, named as the kind is in a scene, and one row in
//! [`QUERIES`]; what holds of every question of a kind stands in its row, so that no other room has to know
//! the kinds by name. To add one: its variant of [`QueryKind`], its file, its row, and at least one algorithm
//! that names the kind among those it answers. If none of the answers in `answer/` says what it found, a
//! variant of [`crate::collision::Answer`] too.

mod bounds;
mod contact;
mod linear_sweep;
mod motion_bound;
mod overlap;
mod separation;
mod time_of_impact;

use crate::geometry::Body;

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
    /// Where two bodies touch, and how deep at each place.
    Contact,
}

/// How many bodies a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bodies {
    /// One body, or two together: A, or A and B.
    OneOrTwo,
    /// A and B.
    Two,
}

/// What part of the motion, over t in [0, 1], a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// One moment, [`Query::time`].
    AtAMoment,
    /// All of [0, 1]; it has no time of its own.
    OverTheMotion,
}

/// Which shapes a question can be asked of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shapes {
    /// Any shape, an outline that is not convex too.
    Any,
    /// Shapes with a convex core: all but outlines.
    Convex,
}

/// Which motions a question can be asked of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Any: the bodies may move and turn.
    Any,
    /// Motions along straight lines: the spin of each body is 0, so that B ⊖ A keeps its shape.
    Unturning,
}

/// A row in the table of questions: what holds of all questions of a kind.
///
/// ```
/// use tracefig::collision::{Bodies, QUERIES, QueryKind, When};
/// let sweep = QUERIES.iter().find(|query| query.word == "linear-sweep").unwrap();
/// assert_eq!((sweep.kind, sweep.bodies), (QueryKind::LinearSweep, Bodies::Two));
/// assert_eq!(sweep.when, When::OverTheMotion);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// The kind whose row this is.
    pub kind: QueryKind,
    /// Its word in scene files and answers.
    pub word: &'static str,
    /// What is asked, in one line.
    pub about: &'static str,
    /// How many bodies it is about.
    pub bodies: Bodies,
    /// Whether it is about a moment or about all of the motion.
    pub when: When,
    /// The shapes that the bodies may have.
    pub shapes: Shapes,
    /// The motions that the bodies may have.
    pub motion: Motion,
}

/// Every kind of question, in the order of `tracefig list`, which is that of the variants of [`QueryKind`].
pub const QUERIES: &[Question] = &[
    bounds::QUESTION,
    overlap::QUESTION,
    separation::QUESTION,
    linear_sweep::QUESTION,
    time_of_impact::QUESTION,
    motion_bound::QUESTION,
    contact::QUESTION,
];

/// [`QueryKind::question`] finds a row by the place of its kind.
const _: () = {
    let mut place = 0;
    while place < QUERIES.len() {
        assert!(QUERIES[place].kind as usize == place, "the rows stand in the order of the kinds");
        place += 1;
    }
};

impl QueryKind {
    /// Its row in [`QUERIES`].
    ///
    /// ```
    /// use tracefig::collision::{QueryKind, When};
    /// assert_eq!(QueryKind::Separation.question().when, When::AtAMoment);
    /// ```
    #[must_use]
    pub fn question(self) -> &'static Question {
        &QUERIES[self as usize]
    }

    /// Its word in scene files and answers.
    ///
    /// ```
    /// assert_eq!(tracefig::collision::QueryKind::TimeOfImpact.word(), "time-of-impact");
    /// ```
    #[must_use]
    pub fn word(self) -> &'static str {
        self.question().word
    }
}

/// A question about one or two bodies.
///
/// ```
/// use tracefig::collision::{ALGORITHMS, Answer, Query, QueryKind};
/// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
/// let disc = Shape::of_kind("circle", &[("radius", FieldValue::Number(1.0))]).unwrap();
/// let at = |x, y| Body {
///     shape: disc.clone(), position: DVec2::new(x, y), angle: Angle::Degrees(0.0),
///     velocity: DVec2::ZERO, spin: Angle::Degrees(0.0),
/// };
/// let (a, b) = (at(0.0, 0.0), at(3.0, 4.0));
/// let query = Query {
///     kind: QueryKind::Separation, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100,
/// };
/// let default = ALGORITHMS.iter().find(|algorithm| algorithm.takes(&query)).unwrap();
/// let Some(Answer::Separation(found)) = default.answer(&query) else { panic!() };
/// // The centres are 5 apart, the radii 1 each.
/// assert_eq!((found.separation, *found.normal), (3.0, DVec2::new(0.6, 0.8)));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Query<'s> {
    /// What is asked.
    pub kind: QueryKind,
    /// Body A.
    pub a: &'s Body,
    /// Body B, where the question is about two.
    pub b: Option<&'s Body>,
    /// The moment in [0, 1], for questions about one; ignored by the others.
    pub time: f64,
    /// World units: how near is near enough for an algorithm that [stops](crate::collision::Stops) at a
    /// tolerance. The one in force, which rounding may raise, is in the answer.
    pub tolerance: f64,
    /// Step cap of an algorithm that iterates; reaching it is an answer,
    /// [`Reason::IterationLimit`](crate::collision::Reason::IterationLimit).
    pub max_iterations: usize,
}

impl Query<'_> {
    /// Whether all of its numbers are, and the tolerance is not negative.
    pub(super) fn is_finite(&self) -> bool {
        if cfg!(tracefig_page) {
            return true;
        }
        let bodies = self.a.is_finite() && self.b.is_none_or(Body::is_finite);
        bodies && self.time.is_finite() && self.tolerance.is_finite() && self.tolerance >= 0.0
    }
}
