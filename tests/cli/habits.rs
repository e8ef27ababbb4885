//! What hands are used to: quiet, colour, help.

use crate::render::drawn;
use crate::{folder_with, run, tracefig};

#[test]
fn quiet_says_what_is_wrong_and_no_more() {
    let folder = folder_with("s.toml", &drawn());
    std::fs::write(folder.path().join("other.json"), "{}").unwrap();
    let ran = |arguments: &[&str]| {
        let ran = run(tracefig(folder.path()).args(arguments));
        (ran.code, ran.out, ran.err)
    };
    assert_eq!(ran(&["render", ".", "-q"]), (Some(0), String::new(), String::new()));
    assert_eq!(ran(&["--quiet", "check", "."]), (Some(0), String::new(), String::new()));
    let picture = ran(&["render", "s.toml", "-q", "-o", "-"]);
    assert!(picture.0 == Some(0) && picture.1.starts_with("<svg"), "what was asked for is written");
    std::fs::write(folder.path().join("s.toml"), "shapes = 1").unwrap();
    let (code, out, err) = ran(&["render", "-q", "s.toml"]);
    assert!(code == Some(1) && out.is_empty() && err.contains("error[wrong-type]"), "{err}");
    std::fs::write(folder.path().join("s.toml"), drawn().replace("radius = 2", "radius = 1")).unwrap();
    let (code, out, _) = ran(&["check", "-q", "s.toml"]);
    assert!(code == Some(1) && out.starts_with("stale     s.svg\n"), "{out}");
}

#[test]
fn colour_is_as_asked_for() {
    let folder = folder_with("s.toml", "title = 1");
    let coloured = |arguments: &[&str], no_color: &str| {
        let mut command = tracefig(folder.path());
        command.env("NO_COLOR", no_color).args(arguments);
        let ran = run(&mut command);
        assert_eq!(ran.code, Some(1), "{}", ran.err);
        ran.err.contains('\u{1b}')
    };
    assert!(coloured(&["solve", "s.toml", "--color", "always"], "1"), "an option beats the surroundings");
    assert!(coloured(&["--color=always", "render", "s.toml"], ""));
    assert!(!coloured(&["solve", "s.toml", "--color", "never"], ""));
    assert!(!coloured(&["solve", "s.toml", "--color", "auto"], ""), "no terminal");
}

#[test]
fn help_is_a_command_too() {
    let folder = folder_with("s.toml", "");
    let ran = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    assert_eq!(ran(&["help"]).out, ran(&["--help"]).out);
    assert_eq!(ran(&["help", "render"]).out, ran(&["render", "--help"]).out);
    assert_eq!(ran(&["help", "rendr"]).code, Some(2));
}

#[test]
fn files_are_the_same_whether_the_disk_is_waited_for_or_not() {
    let folder = folder_with("s.toml", &drawn());
    let render = |more: &[&str]| run(tracefig(folder.path()).args(["render", "s.toml"]).args(more));
    assert_eq!(render(&[]).out, render(&["--sync"]).out);
    assert_eq!(render(&["--sync", "-o", "synced"]).code, Some(0));
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(read("s.png") == read("synced/s.png"));
    assert_eq!(run(tracefig(folder.path()).args(["check", "s.toml", "--sync", "--accept"])).code, Some(0));
}

/// The commands that help lists.
fn commands() -> Vec<String> {
    let help = run(tracefig(std::path::Path::new(".")).arg("--help")).out;
    let listed = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let names = listed.lines().filter_map(|line| line.split_whitespace().next().map(str::to_owned));
    names.filter(|name| name != "help").collect()
}

/// The terms of a section of a man page.
fn terms(page: &str, section: &str) -> Vec<String> {
    let Some((_, rest)) = page.split_once(&format!(".SH \"{section}\"\n")) else {
        let Some((_, rest)) = page.split_once(&format!(".SH {section}\n")) else { return Vec::new() };
        return terms_of(rest);
    };
    terms_of(rest)
}

fn terms_of(rest: &str) -> Vec<String> {
    let section = rest.split("\n.SH").next().unwrap();
    let terms = section.split(".TP\n").skip(1).map(|term| term.lines().next().unwrap());
    terms.map(|term| term.replace("\\fB", "").replace("\\fR", "").replace("\\-", "-")).collect()
}

#[test]
fn every_command_has_a_page_with_examples_and_how_it_ends() {
    let folder = folder_with("s.toml", "");
    let ran = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments));
    let commands = commands();
    assert!(commands.len() >= 10, "{commands:?}");
    for command in &commands {
        let page = ran(&["man", command]);
        assert_eq!(page.code, Some(0), "{command}");
        assert!(page.out.contains(&format!(".TH tracefig-{command} 1 ")), "{}", &page.out[..200]);
        let examples = terms(&page.out, "EXAMPLES");
        assert!(!examples.is_empty(), "{command} has no example:\n{}", page.out);
        let help = ran(&[command, "--help"]).out;
        for example in examples {
            let first = example.split(" | ").next().unwrap();
            assert!(help.contains(first), "{command} --help lacks {example}");
        }
        let endings = terms(&page.out, "EXIT STATUS");
        assert!(endings.len() >= 4 && endings.last().unwrap() == "74", "{command}: {endings:?}");
        assert_eq!(terms(&page.out, "ENVIRONMENT"), ["NO_COLOR", "TERM", "RUST_BACKTRACE"]);
    }
    let files = |command: &str| terms(&ran(&["man", command]).out, "FILES");
    assert_eq!(files("check"), ["tracefig.toml", "figures/", "target/tracefig-check/"]);
    assert!(files("solve").is_empty());
    let all = ran(&["man"]).out;
    assert_eq!(terms(&all, "EXAMPLES").len(), commands.len());
    assert_eq!(terms(&all, "EXIT STATUS"), ["0", "1", "2", "3", "74"]);
}

#[test]
fn a_command_ends_as_its_page_says() {
    let folder = folder_with("wrong.toml", "title = 1");
    let ended = |arguments: &[&str]| run(tracefig(folder.path()).args(arguments)).code.unwrap();
    let page = |command: &str| run(tracefig(folder.path()).args(["man", command])).out;
    for command in ["render", "check", "solve", "trace", "describe", "moodle"] {
        assert_eq!(ended(&[command, "wrong.toml"]), 1);
        assert!(terms(&page(command), "EXIT STATUS").contains(&"1".to_owned()), "{command}");
        assert_eq!(ended(&[command, "absent.toml"]), 74, "{command}");
        assert_eq!(ended(&[command, "--no-such-option"]), 2, "{command}");
    }
    assert_eq!(ended(&["report", "--filter", "none is named so"]), 1);
    assert_eq!(terms(&page("report"), "EXIT STATUS")[1], "1");
    assert_eq!(terms(&page("list"), "EXIT STATUS"), ["0", "2", "3", "74"]);
}
