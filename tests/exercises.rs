//! Keys of variants against exact arithmetic: each is the one number of three digits at most that the answer
//! in 320 bits allows.
//!
//! `TRACEFIG_CASES_EXERCISES` raises the number: `TRACEFIG_CASES_EXERCISES=1000 cargo test --release --test
//! exercises`.

#![expect(clippy::expect_used, clippy::panic, reason = "tests fail by panics")]

use std::path::Path;

use tracefig::figure::exercise::{Asked, Found, asked, search};
use tracefig::figure::plan;
use tracefig::scene::{open, open_text};
use tracefig_reference::check::check;
use tracefig_reference::json::Json;
use tracefig_reference::scene::Scene;

/// Scenes of bodies that turn: few of their variants have a root and an arc of three digits.
const TURNING: usize = 2;

/// How far a told double may be off the result's, in parts of it or of 1.
const TOLD: f64 = 1e-14;

/// Exercises whose variants turn by round angles, at the start or on the way.
const ANGLED: [&str; 3] = [
    "exercise.ask = ['h.x', 'h.y']
    shapes.A = { kind = 'box', half_extents = [2, 1], angle_deg = 30, angular_velocity_deg = 60 }
    query = { kind = 'bounds', of = ['A'], time = 0.5 }",
    "exercise.ask = ['separation', 'n.x']
    shapes.A = { kind = 'circle', radius = 1 }
    shapes.B = { kind = 'box', half_extents = [1, 0.5], position = [4, 1], angle_deg = 45 }
    query = { kind = 'separation', of = ['A', 'B'] }",
    "exercise.ask = 'time'
    shapes.A = { kind = 'circle', radius = 1, velocity = [8, 0], angular_velocity_deg = 90 }
    shapes.B = { kind = 'box', half_extents = [1, 2], position = [5, 0], angle_deg = 90 }
    query = { kind = 'time-of-impact', of = ['A', 'B'] }",
];

/// Exercises about a contact: a body that is tilted on a floor, and one on its vertex.
const CONTACTS: [&str; 2] = [
    "exercise.ask = ['contacts', 'depth', 'shallow', 'contact.a.x', 'contact.b.x', 'contact.b.y']
    shapes.A = { kind = 'aabb', half_extents = [5, 1] }
    shapes.B = { kind = 'polygon', vertices = [[-2, 0.5], [2, 0.75], [2, 3], [-2, 3]] }
    query = { kind = 'contact', of = ['A', 'B'] }",
    "exercise.ask = ['contacts', 'contact.a.x', 'contact.a.y', 'n.y']
    shapes.A = { kind = 'aabb', half_extents = [5, 1] }
    shapes.B = { kind = 'polygon', vertices = [[0, 0.5], [2, 2], [-2, 2]] }
    query = { kind = 'contact', of = ['A', 'B'] }",
];

/// The number of a value of a contact and its bounds in a result whose contacts are checked; `None` of other
/// values.
fn of_the_contact(name: &str, result: &Json) -> Option<[f64; 3]> {
    let all = result.get("contacts")?.list();
    let number = |json: &Json| json.number().expect("a number");
    let gap = |contact: &&Json| number(contact.get("separation").expect("its separation"));
    let by_gap = |p: &&Json, q: &&Json| gap(p).total_cmp(&gap(q));
    let (deepest, shallowest) = (all.iter().min_by(by_gap)?, all.iter().max_by(by_gap)?);
    let place = |side: &str, i: usize| {
        let points = deepest.get("points").expect("its points");
        [number(&points.get(side).expect("a point").list()[i]); 3]
    };
    Some(match name {
        "contacts" => [f64::from(u32::try_from(all.len()).expect("two at most")); 3],
        "shallow" => {
            let bounds = shallowest.get("separation_bounds").expect("its bounds").list();
            [-gap(&shallowest), -number(&bounds[1]), -number(&bounds[0])]
        }
        "contact.a.x" => place("A", 0),
        "contact.a.y" => place("A", 1),
        "contact.b.x" => place("B", 0),
        "contact.b.y" => place("B", 1),
        _ => return None,
    })
}

/// The part of a result that a value is, as `solve` prints it: its key, which of its numbers, its sign.
fn part(name: &str) -> (&'static str, Option<usize>, f64) {
    match name {
        "separation" => ("separation", None, 1.0),
        "depth" => ("separation", None, -1.0),
        "time" => ("time", None, 1.0),
        "n.x" | "hit.n.x" => ("normal", Some(0), 1.0),
        "n.y" | "hit.n.y" => ("normal", Some(1), 1.0),
        "h.x" => ("half_extents", Some(0), 1.0),
        "h.y" => ("half_extents", Some(1), 1.0),
        "bound" => ("bound", None, 1.0),
        other => panic!("the test does not know the value {other}"),
    }
}

/// Whether the key of a value is what the checked result says.
fn agrees(asked: &Asked, result: &Json) -> bool {
    let number = |key: &str, index: Option<usize>| {
        let value = result.get(key).expect("a part of the result");
        index.map_or(value, |i| &value.list()[i]).number().expect("a number")
    };
    let value = asked.value();
    let digits = format!("{value}").bytes().filter(u8::is_ascii_digit).collect::<Vec<_>>();
    let leading = digits.iter().take_while(|&&digit| digit == b'0').count();
    if digits.len() - leading > 3 {
        return false;
    }
    if let Some([told, lo, hi]) = of_the_contact(asked.name, result) {
        let bounds = !asked.is_proved || [lo, hi] == [asked.lo, asked.hi];
        return bounds && (told - value).abs() <= TOLD * value.abs().max(1.0);
    }
    let (key, index, sign) = part(asked.name);
    if asked.is_proved {
        let bounds = format!("{key}_bounds");
        let mut ends = [0, 1].map(|i| sign * number(&bounds, Some(i)));
        ends.sort_by(f64::total_cmp);
        return ends == [asked.lo, asked.hi] && ends[0] <= value && value <= ends[1];
    }
    (sign * number(key, index) - value).abs() <= TOLD * value.abs().max(1.0)
}

#[test]
fn every_key_is_right_in_320_bits() {
    let count =
        std::env::var("TRACEFIG_CASES_EXERCISES").ok().and_then(|text| text.parse().ok()).unwrap_or(40);
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("guide/exercises");
    let mut scenes: Vec<_> = guide.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    scenes.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    scenes.sort();
    assert!(scenes.len() >= 3, "{}", scenes.len());
    let (mut checked, mut short, mut wrong) = (0, 0, Vec::new());
    let of_guide = scenes.iter().map(|path| (path.display().to_string(), open(path).unwrap()));
    let angled = ANGLED
        .iter()
        .chain(&CONTACTS)
        .map(|text| ((*text).to_owned(), open_text("angled.toml", text).unwrap()));
    let all: Vec<_> = of_guide.chain(angled).collect();
    for (name, file) in &all {
        let template = file.template();
        let each = usize::div_ceil(count, all.len() - TURNING);
        let found = search(&template, each).or_else(|few| {
            short += 1;
            search(&template, few.found)
        });
        let found = found.unwrap_or_else(|few| panic!("{name}: {few:?}"));
        for Found { file, .. } in found {
            let line = file.json();
            let answer = tracefig::solve_jsonl_line(&line, 1).line;
            let (scene, answer) = (Scene::parse(&line).unwrap(), Json::parse(&answer).unwrap());
            let report = check(&scene, &answer);
            let result = answer.get("result").expect("an answer");
            let plan = plan(&file.scene).unwrap();
            let keys = asked(&plan);
            let is_right = report.faults.is_empty() && keys.iter().all(|key| agrees(key, result));
            checked += 1;
            if !is_right || keys.is_empty() {
                wrong.push(format!("{line}\n{keys:?}\n{:?}", report.faults));
            }
        }
    }
    println!("{checked} keys, {} wrong", wrong.len());
    assert!(short <= TURNING, "{short} scenes have few variants");
    assert!(checked >= count && wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
}
