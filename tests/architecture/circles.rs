//! No file of the library, or of the checker, uses another that, by whatever way, uses it: who reads down the
//! arrows never comes back.
//!
//! A folder's `mod.rs` and what is below it count as one shelf: the table there lists its files, and they
//! take its row's type from there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::rooms::is_within;
use crate::sources::{module_of, paths, rust_files, src};

/// The files that each file uses, as modules.
type Arrows = BTreeMap<String, BTreeSet<String>>;

/// The arrows between files, given as their paths below `src/` and their sources.
fn arrows(files: &[(String, String)]) -> Arrows {
    let modules: Vec<Vec<String>> = files.iter().map(|(path, _)| module_of(Path::new(path))).collect();
    let of = |path: &[String]| {
        let holding = modules.iter().filter(|module| path.starts_with(module));
        holding.max_by_key(|module| module.len())
    };
    let mut found = Arrows::new();
    for ((path, source), module) in files.iter().zip(&modules) {
        let named = paths(Path::new(path), source).unwrap();
        let of_library = named.iter().filter(|named| !named.module.iter().any(|segment| segment == "tests"));
        let targets = of_library.filter_map(|named| of(&named.resolved()?));
        let others =
            targets.filter(|other| !is_within(other, &module.join("/")) && !module.starts_with(other));
        found.entry(module.join("/")).or_default().extend(others.map(|other| other.join("/")));
    }
    found
}

/// A circle of files, if there is one: each uses the next, the last the first.
fn circle(arrows: &Arrows) -> Option<Vec<String>> {
    let mut done = BTreeSet::new();
    arrows.keys().find_map(|file| from(file, arrows, &mut Vec::new(), &mut done))
}

/// A circle that is met on the ways down from a file, after the files on the way to it.
fn from(
    file: &str,
    arrows: &Arrows,
    way: &mut Vec<String>,
    done: &mut BTreeSet<String>,
) -> Option<Vec<String>> {
    if let Some(start) = way.iter().position(|other| other == file) {
        return Some(way[start..].to_vec());
    }
    if done.contains(file) {
        return None;
    }
    way.push(file.to_owned());
    let found = arrows.get(file).and_then(|next| next.iter().find_map(|next| from(next, arrows, way, done)));
    way.pop();
    done.insert(file.to_owned());
    found
}

/// Holds that the files of a crate, the roots aside, use each other in no circle, and that arrows were read.
#[track_caller]
fn hold(src: &Path, least: usize) {
    let mut files = Vec::new();
    rust_files(src, &mut files);
    let read = |path: &PathBuf| {
        let relative = path.strip_prefix(src).unwrap().to_string_lossy().into_owned();
        (relative, fs::read_to_string(path).unwrap())
    };
    let roots = ["lib.rs", "main.rs"].map(|root| src.join(root));
    let sources: Vec<_> = files.iter().filter(|path| !roots.contains(path)).map(read).collect();
    let arrows = arrows(&sources);
    assert!(arrows.values().map(BTreeSet::len).sum::<usize>() > least, "the arrows are read: {arrows:?}");
    assert_eq!(circle(&arrows), None);
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    hold(&src(), 300);
}

#[test]
fn no_files_of_the_checker_use_each_other_in_a_circle() {
    hold(&src().with_file_name("reference").join("src"), 40);
}

#[test]
fn a_planted_circle_is_found() {
    let of = |sources: &[(&str, &str)]| {
        let files: Vec<_> = sources.iter().map(|(path, source)| ((*path).into(), (*source).into())).collect();
        circle(&arrows(&files)).map(|files| files.join(" "))
    };
    let (down, up) = ("use crate::a::y::Y;", "fn f() -> super::z::Z { loop {} }");
    let back = "use crate::a::x::X;";
    assert_eq!(of(&[("a/x.rs", down), ("a/y.rs", up), ("a/z.rs", "")]), None);
    assert_eq!(of(&[("a/x.rs", down), ("a/y.rs", up), ("a/z.rs", back)]).unwrap(), "a/x a/y a/z");
    let in_tests = format!("mod tests {{ {back} }}");
    assert_eq!(of(&[("a/x.rs", down), ("a/y.rs", up), ("a/z.rs", &in_tests)]), None);
    // A table and its rows.
    assert_eq!(of(&[("a/mod.rs", "fn f() { self::x::ROW; }"), ("a/x.rs", "use super::Row;")]), None);
}
