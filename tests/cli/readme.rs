//! What the README and CONTRIBUTING.md show is true: its scene renders, its commands run, its links lead
//! somewhere.

use std::path::Path;

use crate::{run, run_on, tracefig};

const README: &str = include_str!("../../README.md");
const CONTRIBUTING: &str = include_str!("../../CONTRIBUTING.md");

/// The pages whose links and commands are held.
const PAGES: [(&str, &str); 2] = [("README.md", README), ("CONTRIBUTING.md", CONTRIBUTING)];

/// The fenced blocks of a language.
fn blocks(language: &str) -> Vec<&'static str> {
    README.split("\n```").filter_map(|part| part.strip_prefix(language)?.strip_prefix('\n')).collect()
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn the_example_scene_goes_through_every_command_shown() {
    let folder = tempfile::tempdir().unwrap();
    let scenes = blocks("toml");
    std::fs::write(folder.path().join("scene.toml"), scenes[0]).unwrap();
    let commands: Vec<&str> = blocks("sh")
        .iter()
        .flat_map(|block| block.lines())
        .filter(|line| line.starts_with("tracefig ") && line.ends_with("scene.toml"))
        .collect();
    assert!(commands.len() >= 4, "{commands:?}");
    for command in commands {
        let words: Vec<&str> = command.split_whitespace().skip(1).collect();
        let ran = run(tracefig(folder.path()).args(&words));
        assert_eq!(ran.code, Some(0), "{command}: {}", ran.err);
    }
    for file in ["scene.svg", "scene.png"] {
        assert!(folder.path().join(file).metadata().unwrap().len() > 1000, "{file}");
    }
}

#[test]
fn every_command_named_is_one() {
    let help = run(tracefig(root()).arg("--help")).out;
    let mut named = 0;
    for part in README.split("`tracefig ").skip(1) {
        let word = part.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap();
        assert!(help.contains(&format!("  {word} ")), "`tracefig {word}` is no command");
        named += 1;
    }
    assert!(named >= 5);
}

#[test]
fn every_link_to_a_file_leads_to_it() {
    let mut astray = Vec::new();
    for (name, text) in PAGES {
        for part in text.split("](").skip(1) {
            let target = part.split(')').next().unwrap();
            if !target.contains("://") && !root().join(target).exists() {
                astray.push(format!("{name}: {target}"));
            }
        }
    }
    assert!(astray.is_empty(), "not there:\n{}", astray.join("\n"));
}

#[test]
fn every_table_named_is_in_its_file() {
    let mut named = 0;
    for line in CONTRIBUTING.lines().filter(|line| line.contains("` in [`")) {
        let (before, after) = line.split_once("` in [`").unwrap();
        let table = before.rsplit('`').next().unwrap();
        let file = after.split_once("](").unwrap().1.split(')').next().unwrap();
        let text = std::fs::read_to_string(root().join(file)).unwrap_or_default();
        assert!(text.contains(&format!(" {table}: ")), "{file} has no table {table}");
        named += 1;
    }
    assert!(named >= 7, "{named} tables");
}

#[test]
fn every_test_target_named_is_one() {
    let ci = std::fs::read_to_string(root().join(".ci/run")).unwrap();
    let mut named = 0;
    for part in
        PAGES.iter().map(|(_, text)| *text).chain([ci.as_str()]).flat_map(|t| t.split("--test ").skip(1))
    {
        let target = part.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap();
        let tests = root().join("tests");
        let is_one =
            tests.join(format!("{target}.rs")).exists() || tests.join(target).join("main.rs").exists();
        assert!(is_one, "there is no test {target}");
        named += 1;
    }
    assert!(named >= 8, "{named} targets");
}

#[test]
fn every_step_of_ci_is_told() {
    let ci = std::fs::read_to_string(root().join(".ci/run")).unwrap();
    let told = CONTRIBUTING.split_once("## What CI holds").unwrap().1;
    let mut steps = 0;
    for step in ci.lines().filter_map(|line| line.strip_prefix("echo \"== ")) {
        let step = step.trim_end_matches('"');
        assert!(told.contains(step), "{step}");
        steps += 1;
    }
    assert!(steps >= 10, "{steps} steps");
}

#[test]
fn the_two_commands_are_those_that_ci_runs() {
    let first = blocks("sh")[0];
    let commands: Vec<&str> = first.lines().map(|line| line.split('#').next().unwrap().trim()).collect();
    assert_eq!(commands, ["cargo run --release -- render", "cargo test"]);
    let ci = std::fs::read_to_string(root().join(".ci/run")).unwrap();
    assert!(
        ci.lines().any(|line| line.trim().starts_with("cargo test")),
        "CI runs the README's test command"
    );
}

#[test]
fn the_line_piped_to_solve_is_answered() {
    let line = README.lines().find(|line| line.ends_with("| tracefig solve --jsonl")).unwrap();
    let scene = line.trim_start_matches("echo '").split("' | ").next().unwrap();
    let answer = run_on(tracefig(root()).args(["solve", "--jsonl"]), scene).out;
    assert!(answer.contains("\"separation\":1.0") || answer.contains("\"separation\": 1.0"), "{answer}");
}
