//! What the algorithms answer: one variant a kind of question, each number in world units, each with its proof.
//!
//! Bounds enclose the exact value; `bounds.lo ≤ s ≤ bounds.hi`, s negative inside. Where rounding forbids a
//! verdict, the answer says so instead of guessing: [`Overlap::overlap`] is None, a motion ends [`Outcome::Unresolved`].

use crate::geometry::{DVec2, Enclosure, Feature};

/// What a query found.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// To [`crate::collision::QueryKind::Bounds`].
    Bounds(Bounds),
    /// To [`crate::collision::QueryKind::Overlap`].
    Overlap(Overlap),
    /// To [`crate::collision::QueryKind::Separation`].
    Separation(Separation),
    /// To [`crate::collision::QueryKind::LinearSweep`] and [`crate::collision::QueryKind::TimeOfImpact`].
    Impact(Impact),
    /// To [`crate::collision::QueryKind::MotionBound`].
    MotionBound(MotionBound),
}

/// An axis-aligned bounding box, rounded outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub min: DVec2,
    /// Largest coordinates.
    pub max: DVec2,
    /// (min + max) / 2.
    pub center: DVec2,
    /// Rounded up: center ± `half_extents` holds the body.
    pub half_extents: DVec2,
}

/// Whether two bodies overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// None where rounding forbids a verdict.
    pub overlap: Option<bool>,
    /// Encloses the exact separation (or is one-sided: `hi` infinite after a separating axis).
    pub separation_bounds: Enclosure,
}

/// Signed separation with its witnesses. `p_B` − `p_A` = s n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation {
    /// World units; the distance apart, or minus the penetration depth.
    pub separation: f64,
    /// Encloses the exact value.
    pub bounds: Enclosure,
    /// Unit vector from A to B along which B moves apart.
    pub normal: DVec2,
    /// Directions with the same depth or distance within the bounds; 0 where all tie.
    pub ties: u32,
    /// Witness points on A and B, world.
    pub points: [DVec2; 2],
    /// The features of A and B that carry them.
    pub features: [Feature; 2],
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
    /// Steps no longer move t.
    Stalled,
}

impl Reason {
    /// Its word in answers.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::WithinRounding => "within-rounding",
            Self::WithinTolerance => "within-tolerance",
            Self::IterationLimit => "iteration-limit",
            Self::Stalled => "stalled",
        }
    }
}

/// How a motion ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// First contact.
    Hit {
        /// The last moment proved free (`lo`), and contact proved at or before (`hi`).
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
    /// Not decided.
    Unresolved {
        /// Why.
        reason: Reason,
        /// Proved free until here.
        free_until: f64,
    },
}

impl Outcome {
    /// Its word in answers.
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

/// Answer of a sweep or a time of impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// How it ends.
    pub outcome: Outcome,
    /// In force, world units; 0 for a linear sweep.
    pub tolerance: f64,
    /// Distance queries made.
    pub iterations: usize,
}

/// How far any point of a body, or of two relative to each other, can move over t in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionBound {
    /// World units, rounded up.
    pub bound: f64,
}
