//! The exact separation against answers from elsewhere: the committed hard cases and the storyboard's pairs,
//! both computed by other programs in 256 bits or by head.

use tracefig_reference::answer::separation_line;
use tracefig_reference::check::{Setting, check};
use tracefig_reference::float::Real;
use tracefig_reference::generate::Family;
use tracefig_reference::json::Json;
use tracefig_reference::random::Random;
use tracefig_reference::scene::{Kind, Scene};
use tracefig_reference::separation::{Exact, separation};

const HARD: &str = include_str!("../../tests/data/hard.jsonl");

fn exact(scene: &Scene, t: f64) -> Exact {
    let pair = Setting::of(scene).pair(&scene.bodies, Real::from(t));
    separation(&pair[0], &pair[1])
}

#[test]
fn hard_separations_agree_to_all_printed_digits() {
    let mut seen = 0;
    for line in HARD.lines() {
        let scene = Scene::parse(line).expect("valid");
        if scene.kind != Kind::Separation {
            continue;
        }
        let expected = scene.expected.as_ref().and_then(|e| e.text_at("separation")).expect("a decimal");
        let expected = Real::from_decimal(expected).expect("a number");
        let ours = exact(&scene, scene.time).separation;
        assert!(
            (ours - expected).abs() <= expected.abs().scaled(-82),
            "{}: {ours} is not {expected}",
            scene.id
        );
        seen += 1;
    }
    assert_eq!(seen, 15);
}

fn story(a: &str, b: &str) -> Scene {
    let text = format!(
        r#"{{"shapes": {{"A": {a}, "B": {b}}}, "query": {{"kind": "separation", "of": ["A", "B"]}}}}"#
    );
    Scene::parse(&text).expect("valid")
}

fn assert_story(a: &str, b: &str, t: f64, s: f64, normal: [f64; 2]) {
    let exact = exact(&story(a, b), t);
    let n = exact.normal.expect("unique");
    let off = [n.x.to_f64() - normal[0], n.y.to_f64() - normal[1], exact.separation.to_f64() - s];
    assert!(off.into_iter().all(|x| x.abs() < 1e-15), "{a} {b}: {off:?}");
}

#[test]
fn the_storyboards_pairs_have_their_answers() {
    let a = r#"{"kind": "polygon", "vertices": [[5,-1],[2,3],[-3,3.5],[-5,0],[-3,-3.5],[2,-4]]}"#;
    let b = r#"{"kind": "polygon", "vertices": [[1.5,-0.5],[6,-2],[8,1],[6,3.5],[2.5,3]]}"#;
    assert_story(a, b, 0.0, -2.5, [0.8, 0.6]);
    let a = r#"{"kind": "aabb", "half_extents": [4, 1]}"#;
    assert_story(a, r#"{"kind": "circle", "radius": 1, "position": [5.5, 3]}"#, 0.0, 1.5, [0.6, 0.8]);
    let a = r#"{"kind": "box", "half_extents": [3, 1.5], "angle_deg": 36.86989764584402}"#;
    let b =
        r#"{"kind": "box", "half_extents": [2, 1.5], "position": [1, 2], "angle_deg": 36.86989764584402}"#;
    assert_story(a, b, 0.0, -2.0, [-0.6, 0.8]);
    let a = r#"{"kind": "circle", "radius": 1, "position": [-1.5, 2.5], "velocity": [4, -3]}"#;
    let b = r#"{"kind": "polygon", "vertices": [[0,-3],[4,-3.5],[6,0],[4.5,3]]}"#;
    assert_story(a, b, 0.0, 3.5, [0.8, -0.6]);
    assert_story(a, b, 1.0, -1.5, [0.8, -0.6]);
    let a = r#"{"kind": "polygon", "vertices": [[0,-3],[1,0],[0,1.5],[-1,0]], "position": [-7,-1], "velocity": [10,6], "angular_velocity_deg": 180}"#;
    let b = r#"{"kind": "polygon", "vertices": [[-2,-1.5],[1.5,-2],[2.5,0],[2,1.5],[-2,1.5]], "position": [7.5,-1.5], "velocity": [-10,6], "angular_velocity_deg": 180}"#;
    assert_story(a, b, 0.0, 11.5, [1.0, 0.0]);
    assert!(exact(&story(a, b), 0.5).separation.abs() < Real::power_of_two(-300));
}

#[test]
fn coincident_squares_have_four_ways_out() {
    let square = r#"{"kind": "box", "half_extents": [0.5, 0.5], "angle_deg": 33}"#;
    let exact = exact(&story(square, square), 0.0);
    assert_eq!(exact.ways.len(), 4);
    assert!(exact.ways.iter().all(|way| (way.separation + Real::one()).abs() < Real::power_of_two(-300)));
}

#[test]
fn exact_answers_rounded_to_doubles_pass_the_check() {
    for line in HARD.lines() {
        let scene = Scene::parse(line).expect("valid");
        if scene.kind == Kind::Separation {
            let report = check(&scene, &separation_line(&scene));
            assert_eq!(report.faults, [], "{}", separation_line(&scene));
        }
    }
}

#[test]
fn exact_answers_to_generated_cases_pass_the_check() {
    let mut wrong = Vec::new();
    for i in 0..1900 {
        let case = Family::Separation.case(11, i).to_string();
        let scene = Scene::parse(&case).expect("valid");
        if scene.kind == Kind::Separation {
            let line = separation_line(&scene);
            let faults = check(&scene, &line).faults;
            if !faults.is_empty() {
                wrong.push(format!("{faults:?}\n  {case}\n  {line}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A right answer with one claim changed.
#[test]
fn a_segment_whose_end_alone_faces_a_body_is_named_by_that_end() {
    let triangle = r#"{"kind": "polygon", "vertices": [[-3,-3],[-1,-3],[-1,0]], "position": [-1.5,-3]}"#;
    let segment = r#"{"kind": "capsule", "points": [[-1.5,-1],[0.5,1]], "radius": 0, "position": [0.5,-1.5], "angle_deg": 90}"#;
    // The triangle's corner is over the segment's end, square to it.
    let scene = story(triangle, segment);
    let report = check(&scene, &separation_line(&scene));
    assert!(report.faults.is_empty(), "{:?}", report.faults);
    for (category, seeds) in [(Family::Separation.flat_pairs(), 400), (Family::near_vertices(), 200)] {
        for seed in 0..seeds {
            let case = (category.draw)(&mut Random::of_case(11, seed));
            let mut query = case.get("query").cloned().expect("a query");
            query.set("kind", Json::Text("separation".to_owned()));
            let mut case = case.clone();
            case.set("query", query);
            let scene = Scene::parse(&case.to_string()).expect("valid");
            let report = check(&scene, &separation_line(&scene));
            assert!(report.faults.is_empty(), "{case}\n{:?}", report.faults);
        }
    }
}

fn planted(scene: &Scene, change: impl Fn(&mut Json)) -> Vec<&'static str> {
    let mut line = separation_line(scene);
    assert_eq!(check(scene, &line).faults, []);
    if let Json::Object(fields) = &mut line {
        change(&mut fields[1].1);
    }
    check(scene, &line).faults.iter().map(|fault| fault.claim).collect()
}

fn pair_of_polygons() -> Scene {
    let a = r#"{"kind": "polygon", "vertices": [[5,-1],[2,3],[-3,3.5],[-5,0],[-3,-3.5],[2,-4]], "angle_deg": 10}"#;
    let b = r#"{"kind": "polygon", "vertices": [[1.5,-0.5],[6,-2],[8,1],[6,3.5],[2.5,3]], "radius": 0.25}"#;
    story(a, b)
}

#[test]
fn a_flipped_sign_is_caught() {
    let faults = planted(&pair_of_polygons(), |result| {
        let s = result.number_at("separation").expect("there");
        result.set("separation", Json::Number(-s));
        result.set("separation_bounds", Json::from_pair([-s, -s]));
    });
    assert!(faults.contains(&"bounds") && faults.contains(&"sign"), "{faults:?}");
    let faults = planted(&pair_of_polygons(), |result| {
        let [x, y] = result.pair_at("normal").expect("there");
        result.set("normal", Json::from_pair([-x, -y]));
    });
    assert!(faults.contains(&"normal"), "{faults:?}");
}

#[test]
fn a_bound_cut_to_a_quarter_is_caught() {
    // Bounds three roundings wide around the exact value, a quarter of them on one side of the double nearest
    // to it.
    let faults = planted(&pair_of_polygons(), |result| {
        let s = result.number_at("separation").expect("there");
        result.set("separation_bounds", Json::from_pair([s, s]));
    });
    assert_eq!(faults, ["bounds"]);
}

#[test]
fn a_feature_off_by_one_is_caught() {
    for body in ["A", "B"] {
        let faults = planted(&pair_of_polygons(), |result| {
            let mut features = result.get("features").cloned().expect("there");
            let Some(Json::Object(feature)) = features.get(body).cloned() else { panic!("no feature") };
            let i = feature[0].1.number().expect("an index");
            features.set(body, Json::Object(vec![(feature[0].0.clone(), Json::Number((i + 1.0) % 5.0))]));
            result.set("features", features);
        });
        assert!(faults.contains(&"feature below support / εS"), "{body}: {faults:?}");
    }
}

#[test]
fn a_wrong_tie_is_caught() {
    let square = r#"{"kind": "box", "half_extents": [0.5, 0.5], "angle_deg": 33}"#;
    for ties in [0.0, 3.0, 5.0] {
        let faults = planted(&story(square, square), |result| result.set("ties", Json::Number(ties)));
        assert_eq!(faults, ["ties"]);
    }
    let faults = planted(&pair_of_polygons(), |result| result.set("ties", Json::Number(2.0)));
    assert_eq!(faults, ["ties"]);
}

#[test]
fn a_dropped_edge_is_caught() {
    // The answer that skips the best edge: the next way out, with all that belongs to it.
    let scene = pair_of_polygons();
    let pair = Setting::of(&scene).pair(&scene.bodies, Real::ZERO);
    let mut exact = separation(&pair[0], &pair[1]);
    exact.ways.retain(|way| way.separation != exact.separation);
    let next = exact.ways.iter().max_by(|x, y| x.separation.cmp(&y.separation)).copied().expect("more ways");
    exact.separation = next.separation;
    exact.normal = Some(next.normal);
    let mut wrong = tracefig_reference::answer::contact(&pair, &exact);
    wrong.set("ties", Json::Number(1.0));
    wrong.set("kind", Json::Text("separation".to_owned()));
    let report = check(&scene, &Json::object([("result", wrong)]));
    assert!(report.has("bounds") && report.has("error / εS") && report.has("normal"), "{:?}", report.faults);
}

#[test]
fn a_moved_witness_is_caught() {
    let faults = planted(&pair_of_polygons(), |result| {
        let mut points = result.get("points").cloned().expect("there");
        let [x, y] = points.pair_at("A").expect("there");
        points.set("A", Json::from_pair([x + 1e-13, y]));
        result.set("points", points);
    });
    assert!(faults.contains(&"p_B − p_A − s n / εS"), "{faults:?}");
    // Both moved along parallel faces: off the middle of the common span.
    let a = r#"{"kind": "box", "half_extents": [0.5, 0.5]}"#;
    let b = r#"{"kind": "box", "half_extents": [0.5, 0.5], "position": [2, 0.25]}"#;
    let faults = planted(&story(a, b), |result| {
        let points = result.get("points").cloned().expect("there");
        let up =
            |key: &str| points.pair_at(key).map(|[x, y]| Json::from_pair([x, y + 0.0625])).expect("there");
        result.set("points", Json::object([("A", up("A")), ("B", up("B"))]));
    });
    assert_eq!(faults, ["off the middle / εS"]);
}
