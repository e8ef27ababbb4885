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
