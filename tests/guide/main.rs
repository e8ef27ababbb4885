//! The guide: its reference is what the tables say, and its pages are true.
//!
//! `TRACEFIG_WRITE=1 cargo test --test guide` writes the reference anew.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

mod exercises;
mod pages;
mod reference;

use std::path::PathBuf;
use std::process::Command;

/// The folder of the guide's pages.
fn src() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("guide/src")
}

/// The built binary, with no settings of whoever runs the tests.
fn tracefig() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tracefig"));
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    // Without these nothing is kept from build to build.
    for name in ["NO_COLOR", "COLUMNS", "XDG_CACHE_HOME", "HOME", "LOCALAPPDATA"] {
        command.env_remove(name);
    }
    command
}

/// What a run prints.
fn printed(arguments: &[&str]) -> String {
    let ran = tracefig().args(arguments).output().unwrap();
    assert!(ran.status.success(), "{arguments:?}");
    String::from_utf8(ran.stdout).unwrap()
}
