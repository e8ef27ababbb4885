//! What the algorithms answer: one variant a kind of answer, each number in world units, each with its proof.
//!
//! Bounds enclose the exact value; `bounds.lo ≤ s ≤ bounds.hi`, s negative inside. Where rounding forbids a
//! verdict, the answer says so instead of guessing: [`Overlap::overlap`] is None, a motion ends
//! [`Outcome::Unresolved`].
//!
//! An answer also knows how it is written down: [`Answer::parts`] names its parts in the order of the format,
//! so that whoever writes JSON or text needs to know kinds of values, not kinds of answers.

mod contact;
pub(crate) mod fields;
mod part;
mod separation;
mod verdict;

use crate::geometry::{DVec2, Enclosure};

pub use contact::{Contact, ContactPoint};
pub use fields::AnswerField;
pub(crate) use part::{Part, Parts};
pub use separation::Separation;
pub use verdict::Verdict;

/// What a query found.
///
/// ```
/// use tracefig::collision::{ALGORITHMS, Answer, Query, QueryKind};
/// use tracefig::geometry::{Body, DVec2, Angle, Shape, shape::FieldValue};
/// let square = Shape::of_kind("box", &[("half_extents", FieldValue::Point(DVec2::ONE))]).unwrap();
/// let at = |x| Body {
///     shape: square.clone(), position: DVec2::new(x, 0.0), angle: Angle::Degrees(0.0),
///     velocity: DVec2::ZERO, spin: Angle::Degrees(0.0),
/// };
/// let (a, b) = (at(0.0), at(1.75));
/// let answer = |kind| {
///     let query = Query { kind, a: &a, b: Some(&b), time: 0.0, tolerance: 0.0, max_iterations: 100 };
///     query.answer().unwrap()
/// };
/// let Answer::Separation(found) = answer(QueryKind::Separation) else { panic!() };
/// // A quarter of a unit inside each other: B leaves along +x.
/// assert_eq!((found.separation, *found.normal), (-0.25, DVec2::X));
/// assert!(found.bounds.lo <= -0.25 && -0.25 <= found.bounds.hi);
/// let Answer::Overlap(verdict) = answer(QueryKind::Overlap) else { panic!() };
/// assert_eq!(verdict.overlap, Some(true));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A box: to [`crate::collision::QueryKind::Bounds`].
    Bounds(Bounds),
    /// A verdict: to [`crate::collision::QueryKind::Overlap`].
    Overlap(Overlap),
    /// A signed distance: to [`crate::collision::QueryKind::Separation`].
    Separation(Separation),
    /// A time, or why there is none: to [`crate::collision::QueryKind::LinearSweep`] and
    /// [`crate::collision::QueryKind::TimeOfImpact`].
    Impact(Impact),
    /// A length: to [`crate::collision::QueryKind::MotionBound`].
    MotionBound(MotionBound),
    /// Points of contact: to [`crate::collision::QueryKind::Contact`].
    Contact(Contact),
}

/// An axis-aligned bounding box in the world, rounded outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub min: DVec2,
    /// Largest coordinates.
    pub max: DVec2,
    /// (min + max) / 2.
    pub center: DVec2,
    /// Half of the width and of the height, rounded up: center ± `half_extents` holds the body.
    pub half_extents: DVec2,
}

/// Whether two bodies overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Whether they share a point, touching included; None where rounding forbids a verdict.
    pub overlap: Option<bool>,
    /// Encloses the exact separation, world units; `hi` is infinite where the search ended at a separating
    /// axis.
    pub separation_bounds: Enclosure,
}

/// Why a time of impact was not decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Rounding forbids a verdict.
    WithinRounding,
    /// The bodies come within the tolerance and no contact is proved.
    WithinTolerance,
    /// The step cap was reached.
    IterationLimit,
    /// A step was too short to change the time t, a double.
    Stalled,
    /// A body is not convex or has a number that is not finite, or the tolerance is none: in no scene.
    NotFinite,
}

/// How a motion ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// First contact.
    Hit {
        /// The last moment proved free (`lo`), and contact proved at or before (`hi`); t in [0, 1].
        time: Enclosure,
        /// The pair at `time.lo`.
        contact: Separation,
    },
    /// No contact in [0, 1].
    Miss,
    /// Touching or inside at t = 0.
    Overlapping {
        /// The pair at t = 0.
        contact: Separation,
    },
    /// Neither contact nor its absence is proved.
    Unresolved {
        /// What kept it undecided.
        reason: Reason,
        /// The bodies are proved free until this time in [0, 1].
        free_until: f64,
    },
}

/// Answer of a sweep or a time of impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// How the motion ends.
    pub outcome: Outcome,
    /// The tolerance in force, world units; 0 where the answer is direct.
    pub tolerance: f64,
    /// Distance queries made.
    pub iterations: usize,
}

/// How near two bodies come that never touch, over t in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestApproach {
    /// When they are closest, in [0, 1]; of moments that tie, one.
    pub time: f64,
    /// The pair at that time.
    pub contact: Separation,
    /// Encloses the least separation over [0, 1], world units: `lo` is proved of all moments, and what is
    /// reached at `time` is at most `hi`.
    pub bounds: Enclosure,
}

/// How far any point of a body, or of two relative to each other, can move over t in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionBound {
    /// World units, rounded up.
    pub bound: f64,
}

impl Answer {
    /// Its parts, as `solve` writes them.
    pub(crate) fn parts(&self) -> Parts {
        match self {
            Self::Bounds(bounds) => bounds.parts(),
            Self::Overlap(overlap) => overlap.parts(),
            Self::Separation(separation) => separation.parts(),
            Self::Impact(impact) => impact.parts(),
            Self::MotionBound(MotionBound { bound }) => vec![("bound", Part::Number(*bound))],
            Self::Contact(contact) => contact.parts(),
        }
    }
}

impl ClosestApproach {
    /// Its parts, as `solve` writes them.
    pub(crate) fn parts(&self) -> Parts {
        vec![
            ("time", Part::Number(self.time)),
            ("separation", Part::Number(self.contact.separation)),
            ("separation_bounds", Part::Interval(self.bounds)),
        ]
    }
}

impl Bounds {
    fn parts(&self) -> Parts {
        vec![
            ("min", Part::Point(self.min)),
            ("max", Part::Point(self.max)),
            ("center", Part::Point(self.center)),
            ("half_extents", Part::Point(self.half_extents)),
        ]
    }
}

impl Overlap {
    /// A word for the verdict, as events tell it.
    pub(crate) fn word(&self) -> &'static str {
        match self.overlap {
            Some(true) => "overlapping",
            Some(false) if self.separation_bounds.hi == f64::INFINITY => "separating axis",
            Some(false) => "apart",
            None => "undecided",
        }
    }

    fn parts(&self) -> Parts {
        vec![
            ("overlap", Part::Verdict(self.overlap)),
            ("separation_bounds", Part::Interval(self.separation_bounds)),
        ]
    }
}

/// The verdict that a separation allows; touching counts as overlap.
impl From<&Separation> for Overlap {
    fn from(s: &Separation) -> Self {
        Self { overlap: s.overlaps(), separation_bounds: s.bounds }
    }
}

impl Reason {
    /// Its word in answers.
    ///
    /// ```
    /// assert_eq!(tracefig::collision::Reason::WithinRounding.word(), "within-rounding");
    /// ```
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::WithinRounding => "within-rounding",
            Self::WithinTolerance => "within-tolerance",
            Self::IterationLimit => "iteration-limit",
            Self::Stalled => "stalled",
            Self::NotFinite => "not-finite",
        }
    }
}

impl Outcome {
    /// What is known of bodies of which nothing can be said.
    pub(super) const UNKNOWN: Self = Self::Unresolved { reason: Reason::NotFinite, free_until: 0.0 };

    /// What a separation at t = 0 says that is not certainly above 0.
    pub(crate) fn at_start(near: &Separation) -> Self {
        if near.bounds.hi <= 0.0 {
            Self::Overlapping { contact: *near }
        } else {
            Self::Unresolved { reason: Reason::WithinRounding, free_until: 0.0 }
        }
    }

    /// This outcome, with the bodies called the other way round.
    pub(crate) fn swapped(self) -> Self {
        match self {
            Self::Hit { time, contact } => Self::Hit { time, contact: contact.swapped() },
            Self::Overlapping { contact } => Self::Overlapping { contact: contact.swapped() },
            other => other,
        }
    }

    /// Its word in answers.
    ///
    /// ```
    /// assert_eq!(tracefig::collision::Outcome::Miss.word(), "miss");
    /// ```
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Hit { .. } => "hit",
            Self::Miss => "miss",
            Self::Overlapping { .. } => "overlapping",
            Self::Unresolved { .. } => "unresolved",
        }
    }
}

impl Impact {
    fn parts(&self) -> Parts {
        let mut parts = vec![("outcome", Part::Word(self.outcome.word()))];
        let tolerance = ("tolerance", Part::Number(self.tolerance));
        match &self.outcome {
            Outcome::Hit { time, contact } => {
                parts.push(("time", Part::Number(time.lo)));
                parts.push(("time_bounds", Part::Interval(*time)));
                parts.extend(contact.measures());
                parts.push(tolerance);
                parts.push(("normal", Part::Point(*contact.normal)));
                parts.extend(contact.witnesses());
            }
            Outcome::Miss => parts.push(tolerance),
            Outcome::Overlapping { contact } => {
                parts.extend(contact.measures());
                parts.push(tolerance);
            }
            Outcome::Unresolved { reason, free_until } => {
                parts.push(("reason", Part::Word(reason.word())));
                parts.push(("time_bounds", Part::Interval(Enclosure { lo: *free_until, hi: 1.0 })));
                parts.push(tolerance);
            }
        }
        parts.push(("iterations", Part::Count(self.iterations)));
        parts
    }
}
