//! Every answer against the exact one: cases of `tracefig-reference` from a seed, checked in 320 bits.
//!
//! `TRACEFIG_CASES_SEPARATION` and `TRACEFIG_CASES_IMPACT` raise the numbers, `TRACEFIG_SEED` changes the cases. A
//! failure prints the scene, which `tracefig solve` reads as it stands.

use tracefig::geometry::Side;
use tracefig::trace::{Event, Trace};
use tracefig_reference::check::{Record, Report, check, check_certificate};
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::scene::{Kind, Scene};
use tracefig_reference::tally::Tally;

/// Wrong answers printed of each category.
const SHOWN: usize = 2;

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

fn assert_right(family: Family, count: u64) {
    let seed = setting("TRACEFIG_SEED", 1);
    println!("TRACEFIG_SEED={seed} repeats these {count} cases");
    let mut tally = Tally::default();
    for i in 0..count {
        let scene = family.case(seed, i).to_string();
        let answer = tracefig::solve_jsonl_line(&scene, 1).line;
        let report = checked(&scene, &answer);
        tally.add(&scene, &answer, &report);
    }
    println!("{tally}");
    let wrong = tally.failures.len();
    assert!(wrong == 0, "seed {seed}: {wrong} of {} are wrong\n{}", tally.cases(), tally.told(SHOWN));
}

fn checked(text: &str, answer: &str) -> Report {
    let (scene, answer) = match (Scene::parse(text), Json::parse(answer)) {
        (Ok(scene), Ok(answer)) => (scene, answer),
        (Err(error), _) | (_, Err(error)) => panic!("{error}\n{text}\n{answer}"),
    };
    let mut report = check(&scene, &answer);
    if scene.kind == Kind::TimeOfImpact
        && let Some(result) = answer.get("result")
    {
        check_certificate(&mut report, &scene, result, &certificate(text));
    }
    report
}

/// The records of the swept axis, from the trace of the same query.
fn certificate(text: &str) -> Vec<Record> {
    let file = tracefig::scene::open_text("case.json", text).expect("answered before");
    let query = file.scene.query_of_bodies();
    let mut trace = Trace::default();
    (file.scene.query.algorithm.traced)(&query, &mut trace);
    let record = |event: &Event| match event {
        Event::AxisSwept { from, to, owner, normal } => Some(Record {
            from: *from,
            to: *to,
            owner: usize::from(*owner == Side::B),
            normal: normal.to_array(),
        }),
        _ => None,
    };
    trace.events.iter().filter_map(record).collect()
}

#[test]
fn separations_bounds_and_overlaps_are_exact_within_their_bounds() {
    assert_right(Family::Separation, setting("TRACEFIG_CASES_SEPARATION", 5_000));
}

#[test]
fn contacts_are_the_first_and_misses_are_proved() {
    assert_right(Family::Impact, setting("TRACEFIG_CASES_IMPACT", 500));
}
