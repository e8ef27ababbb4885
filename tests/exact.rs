//! Every answer against the exact one: cases of `tracefig-reference` from a seed, checked in 320 bits.
//!
//! `TRACEFIG_CASES_SEPARATION`, `TRACEFIG_CASES_IMPACT`, `TRACEFIG_CASES_LOGGED` and
//! `TRACEFIG_CASES_LOGGED_IMPACT` and `TRACEFIG_CASES_CONTACT` raise the numbers, `TRACEFIG_SEED` changes
//! the cases. A failure prints the scene, which `tracefig solve` reads as it stands.

#![expect(
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "tests fail by panics and print their tables"
)]

use tracefig::geometry::Side;
use tracefig::trace::{Event, Trace};
use tracefig_reference::check::{Record, Report, check, check_certificate};
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::random::Random;
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
        && !scene.iterates
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
    (file.scene.query().algorithm.traced)(&query, &mut trace);
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

/// Claims that only the default algorithms hold to: how tight, not how true.
const TIGHT: [&str; 9] = [
    "error / εS",
    "error / |s|",
    "width / εS",
    "width / |s|",
    "loss along n / εS",
    "Δt · closing / (4 tol + 16 εS)",
    "bounds beyond / εS",
    "center, half-extents / εS",
    "undecided",
];

/// The scene with another kind of question and an algorithm asked for; None where that does not take it.
fn asking(scene: &Json, kind: &str, algorithm: &str) -> Option<String> {
    let mut scene = scene.clone();
    let mut query = scene.get("query")?.clone();
    query.set("kind", Json::Text(kind.to_owned()));
    query.set("algorithm", Json::Text(algorithm.to_owned()));
    scene.set("query", query);
    let text = scene.to_string();
    tracefig::scene::open_text("case.json", &text).ok().map(|_| text)
}

#[test]
fn every_algorithm_keeps_within_its_bounds() {
    let mut tally = Tally::default();
    let families =
        [(Family::Separation, 300), (Family::Impact, 42), (Family::Logged, 60), (Family::LoggedImpact, 20)];
    for (family, count) in families {
        for i in 0..count {
            let scene = family.case(setting("TRACEFIG_SEED", 1), i);
            let kind = scene.get("query").and_then(|query| query.text_at("kind")).expect("a kind");
            let kinds = if kind == "separation" { vec![kind, "overlap"] } else { vec![kind] };
            for (algorithm, kind) in
                tracefig::collision::ALGORITHMS.iter().flat_map(|a| kinds.iter().map(move |k| (a, k)))
            {
                let Some(text) = asking(&scene, kind, algorithm.name) else { continue };
                let answer = tracefig::solve_jsonl_line(&text, 1).line;
                let mut report = checked(&text, &answer);
                report.faults.retain(|fault| !TIGHT.contains(&fault.claim));
                tally.add(&text, &answer, &report);
            }
        }
    }
    println!("{tally}");
    assert!(tally.failures.is_empty(), "{}", tally.told(SHOWN));
}

/// The scene with its two bodies called the other way round.
fn swapped(scene: &Json) -> Json {
    let mut scene = scene.clone();
    let mut query = scene.get("query").cloned().expect("a query");
    let mut of = query.get("of").expect("two bodies").list().to_vec();
    of.reverse();
    query.set("of", Json::List(of));
    scene.set("query", query);
    scene
}

/// Whether nothing in the scene is turned: its points are doubles exactly.
fn is_unturned(text: &str) -> bool {
    !text.contains("angle_deg")
}

#[test]
fn points_and_segments_on_one_line_are_right_by_every_algorithm_in_both_orders() {
    let mut tally = Tally::default();
    let mut open = Vec::new();
    for family in [Family::Separation, Family::Impact] {
        let category = family.flat_pairs();
        for i in 0..setting("TRACEFIG_CASES_FLAT", 100) {
            let case = (category.draw)(&mut Random::of_case(setting("TRACEFIG_SEED", 1), i));
            let kinds: &[&str] = match family {
                Family::Impact => &["linear-sweep", "time-of-impact"],
                _ => &["separation", "overlap", "contact"],
            };
            let asked = tracefig::collision::ALGORITHMS
                .iter()
                .flat_map(|a| kinds.iter().map(move |kind| (*kind, a.name)))
                .flat_map(|(kind, name)| {
                    [&case, &swapped(&case)].map(|scene| asking(scene, kind, name).map(|text| (name, text)))
                });
            for (name, text) in asked.flatten() {
                let answer = tracefig::solve_jsonl_line(&text, 1).line;
                let mut report = checked(&text, &answer);
                let is_default = matches!(name, "ray-cast" | "swept-axis" | "closest-features");
                report.faults.retain(|fault| is_default || !TIGHT.contains(&fault.claim));
                tally.add(&text, &answer, &report);
                if is_default && is_unturned(&text) && answer.contains("unresolved") {
                    open.push(format!("{text}\n{answer}"));
                }
            }
        }
    }
    println!("{tally}");
    assert!(tally.failures.is_empty(), "{} wrong\n{}", tally.failures.len(), tally.told(SHOWN));
    assert!(open.is_empty(), "{} are left open, as\n{}", open.len(), open[0]);
}

#[test]
fn separations_bounds_and_overlaps_are_exact_within_their_bounds() {
    assert_right(Family::Separation, setting("TRACEFIG_CASES_SEPARATION", 5_000));
}

#[test]
fn contacts_are_the_first_and_misses_are_proved() {
    assert_right(Family::Impact, setting("TRACEFIG_CASES_IMPACT", 500));
}

/// Plants a fault in the solver's own separations; how many were planted, and how many were caught.
fn planted(fault: impl Fn(&mut Json)) -> (usize, usize) {
    let (mut planted, mut caught) = (0, 0);
    for i in 0..760 {
        let text = Family::Separation.case(3, i).to_string();
        let scene = Scene::parse(&text).expect("valid");
        let mut answer = Json::parse(&tracefig::solve_jsonl_line(&text, 1).line).expect("valid");
        let Some(mut result) = answer.get("result").cloned() else { continue };
        if scene.kind != Kind::Separation {
            continue;
        }
        let before = check(&scene, &answer).faults.len();
        fault(&mut result);
        answer.set("result", result);
        planted += 1;
        caught += usize::from(check(&scene, &answer).faults.len() > before);
    }
    assert!(planted > 500, "only {planted} answers to spoil");
    (planted, caught)
}

/// The bounds drawn in to a part of their distance from the value.
fn drawn_in(result: &mut Json, part: f64) {
    let (Some(s), Some([lo, hi])) = (result.number_at("separation"), result.pair_at("separation_bounds"))
    else {
        return;
    };
    result.set("separation_bounds", Json::from_pair([s - (s - lo) * part, s + (hi - s) * part]));
}

#[test]
fn bounds_cut_to_a_quarter_would_be_caught() {
    let (planted, caught) = planted(|result| drawn_in(result, 0.25));
    println!("{caught} of {planted} caught");
    // Where an answer is exact or luckily near, narrower bounds are still true: no checker can object.
    assert!(
        caught * 100 > planted,
        "{caught} of {planted}: the bounds are so wide that a quarter of them holds as well"
    );
}

#[test]
fn a_flipped_sign_a_wrong_tie_and_a_feature_off_by_one_would_be_caught() {
    let (flips, caught) = planted(|result| {
        let [x, y] = result.pair_at("normal").expect("a normal");
        result.set("normal", Json::from_pair([-x, -y]));
    });
    assert!(caught * 100 > flips * 95, "normals: {caught} of {flips}");
    let (ties, caught) = planted(|result| {
        let ties = result.number_at("ties").expect("ties");
        result.set("ties", Json::Number(ties + 1.0));
    });
    assert!(caught * 10 > ties * 9, "ties: {caught} of {ties}");
    let (features, caught) = planted(|result| {
        let mut features = result.get("features").expect("features").clone();
        if let Some(Json::Object(mut feature)) = features.get("B").cloned() {
            feature[0].1 = Json::Number(feature[0].1.number().expect("an index") + 1.0);
            features.set("B", Json::Object(feature));
        }
        result.set("features", features);
    });
    assert!(caught * 100 > features * 95, "features: {caught} of {features}");
}

/// Plants a fault in how near the solver's misses came; how many were planted, and how many were caught.
fn planted_in_misses(fault: impl Fn(&mut Json)) -> (usize, usize) {
    let (mut planted, mut caught) = (0, 0);
    for i in 0..600 {
        let text = Family::Impact.case(3, i).to_string();
        let scene = Scene::parse(&text).expect("valid");
        let mut answer = Json::parse(&tracefig::solve_jsonl_line(&text, 1).line).expect("valid");
        let Some(mut result) = answer.get("result").cloned() else { continue };
        let Some(mut closest) = result.get("closest").cloned() else { continue };
        // A graze by 1e-17 and less says as little of a millionth of it as doubles do.
        if closest.number_at("separation").is_none_or(|s| s < 1e-15) {
            continue;
        }
        fault(&mut closest);
        result.set("closest", closest);
        answer.set("result", result);
        planted += 1;
        caught += usize::from(check(&scene, &answer).has("closest"));
    }
    assert!(planted > 100, "only {planted} answers to spoil");
    (planted, caught)
}

#[test]
fn a_miss_that_is_said_to_come_nearer_or_less_near_or_at_another_time_would_be_caught() {
    let by = |part: f64| {
        move |closest: &mut Json| {
            let (separation, bounds) =
                (closest.number_at("separation"), closest.pair_at("separation_bounds"));
            let (Some(s), Some([_, hi])) = (separation, bounds) else { return };
            closest.set("separation", Json::Number(s * part));
            closest.set("separation_bounds", Json::from_pair([s.min(hi) * part, hi * part]));
        }
    };
    let (less_near, caught) = planted_in_misses(by(1.0 + 1e-6));
    assert!(caught == less_near, "less near: {caught} of {less_near}");
    let (nearer, caught) = planted_in_misses(by(1.0 - 1e-6));
    assert!(caught == nearer, "nearer: {caught} of {nearer}");
    let (moved, caught) = planted_in_misses(|closest| {
        let time = closest.number_at("time").expect("a time");
        closest.set("time", Json::Number(if time < 0.5 { time + 0.25 } else { time - 0.25 }));
    });
    // Where nothing moves relative to the other body, any time is as good.
    assert!(caught * 10 > moved * 7, "times: {caught} of {moved}");
}

#[test]
fn pairs_of_an_engines_log_are_exact_within_their_bounds() {
    assert_right(Family::Logged, setting("TRACEFIG_CASES_LOGGED", 1_000));
}

#[test]
fn contacts_of_an_engines_log_are_the_first() {
    assert_right(Family::LoggedImpact, setting("TRACEFIG_CASES_LOGGED_IMPACT", 150));
}

/// Cases of a family asked for their contact, of which an algorithm takes this many; each is checked, and how
/// many have so many points.
fn contacts(family: Family, count: usize, mut each: impl FnMut(&Scene, &Json)) -> [usize; 3] {
    let seed = setting("TRACEFIG_SEED", 1);
    let mut points = [0; 3];
    let cases = (0..).filter_map(|i| asking(&family.case(seed, i), "contact", "clip"));
    for text in cases.take(count) {
        let answer = tracefig::solve_jsonl_line(&text, 1).line;
        let (scene, answer) = (Scene::parse(&text).expect("valid"), Json::parse(&answer).expect("valid"));
        let found = answer.get("result").and_then(|result| result.get("contacts"));
        points[found.expect("contacts").list().len()] += 1;
        each(&scene, &answer);
    }
    points
}

#[test]
fn points_of_contact_are_exact_within_their_bounds() {
    let count = usize::try_from(setting("TRACEFIG_CASES_CONTACT", 2_000)).expect("a count");
    for family in [Family::Separation, Family::Logged] {
        let mut tally = Tally::default();
        let points = contacts(family, count / 2, |scene, answer| {
            let report = check(scene, answer);
            tally.add(&scene.id.to_string(), &answer.to_string(), &report);
        });
        println!("{tally}\nwith 0, 1, 2 points: {points:?}");
        assert!(points.iter().all(|&n| n * 50 > count), "{points:?}");
        assert!(tally.failures.is_empty(), "{}", tally.told(SHOWN));
    }
}

#[test]
fn a_point_of_contact_left_out_moved_or_of_another_edge_would_be_caught() {
    let spoil = |fault: &dyn Fn(&mut Json) -> Option<()>| {
        let (mut planted, mut caught) = (0, 0);
        contacts(Family::Separation, 600, |scene, answer| {
            let mut result = answer.get("result").cloned().expect("a result");
            if fault(&mut result).is_some() {
                let mut spoilt = answer.clone();
                spoilt.set("result", result);
                planted += 1;
                caught += usize::from(check(scene, &spoilt).faults.len() > check(scene, answer).faults.len());
            }
        });
        assert!(planted > 100, "only {planted} answers to spoil");
        (planted, caught)
    };
    let list = |result: &Json| result.get("contacts").map(|list| list.list().to_vec());
    let (left_out, caught) = spoil(&|result| {
        let mut points = list(result)?;
        points.pop()?;
        result.set("contacts", Json::List(points));
        Some(())
    });
    assert!(caught * 100 > left_out * 90, "left out: {caught} of {left_out}");
    let (moved, caught) = spoil(&|result| {
        let mut points = list(result)?;
        let [lo, hi] = points.first()?.pair_at("separation_bounds")?;
        let by = 1e-9 * (1.0 + lo.abs());
        points[0].set("separation_bounds", Json::from_pair([lo - 2.0 * by, hi.min(lo) - by]));
        points[0].set("separation", Json::Number(lo - by));
        result.set("contacts", Json::List(points));
        Some(())
    });
    assert!(caught * 100 > moved * 95, "moved: {caught} of {moved}");
    let (edges, caught) = spoil(&|result| {
        let mut incident = result.get("incident")?.clone();
        let edge = incident.number_at("edge")?;
        incident.set("edge", Json::Number(if edge > 0.0 { edge - 1.0 } else { edge + 1.0 }));
        result.set("incident", incident);
        Some(())
    });
    assert!(caught * 100 > edges * 90, "edges: {caught} of {edges}");
}
