//! Words and picture of every committed figure name the same things.
//!
//! What they do not is in `unnamed.txt`, a line each; a line that is no longer true fails too, so that the
//! list only shrinks. `TRACEFIG_WRITE=1` takes such lines away and adds none.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use tracefig::figure::{draw, plan, unnamed};

fn list() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/figures/unnamed.txt")
}

/// What words and picture of the committed figures do not say of each other.
fn found() -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let scene = tracefig::open(&path).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let drawing = draw(&plan, plan.theme, &stem).drawing;
        found.extend(unnamed(&drawing).iter().map(|unnamed| format!("{stem}: {unnamed}")));
    }
    found
}

#[test]
fn words_and_picture_of_every_figure_name_the_same() {
    let found = found();
    let known: BTreeSet<String> = fs::read_to_string(list()).unwrap().lines().map(str::to_owned).collect();
    if std::env::var_os("TRACEFIG_WRITE").is_some() {
        let still: Vec<&str> = known.intersection(&found).map(String::as_str).collect();
        fs::write(list(), still.iter().fold(String::new(), |text, line| text + line + "\n")).unwrap();
    }
    let new: Vec<_> = found.difference(&known).collect();
    assert!(new.is_empty(), "name these in the words or on the picture: {new:#?}");
    let gone: Vec<_> = known.difference(&found).collect();
    assert!(gone.is_empty(), "true no longer; `TRACEFIG_WRITE=1` takes them from the list: {gone:#?}");
}
