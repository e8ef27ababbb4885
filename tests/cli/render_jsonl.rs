//! `render --jsonl`: the lines that `solve --jsonl` answers become figures, one by one.

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::render::{names, set};
use crate::{Ran, TRACEFIG, run, run_on, tracefig};

/// A line of a log: a circle that moves by `v` to the right, towards one at (3, 0).
fn line(id: &str, v: &str) -> String {
    let id = if id.is_empty() { String::new() } else { format!("\"id\": {id}, ") };
    format!(
        r#"{{{id}"shapes": {{"A": {{"kind": "circle", "radius": 1, "velocity": [{v}, 0]}}, "B": {{"kind": "circle", "radius": 0.5, "position": [3, 0]}}}}, "query": {{"kind": "linear-sweep", "of": ["A", "B"]}}}}"#
    )
}

/// What a run over such lines printed, and the folder that it ran in.
fn drawn(lines: &str, more: &[&str]) -> (Ran, TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["render", "--jsonl", "--format", "svg"];
    let ran = run_on(tracefig(folder.path()).args(arguments).args(more), lines);
    (ran, folder)
}

#[test]
fn every_line_becomes_a_figure_named_by_its_id() {
    let lines = [line("\"a hit\"", "3"), line("17", "-3"), line("[1]", "1"), line("", "9")].join("\n");
    let (ran, folder) = drawn(&lines, &["-o", "out", "--theme", "light,dark", "--format", "svg,png"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let stems = ["a-hit", "17", "line-3", "line-4"];
    let files: Vec<String> = stems
        .iter()
        .flat_map(|stem| {
            ["light.svg", "light.png", "dark.svg", "dark.png"].map(|end| format!("{stem}.{end}"))
        })
        .collect();
    assert_eq!(ran.out.lines().map(|l| l.trim_start_matches("out/")).collect::<Vec<_>>(), files);
    assert_eq!(names(&folder.path().join("out")), files.iter().cloned().collect());
    let svg = std::fs::read_to_string(folder.path().join("out/a-hit.light.svg")).unwrap();
    assert!(svg.contains("A first touches B at t = 0.5"), "the answer's own picture");
    let svg = std::fs::read_to_string(folder.path().join("out/17.light.svg")).unwrap();
    assert!(svg.contains("do not touch"), "a miss is one too");
}

#[test]
fn a_bad_line_and_a_second_one_of_an_id_are_told_with_their_numbers_and_cost_only_themselves() {
    let lines = [
        line("1", "3"),
        "{".to_owned(),
        line("\"A\"", "3").replace("0.5", "-0.5"),
        line("\"x/y\"", "3"),
        line("\"x/y\"", "-3"),
        line("\"good\"", "3"),
        line("\"good\"", "3").replace("0.5", "-1"),
    ];
    let (ran, folder) = drawn(&lines.join("\n"), &[]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), "1.svg\nx-y.svg\ngood.svg\n"));
    assert_eq!(names(folder.path()), set(&["1.svg", "x-y.svg", "good.svg"]));
    for told in [
        "error[syntax]: not JSON",
        " --> <stdin>:2:",
        "error[negative-radius]: `radius`: expected 0 or more, got -0.5\n --> <stdin>:3:",
        "error: <stdin>:5 has the id of <stdin>:4, x/y: it is not drawn\n",
        "has the id of <stdin>:6, good: it is not drawn\n\nerror[negative-radius]: `radius`: expected 0 or more, got -1\n",
    ] {
        assert!(ran.err.contains(told), "{told}\n{}", ran.err);
    }
    let svg = std::fs::read_to_string(folder.path().join("x-y.svg")).unwrap();
    assert!(svg.contains("A first touches B"), "the first one is still there");
    let (ran, folder) = drawn("\u{0}\n", &[]);
    assert_eq!((ran.code, names(folder.path()).len()), (Some(1), 0));
}

#[test]
fn each_id_has_its_own_figure_whatever_its_name_becomes() {
    let long = "n".repeat(200);
    let ids = ["x/y", "x:y", "X/Y", "1", "-1", &format!("{long}a"), &format!("{long}b")];
    let lines: Vec<String> = ids.iter().map(|id| line(&format!("\"{id}\""), "3")).collect();
    let (ran, folder) = drawn(&lines.join("\n"), &[]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let written: Vec<&str> = ran.out.lines().collect();
    let small: BTreeSet<String> = written.iter().map(|name| name.to_lowercase()).collect();
    assert_eq!((written.len(), small.len()), (ids.len(), ids.len()), "{written:?}");
    assert_eq!(names(folder.path()).len(), ids.len());
    for (id, name) in ids.iter().zip(&written) {
        let begin = id.trim_start_matches('-').replace(['/', ':'], "-");
        assert!(name.starts_with(&begin[..begin.len().min(140)]), "{id}: {name}");
    }
    // What is written does not depend on what came before, but for who has the plain name.
    let (alone, _) = drawn(&line(&format!("\"{long}b\""), "3"), &[]);
    assert_eq!(alone.out.trim(), written[6]);
}

#[test]
fn names_order_and_bytes_do_not_depend_on_the_number_of_threads() {
    let lines: Vec<String> = (0..12).map(|i| line(&i.to_string(), &format!("{}.5", i % 7))).collect();
    let lines = lines.join("\n");
    let (one, first) = drawn(&lines, &["--threads", "1"]);
    let (many, second) = drawn(&lines, &["--threads", "3"]);
    let expected = (0..12).map(|i| format!("{i}.svg")).collect::<Vec<_>>().join("\n") + "\n";
    assert_eq!((one.out.as_str(), many.out.as_str()), (expected.as_str(), expected.as_str()));
    for name in expected.lines() {
        let read = |folder: &TempDir| std::fs::read(folder.path().join(name)).unwrap();
        assert!(read(&first) == read(&second), "{name}");
    }
}

#[test]
fn a_figure_is_there_before_the_next_line_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = Command::new(TRACEFIG)
        .current_dir(folder.path())
        .args(["render", "--jsonl", "--format", "svg"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut input, output) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
    let mut files = BufReader::new(output).lines();
    for id in ["1", "2"] {
        writeln!(input, "{}", line(id, "3")).unwrap();
        let file = files.next().unwrap().unwrap();
        assert_eq!(file, format!("{id}.svg"));
        assert!(folder.path().join(file).exists());
    }
    drop(input);
    assert!(child.wait().unwrap().success());
}

#[test]
fn scenes_and_standard_output_are_no_places_for_a_stream() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [&["s.toml"][..], &["-o", "-"], &["--partition", "1/2"]] {
        let ran = run(tracefig(folder.path()).args(["render", "--jsonl"]).args(arguments));
        assert_eq!(ran.code, Some(2), "{arguments:?}: {}", ran.err);
    }
}
