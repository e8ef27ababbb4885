//! Holds how near a miss is said to have come against the exact motion.
//!
//! The upper end is what the separation is at the time given; the lower one is proved by the same subdivision
//! as a miss is: no separation in [0, 1] is below it.

use super::{ERROR, RELATIVE_WIDTH, Report, Setting, WIDTH};
use crate::first_contact::{Motion, Passage};
use crate::float::Real;
use crate::json::Json;
use crate::scene::{Body, EPSILON, Scene};

/// From |s| > this · ε·S on, the relative width holds too: a vertex is passed at a moment that is no double,
/// and at the next one is farther by the square of the way between them over twice the separation.
const RELATIVE_FROM: f64 = 1e8;

/// Width of the bounds in S, of a pair that turns.
const TURNING_WIDTH: f64 = 1e-9;

/// Degrees that a pair may turn, of both bodies together, for its bounds to be that narrow.
const TURNS: f64 = 3600.0;

/// What a subdivision of a parabola's vertex may hide, in S: far below what a double tells.
fn hidden(scale: f64) -> Real {
    Real::from(scale) * Real::power_of_two(-90)
}

/// Checks `closest` of a miss.
pub(super) fn check_approach(
    report: &mut Report,
    scene: &Scene,
    setting: &Setting,
    motion: &Motion,
    result: &Json,
) {
    let fields = result.get("closest").map(|closest| {
        (closest.number_at("time"), closest.number_at("separation"), closest.pair_at("separation_bounds"))
    });
    let Some((Some(time), Some(value), Some([lo, hi]))) = fields else {
        report.fault("closest", format!("incomplete: {result}"));
        return;
    };
    if !((0.0..=1.0).contains(&time) && 0.0 <= lo && lo <= value && value <= hi) {
        report.fault("closest", format!("out of order: {result}"));
        return;
    }
    let reached = motion.separation(Real::from(time)).separation;
    let hidden = hidden(setting.scale);
    if reached > Real::from(hi) + hidden {
        report.fault("closest", format!("at {time:e} the separation is {reached}, above {hi:e}"));
    }
    report.limit("closest: error / εS", setting.units(Real::from(value) - reached), ERROR);
    let below = Real::from(lo) - hidden;
    if let Passage::Below { by, .. } = motion.first_within(below, Real::ZERO, Real::one()) {
        let s = motion.separation(by).separation;
        report.fault("closest", format!("at {by} the separation is {s}, below {lo:e}"));
    }
    check_width(report, scene, setting, [lo, hi]);
}

/// How far both bodies turn together, in degrees; a disc about its own origin does not.
#[must_use]
pub fn turning(scene: &Scene) -> f64 {
    let spin = |body: &Body| body.spin.degrees.abs() + body.spin.radians.abs().to_degrees();
    scene.bodies.iter().filter(|body| body.vertices != [[0.0, 0.0]]).map(spin).sum()
}

/// How narrow the bounds are.
fn check_width(report: &mut Report, scene: &Scene, setting: &Setting, [lo, hi]: [f64; 2]) {
    let width = Real::from(hi) - Real::from(lo);
    let turned = turning(scene);
    if turned == 0.0 {
        report.limit("closest: width / εS", setting.units(width), WIDTH);
        if lo > RELATIVE_FROM * EPSILON * setting.scale {
            report.limit("closest: width / |s|", width.over(Real::from(hi)).to_f64(), RELATIVE_WIDTH);
        }
    } else if turned <= TURNS {
        let parts = width.over(Real::from(setting.scale)).to_f64();
        report.limit("closest: width / S, turning", parts, TURNING_WIDTH);
    }
}
