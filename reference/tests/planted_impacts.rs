//! Right answers to motions pass; each planted fault is caught.

use tracefig_reference::answer::impact_line;
use tracefig_reference::check::{Record, Report, check, check_certificate};
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::scene::Scene;

fn scene(a: &str, b: &str, kind: &str) -> Scene {
    let text =
        format!(r#"{{"shapes": {{"A": {a}, "B": {b}}}, "query": {{"kind": "{kind}", "of": ["A", "B"]}}}}"#);
    Scene::parse(&text).expect("valid")
}

/// A bar that turns into a wall.
fn bar() -> Scene {
    let a = r#"{"kind": "box", "half_extents": [1, 0.1], "angular_velocity_deg": 180}"#;
    scene(a, r#"{"kind": "box", "half_extents": [0.5, 5], "position": [1.504, 0.25]}"#, "time-of-impact")
}

/// A rod that crosses a peg four times.
fn rod() -> Scene {
    let a = r#"{"kind": "box", "half_extents": [2, 0.05], "angle_deg": 30, "angular_velocity_deg": 720}"#;
    scene(a, r#"{"kind": "circle", "radius": 0.05, "position": [-1.8, 0]}"#, "time-of-impact")
}

/// A bar that turns beside a wall, a hair away.
fn beside() -> Scene {
    let a = r#"{"kind": "box", "half_extents": [1, 0.1], "angular_velocity_deg": 180}"#;
    scene(a, r#"{"kind": "box", "half_extents": [0.5, 5], "position": [1.5051, 0]}"#, "time-of-impact")
}

fn report(scene: &Scene, change: impl Fn(&mut Json)) -> Report {
    let mut line = impact_line(scene);
    assert_eq!(check(scene, &line).faults, [], "{line}");
    if let Json::Object(fields) = &mut line {
        change(&mut fields[1].1);
    }
    check(scene, &line)
}

fn text(word: &str) -> Json {
    Json::Text(word.to_owned())
}

#[test]
fn exact_answers_rounded_to_doubles_pass_the_check() {
    for i in 0..190 {
        let case = Family::Impact.case(11, i).to_string();
        let scene = Scene::parse(&case).expect("valid");
        let line = impact_line(&scene);
        assert_eq!(check(&scene, &line).faults, [], "{case}\n{line}");
    }
}

#[test]
fn a_later_contact_is_caught() {
    // Half a turn later the rod is as near to the peg as at the first contact.
    let report = report(&rod(), |result| {
        let [free, met] = result.pair_at("time_bounds").expect("there");
        result.set("time", Json::Number(free + 0.25));
        result.set("time_bounds", Json::from_pair([free + 0.25, met + 0.25]));
    });
    assert!(report.has("time"), "{:?}", report.faults);
}

#[test]
fn a_contact_that_is_not_there_yet_is_caught() {
    let report = report(&bar(), |result| {
        let [free, _] = result.pair_at("time_bounds").expect("there");
        let early = free.next_down().next_down();
        result.set("time", Json::Number(early));
        result.set("time_bounds", Json::from_pair([early, early]));
    });
    assert!(report.has("contact"), "{:?}", report.faults);
}

#[test]
fn time_bounds_too_wide_are_caught() {
    let report = report(&bar(), |result| {
        let [free, met] = result.pair_at("time_bounds").expect("there");
        result.set("time_bounds", Json::from_pair([free, met + 1e-9]));
    });
    assert!(report.has("Δt · closing / (4 tol + 16 εS)"), "{:?}", report.faults);
}

#[test]
fn a_miss_for_a_hit_and_a_hit_for_a_miss_are_caught() {
    assert!(report(&bar(), |result| result.set("outcome", text("miss"))).has("outcome"));
    let hit = impact_line(&bar());
    let mut line = hit.clone();
    line.set("id", Json::Null);
    assert!(check(&beside(), &line).has("contact"));
}

#[test]
fn a_shrug_at_what_can_be_decided_is_caught() {
    for scene in [bar(), beside(), rod()] {
        let report = report(&scene, |result| {
            result.set("outcome", text("unresolved"));
            result.set("reason", text("within-rounding"));
            result.set("time_bounds", Json::from_pair([0.0, 1.0]));
        });
        assert_eq!(report.faults.iter().map(|fault| fault.claim).collect::<Vec<_>>(), ["undecided"]);
    }
}

#[test]
fn points_that_meet_between_two_doubles_are_a_hit_and_those_that_just_miss_are_none() {
    let moving = r#"{"kind": "circle", "radius": 0, "center": [-4.5, -1.5], "position": [-12, -4], "velocity": [12, 4]}"#;
    let coming = |y: f64| {
        format!(r#"{{"kind": "circle", "radius": 0, "center": [6, {y}], "velocity": [-16.5, -5.5]}}"#)
    };
    // At 15/19.
    let met = scene(moving, &coming(2.0), "linear-sweep");
    let line = impact_line(&met);
    assert_eq!(check(&met, &line).faults, [], "{line}");
    let passed = scene(moving, &coming(2.0_f64.next_up()), "linear-sweep");
    assert!(check(&passed, &line).has("contact"), "{line}");
}

#[test]
fn a_shrug_is_taken_at_discs_that_touch_at_the_start_and_at_no_others() {
    let a = r#"{"kind": "circle", "radius": 1, "center": [-3, 0], "angle_deg": 38.29404581263847, "velocity": [5.5, 0]}"#;
    for (x, may_shrug) in [("1", true), ("1.5", false)] {
        let b = format!(
            r#"{{"kind": "circle", "radius": 0, "center": [-3, 0], "position": [{x}, 0], "angle_deg": 38.29404581263847}}"#
        );
        let shrug = r#"{"id": null, "result": {"kind": "linear-sweep", "outcome": "unresolved",
            "reason": "within-rounding", "time_bounds": [0, 1], "tolerance": 0, "iterations": 1}}"#;
        let faults = check(&scene(a, &b, "linear-sweep"), &Json::parse(shrug).expect("valid")).faults;
        assert_eq!(faults.is_empty(), may_shrug, "{x}: {faults:?}");
    }
}

#[test]
fn overlap_that_is_a_hair_apart_is_caught() {
    let b = r#"{"kind": "circle", "radius": 1, "position": [2.0000000000000004, 0]}"#;
    let scene = scene(r#"{"kind": "circle", "radius": 1}"#, b, "linear-sweep");
    let report = report(&scene, |result| {
        result.set("outcome", text("overlapping"));
        result.set("separation", Json::Number(0.0));
        result.set("separation_bounds", Json::from_pair([0.0, 4e-16]));
    });
    assert!(report.has("outcome"), "{:?}", report.faults);
}

fn certified(records: &[Record]) -> bool {
    let scene = beside();
    let result = impact_line(&scene).get("result").cloned().expect("there");
    let mut report = Report::default();
    check_certificate(&mut report, &scene, &result, records);
    report.faults.is_empty()
}

#[test]
fn certificates_with_a_gap_an_early_end_or_a_wrong_axis_are_caught() {
    let record = |from, to| Record { from, to, owner: 1, normal: [-1.0, 0.0] };
    assert!(certified(&[record(0.0, 1.0)]));
    assert!(certified(&[record(0.0, 0.4), record(0.4, 1.0)]));
    assert!(!certified(&[record(0.0, 0.4), record(0.41, 1.0)]));
    assert!(!certified(&[record(0.0, 0.4)]));
    assert!(!certified(&[Record { normal: [1.0, 0.0], ..record(0.0, 1.0) }]));
    assert!(!certified(&[Record { owner: 0, ..record(0.0, 1.0) }]));
    assert!(!certified(&[Record { normal: [-1.0, 0.01], ..record(0.0, 1.0) }]));
}
