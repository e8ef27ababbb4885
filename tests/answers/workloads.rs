//! The report's workloads and their committed answers: `src/report/answers.tsv` is what exact arithmetic
//! gives.
//!
//! Some answers of each workload are computed again on every run.
//! `TRACEFIG_WRITE_ANSWERS=1 cargo test --test answers workloads` computes all of them and writes the file.

#![expect(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::fmt::Write;

use tracefig::collision::{MovingPair, QueryKind};
use tracefig::geometry::Body;
use tracefig::report::{Case, Class, Workload, workloads};
use tracefig_reference::first_contact::{Motion, Passage};
use tracefig_reference::float::Real;
use tracefig_reference::scene::Scene;

/// Digits of a committed answer.
const DIGITS: usize = 40;
/// Cases in each workload.
const CASES: usize = 16;
/// Largest number of vertices whose answers are computed again on every run.
const AGAIN: usize = 16;

fn body_json(body: &Body) -> serde_json::Value {
    let pair = |v: tracefig::geometry::DVec2| serde_json::json!([v.x, v.y]);
    serde_json::json!({
        "kind": "polygon",
        "vertices": body.shape.vertices.iter().map(|v| pair(*v)).collect::<Vec<_>>(),
        "position": pair(body.position),
        "angle_deg": body.angle.degrees(),
        "velocity": pair(body.velocity),
        "angular_velocity_deg": body.spin.degrees(),
    })
}

fn scene(workload: &Workload, case: &Case) -> Scene {
    let kind = match workload.class.query() {
        QueryKind::Separation => "separation",
        _ => "time-of-impact",
    };
    let json = serde_json::json!({
        "shapes": { "A": body_json(&case.a), "B": body_json(&case.b) },
        "query": { "kind": kind, "of": ["A", "B"] },
    });
    Scene::parse(&json.to_string()).expect("a workload is a valid scene")
}

/// The exact answer, None for a miss.
fn exact(workload: &Workload, case: &Case) -> Option<Real> {
    let motion = Motion::of(&scene(workload, case).bodies);
    if workload.class.query() == QueryKind::Separation {
        return Some(motion.separation(Real::from(0.0)).separation);
    }
    match motion.first_within(Real::from(0.0), Real::from(0.0), Real::one()) {
        Passage::Clear => None,
        Passage::Below { after, by } => Some(root(&motion, after, by)),
        Passage::Unsettled { after, until } => {
            panic!("{}: contact in doubt between {after} and {until}", workload.name())
        }
    }
}

/// The crossing between two moments 2⁻¹¹⁰ apart: one step of the secant squares what is left.
fn root(motion: &Motion, after: Real, by: Real) -> Real {
    let (high, low) = (motion.separation(after).separation, motion.separation(by).separation);
    if high == low { by } else { after + (by - after) * high.over(high - low) }
}

fn line(workload: &Workload, index: usize, answer: Option<Real>) -> String {
    let name = workload.name();
    match answer {
        None => format!("{name}\t{index}\tmiss\n"),
        Some(value) => {
            let rest = (value - Real::from(value.to_f64())).to_f64();
            format!("{name}\t{index}\t{}\t{rest:e}\n", value.to_decimal(DIGITS))
        }
    }
}

#[test]
fn every_workload_has_all_its_cases() {
    for workload in workloads() {
        assert_eq!(workload.cases.len(), CASES, "{}", workload.name());
        for case in &workload.cases {
            assert_eq!(case.a.shape.core.len(), workload.vertices, "{}", workload.name());
        }
    }
}

#[test]
fn the_committed_answers_are_the_exact_ones() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/report/answers.tsv");
    let write = std::env::var_os("TRACEFIG_WRITE_ANSWERS").is_some();
    let committed = std::fs::read_to_string(path).expect("the answers are committed");
    let mut all = String::new();
    for workload in workloads() {
        let indices = if write { 0..CASES } else { 0..usize::from(workload.vertices <= AGAIN) };
        for index in indices {
            let line = line(&workload, index, exact(&workload, &workload.cases[index]));
            assert!(write || committed.contains(&line), "not committed: {line}");
            let _ = write!(all, "{line}");
        }
    }
    if write {
        std::fs::write(path, all).expect("the answers can be written");
    } else {
        assert_eq!(committed.lines().count(), workloads().len() * CASES);
    }
}

#[test]
fn turning_takes_four_distance_queries_at_most_on_average() {
    for workload in workloads().iter().filter(|w| w.class == Class::Turning) {
        for tolerance in [1e-2, 1e-6, 1e-12] {
            let queries =
                |case: &Case| MovingPair::new(&case.a, &case.b).first_contact(tolerance, 1000).iterations;
            let sum: usize = workload.cases.iter().map(queries).sum();
            assert!(sum <= 4 * CASES, "{}: {sum} queries of {CASES} cases", workload.name());
        }
    }
}
