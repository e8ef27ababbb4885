//! The command line as a user runs it.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

mod bad_input;
mod breakage;
mod check;
mod exercises;
mod habits;
mod handouts;
mod hooks;
#[path = "../hostile_figures/mod.rs"]
mod hostile_figures;
mod in_motion;
mod in_steps;
mod inert;
#[cfg(unix)]
mod inputs_stay;
mod jsonl;
mod live;
mod live_book;
mod mdbook;
mod moodle;
mod orphans;
mod project;
mod qti;
mod readme;
mod render;
mod render_jsonl;
mod report;
mod schema;
mod streams;
mod themes;
mod vocabulary;
#[cfg(unix)]
mod watch;
#[cfg(unix)]
mod whole_files;

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread;

use tempfile::TempDir;

/// Path of the built binary.
const TRACEFIG: &str = env!("CARGO_BIN_EXE_tracefig");

/// The built binary, in a folder, with no settings of whoever runs the tests.
fn tracefig(folder: &Path) -> Command {
    let mut command = Command::new(TRACEFIG);
    command
        .current_dir(folder)
        .env_remove("NO_COLOR")
        .env_remove("CLICOLOR_FORCE")
        .env_remove("RUST_BACKTRACE");
    command
}

/// A folder with one file.
fn folder_with(name: &str, text: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(name), text).unwrap();
    folder
}

/// What a run printed and how it ended.
struct Ran {
    code: Option<i32>,
    out: String,
    err: String,
}

impl From<Output> for Ran {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

/// Runs to the end, with nothing on standard input.
fn run(command: &mut Command) -> Ran {
    command.output().unwrap().into()
}

/// Runs to the end with a text on standard input, which the command need not read.
fn run_on(command: &mut Command, input: impl AsRef<[u8]> + Send) -> Ran {
    let command = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    thread::scope(|scope| {
        // Beside the reading of what is printed, so that no full pipe stops both.
        scope.spawn(move || drop(stdin.write_all(input.as_ref())));
        child.wait_with_output().unwrap().into()
    })
}

/// Two circles, 1 apart.
const CIRCLES: &str = r#"title = "Two circles"
[shapes.A]
kind = "circle"
radius = 1
[shapes.B]
kind = "circle"
radius = 2
position = [4, 0]
[query]
kind = "separation"
of = ["A", "B"]
"#;
