//! Every answer against the exact one: cases of `tracefig-reference` from a seed, checked in 320 bits.
//!
//! `TRACEFIG_CASES_SEPARATION` and `TRACEFIG_CASES_IMPACT` raise the numbers, `TRACEFIG_SEED` changes the cases. A
//! failure prints the scene, which `tracefig solve` reads as it stands.

use tracefig_reference::check::{Report, check};
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::scene::Scene;
use tracefig_reference::tally::Tally;

/// Wrong answers printed of each category.
const SHOWN: usize = 2;

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

fn tallied(family: Family, count: u64, check_one: impl Fn(&str, &str) -> Report + Sync) -> Tally {
    let seed = setting("TRACEFIG_SEED", 1);
    println!("seed {seed}: TRACEFIG_SEED={seed} repeats these {count} cases");
    let mut tally = Tally::default();
    for i in 0..count {
        let scene = family.case(seed, i).to_string();
        let answer = tracefig::solve_jsonl_line(&scene, 1).line;
        let report = check_one(&scene, &answer);
        tally.add(&scene, &answer, &report);
    }
    println!("{tally}");
    tally
}

fn assert_right(tally: &Tally) {
    let wrong = tally.failures.len();
    assert!(wrong == 0, "{wrong} of {} are wrong\n{}", tally.cases(), tally.told(SHOWN));
}

fn checked(scene: &str, answer: &str) -> Report {
    match (Scene::parse(scene), Json::parse(answer)) {
        (Ok(scene), Ok(answer)) => check(&scene, &answer),
        (Err(error), _) | (_, Err(error)) => panic!("{error}\n{scene}\n{answer}"),
    }
}

#[test]
fn separations_bounds_and_overlaps_are_exact_within_their_bounds() {
    let count = setting("TRACEFIG_CASES_SEPARATION", 5_000);
    assert_right(&tallied(Family::Separation, count, checked));
}

#[test]
fn contacts_are_the_first_and_misses_are_proved() {
    let count = setting("TRACEFIG_CASES_IMPACT", 500);
    assert_right(&tallied(Family::Impact, count, checked));
}
