//! The question: its kind, the one or two bodies it is about, and the moment or the limits that it names.

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
