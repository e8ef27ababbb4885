//! `solve --jsonl`, field by field.

use std::process::Stdio;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::{TRACEFIG, run, run_on, tracefig};

/// The lines that a stream is answered with, and the exit status.
fn answers(lines: &str) -> (Vec<Value>, Option<i32>) {
    let ran = run_on(tracefig(".".as_ref()).args(["solve", "--jsonl"]), lines);
    assert_eq!(ran.err, "");
    (ran.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect(), ran.code)
}

#[track_caller]
fn result_of(scene: &str) -> Value {
    let (answers, code) = answers(scene);
    assert_eq!((answers.len(), code), (1, Some(0)), "{answers:?}");
    answers[0]["result"].clone()
}

#[track_caller]
fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

fn pair(query: &str, b: &str) -> String {
    format!(
        r#"{{"id": "x", "shapes": {{"A": {{"kind": "box", "half_extents": [1, 1]}}, "B": {{"kind": "circle", "radius": 0.5, {b}}}}}, "query": {{"kind": "{query}", "of": ["A", "B"]}}}}"#
    )
}

#[test]
fn a_separation_has_its_fields_in_order() {
    let got = result_of(&pair("separation", r#""position": [3, 0.25]"#));
    assert_eq!(
        keys(&got),
        ["kind", "separation", "separation_bounds", "normal", "ties", "points", "features"]
    );
    assert_eq!(got["kind"], "separation");
    assert_eq!(got["separation"], 1.5);
    let bounds: Vec<f64> = serde_json::from_value(got["separation_bounds"].clone()).unwrap();
    assert!(bounds[0] <= 1.5 && 1.5 <= bounds[1] && bounds[1] - bounds[0] < 1e-9, "{bounds:?}");
    assert_eq!(got["normal"], json!([1.0, 0.0]));
    assert_eq!(got["ties"], 1);
    assert_eq!(got["points"], json!({"A": [1.0, 0.25], "B": [2.5, 0.25]}));
    assert_eq!(got["features"], json!({"A": {"edge": 1}, "B": {"vertex": 0}}));
}

#[test]
fn a_hit_a_miss_and_an_overlap_have_their_fields() {
    let hit = result_of(&pair("linear-sweep", r#""position": [3, 0.25], "velocity": [-3, 0]"#));
    assert_eq!(
        keys(&hit),
        [
            "kind",
            "outcome",
            "time",
            "time_bounds",
            "separation",
            "separation_bounds",
            "tolerance",
            "normal",
            "points",
            "features",
            "iterations"
        ]
    );
    assert_eq!((&hit["kind"], &hit["outcome"]), (&json!("linear-sweep"), &json!("hit")));
    assert_eq!(hit["time"], hit["time_bounds"][0]);
    assert!((hit["time"].as_f64().unwrap() - 0.5).abs() < 1e-9, "{hit}");
    assert_eq!(hit["tolerance"], 0.0);

    let miss = result_of(&pair("time-of-impact", r#""position": [3, 0.25], "velocity": [3, 0]"#));
    assert_eq!(keys(&miss), ["kind", "outcome", "tolerance", "iterations", "closest"]);
    assert_eq!((&miss["kind"], &miss["outcome"]), (&json!("time-of-impact"), &json!("miss")));
    assert_eq!(keys(&miss["closest"]), ["time", "separation", "separation_bounds"]);

    let inside = result_of(&pair("time-of-impact", r#""position": [1, 0.25], "velocity": [3, 0]"#));
    assert_eq!(
        keys(&inside),
        ["kind", "outcome", "separation", "separation_bounds", "tolerance", "iterations"]
    );
    assert_eq!(inside["outcome"], "overlapping");
    assert!((inside["separation"].as_f64().unwrap() + 0.5).abs() < 1e-9, "{inside}");
}

#[test]
fn a_line_that_is_no_json_farther_on_keeps_the_id_that_it_begins_with() {
    for (text, id) in [
        (r#"{"id": 17, "shapes": {"A": {"kind": "circle", "radius": NaN}}}"#, "17"),
        (r#" { "id" :"a/b\"c", "velocity": [inf, 0]}"#, r#""a/b\"c""#),
        (r#"{"id": [1, 2], "time": -Infinity}"#, "[1, 2]"),
        (r#"{"id": NaN}"#, "null"),
        (r#"{"time": NaN, "id": 3}"#, "null"),
    ] {
        let ran = run_on(tracefig(".".as_ref()).args(["solve", "--jsonl"]), text);
        let begins = format!(r#"{{"id":{id},"line":1,"error":{{"code":"syntax""#);
        assert!(ran.out.starts_with(&begins), "{text}: {}", ran.out);
    }
}

#[test]
fn what_someone_else_answered_is_told_by_how_far_it_is_off() {
    let asked = |query: &str, b: &str, expected: &str| {
        let scene = pair(query, b).replace(r#""of": "#, &format!(r#""expected": {expected}, "of": "#));
        result_of(&scene)["off"].clone()
    };
    let apart = r#""position": [3, 0.25]"#;
    let all =
        r#"{"separation": 1.75, "time": 0, "normal": [0, 2], "points": {"A": [1, 0.25], "B": [2.5, 0.5]}}"#;
    let off = asked("separation", apart, all);
    assert_eq!(
        keys(&off),
        ["size", "separation", "separation_in_eps", "time", "normal_deg", "points", "points_in_eps"]
    );
    let near = |value: &Value, expected: f64| (value.as_f64().unwrap() / expected - 1.0).abs() < 1e-14;
    assert_eq!(off["size"], json!(1.5));
    assert!(near(&off["separation"], 0.25), "{off}");
    assert!(near(&off["separation_in_eps"], 0.25 / (1.5 * f64::EPSILON)), "{off}");
    // A separation has no time of its own.
    assert_eq!((&off["time"], &off["normal_deg"]), (&Value::Null, &json!(90.0)));
    assert_eq!(off["points"], json!({"A": 0.0, "B": 0.25}));
    let closing = r#""position": [3, 0.25], "velocity": [-3, 0]"#;
    assert_eq!(asked("linear-sweep", closing, r#"{"time": 0.5}"#)["time"], json!(0.0));
    assert!(near(&asked("linear-sweep", closing, r#"{"time": 0.25}"#)["time"], -0.25));
    let parting = r#""position": [3, 0.25], "velocity": [3, 0]"#;
    assert!(near(&asked("linear-sweep", parting, r#"{"separation": 1}"#)["separation"], -0.5));
    assert_eq!(asked("linear-sweep", parting, r#"{"separation": 1.5}"#)["separation"], json!(0.0));
}

#[test]
fn an_unresolved_impact_says_why_and_until_when_it_is_free() {
    let scene =
        pair("time-of-impact", r#""position": [3, 0.25], "velocity": [-3, 0], "angular_velocity_deg": 10"#)
            .replace("\"of\"", "\"algorithm\": \"conservative-advancement\", \"max_iterations\": 1, \"of\"");
    let got = result_of(&scene);
    assert_eq!(keys(&got), ["kind", "outcome", "reason", "time_bounds", "tolerance", "iterations"]);
    assert_eq!((&got["outcome"], &got["reason"]), (&json!("unresolved"), &json!("iteration-limit")));
    assert_eq!(got["time_bounds"][1], 1.0);
}

#[test]
fn overlap_bounds_and_motion_bound_have_their_fields() {
    let apart = result_of(&pair("overlap", r#""position": [3, 0.25]"#));
    assert_eq!(keys(&apart), ["kind", "overlap", "separation_bounds"]);
    assert_eq!(apart["overlap"], false);
    let touching = result_of(&pair("overlap", r#""position": [1.5, 0]"#));
    assert_eq!(touching["overlap"], true);

    let one = |query: &str| pair(query, r#""position": [3, 0.25]"#).replace(r#"["A", "B"]"#, r#"["A"]"#);
    let bounds = result_of(&one("bounds"));
    assert_eq!(
        bounds,
        json!({"kind": "bounds", "min": [-1.0, -1.0], "max": [1.0, 1.0], "center": [0.0, 0.0], "half_extents": [1.0, 1.0]})
    );
    let still = result_of(&one("motion-bound"));
    assert_eq!(keys(&still), ["kind", "bound"]);
    assert_eq!(still["bound"], 0.0);
}

#[test]
fn the_id_is_copied_whatever_it_is() {
    for id in [r#""a""#, "7", "1e400", "[1, {\"x\": null}]", "true", "\"\\u00e9 \\n\""] {
        let scene = pair("overlap", r#""position": [3, 0]"#).replace(r#""x""#, id);
        let ran = run_on(tracefig(".".as_ref()).args(["solve", "--jsonl"]), scene);
        assert!(ran.out.starts_with(&format!("{{\"id\":{id},\"result\":")), "{id}: {}", ran.out);
    }
    let without = pair("overlap", r#""position": [3, 0]"#).replace(r#""id": "x", "#, "");
    assert_eq!(answers(&without).0[0]["id"], Value::Null);
}

#[test]
fn bad_lines_get_an_error_line_and_the_run_goes_on() {
    let good = pair("overlap", r#""position": [3, 0]"#);
    let bad = good.replace("0.5", "-0.5").replace(r#""x""#, r#"{"k": 1}"#);
    let (got, code) = answers(&format!("{good}\nnot json\n{bad}\r\n\n[1]\n{good}"));
    assert_eq!(code, Some(1));
    assert_eq!(got.len(), 6);
    assert_eq!((&got[0]["id"], &got[5]["id"]), (&json!("x"), &json!("x")));
    assert_eq!(keys(&got[1]), ["id", "line", "error"]);
    assert_eq!(
        (&got[1]["id"], &got[1]["line"], &got[1]["error"]["code"]),
        (&Value::Null, &json!(2), &json!("syntax"))
    );
    assert_eq!((&got[2]["id"], &got[2]["line"]), (&json!({"k": 1}), &json!(3)));
    assert_eq!(
        got[2]["error"],
        json!({"code": "negative-radius", "message": "/shapes/B/radius: `radius`: expected 0 or more, got -0.5"})
    );
    assert_eq!((&got[3]["line"], &got[3]["error"]["code"]), (&json!(4), &json!("empty-file")));
    assert_eq!((&got[4]["line"], &got[4]["error"]["code"]), (&json!(5), &json!("wrong-type")));
}

#[test]
fn what_a_misspelt_key_lacks_is_told_with_the_key() {
    let line =
        r#"{"shapes": {"A": {"kind": "circle", "raduis": 1}}, "query": {"kind": "bounds", "of": ["A"]}}"#;
    let (answers, _) = answers(line);
    let error = &answers[0]["error"];
    assert_eq!(error["code"], "missing-key");
    let expected = "/shapes/A: a circle lacks `radius`: expected a number; unknown key `raduis` in a circle, \
                    did you mean `radius`?";
    assert_eq!(error["message"], expected);
}

#[test]
fn an_answer_comes_before_the_next_line_is_written() {
    use std::io::{BufRead, BufReader, Write};
    use std::process::{Command, Stdio};
    let mut child = Command::new(TRACEFIG)
        .args(["solve", "--jsonl"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut input, output) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
    let mut lines = BufReader::new(output).lines();
    for _ in 0..3 {
        writeln!(input, "{}", pair("overlap", r#""position": [3, 0]"#)).unwrap();
        assert!(lines.next().unwrap().unwrap().contains("\"overlap\":false"));
    }
    drop(input);
    assert!(child.wait().unwrap().success());
}

#[test]
fn an_answer_does_not_wait_for_the_rest_of_the_next_line() {
    use std::io::{BufRead, BufReader, Write};
    let mut child = tracefig(".".as_ref())
        .args(["solve", "--jsonl"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut input, output) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
    let (sender, answers) = mpsc::channel();
    thread::spawn(move || BufReader::new(output).lines().try_for_each(|line| sender.send(line.unwrap())));
    let line = pair("overlap", r#""position": [3, 0]"#);
    let (begin, end) = line.split_at(20);
    write!(input, "{line}\n{begin}").unwrap();
    let first = answers.recv_timeout(Duration::from_mins(1));
    assert!(first.is_ok_and(|answer| answer.contains("\"overlap\":false")), "the answer was held back");
    writeln!(input, "{end}").unwrap();
    drop(input);
    assert!(answers.recv().unwrap().contains("\"overlap\":false"));
    assert!(child.wait().unwrap().success());
}

#[test]
fn a_line_that_is_too_long_is_told_with_its_length_and_the_run_goes_on() {
    let long = format!("{{\"title\": \"{}\"}}", "é".repeat(2_500_000));
    let (got, code) = answers(&format!("{long}\n{}", pair("overlap", r#""position": [3, 0]"#)));
    assert_eq!((got.len(), code), (2, Some(1)));
    let message = "the line: expected at most 4194304 bytes, got 5000013";
    assert_eq!(got[0]["error"], json!({"code": "over-limit", "message": message}));
    assert_eq!(got[1]["result"]["overlap"], false);
}

#[test]
fn a_byte_order_mark_may_stand_before_the_first_line() {
    let line = pair("overlap", r#""position": [3, 0]"#);
    let (got, code) = answers(&format!("\u{feff}{line}\n\u{feff}{line}\n"));
    assert_eq!((&got[0]["result"]["overlap"], code), (&json!(false), Some(1)));
    assert_eq!(got[1]["error"]["code"], "syntax");
}

#[test]
fn an_id_does_not_break_the_line_of_its_answer() {
    let scene = pair("overlap", r#""position": [3, 0]"#).replace(r#""x""#, "[1,\r\r{\"a\":\r2}]");
    let ran = run_on(tracefig(".".as_ref()).args(["solve", "--jsonl"]), scene);
    assert!(ran.out.starts_with("{\"id\":[1,  {\"a\": 2}],\"result\""), "{:?}", ran.out);
    assert_eq!(ran.out.matches(['\r', '\n']).count(), 1);
}

#[test]
fn every_error_code_that_is_printed_is_listed() {
    let ran = run(tracefig(".".as_ref()).args(["list", "errors"]));
    let listed: Vec<_> = ran.out.lines().filter_map(|l| l.split_whitespace().next()).collect();
    for code in ["syntax", "not-convex", "negative-radius", "unknown-key", "turning-body", "too-large"] {
        assert!(listed.contains(&code), "{code} in {listed:?}");
    }
}

/// A stream of boxes, circles, and every 7th line refused.
fn mixed(count: usize) -> String {
    let line = |k: usize| match k % 7 {
        3 => "no json".to_owned(),
        _ => pair(
            ["separation", "overlap", "linear-sweep", "time-of-impact"][k % 4],
            &format!(r#""position": [{}, 0.25], "velocity": [-{}, 0]"#, k % 9, k % 5),
        ),
    };
    (0..count).map(|k| line(k) + "\n").collect()
}

#[test]
fn any_number_of_threads_gives_the_same_bytes_and_the_same_summary() {
    let lines = mixed(700);
    let folder = tempfile::tempdir().unwrap();
    let mut seen = Vec::new();
    for threads in ["1", "2", "3", "8"] {
        let mut command = tracefig(folder.path());
        command.args(["solve", "--jsonl", "--errors=lines", "--summary", "s.json", "--threads", threads]);
        let ran = run_on(&mut command, &lines);
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
        seen.push((ran.out, std::fs::read_to_string(folder.path().join("s.json")).unwrap()));
    }
    assert!(seen.iter().all(|one| *one == seen[0]));
    assert_eq!(seen[0].0.lines().count(), 700);
}

#[test]
fn a_refused_line_costs_the_exit_status_unless_errors_are_lines() {
    for (option, code) in [("--errors=status", 1), ("--errors=lines", 0)] {
        for threads in ["1", "2"] {
            let mut command = tracefig(".".as_ref());
            let ran = run_on(command.args(["solve", "--jsonl", option, "--threads", threads]), mixed(10));
            assert_eq!((ran.code, ran.out.lines().count()), (Some(code), 10), "{option}");
            assert!(ran.out.lines().nth(3).unwrap().starts_with(r#"{"id":null,"line":4,"error":{"code":"#));
        }
    }
}

#[test]
fn shares_are_dealt_out_with_the_numbers_of_their_lines_and_their_summaries_add_up() {
    let lines = mixed(50);
    let folder = tempfile::tempdir().unwrap();
    let solve = |partition: &str, threads: &str| {
        let mut command = tracefig(folder.path());
        command.args(["solve", "--jsonl", "--summary", "s.json"]);
        let ran = run_on(command.args(["--partition", partition, "--threads", threads]), &lines);
        let summary = std::fs::read_to_string(folder.path().join("s.json")).unwrap();
        (ran.out, serde_json::from_str::<Value>(&summary).unwrap())
    };
    let (whole, all) = solve("1/1", "1");
    let shares: Vec<_> = (1..=4).map(|k| solve(&format!("{k}/4"), "2")).collect();
    for (k, line) in whole.lines().enumerate() {
        assert_eq!(shares[k % 4].0.lines().nth(k / 4), Some(line));
    }
    let sum = |key: &str| shares.iter().map(|(_, share)| share[key].as_u64().unwrap()).sum::<u64>();
    for key in ["lines", "answered", "refused"] {
        assert_eq!(sum(key), all[key].as_u64().unwrap(), "{key}");
    }
    assert_eq!(sum("checksum") % (1 << 40), all["checksum"].as_u64().unwrap());
    assert_eq!((&all["lines"], &all["errors"]), (&json!(50), &json!({ "syntax": 7 })));
    let kinds: Vec<&str> = keys(&all["answers"]);
    assert!(kinds.contains(&"separation") && kinds.contains(&"linear-sweep hit"), "{kinds:?}");
}

#[test]
fn with_threads_an_answer_comes_before_the_next_line_too() {
    let mut child = tracefig(".".as_ref())
        .args(["solve", "--jsonl", "--threads", "3"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut stdin, stdout) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
    let (tell, told) = mpsc::channel();
    thread::spawn(move || {
        for line in std::io::BufRead::lines(std::io::BufReader::new(stdout)) {
            tell.send(line.unwrap()).unwrap();
        }
    });
    for _ in 0..20 {
        std::io::Write::write_all(
            &mut stdin,
            (pair("separation", r#""position": [3, 0]"#) + "\n").as_bytes(),
        )
        .unwrap();
        assert!(told.recv_timeout(Duration::from_mins(1)).unwrap().contains("separation"));
    }
    drop(stdin);
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[test]
fn a_summary_that_cannot_be_written_is_no_wrong_input() {
    let here = tempfile::tempdir().unwrap();
    let ran = run_on(tracefig(here.path()).args(["solve", "--jsonl", "--summary", "-"]), mixed(1));
    assert_eq!((ran.code, ran.out.as_str(), here.path().join("-").exists()), (Some(2), "", false));
    let folder = tempfile::tempdir().unwrap();
    let mut command = tracefig(folder.path());
    let ran = run_on(command.args(["solve", "--jsonl", "--summary", "nowhere/s.json"]), mixed(1));
    assert_eq!((ran.code, ran.out.lines().count()), (Some(74), 1));
    assert!(ran.err.starts_with("error: can't write nowhere/s.json: "), "{}", ran.err);
}

#[test]
fn options_of_a_stream_need_a_stream_and_a_share_that_there_is() {
    for arguments in [
        &["solve", "--errors=lines"][..],
        &["solve", "--summary", "s.json"],
        &["solve", "--jsonl", "--partition", "5/4"],
        &["solve", "--jsonl", "--threads", "0"],
    ] {
        assert_eq!(run(tracefig(".".as_ref()).args(arguments)).code, Some(2), "{arguments:?}");
    }
}
