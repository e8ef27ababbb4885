//! A layer is one file and one row: its name stands as a string in its own file and in no other of `src/`.
//!
//! Whoever needs to know something of a layer by its name would have to be found and changed with it. Where
//! the same word means something else, as the kind of query `separation`, [`HOMONYMS`] says what.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

use tracefig::figure::layer::LAYERS;
use tracefig::figure::theme::THEMES;

/// Rooms or files, as they begin, in which a word that is also a layer's name means something else.
const HOMONYMS: &[(&str, &str, &str)] = &[
    ("cli/list.rs", "shapes", "a topic of `list`"),
    ("collision", "arc", "an algorithm"),
    ("collision", "bounds", "a kind of query"),
    ("collision", "clamp", "an algorithm"),
    ("collision/answer.rs", "normal", "a part of an answer"),
    ("collision", "separation", "a kind of query"),
    ("drawing/paint.rs", "difference", "a colour role"),
    ("drawing/paint.rs", "translation", "a colour role"),
    ("drift/moved.rs", "ray", "words for an event"),
    ("figure/layer/advancement.rs", "closest", "a label and a part of the drawing"),
    ("figure/layer/advancement.rs", "normal", "a part of the drawing"),
    ("figure/layer/arc.rs", "radii", "a part of the drawing"),
    ("figure/layer/axis_gaps.rs", "axes", "an option"),
    ("figure/layer/normal.rs", "contact", "a word of an option"),
    ("figure/layer/simplex.rs", "closest", "a label and a part of the drawing"),
    ("figure/layer/velocity.rs", "contact", "a word of an option"),
    ("figure/text/values.rs", "radii", "a value"),
    ("figure/text/values.rs", "separation", "a value"),
    ("output/samples.rs", "clamp", "a group of a sample drawing"),
    ("output/samples.rs", "difference", "a group of a sample drawing"),
    ("output/samples.rs", "ghosts", "a group of a sample drawing"),
    ("output/samples.rs", "shapes", "a group of a sample drawing"),
    ("scene", "frame", "a key of a panel"),
    ("scene", "shapes", "a table of a scene"),
    ("scene", "velocity", "a key of a shape"),
];

/// The strings of a file, without those of its tests, docs and attributes.
#[derive(Default)]
struct Strings {
    found: Vec<(usize, String)>,
}

impl Strings {
    fn tokens(&mut self, stream: TokenStream) {
        for token in stream {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Literal(literal) => {
                    let line = literal.span().start().line;
                    if let syn::Lit::Str(text) = syn::Lit::new(literal) {
                        self.found.push((line, text.value()));
                    }
                }
                _ => {}
            }
        }
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| a.path().is_ident("cfg") || a.path().is_ident("test"))
}

impl<'ast> Visit<'ast> for Strings {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}

    fn visit_lit_str(&mut self, text: &'ast syn::LitStr) {
        self.found.push((text.span().start().line, text.value()));
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        self.tokens(mac.tokens.clone());
    }
}

fn rust_files(folder: &Path, into: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            rust_files(&path, into);
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
            into.push(path);
        }
    }
}

/// Every string of `src/` with the file, from there, and the line in which it stands.
fn strings() -> Vec<(String, usize, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&src, &mut files);
    let mut all = Vec::new();
    for file in files {
        let relative = file.strip_prefix(&src).unwrap().to_string_lossy().replace('\\', "/");
        let mut strings = Strings::default();
        strings.visit_file(&syn::parse_file(&fs::read_to_string(&file).unwrap()).unwrap());
        all.extend(strings.found.into_iter().map(|(line, text)| (relative.clone(), line, text)));
    }
    all
}

#[test]
fn the_name_of_a_layer_stands_in_its_own_file_only() {
    let strings = strings();
    let mut wrong = Vec::new();
    for layer in LAYERS {
        let own = format!("figure/layer/{}.rs", layer.name.replace('-', "_"));
        assert!(strings.iter().any(|(file, _, text)| *file == own && text == layer.name), "{own} has no row");
        for (file, line, _) in strings.iter().filter(|(file, _, text)| *file != own && text == layer.name) {
            if !HOMONYMS.iter().any(|(known, word, _)| file.starts_with(known) && *word == layer.name) {
                wrong.push(format!("src/{file}:{line}: \"{}\"", layer.name));
            }
        }
    }
    assert!(wrong.is_empty(), "names of layers:\n{}", wrong.join("\n"));
}

#[test]
fn every_homonym_still_stands_where_it_is_said_to() {
    let strings = strings();
    for (file, word, meaning) in HOMONYMS {
        let stands = strings.iter().any(|(known, _, text)| known.starts_with(file) && text == word);
        assert!(stands, "src/{file} no longer says {word:?} for {meaning}: take the row away");
        assert!(LAYERS.iter().any(|layer| layer.name == *word), "{word:?} is no layer: take the row away");
    }
}

#[test]
fn the_default_theme_is_the_first_row_and_is_named_in_its_own_file_only() {
    let default = THEMES[0].name;
    let own = format!("figure/theme/{default}.rs");
    let elsewhere: Vec<_> =
        strings().into_iter().filter(|(file, _, text)| text == default && *file != own).collect();
    assert!(elsewhere.is_empty(), "{elsewhere:?}");
}
