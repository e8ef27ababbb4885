//! Standard input, output and error: what goes where, in which colour, and what a closed pipe does.

use std::path::Path;
use std::process::{Command, Stdio};

use crate::render::{drawn, names};
use crate::{CIRCLES, TRACEFIG, folder_with, run, run_on, tracefig};

#[test]
fn results_go_to_standard_output_and_messages_to_standard_error() {
    let folder = folder_with("s.toml", CIRCLES);
    let ran = run(tracefig(folder.path()).args(["solve", "s.toml"]));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert!(ran.out.starts_with("s.toml: separation of A and B by "), "{}", ran.out);
    let ran = run(tracefig(folder.path()).args(["solve", "--json", "s.toml"]));
    let line: serde_json::Value = serde_json::from_str(ran.out.trim_end()).unwrap();
    assert_eq!((line["scene"].as_str(), line["result"]["separation"].as_f64()), (Some("s.toml"), Some(1.0)));
}

#[test]
fn a_dash_is_standard_input_in_either_language() {
    let folder = tempfile::tempdir().unwrap();
    let ran = run_on(tracefig(folder.path()).args(["solve", "-"]), CIRCLES);
    assert!(ran.out.starts_with("<stdin>: separation of A and B"), "{}{}", ran.out, ran.err);
    let json =
        r#" {"shapes": {"A": {"kind": "circle", "radius": 1}}, "query": {"kind": "bounds", "of": ["A"]}}"#;
    let ran = run_on(tracefig(folder.path()).args(["solve", "-"]), json);
    assert!(ran.out.starts_with("<stdin>: bounds of A"), "{}{}", ran.out, ran.err);
    let ran = run_on(tracefig(folder.path()).args(["solve", "-"]), "title = 1");
    assert!(ran.err.contains("--> <stdin>:1:9"), "{}", ran.err);
    let ran = run_on(tracefig(folder.path()).args(["solve", "-", "-"]), CIRCLES);
    assert_eq!(ran.code, Some(1));
}

#[test]
fn usage_is_2_and_help_is_0() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in
        [&["solve", "--jsonn"][..], &["sovle"], &["solve", "--jsonl", "x.toml"], &["list", "nothing"]]
    {
        let ran = run(tracefig(folder.path()).args(arguments));
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{arguments:?}");
    }
    for arguments in [&["--help"][..], &["solve", "--help"], &["--version"]] {
        assert_eq!(run(tracefig(folder.path()).args(arguments)).code, Some(0), "{arguments:?}");
    }
}

#[test]
fn without_a_terminal_nothing_is_coloured() {
    let folder = folder_with("s.toml", "title = 1");
    for (key, value) in [("NO_COLOR", "1"), ("TERM", "xterm-256color")] {
        let ran = run(tracefig(folder.path()).env(key, value).args(["solve", "s.toml"]));
        assert!(!ran.err.contains('\u{1b}'), "{}", ran.err);
    }
}

/// Runs in a pseudo-terminal, where `script` is there to make one.
#[cfg(target_os = "linux")]
fn in_a_terminal(no_color: &str) -> Option<String> {
    let folder = folder_with("s.toml", "title = 1");
    let line = format!("'{TRACEFIG}' solve s.toml");
    let output = Command::new("script")
        .args(["-qec", &line, "/dev/null"])
        .current_dir(folder.path())
        .env("TERM", "xterm")
        .env("NO_COLOR", no_color)
        .stdin(Stdio::null())
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.contains("wrong-type").then_some(text)
}

#[cfg(target_os = "linux")]
#[test]
fn on_a_terminal_colour_follows_no_color() {
    // An empty NO_COLOR is as none.
    let Some(coloured) = in_a_terminal("") else { return };
    assert!(coloured.contains("\u{1b}["), "{coloured}");
    let plain = in_a_terminal("1").unwrap();
    assert!(!plain.contains("\u{1b}["), "{plain}");
}

#[test]
fn a_closed_pipe_is_quiet() {
    for arguments in
        [&["solve", "s.toml"][..], &["list"], &["man"], &["completions", "bash"], &["trace", "s.toml"]]
    {
        let folder = folder_with("s.toml", CIRCLES);
        let mut child = Command::new(TRACEFIG)
            .args(arguments)
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let ended = child.wait_with_output().unwrap();
        assert_eq!(String::from_utf8_lossy(&ended.stderr), "", "{arguments:?}");
        assert_eq!(ended.status.code(), Some(0), "{arguments:?}");
    }
}

/// Runs with nobody at the other end of standard output; the exit status.
#[cfg(unix)]
fn unread(folder: &Path, arguments: &[&str]) -> Option<i32> {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let command = &mut tracefig(folder);
    command.args(arguments).stdout(writer).stderr(Stdio::null()).status().unwrap().code()
}

#[cfg(unix)]
#[test]
fn work_goes_on_though_nobody_reads_and_the_exit_status_tells_of_all() {
    let folder = tempfile::tempdir().unwrap();
    for i in 0..40 {
        std::fs::write(folder.path().join(format!("s{i:02}.toml")), drawn()).unwrap();
    }
    let there = || names(folder.path()).len() - 40;
    assert_eq!(unread(folder.path(), &["render", ".", "--format", "svg", "--threads", "1"]), Some(0));
    assert_eq!(there(), 40);
    std::fs::remove_file(folder.path().join("s39.svg")).unwrap();
    let check = ["check", ".", "--format", "svg", "--junit", "junit.xml", "--summary", "summary.md"];
    assert_eq!(unread(folder.path(), &check), Some(1));
    let junit = std::fs::read_to_string(folder.path().join("junit.xml")).unwrap();
    assert!(junit.contains("tests=\"40\" failures=\"1\""), "{junit}");
    assert!(folder.path().join("summary.md").exists());
    std::fs::write(folder.path().join("s39.toml"), "shapes = 1").unwrap();
    assert_eq!(unread(folder.path(), &["solve", "."]), Some(1));
    assert_eq!(unread(folder.path(), &["render", ".", "--format", "svg"]), Some(1));
}

#[cfg(unix)]
#[test]
fn a_stream_whose_answers_nobody_reads_ends() {
    let script = "yes '{}' | (\"$0\" solve --jsonl; echo $? >&2) | head -1";
    let ran = run(Command::new("sh").args(["-c", script]).arg(TRACEFIG));
    assert_eq!((ran.out.lines().count(), ran.err.as_str()), (1, "1\n"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = folder_with("s.toml", &drawn());
    let render = ["render", "s.toml", "--format", "svg"];
    for arguments in [&["solve", "s.toml"][..], &["--help"], &["solve", "--help"], &["--version"], &render] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = tracefig(folder.path()).args(arguments).stdout(full).output().unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(
            err.starts_with("error: can't write to standard output: No space left"),
            "{arguments:?}: {err}"
        );
        assert_eq!(output.status.code(), Some(74), "{arguments:?}");
    }
    assert!(folder.path().join("s.svg").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_stream_that_can_not_be_read_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let unreadable = std::fs::File::open(folder.path()).unwrap();
    let ran = run(tracefig(folder.path()).args(["solve", "--jsonl"]).stdin(unreadable));
    assert_eq!(ran.code, Some(74));
    assert!(ran.err.starts_with("error: can't read standard input: Is a directory"), "{}", ran.err);
}

#[cfg(target_os = "linux")]
#[test]
fn where_there_are_no_threads_there_are_fewer() {
    let folder = tempfile::tempdir().unwrap();
    for i in 0..6 {
        std::fs::write(folder.path().join(format!("s{i}.toml")), drawn()).unwrap();
    }
    // There is less address space than a stack is to have, so no thread can be made.
    let limited = |threads: &str| {
        let script = format!(
            "ulimit -v 1000000; export RUST_MIN_STACK=2000000000; exec \"$0\" render . --format svg --threads {threads}"
        );
        run(Command::new("sh").args(["-c", &script]).arg(TRACEFIG).current_dir(folder.path()))
    };
    for threads in ["1", "2", "500"] {
        let ran = limited(threads);
        assert_eq!((ran.code, ran.err.as_str(), ran.out.lines().count()), (Some(0), "", 6), "{threads}");
    }
}

#[test]
fn completions_and_the_man_page_know_every_command() {
    let folder = tempfile::tempdir().unwrap();
    let script = run(tracefig(folder.path()).args(["completions", "bash"])).out;
    let page = run(tracefig(folder.path()).arg("man")).out;
    let help = run(tracefig(folder.path()).arg("--help")).out;
    for command in ["render", "check", "solve", "trace", "describe", "report", "list", "completions", "man"] {
        assert!(script.contains(command) && page.contains(command) && help.contains(command), "{command}");
    }
    assert!(run(tracefig(folder.path()).args(["man", "solve"])).out.contains("jsonl"));
}

#[test]
fn the_schema_is_json_and_is_printed_only_when_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let ran = run(tracefig(folder.path()).args(["list", "schema"]));
    let schema: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(schema["properties"]["query"]["required"], serde_json::json!(["kind", "of"]));
    assert!(!run(tracefig(folder.path()).arg("list")).out.contains("$schema"));
}

#[test]
fn titles_are_listed_in_plain_words() {
    let scene = "title = '{a|Boxes} and $B \\ominus A$'\nshapes.A = { kind = 'circle', radius = 1 }\n\
                 query = { kind = 'bounds', of = ['A'] }";
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("figures")).unwrap();
    std::fs::write(folder.path().join("figures/s.toml"), scene).unwrap();
    let ran = run(tracefig(folder.path()).args(["list", "figures"]));
    assert!(ran.out.contains("  Boxes and B ⊖ A\n"), "{}", ran.out);
}
