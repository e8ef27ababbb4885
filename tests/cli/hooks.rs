//! The hook for pre-commit and the GitHub action name what there is, and do what they say.

use std::fs;
use std::path::Path;

use tracefig::output::FORMATS;

use crate::{run, tracefig};

const HOOKS: &str = include_str!("../../.pre-commit-hooks.yaml");
const ACTION: &str = include_str!("../../action.yml");
const README: &str = include_str!("../../README.md");

/// What stands behind a key, once in a file.
fn value<'t>(text: &'t str, key: &str) -> &'t str {
    let values: Vec<&str> = text.lines().filter_map(|line| line.trim().strip_prefix(key)).collect();
    assert_eq!(values.len(), 1, "{key} {values:?}");
    values[0].trim().trim_matches('"')
}

/// Options of a line that runs tracefig are those of the command that it names.
fn names_what_there_is(line: &str) -> usize {
    let words: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(words[0], "tracefig", "{line}");
    let help = run(tracefig(Path::new(".")).args([words[1], "--help"]));
    assert_eq!(help.code, Some(0), "{line}: no command {}", words[1]);
    let options = words[2..].iter().filter(|word| word.starts_with("--") && word.len() > 2);
    options
        .inspect(|option| assert!(help.out.contains(&format!(" {option} ")), "{line}: no option {option}"))
        .count()
}

#[test]
fn the_hook_runs_a_command_on_every_file_that_a_figure_depends_on() {
    assert_eq!(names_what_there_is(value(HOOKS, "entry:")), 0);
    let pattern = value(HOOKS, "files:").strip_prefix("\\.(").unwrap().strip_suffix(")$").unwrap();
    let endings: Vec<&str> = pattern.split('|').collect();
    for format in FORMATS {
        assert!(endings.contains(&format.name), "no {} in {pattern}", format.name);
    }
    assert!(endings.contains(&"toml") && endings.contains(&"json"));
    assert!(README.contains(&format!("id: {}, ", value(HOOKS, "- id:"))), "the README names the hook");
}

#[test]
fn the_action_installs_this_package_and_names_options_that_there_are() {
    let lines: Vec<&str> = ACTION.lines().map(str::trim).filter(|l| l.starts_with("tracefig ")).collect();
    assert_eq!(lines.len(), 1);
    assert_eq!(names_what_there_is(lines[0]), 2);
    assert!(ACTION.contains("run: cargo install --locked --path ."));
    let inputs = ACTION.split("\ninputs:").nth(1).unwrap().split("\nruns:").next().unwrap();
    let named = |line: &str| Some(line.strip_prefix("  ")?.strip_suffix(':')?.to_owned());
    let inputs: Vec<String> = inputs.lines().filter_map(named).filter(|name| !name.contains(' ')).collect();
    assert_eq!(inputs, ["scenes", "options", "artifact"]);
    for used in ACTION.split("${{ inputs.").skip(1) {
        assert!(inputs.iter().any(|name| used.starts_with(&format!("{name} }}"))), "{used}");
    }
    let with = README.split("with: {").nth(1).unwrap().split('}').next().unwrap();
    for part in with.split(',') {
        assert!(inputs.iter().any(|name| part.trim().starts_with(&format!("{name}: "))), "README: {part}");
    }
}

/// What the action's step says to bash, run as GitHub does, in a folder of two scenes' folders.
#[cfg(unix)]
fn compare(folder: &Path, options: &str, scenes: &str) -> (Option<i32>, String) {
    let block = ACTION.split("run: |\n").nth(1).unwrap();
    let lines: Vec<&str> = block.lines().take_while(|line| line.starts_with("        ")).collect();
    assert!(lines.len() > 2);
    let binaries = Path::new(crate::TRACEFIG).parent().unwrap();
    let path = std::env::join_paths([binaries, Path::new("/usr/bin"), Path::new("/bin")]).unwrap();
    let mut bash = std::process::Command::new("bash");
    bash.args(["--noprofile", "--norc", "-eo", "pipefail", "-c", &lines.join("\n")]).current_dir(folder);
    bash.env("PATH", path).env("OPTIONS", options).env("SCENES", scenes);
    bash.env("RUNNER_TEMP", folder.join("temp")).env("GITHUB_STEP_SUMMARY", folder.join("summary.md"));
    let ran = run(&mut bash);
    (ran.code, ran.out + &ran.err)
}

#[cfg(unix)]
#[test]
fn the_action_fails_where_a_figure_is_not_what_its_scene_gives() {
    let folder = tempfile::tempdir().unwrap();
    let scene = crate::render::drawn();
    for name in ["my figures", "others"] {
        fs::create_dir_all(folder.path().join(name)).unwrap();
        fs::write(folder.path().join(name).join("s.toml"), &scene).unwrap();
    }
    let drawn = run(tracefig(folder.path()).args(["render", "my figures", "others", "--format", "svg"]));
    assert_eq!(drawn.code, Some(0), "{}", drawn.err);
    let figures = "my figures\n\nothers\n";
    assert_eq!(compare(folder.path(), "--format=svg", figures).0, Some(0));
    fs::write(folder.path().join("others/s.svg"), "").unwrap();
    assert_eq!(compare(folder.path(), "--format=svg", "my figures").0, Some(0));
    let (code, said) = compare(folder.path(), "--format=svg\n--tolerance=2", figures);
    assert!(code == Some(1) && said.contains("s.svg"), "{said}");
    assert!(folder.path().join("temp/tracefig-check/index.html").exists());
    assert!(fs::read_to_string(folder.path().join("summary.md")).unwrap().contains("s.svg"));
    // Nobody says which: what the tool takes then.
    fs::rename(folder.path().join("my figures"), folder.path().join("figures")).unwrap();
    assert_eq!(compare(folder.path(), "--format=svg", "").0, Some(0));
}
