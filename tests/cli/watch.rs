//! `watch`: a change is drawn, an error is told and does not end it, Ctrl-C does.

#![expect(clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::io::{BufRead, BufReader, pipe};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use crate::render::drawn;
use crate::{folder_with, run, tracefig};

/// How long a line may take to come: a loaded machine draws a figure in a second or two.
const PATIENCE: Duration = Duration::from_mins(1);

/// A command that runs, and what it says line by line.
struct Running {
    child: Child,
    lines: Receiver<String>,
}

impl Running {
    fn watch(folder: &Path, arguments: &[&str]) -> Self {
        let mut command = tracefig(folder);
        command.arg("watch").args(arguments).stdin(Stdio::null());
        // One pipe for both, so that the lines come in the order in which they are said.
        let (reader, writer) = pipe().unwrap();
        let child = command.stdout(writer.try_clone().unwrap()).stderr(writer).spawn().unwrap();
        let (sender, lines) = channel();
        thread::spawn(move || {
            BufReader::new(reader).lines().map_while(Result::ok).all(|line| sender.send(line).is_ok())
        });
        Self { child, lines }
    }

    /// Waits for a line that begins so; the lines before it.
    fn says(&self, begin: &str) -> Vec<String> {
        let (start, mut before) = (Instant::now(), Vec::new());
        while let Some(left) = PATIENCE.checked_sub(start.elapsed()) {
            let Ok(line) = self.lines.recv_timeout(left) else { break };
            if line.starts_with(begin) {
                return before;
            }
            before.push(line);
        }
        panic!("no line begins {begin:?}: {before:#?}");
    }

    /// Presses Ctrl-C; how it ends.
    fn interrupted(mut self) -> Option<i32> {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code();
            }
            thread::sleep(Duration::from_millis(20));
        }
        let _ = self.child.kill();
        panic!("Ctrl-C does not end it");
    }
}

#[test]
fn a_change_is_drawn_and_an_error_does_not_end_it() {
    let folder = folder_with("s.toml", &drawn());
    let here = folder.path();
    fs::write(here.join("night.toml"), "based_on = \"dark\"\n").unwrap();
    let write = |name: &str, text: &str| fs::write(here.join(name), text).unwrap();
    let running = Running::watch(here, &[".", "--format", "svg", "--theme", "night.toml"]);
    assert!(running.says("./s.toml: ./s.svg").is_empty());
    assert!(running.says("watching 1 scene in .; Ctrl-C ends it").is_empty());
    let first = fs::read(here.join("s.svg")).unwrap();

    write("s.toml", &drawn().replace("radius = 1", "radius = 1.5"));
    assert!(running.says("./s.toml: ./s.svg").is_empty(), "one line a change");
    assert!(fs::read(here.join("s.svg")).unwrap() != first);

    write("s.toml", &drawn().replace("radius = 1", "raduis = 1"));
    running.says("error[unknown-key]: unknown key `raduis`");
    write("s.toml", &drawn());
    running.says("./s.toml: ./s.svg");
    assert!(fs::read(here.join("s.svg")).unwrap() == first);

    // Another scene, in a folder that was not there.
    fs::create_dir(here.join("more")).unwrap();
    write("more/t.toml", &drawn());
    running.says("./more/t.toml: ./more/t.svg");
    write("more/t.toml", &drawn().replace("radius = 1", "radius = 1.5"));
    running.says("./more/t.toml: ./more/t.svg");

    // What all are drawn with.
    write("night.toml", "based_on = \"dark\"\n[colors]\na = \"#FF6650\"\n");
    running.says("./more/t.toml: ./more/t.svg");
    running.says("./s.toml: ./s.svg");
    write("tracefig.toml", "[canvas]\nwidht = 700\n");
    running.says("error[unknown-key]: unknown key `widht`");
    write("tracefig.toml", "[canvas]\nwidth = 700\n");
    running.says("./s.toml: ./s.svg");
    assert!(fs::read_to_string(here.join("s.svg")).unwrap().contains("width=\"700\""));
    assert_eq!(running.interrupted(), Some(0));
}

#[test]
fn what_is_up_to_date_is_said_and_so_is_what_is_well_again() {
    let folder =
        folder_with("tracefig.toml", "[render]\nscenes = ['docs']\noutput = 'img'\nformats = ['svg']\n");
    let here = folder.path();
    fs::create_dir_all(here.join("docs/deep")).unwrap();
    let write = |name: &str, text: &str| fs::write(here.join(name), text).unwrap();
    write("docs/s.toml", &drawn());
    write("docs/deep/t.toml", &drawn());
    assert_eq!(run(tracefig(here).arg("render")).code, Some(0));
    let running = Running::watch(here, &[]);
    assert!(running.says("watching 2 scenes in docs, up to date; Ctrl-C ends it").is_empty());

    write("docs/s.toml", &drawn().replace("radius = 1", "raduis = 1"));
    running.says("error[unknown-key]: unknown key `raduis`");
    write("docs/s.toml", &drawn());
    running.says("docs/s.toml: well again");
    // What is left of a scene while it is written is none, and its figure is of before.
    for rest in ["", "broken = ["] {
        write("docs/s.toml", rest);
        running.says("note: docs/s.toml is no scene any more, and its figures stay as they were");
        write("docs/s.toml", &drawn());
        running.says("docs/s.toml: well again");
    }

    let project = fs::read_to_string(here.join("tracefig.toml")).unwrap();
    write("tracefig.toml", &project.replace("output", "outptu"));
    running.says("error[unknown-key]: unknown key `outptu`");
    write("tracefig.toml", &project);
    running.says("well again");

    fs::remove_file(here.join("img/deep/t.svg")).unwrap();
    running.says("docs/deep/t.toml: img/deep/t.svg");
    assert!(here.join("img/deep/t.svg").exists());
    assert_eq!(running.interrupted(), Some(0));
}

/// A warning was taken back where the file was written once more, as it was.
#[test]
fn what_is_told_of_a_figure_holds_until_it_is_drawn_again() {
    let text = format!("{}title = 'by {{=depth}}'\n", drawn());
    let folder = folder_with("s.toml", &text);
    let write = |text: &str| fs::write(folder.path().join("s.toml"), text).unwrap();
    let running = Running::watch(folder.path(), &["s.toml", "--format", "svg"]);
    assert!(running.says("s.toml: s.svg").len() > 1, "nothing is told of a depth that is none");
    write(&text);
    write(&drawn().replace("radius = 1", "radius = 1.5"));
    assert!(running.says("s.toml: s.svg").iter().all(|line| !line.ends_with("well again")));
    assert_eq!(running.interrupted(), Some(0));
}

#[test]
fn a_handout_is_written_again_when_one_of_its_scenes_changes() {
    let handout = "[[handout]]\nfile = 'class/all.pdf'\nscenes = ['class/scenes']\n";
    let project = format!("[render]\nscenes = ['docs']\nformats = ['svg']\n{handout}");
    let folder = folder_with("tracefig.toml", &project);
    let here = folder.path();
    let write = |name: &str, text: &str| fs::write(here.join(name), text).unwrap();
    for folder in ["docs", "class/scenes"] {
        fs::create_dir_all(here.join(folder)).unwrap();
    }
    write("docs/s.toml", &drawn());
    write("class/scenes/t.toml", &drawn());
    assert_eq!(run(tracefig(here).arg("render")).code, Some(0));
    let first = fs::read(here.join("class/all.pdf")).unwrap();
    let running = Running::watch(here, &[]);
    assert!(running.says("watching 1 scene in docs, up to date; Ctrl-C ends it").is_empty());

    write("class/scenes/t.toml", &drawn().replace("radius = 1", "radius = 1.5"));
    assert!(running.says("class/all.pdf").is_empty());
    assert!(fs::read(here.join("class/all.pdf")).unwrap() != first);
    write("class/scenes/t.toml", &drawn().replace("radius = 1", "raduis = 1"));
    running.says("error[unknown-key]: unknown key `raduis`");
    running.says("error: class/all.pdf is not written without all its figures");
    write("class/scenes/t.toml", &drawn());
    assert!(running.says("class/all.pdf").is_empty());
    assert!(fs::read(here.join("class/all.pdf")).unwrap() == first);
    fs::remove_file(here.join("class/all.pdf")).unwrap();
    running.says("class/all.pdf");
    assert_eq!(running.interrupted(), Some(0));
}

#[test]
fn what_can_not_be_watched_is_usage() {
    let folder = folder_with("s.toml", &drawn());
    for arguments in [&["watch", "-"][..], &["watch", "s.toml", "-o", "-"]] {
        assert_eq!(run(tracefig(folder.path()).args(arguments)).code, Some(2), "{arguments:?}");
    }
}
