//! The sources keep to the style of the house: public functions with an example that runs, docs that stand
//! alone in the index, a doc on every variant and field, files and lines that fit a screen.
//!
//! A failure lists every place as `file:line: what`.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod sources;

use std::fs;
use std::path::{Path, PathBuf};

use sources::{rust_files, src};
use syn::visit::{self, Visit};

/// Most columns of a line, comments included: what rustfmt is told for code.
const COLUMNS: usize = 110;
/// Most lines of a file.
const LINES: usize = 400;

/// Openings of a doc that lean on a neighbour, which the index of the docs does not show.
const LEANING: &[&str] =
    &["The same", "That", "Those", "These", "Of", "So many", "Here", "As", "See", "By the", "Not:"];

/// A place where a file leaves the style.
type Found = (usize, String);

/// Lines that are too long, and files.
fn sizes(source: &str) -> Vec<Found> {
    let lines = source.lines().count();
    let long = (lines > LINES).then(|| (LINES + 1, format!("the file has {lines} lines, {LINES} at most")));
    let wide = source.lines().zip(1..).filter_map(|(line, at)| {
        let columns = line.chars().count();
        (columns > COLUMNS).then(|| (at, format!("{columns} columns, {COLUMNS} at most")))
    });
    long.into_iter().chain(wide).collect()
}

/// Docs whose first sentence does not stand alone.
fn leaning(source: &str) -> Vec<Found> {
    let doc = |line: &str| {
        let line = line.trim_start();
        ["///", "//!"].into_iter().find(|mark| line.starts_with(mark)).filter(|_| !line.starts_with("////"))
    };
    let mut before = None;
    let mut found = Vec::new();
    for (line, at) in source.lines().zip(1..) {
        let mark = doc(line);
        if let Some(mark) = mark.filter(|_| before != mark) {
            let text = line.trim_start().trim_start_matches(mark).trim();
            let whole_word = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric());
            if let Some(opening) =
                LEANING.iter().find(|opening| text.strip_prefix(**opening).is_some_and(whole_word))
            {
                found.push((at, format!("a doc that begins with `{opening}` does not stand alone: {text}")));
            }
        }
        before = mark;
    }
    found
}

/// Docs whose first paragraph is a formula or a name alone: who does not know its letters learns nothing.
fn wordless(source: &str) -> Vec<Found> {
    let mut found = Vec::new();
    let mut paragraph: Option<(usize, String)> = None;
    let mut ended = false;
    for (line, at) in source.lines().chain([""]).zip(1..) {
        let line = line.trim_start();
        match ["///", "//!"].iter().find_map(|mark| line.strip_prefix(mark)) {
            Some(text) if paragraph.is_none() => paragraph = Some((at, text.to_owned())),
            Some(text) => {
                ended |= text.trim().is_empty();
                if let Some((_, first)) = paragraph.as_mut().filter(|_| !ended) {
                    *first += text;
                }
            }
            None => {
                if let Some((at, first)) = paragraph.take().filter(|(_, first)| !has_word(first)) {
                    found.push((at, format!("a doc without a word:{first}")));
                }
                ended = false;
            }
        }
    }
    found
}

/// Whether a text has a word of three letters outside of code.
fn has_word(text: &str) -> bool {
    let prose = text.split('`').step_by(2);
    prose.flat_map(|text| text.split(|c: char| !c.is_alphabetic())).any(|word| word.chars().count() > 2)
}

/// Reads the items of a file for docs that are missing.
struct Docs {
    found: Vec<Found>,
}

impl Docs {
    fn has_doc(attributes: &[syn::Attribute]) -> bool {
        attributes.iter().any(|attribute| attribute.path().is_ident("doc"))
    }

    /// A public function shows itself at work, in a doc test that runs and asserts.
    fn needs_example(
        &mut self,
        attributes: &[syn::Attribute],
        visibility: &syn::Visibility,
        name: &syn::Ident,
    ) {
        if !matches!(visibility, syn::Visibility::Public(_)) {
            return;
        }
        let wanted = match example(&text_of(attributes)) {
            Example::Asserts => return,
            Example::Missing => "has no example",
            Example::Idle => "has an example that asserts nothing, or is not run",
        };
        self.found.push((name.span().start().line, format!("`pub fn {name}` {wanted}")));
    }

    fn needs_doc(&mut self, attributes: &[syn::Attribute], name: &syn::Ident, what: &str) {
        if !Self::has_doc(attributes) {
            self.found.push((name.span().start().line, format!("{what} `{name}` has no doc")));
        }
    }
}

impl<'ast> Visit<'ast> for Docs {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.needs_example(&item.attrs, &item.vis, &item.sig.ident);
        if !is_for_tests(&item.attrs) {
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.needs_example(&item.attrs, &item.vis, &item.sig.ident);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_variant(&mut self, variant: &'ast syn::Variant) {
        self.needs_doc(&variant.attrs, &variant.ident, "variant");
        visit::visit_variant(self, variant);
    }

    /// Fields with a name; those of a tuple are said by the doc of what they are in.
    fn visit_field(&mut self, field: &'ast syn::Field) {
        if let Some(name) = &field.ident {
            self.needs_doc(&field.attrs, name, "field");
        }
    }
}

/// The text of a doc, a line of it a line.
fn text_of(attributes: &[syn::Attribute]) -> String {
    let mut text = String::new();
    for attribute in attributes {
        if let syn::Meta::NameValue(pair) = &attribute.meta
            && pair.path.is_ident("doc")
            && let syn::Expr::Lit(literal) = &pair.value
            && let syn::Lit::Str(line) = &literal.lit
        {
            text += &line.value();
            text.push('\n');
        }
    }
    text
}

/// What a doc shows of its function at work.
#[derive(Debug, PartialEq)]
enum Example {
    /// A doc test that runs and asserts.
    Asserts,
    /// A block of Rust that is not run, or asserts nothing.
    Idle,
    /// No block of Rust.
    Missing,
}

/// Looks at the blocks between fences; a fence without words is Rust that runs.
fn example(doc: &str) -> Example {
    let mut found = Example::Missing;
    for (info, body) in blocks(doc) {
        let words: Vec<&str> = info.split([',', ' ']).filter(|word| !word.is_empty()).collect();
        let known = ["rust", "should_panic", "no_run", "ignore", "compile_fail", "edition2024"];
        if !words.iter().all(|word| known.contains(word)) {
            continue;
        }
        let runs = !words.iter().any(|word| ["no_run", "ignore", "compile_fail"].contains(word));
        if runs && (body.contains("assert") || words.contains(&"should_panic")) {
            return Example::Asserts;
        }
        found = Example::Idle;
    }
    found
}

/// The words after each opening fence, and the block up to the closing one.
fn blocks(doc: &str) -> Vec<(String, String)> {
    let mut blocks = Vec::new();
    let mut open: Option<(String, String)> = None;
    for line in doc.lines() {
        match (line.trim().strip_prefix("```"), &mut open) {
            (Some(info), None) => open = Some((info.to_owned(), String::new())),
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (None, Some((_, body))) => *body += line,
            (None, None) => {}
        }
    }
    blocks
}

/// Whether an item is compiled for tests only.
fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        syn::Meta::Path(path) => path.is_ident("test"),
        syn::Meta::NameValue(_) => false,
    })
}

/// Docs that are missing in a file.
fn missing_docs(source: &str) -> Vec<Found> {
    let file = match syn::parse_file(source) {
        Ok(file) => file,
        Err(error) => return vec![(error.span().start().line, error.to_string())],
    };
    let mut docs = Docs { found: Vec::new() };
    docs.visit_file(&file);
    docs.found
}

/// The files and folders that a file declares as modules of tests: `#[cfg(test)] mod name;`.
fn modules_of_tests(path: &Path, source: &str) -> Vec<PathBuf> {
    let Ok(file) = syn::parse_file(source) else { return Vec::new() };
    let stem = path.file_stem().unwrap();
    let folder = match path.parent().unwrap() {
        parent if ["mod", "lib", "main"].iter().any(|name| stem == *name) => parent.to_path_buf(),
        parent => parent.join(stem),
    };
    let declared = file.items.iter().filter_map(|item| match item {
        syn::Item::Mod(module) if module.content.is_none() && is_for_tests(&module.attrs) => {
            Some(module.ident.to_string())
        }
        _ => None,
    });
    declared.flat_map(|name| [folder.join(format!("{name}.rs")), folder.join(name)]).collect()
}

/// What a page gets beside the crate: the module and its scripts.
fn of_the_page() -> Vec<PathBuf> {
    let live = src().with_file_name("live");
    let entries = fs::read_dir(&live).unwrap().map(|entry| entry.unwrap().path());
    let is_script = |path: &PathBuf| path.extension().is_some_and(|end| end == "js" || end == "mjs");
    let mut files: Vec<_> = entries.filter(is_script).collect();
    files.sort();
    files.extend(rust_files(&live.join("module").join("src")));
    assert!(files.len() > 2, "{files:?}");
    files
}

/// Which files a rule is for.
#[derive(Clone, Copy, PartialEq)]
enum Files {
    /// All of them, those of the page too.
    All,
    /// Those that are in the library or the binary, not those of tests only.
    Built,
}

/// Holds a rule over the files of `src/` and of a live page.
#[track_caller]
fn hold(rule: fn(&str) -> Vec<Found>, over: Files) {
    let page = if over == Files::All { of_the_page() } else { Vec::new() };
    let files: Vec<(PathBuf, String)> = rust_files(&src())
        .into_iter()
        .chain(page)
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap()))
        .collect();
    let of_tests: Vec<PathBuf> = match over {
        Files::All => Vec::new(),
        Files::Built => files.iter().flat_map(|(path, text)| modules_of_tests(path, text)).collect(),
    };
    let mut report = Vec::new();
    for (path, text) in &files {
        if of_tests.iter().any(|other| path.starts_with(other)) {
            continue;
        }
        let shown = path.strip_prefix(src().parent().unwrap()).unwrap().display();
        report.extend(rule(text).into_iter().map(|(line, what)| format!("{shown}:{line}: {what}")));
    }
    assert!(report.is_empty(), "{} places:\n{}", report.len(), report.join("\n"));
}

#[test]
fn files_and_lines_fit() {
    hold(sizes, Files::All);
}

#[test]
fn every_doc_stands_alone_in_the_index() {
    hold(leaning, Files::All);
}

#[test]
fn every_doc_says_something_in_words() {
    hold(wordless, Files::All);
}

#[test]
fn public_functions_have_an_example_and_variants_and_fields_a_doc() {
    hold(missing_docs, Files::Built);
}

/// The lines at which a rule finds something.
fn lines(rule: fn(&str) -> Vec<Found>, source: &str) -> Vec<usize> {
    rule(source).into_iter().map(|(line, _)| line).collect()
}

#[test]
fn a_planted_long_line_and_a_planted_long_file_are_found() {
    let wide = format!("// {}\n// {}\n", "é".repeat(107), "é".repeat(108));
    assert_eq!(lines(sizes, &wide), [2]);
    assert_eq!(lines(sizes, &"\n".repeat(400)), [0; 0]);
    assert_eq!(lines(sizes, &"\n".repeat(401)), [401]);
}

#[test]
fn a_planted_leaning_doc_is_found() {
    let source =
        "/// Of most.\nstruct A;\n/// Often.\nstruct B {\n    /// The same, longer.\n    x: f64,\n}\n";
    assert_eq!(lines(leaning, source), [1, 5]);
    let second = "/// A gap.\n/// That of this edge.\nstruct A;\n// As ever.\n//! See below.\n";
    assert_eq!(lines(leaning, second), [5]);
}

#[test]
fn a_planted_doc_without_a_word_is_found() {
    let source = "/// |x|.\nfn a() {}\n/// `[labels]`: texts by key.\n\n/// K: at\n/// least f\nfn b() {}\n";
    assert_eq!(lines(wordless, source), [1]);
    assert_eq!(lines(wordless, "/// `hi`\n///\n/// With words.\nx: f64,\n"), [1]);
}

#[test]
fn a_planted_function_without_an_example_is_found() {
    let shown = "/// One.\n///\n/// ```\n/// assert_eq!(x::one(), 1);\n/// ```\npub fn one() {}\n";
    assert_eq!(lines(missing_docs, shown), [0; 0]);
    assert_eq!(lines(missing_docs, &shown.replace("assert_eq", "println")), [6]);
    assert_eq!(lines(missing_docs, &shown.replacen("```", "```text", 1)), [6]);
    assert_eq!(lines(missing_docs, &shown.replacen("```", "```no_run", 1)), [6]);
    assert_eq!(lines(missing_docs, "/// Two.\npub fn two() {}\n"), [2]);
    assert_eq!(lines(missing_docs, "impl A {\n    pub fn two() {}\n    pub(crate) fn three() {}\n}\n"), [2]);
    assert_eq!(lines(missing_docs, "impl Trait for A {\n    fn two() {}\n}\n"), [0; 0]);
}

#[test]
fn a_planted_variant_or_field_without_a_doc_is_found() {
    let source = "enum A {\n    One,\n    /// Two.\n    Two {\n        x: f64,\n    },\n}\nstruct B(f64);\n";
    assert_eq!(lines(missing_docs, source), [2, 5]);
    let tests = format!("#[cfg(test)]\nmod tests {{\n{source}}}\n");
    assert_eq!(lines(missing_docs, &tests), [0; 0]);
}

#[test]
fn a_module_of_tests_is_known_by_its_declaration() {
    let found = modules_of_tests(Path::new("src/a/mod.rs"), "#[cfg(test)]\nmod tests;\nmod b;\n");
    assert_eq!(found, [Path::new("src/a/tests.rs"), Path::new("src/a/tests")]);
    let beside = modules_of_tests(Path::new("src/a/b.rs"), "#[cfg(test)]\nmod tests;\n");
    assert_eq!(beside[0], Path::new("src/a/b/tests.rs"));
}
