//! The command line as a user runs it.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

mod bad_input;
mod check;
mod jsonl;
mod render;
mod report;
mod streams;
#[cfg(unix)]
mod whole_files;

use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

/// The built binary, in a folder, with no settings of whoever runs the tests.
fn tracefig(folder: &Path) -> Command {
    let mut command = assert_cmd::cargo::cargo_bin_cmd!("tracefig");
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

fn run(command: &mut Command) -> Ran {
    let output = command.output().unwrap();
    Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
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
