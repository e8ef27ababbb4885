//! Bounds, overlap and motion bound against the exact ones.

use super::{Report, Setting, UNRESOLVED, WIDTH, slack};
use crate::float::Real;
use crate::json::Json;
use crate::placement::Placed;
use crate::point::Point;
use crate::scene::{EPSILON, Scene};
use crate::separation::separation;

/// Relative excess of a motion bound: ≤ this · ε.
const MOTION: f64 = 16.0;

/// `bounds`: rounded outward, by no more than the width of a separation.
pub(super) fn check_bounds(report: &mut Report, scene: &Scene, setting: &Setting, result: &Json) {
    let pairs = ["min", "max", "center", "half_extents"].map(|key| result.pair_at(key));
    let [Some(min), Some(max), Some(center), Some(half)] = pairs else {
        report.fault("fields", format!("incomplete: {result}"));
        return;
    };
    let t = Real::from(scene.time);
    let all: Vec<usize> =
        (0..scene.bodies.iter().map(|body| body.vertices.len()).max().unwrap_or(0)).collect();
    let placed: Vec<Placed> =
        scene.bodies.iter().map(|body| Placed::at(body, &all[..body.vertices.len()], t)).collect();
    for axis in 0..2 {
        let of = |p: &Point| if axis == 0 { p.x } else { p.y };
        let ends = |sign: f64| {
            let sign = Real::from(sign);
            let far =
                |body: &Placed| body.vertices.iter().map(|p| of(p) * sign).max().map(|far| far + body.radius);
            placed.iter().filter_map(far).max().unwrap_or(Real::ZERO) * sign
        };
        let (lo, hi) = (ends(-1.0), ends(1.0));
        let slack = slack(setting.scale);
        let [min, max, center, half] = [min, max, center, half].map(|pair| Real::from(pair[axis]));
        if min > lo + slack || max < hi - slack {
            report.fault("bounds", format!("[{min}, {max}] does not hold [{lo}, {hi}]"));
        }
        if center - half > lo + slack || center + half < hi - slack {
            report.fault("half-extents", format!("{center} ± {half} does not hold [{lo}, {hi}]"));
        }
        report.limit("bounds beyond / εS", setting.units(lo - min).max(setting.units(max - hi)), WIDTH);
        let middle = setting.units(center - (lo + hi).scaled(-1));
        let size = setting.units(half - (hi - lo).scaled(-1));
        report.limit("center, half-extents / εS", middle.max(size), WIDTH);
    }
}

/// `overlap`: the right verdict, or null within rounding; bounds that hold s, open ends allowed.
pub(super) fn check_overlap(report: &mut Report, scene: &Scene, setting: &Setting, result: &Json) {
    let [a, b] = setting.pair(&scene.bodies, Real::from(scene.time));
    let s = separation(&a, &b).separation;
    let slack = slack(setting.scale);
    let ends = result.get("separation_bounds").map_or(&[][..], Json::list);
    let [lo, hi] = ends else {
        report.fault("fields", format!("incomplete: {result}"));
        return;
    };
    let holds_below = lo.number().is_none_or(|lo| Real::from(lo) <= s + slack);
    let holds_above = hi.number().is_none_or(|hi| Real::from(hi) >= s - slack);
    if !(holds_below && holds_above) {
        report.fault("bounds", format!("[{lo}, {hi}] does not hold {s}"));
    }
    let unsure = lo.number().is_none_or(|lo| lo <= 0.0) && hi.number().is_none_or(|hi| hi >= 0.0);
    match result.get("overlap") {
        Some(Json::Bool(true)) if s > slack => report.fault("verdict", format!("overlap, but s is {s}")),
        Some(Json::Bool(false)) if s <= slack => report.fault("verdict", format!("no overlap, but s is {s}")),
        Some(Json::Bool(_)) => {}
        Some(Json::Null) if unsure => report.limit("undecided |s| / εS", setting.units(s), UNRESOLVED),
        other => report.fault("verdict", format!("{other:?} with [{lo}, {hi}]")),
    }
}

/// `motion-bound`: at least |v| + Σ r |ω|, and no more than that with r the reach of the whole body, rounded
/// up.
pub(super) fn check_motion_bound(report: &mut Report, scene: &Scene, result: &Json) {
    let Some(bound) = result.number_at("bound") else {
        report.fault("fields", format!("incomplete: {result}"));
        return;
    };
    let velocity = |i: usize| scene.bodies.get(i).map_or(Point::ZERO, |body| Point::of(body.velocity));
    let linear = velocity(0).minus(velocity(1)).length();
    let (mut least, mut most) = (linear, linear);
    for body in &scene.bodies {
        let reach = body.multiplied().map(Point::length).max().unwrap_or(Real::ZERO);
        let spin = body.spin.in_radians().abs();
        least = least + spin * reach;
        most = most + spin * (reach + Real::from(body.radius));
    }
    let bound = Real::from(bound);
    if bound < least * (Real::one() - Real::power_of_two(-200)) {
        report.fault("motion bound", format!("{bound} is below {least}"));
    }
    if most.is_zero() {
        report.limit("motion bound, excess in ε", bound.to_f64(), 0.0);
    } else {
        let excess = (bound - most).over(most * Real::from(EPSILON)).to_f64();
        report.limit("motion bound, excess in ε", excess, MOTION);
    }
}
