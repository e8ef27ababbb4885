//! The committed figures are what the built binary draws, byte for byte; a figure changed by hand is found
//! and shown.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn figures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("figures")
}

fn check(folder: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tracefig"));
    command.current_dir(folder).args(["check", "figures", "-o", "found"]).output().unwrap()
}

/// A folder with a copy of the committed figures.
fn copy() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("figures")).unwrap();
    for entry in fs::read_dir(figures()).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), folder.path().join("figures").join(entry.file_name())).unwrap();
    }
    folder
}

#[test]
fn every_committed_figure_is_identical() {
    let output = check(copy().path());
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn every_scene_has_its_svg_and_png() {
    let mut scenes = 0;
    for entry in fs::read_dir(figures()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            scenes += 1;
            for format in ["svg", "png"] {
                assert!(path.with_extension(format).exists(), "{} lacks its {format}", path.display());
            }
            let lines = fs::read_to_string(&path).unwrap().lines().count();
            assert!(lines <= 60, "{} has {lines} lines", path.display());
        }
    }
    assert!(scenes >= 17, "{scenes} scenes");
}

#[test]
fn a_figure_changed_by_hand_fails_the_check_and_is_shown() {
    let folder = copy();
    let svg = folder.path().join("figures/04-minkowski-difference.svg");
    let text = fs::read_to_string(&svg).unwrap();
    fs::write(&svg, text.replacen("BC0D2A", "BC0D2B", 1).replacen("bc0d2a", "bc0d2b", 1)).unwrap();
    let output = check(folder.path());
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("04-minkowski-difference.svg") && said.contains("changed"), "{said}");
    assert!(fs::read_dir(folder.path().join("found")).unwrap().count() > 0);
}

#[test]
fn a_figure_removed_is_missing() {
    let folder = copy();
    fs::remove_file(folder.path().join("figures/01-penetration.png")).unwrap();
    let output = check(folder.path());
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("missing"), "{said}");
}
