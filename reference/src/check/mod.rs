//! Holds an answer of `tracefig solve --jsonl` against the exact one.
//!
//! A check collects every fault it finds, and measures how far from its limit each claim is, so that a table
//! can show the worst of a category. The limits are those that the project promises; ε is that of doubles and
//! S the scale of the scene.

mod approach;
mod clip;
mod contact;
mod extent;
mod impact;

pub use approach::turning;
pub use contact::{Contact, Feature, check_contact};
pub use impact::{Record, check_certificate};

use crate::float::Real;
use crate::json::Json;
use crate::placement::{Placed, convex_core};
use crate::scene::{Body, EPSILON, Kind, Scene, scale};

/// Error of a separation: ≤ this · ε·S.
pub const ERROR: f64 = 4.0;
/// Width of its bounds: ≤ this · ε·S.
pub const WIDTH: f64 = 16.0;
/// From |s| > this · ε·S on, the relative limits hold as well.
pub const RELATIVE_FROM: f64 = 1e3;
/// Relative error there.
pub const RELATIVE_ERROR: f64 = 1e-14;
/// Relative width there.
pub const RELATIVE_WIDTH: f64 = 1e-13;
/// Witness points: printed as doubles, so off by ε·S a coordinate at the least; ≤ this · ε·S.
pub const POINTS: f64 = 8.0;
/// Direction of the normal: ≤ this, where the direction does not hang on the place of two near points.
pub const NORMAL: f64 = 1e-14;
/// `unresolved` only where the exact separation is within this · ε·S of 0.
pub const UNRESOLVED: f64 = 64.0;

/// A claim of the answer that is false.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Which claim, a stable word: `bounds`, `ties`, …
    pub claim: &'static str,
    /// What it says, and what is true.
    pub detail: String,
}

/// What a check found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// False claims; none for a right answer.
    pub faults: Vec<Fault>,
    /// Measured quantities, named with their unit.
    pub measures: Vec<(&'static str, f64)>,
}

impl Report {
    /// Notes a false claim.
    pub fn fault(&mut self, claim: &'static str, detail: String) {
        self.faults.push(Fault { claim, detail });
    }

    /// Measures a quantity, and notes a fault where it is above its limit or no number.
    pub fn limit(&mut self, claim: &'static str, value: f64, limit: f64) {
        self.measures.push((claim, value));
        if value.is_nan() || value > limit {
            self.fault(claim, format!("{value:.3e} is above its limit {limit:e}"));
        }
    }

    /// Whether a claim was found false.
    #[must_use]
    pub fn has(&self, claim: &str) -> bool {
        self.faults.iter().any(|fault| fault.claim == claim)
    }
}

/// What rounding in this package may hide: 2⁻²⁰⁰ S.
#[must_use]
pub fn slack(s: f64) -> Real {
    Real::from(s) * Real::power_of_two(-200)
}

/// The scene's numbers that all checks need.
pub struct Setting {
    /// S.
    pub scale: f64,
    /// Cores of the bodies.
    pub cores: Vec<Vec<usize>>,
}

impl Setting {
    /// The setting of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let moving = matches!(scene.kind, Kind::LinearSweep | Kind::TimeOfImpact | Kind::MotionBound)
            || scene.time != 0.0;
        let cores = scene.bodies.iter().map(|body| convex_core(&body.vertices)).collect();
        Self { scale: scale(&scene.bodies, moving), cores }
    }

    /// The least tolerance that may be in force: the one written, or the rounding of S.
    #[must_use]
    pub fn least_tolerance(&self, scene: &Scene) -> f64 {
        scene.tolerance.max(WIDTH * EPSILON * self.scale)
    }

    /// Both bodies at time t.
    #[must_use]
    pub fn pair(&self, bodies: &[Body], t: Real) -> [Placed; 2] {
        [0, 1].map(|i| Placed::at(&bodies[i], &self.cores[i], t))
    }

    /// A difference in units of ε·S; twice the least positive double counts as no error, for two points round
    /// to it.
    #[must_use]
    pub fn units(&self, difference: Real) -> f64 {
        let least = Real::from(2.0 * f64::MIN_POSITIVE * EPSILON);
        if difference.abs() <= least {
            0.0
        } else {
            difference.abs().over(Real::from(EPSILON) * Real::from(self.scale)).to_f64()
        }
    }
}

/// Holds a line of `solve --jsonl` against its scene.
#[must_use]
pub fn check(scene: &Scene, answer: &Json) -> Report {
    let mut report = Report::default();
    if answer.get("id").unwrap_or(&Json::Null) != &scene.id {
        report.fault("id", format!("{} is not {}", answer.get("id").unwrap_or(&Json::Null), scene.id));
    }
    let Some(result) = answer.get("result") else {
        let error = answer.get("error").map_or("no result".to_owned(), Json::to_string);
        report.fault("answered", error);
        return report;
    };
    if result.text_at("kind") != Some(scene.kind.word()) {
        report.fault("kind", format!("{:?} is not {}", result.get("kind"), scene.kind.word()));
    }
    let setting = Setting::of(scene);
    match scene.kind {
        Kind::Separation => {
            let pair = setting.pair(&scene.bodies, Real::from(scene.time));
            check_contact(&mut report, &setting, &pair, result, true);
        }
        Kind::LinearSweep | Kind::TimeOfImpact => impact::check_impact(&mut report, scene, &setting, result),
        Kind::Bounds => extent::check_bounds(&mut report, scene, &setting, result),
        Kind::Overlap => extent::check_overlap(&mut report, scene, &setting, result),
        Kind::Contact => {
            let pair = setting.pair(&scene.bodies, Real::from(scene.time));
            clip::check_clipped(&mut report, &setting, &pair, result);
        }
        Kind::MotionBound => extent::check_motion_bound(&mut report, scene, result),
    }
    report
}
