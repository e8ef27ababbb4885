//! Whatever is told touching has a normal of the contact's normal cone: an edge's, or between two
//! neighbours', however small a hair the vertices are off.
//!
//! The gap of the supports along a direction of that cone is the separation; along any other it is less, by
//! the bodies' own size. `TRACEFIG_CASES_NEAR_VERTICES` raises the number of pairs, `TRACEFIG_SEED` changes
//! them.

#![expect(clippy::expect_used, reason = "tests fail by panics")]

use tracefig::collision::ALGORITHMS;
use tracefig_reference::check::check;
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::random::Random;
use tracefig_reference::scene::Scene;
use tracefig_reference::tally::Tally;

/// Every so many pairs are asked of every algorithm.
const ASKED_OF_ALL: u64 = 16;

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// The scene in both orders of its bodies.
fn both_orders(scene: &Json) -> [Json; 2] {
    let mut query = scene.get("query").cloned().expect("a query");
    let mut of = query.get("of").expect("two bodies").list().to_vec();
    of.reverse();
    query.set("of", Json::List(of));
    let mut swapped = scene.clone();
    swapped.set("query", query);
    [scene.clone(), swapped]
}

/// The scene asked of an algorithm; None where that does not take it.
fn asked_of(scene: &Json, algorithm: &str) -> Option<Json> {
    let mut query = scene.get("query").cloned()?;
    query.set("algorithm", Json::Text(algorithm.to_owned()));
    let mut asked = scene.clone();
    asked.set("query", query);
    tracefig::scene::open_text("case.json", &asked.to_string()).ok().map(|_| asked)
}

#[test]
fn a_hair_from_a_vertex_the_normal_is_between_those_of_its_edges_in_both_orders() {
    let mut tally = Tally::default();
    let seed = setting("TRACEFIG_SEED", 1);
    for i in 0..setting("TRACEFIG_CASES_NEAR_VERTICES", 1_000) {
        let case = (Family::near_vertices().draw)(&mut Random::of_case(seed, i));
        let mut asked = both_orders(&case).to_vec();
        if i % ASKED_OF_ALL == 0 {
            let other =
                |scene: &Json| ALGORITHMS.iter().filter_map(|a| asked_of(scene, a.name)).collect::<Vec<_>>();
            asked = asked.iter().flat_map(other).collect();
        }
        for scene in asked {
            let text = scene.to_string();
            let answer = tracefig::solve_jsonl_line(&text, 1).line;
            let (scene, json) = (Scene::parse(&text).expect("valid"), Json::parse(&answer).expect("valid"));
            tally.add(&text, &answer, &check(&scene, &json));
        }
    }
    println!("{tally}");
    assert!(tally.failures.is_empty(), "{} wrong\n{}", tally.failures.len(), tally.told(3));
}
