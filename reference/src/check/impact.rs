//! Holds a linear sweep or a time of impact against the exact motion.
//!
//! `hit`: free until `time_bounds[0]`, contact at or before `time_bounds[1]`, so that it is the first; the
//! contact fields at `time`. `miss`: free for all of [0, 1]. `unresolved`: free until `time_bounds[0]`, and
//! so near a graze that nobody could ask for more. Freedom is proved by our own subdivision, and again by
//! replaying the solver's certificate where there is one.

use super::approach::check_approach;
use super::contact::{check_contact, check_value};
use super::{Report, Setting, UNRESOLVED, WIDTH, slack};
use crate::first_contact::{Axis, Motion, Passage, finest};
use crate::float::Real;
use crate::json::Json;
use crate::placement::Placed;
use crate::point::Point;
use crate::scene::{EPSILON, Kind, Scene};
use crate::separation::Difference;

/// Width of the time bounds times the closing speed: ≤ this · tolerance + [`WIDTH`] ε·S.
const TOLERANCES: f64 = 4.0;

/// A record of a certificate: over [from, to] the pair is apart along an axis that turns with its owner.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Start.
    pub from: f64,
    /// End.
    pub to: f64,
    /// 0 for A, 1 for B.
    pub owner: usize,
    /// In the owner's frame, from the owner to the other.
    pub normal: [f64; 2],
}

/// All that the checks of one answer share.
struct Case<'c> {
    scene: &'c Scene,
    setting: &'c Setting,
    motion: Motion,
    result: &'c Json,
    tolerance: f64,
    slack: Real,
}

/// Checks the answer of a sweep or a time of impact.
pub(super) fn check_impact(report: &mut Report, scene: &Scene, setting: &Setting, result: &Json) {
    let tolerance = result.number_at("tolerance").unwrap_or(f64::NAN);
    let motion = Motion::of(&scene.bodies);
    let case = Case { scene, setting, motion, result, tolerance, slack: slack(setting.scale) };
    case.check_tolerance(report);
    let start = case.motion.separation(Real::ZERO);
    let outcome = result.text_at("outcome").unwrap_or("");
    if start.separation <= case.slack && !matches!(outcome, "overlapping" | "unresolved") {
        report.fault("outcome", format!("{outcome}, but s(0) is {}", start.separation));
        return;
    }
    match outcome {
        "overlapping" => {
            if start.separation > case.slack {
                report.fault("outcome", format!("overlapping, but s(0) is {}", start.separation));
            }
            match (result.number_at("separation"), result.pair_at("separation_bounds")) {
                (Some(value), Some(bounds)) => check_value(report, setting, &start, value, bounds),
                _ => report.fault("fields", format!("incomplete: {result}")),
            }
        }
        "hit" => case.check_hit(report),
        "miss" => {
            let passage = case.motion.first_within(case.slack, Real::ZERO, Real::one());
            if passage == Passage::Clear {
                check_approach(report, scene, setting, &case.motion, result);
            } else {
                report.fault("outcome", format!("miss, but {}", told(passage)));
            }
        }
        "unresolved" => case.check_unresolved(report),
        _ => report.fault("outcome", format!("{outcome:?} is none")),
    }
}

fn told(passage: Passage) -> String {
    match passage {
        Passage::Clear => "clear".to_owned(),
        Passage::Below { after, by } => format!("contact between {after} and {by}"),
        Passage::Unsettled { after, .. } => format!("touching at {after}"),
    }
}

impl Case<'_> {
    fn check_tolerance(&self, report: &mut Report) {
        let most = self.setting.least_tolerance(self.scene);
        let fits = match self.scene.kind {
            Kind::LinearSweep if !self.scene.iterates => self.tolerance == 0.0,
            Kind::LinearSweep => (0.0..=most).contains(&self.tolerance),
            _ => (self.scene.tolerance..=most).contains(&self.tolerance),
        };
        if !fits {
            report.fault("tolerance", format!("{:e} of {:e}", self.tolerance, self.scene.tolerance));
        }
    }

    /// Whether the pair is free until t; a touch at t itself is free before.
    fn check_free(&self, report: &mut Report, until: f64) {
        let until = Real::from(until);
        if until.is_zero() {
            return;
        }
        match self.motion.first_within(self.slack, Real::ZERO, until) {
            Passage::Clear => {}
            Passage::Below { after, .. } | Passage::Unsettled { after, .. }
                if after >= until - finest().scaled(20) =>
            {
                if self.motion.separation(until).separation < -self.slack {
                    report.fault("time", format!("in contact already at {until}"));
                }
            }
            passage => report.fault("time", format!("free until {until}, but {}", told(passage))),
        }
    }

    fn check_hit(&self, report: &mut Report) {
        let (Some(time), Some([lo, hi])) =
            (self.result.number_at("time"), self.result.pair_at("time_bounds"))
        else {
            report.fault("fields", format!("incomplete: {}", self.result));
            return;
        };
        if !(time == lo && 0.0 <= lo && lo <= hi && hi <= 1.0) {
            report.fault("order", format!("time {time:e}, bounds [{lo:e}, {hi:e}]"));
            return;
        }
        self.check_free(report, lo);
        let (from, to) = (Real::from(lo), Real::from(hi));
        if !self.touches(from, to) {
            let s = self.motion.separation(to).separation;
            report.fault("contact", format!("none in [{lo:e}, {hi:e}], s is {s} there"));
        }
        let closing = self.motion.closing(from).max(Real::ZERO);
        let allowed = Real::from(TOLERANCES * self.tolerance + WIDTH * EPSILON * self.setting.scale);
        let width = ((to - from) * closing).over(allowed).to_f64();
        report.limit("Δt · closing / (4 tol + 16 εS)", width, 1.0);
        let pair = self.motion.pair(from);
        check_contact(report, self.setting, &pair, self.result, false);
    }

    /// Whether s ≤ 0 somewhere in [from, to], or the bodies have no interior and pass through each other.
    fn touches(&self, from: Real, to: Real) -> bool {
        if self.motion.separation(to).separation <= self.slack {
            return true;
        }
        let wider = finest().scaled(8);
        match self.motion.first_within(self.slack, from, to) {
            Passage::Clear => false,
            Passage::Below { .. } => true,
            Passage::Unsettled { after, until } => {
                let crossed = self.crosses(after - wider, until + wider, Real::ZERO);
                // A vertex that touches a vertex and leaves at once: s is no more than the speed times 2⁻¹¹⁰.
                let touch = finest().scaled(8) * Real::from(self.setting.scale);
                let touched = self.motion.separation((after + until).scaled(-1)).separation <= touch;
                crossed || (touched && self.motion.separation(from).solid) || self.meets_a_vertex(from, to)
            }
        }
    }

    /// Whether a vertex of a body that does not turn meets one of the other within [from, to]: at a moment
    /// that is a quotient, where no halving arrives.
    fn meets_a_vertex(&self, from: Real, to: Real) -> bool {
        let v = self.motion.closing_velocity();
        let (Some(v), [a, b]) = (v, self.motion.pair(Real::ZERO)) else { return false };
        let between = a.core_points().flat_map(|p| b.core_points().map(move |q| q.minus(p)));
        between.map(|d| d.dot(v).over(v.dot(v))).any(|t| {
            // The end of a time bound may be that moment itself, and rounded it is beyond.
            let t = t.max(from).min(to);
            self.motion.separation(t).separation <= self.slack
        })
    }

    /// Whether a flat B ⊖ A passes over the origin within [from, to]: the origin changes its side of the
    /// carrying line by more than `margin`, and stays between the ends by more than that.
    fn crosses(&self, from: Real, to: Real, margin: Real) -> bool {
        let flat = |pair: [Placed; 2]| {
            let difference = Difference::of(&pair[0], &pair[1]);
            (difference.edges.len() == 2 && (pair[0].radius + pair[1].radius).is_zero())
                .then(|| difference.edges[0])
        };
        let (Some(first), Some(last)) = (flat(self.motion.pair(from)), flat(self.motion.pair(to))) else {
            return false;
        };
        let moved = Real::from(4.0 * self.setting.scale) * (to - from);
        let look = |edge: crate::separation::Edge, along: Point| {
            let along = along.unit();
            let (place, end) = (-edge.start.dot(along), edge.along.dot(along));
            let (low, high) = (Real::ZERO.min(end), Real::ZERO.max(end));
            let room = (place - low).min(high - place);
            (along.cross(edge.start.reversed()), room > margin + moved)
        };
        let forward = first.along.dot(last.along).signum() >= 0;
        let (before, inside_before) = look(first, first.along);
        let (after, inside_after) = look(last, if forward { last.along } else { last.along.reversed() });
        let changes = before.signum() * after.signum() < 0;
        changes && before.abs() > margin && after.abs() > margin && inside_before && inside_after
    }

    fn check_unresolved(&self, report: &mut Report) {
        let Some([free, end]) = self.result.pair_at("time_bounds") else {
            report.fault("fields", format!("incomplete: {}", self.result));
            return;
        };
        let reason = self.result.text_at("reason").unwrap_or("");
        if end != 1.0 || !(0.0..=1.0).contains(&free) {
            report.fault("order", format!("time_bounds [{free:e}, {end:e}]"));
            return;
        }
        if !["within-rounding", "within-tolerance", "iteration-limit", "stalled"].contains(&reason) {
            report.fault("reason", format!("{reason:?} is none"));
        }
        self.check_free(report, free);
        if self.scene.iterates {
            return;
        }
        // Bodies that touch at the start, to all of 320 bits: nobody tells an overlap from a first contact.
        if free == 0.0 && self.motion.separation(Real::ZERO).separation.abs() <= self.slack {
            return;
        }
        let near =
            Real::from(UNRESOLVED * EPSILON * self.setting.scale) + Real::from(self.tolerance.max(0.0));
        if self.motion.first_within(near, Real::ZERO, Real::one()) == Passage::Clear {
            report.fault("undecided", "a miss by more than the limit".to_owned());
        } else if self.motion.first_within(-near, Real::ZERO, Real::one()) != Passage::Clear {
            report.fault("undecided", "a contact deeper than the limit".to_owned());
        } else if self.plainly_crosses(near) {
            report.fault("undecided", "bodies without interior cross by more than the limit".to_owned());
        }
    }

    fn plainly_crosses(&self, near: Real) -> bool {
        let at = match self.motion.first_within(self.slack, Real::ZERO, Real::one()) {
            Passage::Clear => return false,
            Passage::Below { by, .. } => by,
            Passage::Unsettled { after, .. } => after,
        };
        (4..45).any(|k| {
            let step = Real::power_of_two(-k);
            self.crosses((at - step).max(Real::ZERO), (at + step).min(Real::one()), near)
        })
    }
}

/// Replays a certificate: its records reach without a gap from 0 to the last free moment of the answer, or to
/// where the pair is nearer than an axis in doubles tells, and on each the axis keeps the pair apart.
pub fn check_certificate(report: &mut Report, scene: &Scene, result: &Json, records: &[Record]) {
    let setting = Setting::of(scene);
    let motion = Motion::of(&scene.bodies);
    let until = match result.text_at("outcome") {
        Some("miss") => 1.0,
        Some("hit" | "unresolved") => result.pair_at("time_bounds").map_or(1.0, |[free, _]| free),
        _ => return,
    };
    let mut covered = 0.0;
    for record in records {
        if record.from > covered {
            report.fault("certificate", format!("a gap from {covered:e} to {:e}", record.from));
            return;
        }
        covered = covered.max(record.to);
        let length = Point::of(record.normal).length();
        if length.is_zero() || record.owner > 1 {
            report.fault("certificate", format!("no axis: {record:?}"));
            return;
        }
        let axis = Axis { owner: record.owner, normal: Point::of(record.normal).unit() };
        let (from, to) = (Real::from(record.from), Real::from(record.to));
        if let Err(at) = motion.replay(axis, -slack(setting.scale), from, to) {
            report.fault("certificate", format!("{record:?} does not part the pair at {at}"));
            return;
        }
    }
    // Bodies that pass each other by less than doubles can tilt an axis are parted by none that they hold.
    let near = Real::from(UNRESOLVED * EPSILON * setting.scale);
    let rest = [Real::from(covered), Real::from(until)];
    if covered < until && motion.first_within(near, rest[0], rest[1]) == Passage::Clear {
        report.fault("certificate", format!("reaches {covered:e} of {until:e}"));
    }
}
