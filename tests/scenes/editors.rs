//! Committed scenes and the guide's are TOML 1.0, which editors read: an inline table stands on one line and
//! ends without a comma. We read TOML 1.1 too.

#![expect(clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// What TOML 1.0 refuses in a value and what stands in it.
fn of_version_1_1<'t>(value: &Spanned<DeValue<'t>>, text: &'t str, found: &mut Vec<&'t str>) {
    let children: Vec<&Spanned<DeValue>> = match value.get_ref() {
        DeValue::Array(items) => items.iter().collect(),
        DeValue::Table(entries) => entries.values().collect(),
        _ => return,
    };
    let whole = &text[value.span()];
    if whole.starts_with('{') {
        let mut at = value.span().start;
        let mut own = String::new();
        for child in &children {
            own.push_str(&text[at..child.span().start]);
            at = child.span().end;
        }
        let end = &text[at..value.span().end];
        if own.contains('\n') || end.contains(['\n', ',']) {
            found.push(whole);
        }
    }
    for child in children {
        of_version_1_1(child, text, found);
    }
}

/// Inline tables of a text that TOML 1.0 refuses.
fn refused(text: &str) -> Vec<&str> {
    let root = DeTable::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let mut found = Vec::new();
    root.get_ref().values().for_each(|value| of_version_1_1(value, text, &mut found));
    found
}

/// The TOML files of a folder, in depth.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] })
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect()
}

#[test]
fn committed_scenes_can_be_read_by_editors() {
    assert_eq!(refused("a = { b = [1,\n2], c = \"\\n\" }"), [""; 0], "arrays may be of several lines");
    assert_eq!(refused("a = [{ b = 1,\n c = 2 }]").len(), 1);
    assert_eq!(refused("a = { b = { c = 2, } }").len(), 1);
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files: Vec<_> =
        ["figures", "guide", "examples"].iter().flat_map(|at| files(&root.join(at))).collect();
    assert!(files.len() > 24, "{files:?}");
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        assert_eq!(refused(&text), [""; 0], "{}", file.display());
    }
}
