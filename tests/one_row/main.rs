//! One file and one row: an output format, a shape kind, a theme, a layer, an algorithm, a question and a
//! command each stand in a file of their own and in one table, and nothing else in `src/` knows them by name.
//!
//! What is asked about a format, a kind or a theme is a column of its table, so that a new one is made by
//! writing its file. Every string of every source file is read with `syn`, those inside macro calls and
//! attributes too; comments and tests may name what they like.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../sources/mod.rs"]
mod sources;
mod tables;

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

use tracefig::collision::{ALGORITHMS, QUERIES};
use tracefig::figure::theme::THEMES;

use sources::{rust_files, src};
use tables::{Table, has_word, tables};

/// What one file says.
#[derive(Default)]
struct Strings {
    /// Every string with its line.
    found: Vec<(usize, String)>,
    /// Names of modules under `#[cfg(test)]`.
    test_modules: Vec<String>,
    /// Constants with a field `name` or `word` that is a string.
    rows: Vec<(String, String)>,
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| {
        let says_test = |list: &syn::MetaList| list.tokens.to_string().split(' ').any(|word| word == "test");
        a.path().is_ident("test") || (a.path().is_ident("cfg") && a.meta.require_list().is_ok_and(says_test))
    })
}

impl Strings {
    fn literal(&mut self, literal: &proc_macro2::Literal) {
        if let Ok(text) = syn::parse_str::<syn::LitStr>(&literal.to_string()) {
            self.found.push((literal.span().start().line, text.value()));
        }
    }

    fn tokens(&mut self, stream: TokenStream) {
        for token in stream {
            match token {
                TokenTree::Literal(literal) => self.literal(&literal),
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(_) | TokenTree::Punct(_) => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Strings {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if is_test(&item.attrs) {
            self.test_modules.push(item.ident.to_string());
        } else {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if !is_test(&item.attrs) {
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        if let syn::Expr::Struct(row) = &*item.expr {
            let name = row
                .fields
                .iter()
                .find(|f| matches!(&f.member, syn::Member::Named(n) if n == "name" || n == "word"));
            if let Some(syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(name), .. })) = name.map(|f| &f.expr)
            {
                self.rows.push((item.ident.to_string(), name.value()));
            }
        }
        visit::visit_item_const(self, item);
    }

    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        if let syn::Meta::List(list) = &attribute.meta {
            self.tokens(list.tokens.clone());
        }
    }

    fn visit_lit_str(&mut self, text: &'ast syn::LitStr) {
        self.found.push((text.span().start().line, text.value()));
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        self.tokens(mac.tokens.clone());
    }
}

fn strings_of(source: &str) -> Strings {
    let mut strings = Strings::default();
    strings.visit_file(&syn::parse_file(source).unwrap());
    strings
}

/// Every file of `src/` that is not for tests only, below `src/`, with its strings.
fn house() -> Vec<(PathBuf, Strings)> {
    let paths = rust_files(&src());
    let read = |path: &PathBuf| {
        let relative = path.strip_prefix(src()).unwrap().to_path_buf();
        (relative, strings_of(&fs::read_to_string(path).unwrap()))
    };
    let mut files: Vec<(PathBuf, Strings)> = paths.iter().map(read).collect();
    let mut tests: Vec<PathBuf> = Vec::new();
    for (path, strings) in &files {
        let stem = path.file_stem().unwrap();
        let own = if stem == "mod" || stem == "lib" {
            path.parent().unwrap().to_path_buf()
        } else {
            path.with_extension("")
        };
        tests.extend(strings.test_modules.iter().map(|module| own.join(module)));
    }
    files.retain(|(path, _)| {
        !tests.iter().any(|test| path.with_extension("") == *test || path.starts_with(test))
    });
    files
}

/// Where a row's file is: itself, or its folder where it is the folder's `mod.rs`.
fn own_place(table: &Table, name: &str, house: &[(PathBuf, Strings)]) -> Result<PathBuf, String> {
    let is_row = |(constant, row): &(String, String)| Some(constant.as_str()) == table.row && row == name;
    let own: Vec<&Path> = house
        .iter()
        .filter(|(path, strings)| match table.row {
            Some(_) => path.starts_with(table.folder) && strings.rows.iter().any(is_row),
            None => *path == Path::new(table.folder).join(name).with_extension("rs"),
        })
        .map(|(path, _)| path.as_path())
        .collect();
    match own[..] {
        [path] if path.ends_with("mod.rs") => Ok(path.parent().unwrap().to_path_buf()),
        [path] => Ok(path.to_path_buf()),
        _ => Err(format!("{} `{name}`: expected one file with its row, got {own:?}", table.what)),
    }
}

/// What says which row is meant by a word of another tool, as `circle` by `disc`.
const WORDS_OF_OTHERS: [&str; 2] = ["scene/meant.rs", "scene/suggest.rs"];

/// Strings that name a row outside its own place.
fn strangers(table: &Table, house: &[(PathBuf, Strings)]) -> Vec<String> {
    let mut wrong = Vec::new();
    for name in &table.names {
        let own = match own_place(table, name, house) {
            Ok(own) => own,
            Err(message) => {
                wrong.push(message);
                continue;
            }
        };
        let in_table = Path::new(table.folder).join("mod.rs");
        for (path, strings) in house {
            let listed = table.row.is_none() && *path == in_table;
            let other = table.other_meanings.iter().any(|(n, file, _)| n == name && path.starts_with(file));
            if path.starts_with(&own)
                || listed
                || other
                || WORDS_OF_OTHERS.iter().any(|of| path == Path::new(of))
            {
                continue;
            }
            for (line, text) in strings.found.iter().filter(|(_, text)| (table.finds)(text, name)) {
                wrong.push(format!("src/{}:{line}: {} `{name}` in {text:?}", path.display(), table.what));
            }
        }
    }
    wrong
}

/// Files of a folder that hold a row which the library's table does not list.
fn unlisted(table: &Table, house: &[(PathBuf, Strings)]) -> Vec<String> {
    let files = house.iter().filter(|(path, _)| path.starts_with(table.folder));
    let rows = files.flat_map(|(path, strings)| strings.rows.iter().map(move |row| (path, row)));
    rows.filter(|(_, (constant, name))| Some(constant.as_str()) == table.row && !table.names.contains(name))
        .map(|(path, (_, name))| format!("src/{}: `{name}` is in no table", path.display()))
        .collect()
}

#[test]
fn nothing_but_its_own_file_knows_a_row_by_its_name() {
    let house = house();
    let wrong: Vec<String> = tables().iter().flat_map(|table| strangers(table, &house)).collect();
    assert!(wrong.is_empty(), "known by name:\n{}", wrong.join("\n"));
}

#[test]
fn every_row_is_in_its_table() {
    let house = house();
    let wrong: Vec<String> = tables().iter().flat_map(|table| unlisted(table, &house)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(tables().iter().all(|table| table.names.len() > 3), "the tables are read");
}

#[test]
fn another_meaning_that_is_said_nowhere_is_taken_out() {
    let house = house();
    for table in tables() {
        for (name, file, meaning) in table.other_meanings {
            let files = house.iter().filter(|(path, _)| path.starts_with(file));
            let mut texts = files.flat_map(|(_, strings)| &strings.found);
            assert!(texts.any(|(_, text)| (table.finds)(text, name)), "{file} no longer says {meaning}");
        }
    }
}

#[test]
fn a_planted_name_is_found_wherever_it_stands_in_code_and_nowhere_else() {
    let found = |source: &str| {
        let texts = strings_of(source).found.into_iter().map(|(_, text)| text);
        texts.filter(|text| has_word(text, "svg")).count()
    };
    for source in [
        r#"fn f(x: &str) -> bool { x == "svg" }"#,
        r#"fn f(x: &str) -> u8 { match x { "svg" => 1, _ => 2 } }"#,
        r#"fn f() { let x = format!("{} svg", 1); }"#,
        r#"fn f() { g!({ ["a", "svg,png"] }) }"#,
        r#"struct S { #[arg(default_value = "svg,png")] x: u8 }"#,
        r#"const X: [&str; 1] = ["image/svg+xml"];"#,
    ] {
        assert_eq!(found(source), 1, "{source}");
    }
    for source in [
        "/// An \"svg\" file.\nfn f() {}",
        r#"fn f() { let svg = "svgs"; }"#,
        r#"#[cfg(test)] mod tests { const X: &str = "svg"; }"#,
        r#"#[test] fn f() { g("svg"); }"#,
    ] {
        assert_eq!(found(source), 0, "{source}");
    }
}

#[test]
fn a_file_of_a_layer_an_algorithm_or_a_question_bears_the_name_of_its_row() {
    let house = house();
    for table in
        tables().iter().filter(|table| ["layer", "picture", "algorithm", "question"].contains(&table.what))
    {
        for name in &table.names {
            let own = own_place(table, name, &house).unwrap();
            let expected = Path::new(table.folder).join(name.replace('-', "_")).with_extension("rs");
            assert_eq!(own, expected, "{} `{name}`", table.what);
            let (_, said) = house.iter().find(|(path, _)| *path == own).unwrap();
            let count = said.found.iter().filter(|(_, text)| text == name).count();
            assert!(count == 1 || table.what == "layer", "{} `{name}` is named once, in its row", table.what);
        }
    }
}

#[test]
fn each_kind_of_question_has_its_row_and_an_algorithm_that_answers_it() {
    let file = syn::parse_file(&fs::read_to_string(src().join("collision/query/mod.rs")).unwrap()).unwrap();
    let variants = file.items.iter().find_map(|item| match item {
        syn::Item::Enum(item) if item.ident == "QueryKind" => Some(item.variants.len()),
        _ => None,
    });
    assert_eq!(variants, Some(QUERIES.len()));
    for question in QUERIES {
        assert_eq!(question.kind.question().word, question.word);
        let answered = ALGORITHMS.iter().any(|algorithm| algorithm.kinds.contains(&question.kind));
        assert!(answered, "no algorithm answers {}", question.word);
    }
}

#[test]
fn the_default_theme_is_the_first_row() {
    let house = house();
    let default = tables().into_iter().find(|table| table.what == "theme").unwrap();
    assert_eq!(THEMES[0].name, default.names[0]);
    assert_eq!(strangers(&default, &house), Vec::<String>::new());
}
