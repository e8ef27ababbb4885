//! What fuzzing found stays found: the inputs of `fuzz/corpus` pass through the very functions of the fuzz
//! targets.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use tracefig::drawing::Role;
use tracefig::figure::layer::LAYERS;
use tracefig::figure::theme::THEMES;
use tracefig::figure::{COMMON, OptionSpec, Takes};
use tracefig::geometry::shape::KINDS;
use tracefig::scene::{Grip, Holds, TABLES, shape_rows};

use crate::fuzz_bodies;

fn fuzz() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz")
}

/// Runs a target of texts on every input of its corpus; libFuzzer skips what is no UTF-8, and so does this.
fn replay(target: &str, body: fn(&str)) {
    replay_bytes(target, |bytes| std::str::from_utf8(bytes).into_iter().for_each(body));
}

/// Runs a target on every input of its corpus.
fn replay_bytes(target: &str, body: impl Fn(&[u8]) + std::panic::RefUnwindSafe) {
    let mut paths: Vec<PathBuf> =
        fuzz().join("corpus").join(target).read_dir().unwrap().map(|e| e.unwrap().path()).collect();
    paths.sort();
    assert!(paths.len() >= 20, "{} inputs for {target}", paths.len());
    let failed: Vec<_> = paths
        .iter()
        .filter(|path| {
            let bytes = std::fs::read(path).unwrap();
            std::panic::catch_unwind(|| body(&bytes)).is_err()
        })
        .collect();
    assert!(failed.is_empty(), "{target} fails on {failed:?}");
}

#[test]
fn every_text_of_the_corpus_is_a_scene_or_refused() {
    replay("scene", fuzz_bodies::scene::holds);
}

#[test]
fn every_line_of_the_corpus_is_answered() {
    replay("solve", fuzz_bodies::solve::holds);
}

#[test]
fn every_figure_of_the_corpus_is_drawn() {
    replay("render", fuzz_bodies::render::holds);
}

#[test]
fn every_choice_of_the_corpus_is_drawn() {
    replay_bytes("figure", fuzz_bodies::figure::holds);
}

#[test]
fn every_pair_of_the_corpus_has_one_answer_in_both_orders() {
    replay_bytes("pair", fuzz_bodies::pair::holds);
}

#[test]
fn every_file_of_the_corpus_is_compared() {
    replay_bytes("check", fuzz_bodies::check::holds);
}

/// Every word that a scene may hold.
fn words() -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    for rows in TABLES.iter().map(|t| t.fields.to_vec()).chain(KINDS.iter().map(shape_rows)) {
        for field in rows {
            words.insert(field.name.to_owned());
            match field.holds {
                Holds::Word { known, .. } => words.extend(known()),
                Holds::NumberOr { word, .. } | Holds::ColorOr(word) => {
                    words.insert(word.to_owned());
                }
                _ => {}
            }
        }
    }
    words.extend(Grip::words().map(str::to_owned));
    for layer in LAYERS {
        words.insert(layer.name.to_owned());
        words.extend(layer.labels.iter().map(|key| key.key.to_owned()));
        words.extend(COMMON.iter().chain(layer.options).flat_map(words_of_option));
    }
    words.extend(tracefig::figure::values().map(|(name, _)| format!("{{={name}}}")));
    words.extend(Role::OF_WORDS.map(|role| format!("{{{}|", role.name())));
    words.extend(THEMES.iter().map(|theme| theme.name.to_owned()));
    words
}

fn words_of_option(option: &OptionSpec) -> Vec<String> {
    let takes: &[&str] = match option.takes {
        Takes::Word(known) | Takes::Words(known) | Takes::When(known) => known,
        _ => &[],
    };
    std::iter::once(&option.name).chain(takes).map(|&word| word.to_owned()).collect()
}

/// With `TRACEFIG_WRITE` the dictionary is written anew.
#[test]
fn the_dictionary_of_the_fuzzer_has_every_word_of_a_scene() {
    let path = fuzz().join("tracefig.dict");
    let punctuation = [
        "[[",
        "]]",
        "[shapes.",
        "[query]\\x0A",
        "[[panels]]\\x0A",
        "[labels]\\x0A",
        "[canvas]\\x0A",
        " = ",
        "{ ",
        " }",
        "\\\"",
        "'''",
        "\\\\",
        "$",
        "{=",
        "true",
        "false",
        "1e300",
        "1e-300",
        "5e-324",
        "-0.0",
        "1e999",
        "nan",
        "-inf",
        "0x7f",
        "\\\\def",
        "\\\\frac{",
        "\\\\sqrt{",
        "\\\\left(",
        "\\\\begin{",
        "\\\\hat{",
        "\\\\text{",
    ];
    let mut wanted = String::from("# Written by `TRACEFIG_WRITE=1 cargo test --test scenes corpus`.\n");
    for word in words().iter().map(String::as_str).chain(punctuation) {
        writeln!(wanted, "\"{word}\"").unwrap();
    }
    if std::env::var_os("TRACEFIG_WRITE").is_some() {
        std::fs::write(&path, &wanted).unwrap();
    }
    assert!(std::fs::read_to_string(&path).unwrap_or_default() == wanted, "{} lacks words", path.display());
}
