//! The hook for pre-commit and the GitHub action name what there is, and do what they say.

use std::fs;
use std::path::Path;

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
fn the_hook_runs_a_command_whatever_a_commit_changes() {
    assert_eq!(names_what_there_is(value(HOOKS, "entry:")), 0);
    assert_eq!((value(HOOKS, "always_run:"), value(HOOKS, "pass_filenames:")), ("true", "false"));
    assert!(!HOOKS.contains("\n  files:") && !HOOKS.contains("\n  types"));
    assert!(README.contains(&format!("id: {}, ", value(HOOKS, "- id:"))), "the README names the hook");
}

/// The hook as pre-commit runs it, where that is installed.
#[cfg(unix)]
#[test]
fn a_commit_that_deletes_a_scene_or_a_figure_is_refused() {
    let command = |name: &str, arguments: &[&str], folder: &Path| {
        let binaries = Path::new(crate::TRACEFIG).parent().unwrap().to_owned();
        let path = std::env::var_os("PATH").unwrap_or_default();
        let path = std::env::join_paths([binaries].into_iter().chain(std::env::split_paths(&path))).unwrap();
        let mut command = std::process::Command::new(name);
        command.args(arguments).current_dir(folder).env("PATH", path).env("HOME", folder.join(".git"));
        command.env("PRE_COMMIT_HOME", folder.join(".git/pre-commit")).env("GIT_CONFIG_NOSYSTEM", "1");
        command
    };
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let is_there =
        |name: &str| command(name, &["--version"], here).output().is_ok_and(|output| output.status.success());
    if !is_there("pre-commit") || !is_there("git") {
        return;
    }
    let git = |arguments: &[&str]| {
        let who = ["-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main"];
        run(&mut command("git", &[&who[..], arguments].concat(), here))
    };
    // The hook itself, but for the building.
    let hook = HOOKS.replace("language: rust", "language: system").replace('\n', "\n      ");
    let config = format!("repos:\n  - repo: local\n    hooks:\n      {}\n", hook.trim_end());
    fs::write(here.join(".pre-commit-config.yaml"), config).unwrap();
    fs::create_dir(here.join("figures")).unwrap();
    for name in ["s", "t"] {
        fs::write(here.join(format!("figures/{name}.toml")), crate::render::drawn()).unwrap();
    }
    assert_eq!(run(tracefig(here).arg("render")).code, Some(0));
    assert_eq!(git(&["init", "--quiet"]).code, Some(0));
    assert_eq!(run(&mut command("pre-commit", &["install"], here)).code, Some(0));
    let commit = |delete: &[&str]| {
        assert_eq!(git(&[&["rm", "--quiet"], delete].concat()).code, Some(0));
        let ran = git(&["commit", "--quiet", "-m", "delete"]);
        let said = ran.out + &ran.err;
        if ran.code != Some(0) {
            assert_eq!(git(&["reset", "--quiet", "--hard"]).code, Some(0));
        }
        (ran.code, said)
    };
    assert_eq!(git(&["add", "-A"]).code, Some(0));
    let first = git(&["commit", "-m", "all"]);
    assert_eq!(first.code, Some(0), "{}{}", first.out, first.err);
    for (deleted, told) in [("figures/s.toml", "orphan "), ("figures/s.png", "missing ")] {
        let (code, said) = commit(&[deleted]);
        assert!(code == Some(1) && said.contains(told), "{deleted}: {code:?} {said}");
    }
    let (code, said) = commit(&["figures/s.toml", "figures/s.png", "figures/s.svg"]);
    assert_eq!(code, Some(0), "{said}");
}

#[test]
fn the_action_installs_this_package_and_names_options_that_there_are() {
    let lines: Vec<&str> = ACTION.lines().map(str::trim).filter(|l| l.starts_with("tracefig ")).collect();
    assert_eq!(lines.len(), 1);
    assert_eq!(names_what_there_is(lines[0]), 2);
    assert!(ACTION.contains("run: cargo install --locked --path . --root ~/.tracefig-action\n"));
    assert_eq!(ACTION.matches("~/.tracefig-action").count(), 3, "where it is kept, put and found");
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

/// What a step of the action says to bash.
fn script(step: &str) -> String {
    let block = ACTION.split(&format!("name: {step}\n")).nth(1).unwrap().split("run: |\n").nth(1).unwrap();
    let lines: Vec<&str> = block.lines().take_while(|line| line.starts_with("        ")).collect();
    assert!(lines.len() > 1, "{step}");
    lines.join("\n")
}

#[cfg(unix)]
#[test]
fn a_build_of_the_action_is_named_by_all_that_it_is_built_of() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::create_dir_all(here.join("src/a b")).unwrap();
    for name in ["Cargo.toml", "Cargo.lock", "src/main.rs", "src/a b/font"] {
        fs::write(here.join(name), name).unwrap();
    }
    let key = || {
        let mut bash = std::process::Command::new("bash");
        bash.args(["--noprofile", "--norc", "-eo", "pipefail", "-c", &script("Name the build")]);
        let ran = run(bash.current_dir(here).env("GITHUB_OUTPUT", here.join("output")));
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
        let text = fs::read_to_string(here.join("output")).unwrap();
        fs::remove_file(here.join("output")).unwrap();
        assert!(text.starts_with("key=") && !text.trim().contains([' ', '/']), "{text}");
        text
    };
    let first = key();
    assert_eq!(key(), first);
    fs::write(here.join("src/a b/font"), "another").unwrap();
    assert_ne!(key(), first);
    assert!(ACTION.contains("-${{ steps.build.outputs.key }}\n"));
}

/// What the action's step says to bash, run as GitHub does, in a folder of two scenes' folders.
#[cfg(unix)]
fn compare(folder: &Path, options: &str, scenes: &str) -> (Option<i32>, String) {
    let lines = script("Compare the figures");
    let binaries = Path::new(crate::TRACEFIG).parent().unwrap();
    let path = std::env::join_paths([binaries, Path::new("/usr/bin"), Path::new("/bin")]).unwrap();
    let mut bash = std::process::Command::new("bash");
    bash.args(["--noprofile", "--norc", "-eo", "pipefail", "-c", &lines]).current_dir(folder);
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
