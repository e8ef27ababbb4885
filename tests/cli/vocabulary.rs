//! `list answers` and `list events` name what `solve` and `trace` write: no less, and no more.

#![expect(clippy::panic, reason = "a test may panic wherever it is")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde_json::{Map, Value};
use tracefig::collision::{ALGORITHMS, AnswerField, Bodies, QUERIES};
use tracefig::scene::{LINE_FIELDS, Scene, Solution, answer_fields, open_text, solve_jsonl_line};
use tracefig::trace::{EVENTS, HEADER, Trace, json_lines};

use crate::{run, tracefig};

const HARD: &str = include_str!("../data/hard.jsonl");

/// Questions about two boxes that meet on their way: with someone else's answer, with too few steps for an
/// answer, with an axis that separates.
const QUESTIONS: [&str; 4] = [
    "kind = 'separation'\nexpected = { separation = 1, normal = [1, 0], points = { A = [1, 0], B = [2, 0] } }",
    "kind = 'linear-sweep'\nexpected = { outcome = 'hit', time = 0.5 }",
    "kind = 'time-of-impact'\nalgorithm = 'conservative-advancement'\nmax_iterations = 1",
    "kind = 'overlap'",
];

/// The committed figures, the examples of each question, the hard cases, and some questions more.
fn scenes() -> Vec<Scene> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts = Vec::new();
    for folder in ["figures", "guide/src/reference/queries"] {
        for file in std::fs::read_dir(root.join(folder)).unwrap().map(|file| file.unwrap().path()) {
            let is_scene = file.extension().is_some_and(|e| e == "toml") && !file.ends_with("tracefig.toml");
            texts.extend(is_scene.then(|| ("s.toml", std::fs::read_to_string(&file).unwrap())));
        }
    }
    for line in HARD.lines() {
        let mut case: Value = serde_json::from_str(line).unwrap();
        case.as_object_mut().unwrap().remove("expected");
        texts.push(("s.json", case.to_string()));
    }
    for question in QUESTIONS {
        let bodies = "[shapes.A]\nkind = 'box'\nhalf_extents = [1, 1]\nvelocity = [2, 0.5]\n\
                      [shapes.B]\nkind = 'box'\nhalf_extents = [1, 1]\nposition = [3, 0]\nangle_deg = 10\n";
        texts.push(("s.toml", format!("{bodies}[query]\nof = ['A', 'B']\n{question}\n")));
    }
    let scene = |(name, text): &(&str, String)| match open_text(name, text) {
        Ok(file) => file.scene,
        Err(refused) => panic!("{}\n{text}", refused.render(tracefig::scene::Ink::Plain)),
    };
    texts.iter().map(scene).collect()
}

/// What objects have that a table lacks, or lack though every one has it; optional keys that are there, with
/// their path, go to `seen`.
fn faults(
    at: &str,
    table: &[AnswerField],
    objects: &[&Map<String, Value>],
    seen: &mut BTreeSet<String>,
) -> Vec<String> {
    let unlisted = objects.iter().flat_map(|object| object.keys());
    let unlisted = unlisted.filter(|key| table.iter().all(|field| field.name != **key));
    let mut faults: Vec<String> = unlisted.map(|key| format!("{at}{key} is not listed")).collect();
    for field in table {
        let path = format!("{at}{}", field.name);
        let held: Vec<&Value> = objects.iter().filter_map(|object| object.get(field.name)).collect();
        if field.when.is_empty() && held.len() < objects.len() {
            faults.push(format!("{path} is not in every answer"));
        }
        if !held.is_empty() {
            seen.insert(path.split_once(": ").map_or(path.clone(), |(_, path)| path.to_owned()));
        }
        let inner: Vec<&Value> = held
            .into_iter()
            .flat_map(|value| value.as_array().map_or(vec![value], |list| list.iter().collect()))
            .collect();
        if !field.inner.is_empty() {
            let inner: Vec<_> = inner.iter().filter_map(|value| value.as_object()).collect();
            faults.extend(self::faults(&format!("{path}."), field.inner, &inner, seen));
        }
    }
    faults
}

/// The paths of a table's keys.
fn paths(at: &str, table: &[AnswerField]) -> Vec<String> {
    let path = |field: &AnswerField| {
        let path = format!("{at}{}", field.name);
        let inner = paths(&format!("{path}."), field.inner);
        std::iter::once(path).chain(inner).collect::<Vec<_>>()
    };
    table.iter().flat_map(path).collect()
}

/// What `tracefig list` prints of a topic: the words at the beginnings of its lines.
fn listed(topic: &str) -> BTreeSet<String> {
    let ran = run(tracefig(Path::new(".")).args(["list", topic]));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    ran.out.lines().map(|line| line.trim().split("  ").next().unwrap().to_owned()).collect()
}

#[test]
fn every_key_of_an_answer_is_listed_and_every_listed_key_is_in_an_answer() {
    let mut answers: BTreeMap<&str, (&[AnswerField], Vec<Value>)> = BTreeMap::new();
    for scene in scenes() {
        let solution = Solution::of(&scene);
        let of_kind =
            answers.entry(solution.kind.word()).or_insert((answer_fields(solution.kind), Vec::new()));
        of_kind.1.push(solution.json());
    }
    assert_eq!(answers.len(), QUERIES.len(), "every kind of question is asked");
    let (mut seen, mut wrong) = (BTreeSet::new(), Vec::new());
    let printed = listed("answers");
    for (kind, (table, answers)) in &answers {
        let objects: Vec<_> = answers.iter().map(|answer| answer.as_object().unwrap()).collect();
        wrong.extend(faults(&format!("{kind}: "), table, &objects, &mut seen));
    }
    for question in QUERIES {
        let has_off = answer_fields(question.kind).iter().any(|field| field.name == "off");
        assert_eq!(has_off, question.bodies == Bodies::Two, "who else answers a {}", question.word);
    }
    let listed: BTreeSet<String> = answers.values().flat_map(|(table, _)| paths("", table)).collect();
    for path in &listed {
        wrong.extend((!seen.contains(path)).then(|| format!("{path} is in no answer")));
        wrong.extend((!printed.contains(path)).then(|| format!("{path} is not printed")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_key_of_a_line_of_answers_is_listed() {
    let folder = tempfile::tempdir().unwrap();
    let line = r#"{"id": 1, "shapes": {"A": {"kind": "circle", "radius": 1}}, "query": {"kind": "bounds", "of": ["A"]}}"#;
    std::fs::write(folder.path().join("s.json"), line).unwrap();
    let of_a_scene = run(tracefig(folder.path()).args(["solve", "--json", "s.json"])).out;
    let lines = [solve_jsonl_line(line, 1).line, solve_jsonl_line("{}", 1).line, of_a_scene];
    let lines: Vec<Value> = lines.iter().map(|line| serde_json::from_str(line).unwrap()).collect();
    let objects: Vec<_> = lines.iter().map(|line| line.as_object().unwrap()).collect();
    let mut seen = BTreeSet::new();
    assert_eq!(faults("", &LINE_FIELDS, &objects, &mut seen), [""; 0]);
    let all: BTreeSet<String> = paths("", &LINE_FIELDS).into_iter().collect();
    assert_eq!(seen, all);
    assert!(all.is_subset(&listed("answers")));
}

#[test]
fn every_event_and_its_keys_are_listed_and_every_listed_event_is_told() {
    let mut told: BTreeMap<String, BTreeSet<Vec<String>>> = BTreeMap::new();
    for scene in scenes() {
        let query = scene.query_of_bodies();
        for algorithm in ALGORITHMS.iter().filter(|a| a.kinds.contains(&query.kind) && a.takes(&query)) {
            let mut trace = Trace::default();
            (algorithm.traced)(&query, &mut trace);
            trace.events.extend(Solution::of(&scene).off.map(|off| off.event()));
            let lines = json_lines(&trace).unwrap();
            let mut lines =
                lines.lines().map(|line| serde_json::from_str::<Map<String, Value>>(line).unwrap());
            let header: BTreeSet<String> = lines.next().unwrap().keys().cloned().collect();
            assert_eq!(header, HEADER.iter().map(|(key, _)| (*key).to_owned()).collect());
            for line in lines {
                let keys = line.keys().filter(|key| *key != "event").cloned().collect();
                told.entry(line["event"].as_str().unwrap().to_owned()).or_default().insert(keys);
            }
        }
    }
    let fields =
        |kind: &tracefig::trace::EventKind| kind.fields.iter().map(|f| f.name.to_owned()).collect::<Vec<_>>();
    let listed_events: BTreeMap<String, BTreeSet<Vec<String>>> =
        EVENTS.iter().map(|kind| (kind.name(), BTreeSet::from([fields(kind)]))).collect();
    assert_eq!(told, listed_events);
    let printed = listed("events");
    let words = EVENTS.iter().flat_map(|kind| fields(kind).into_iter().chain([kind.name()]));
    let missing: Vec<_> = words.filter(|word| !printed.contains(word)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
