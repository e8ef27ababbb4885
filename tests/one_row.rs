//! One file and one row: an output format, a shape kind, a theme and a command each stand in a file of their
//! own and in one table, and nothing else in `src/` knows them by name.
//!
//! What is asked about a format, a kind or a theme is a column of its table, so that a new one is made by
//! writing its file. Every string of every source file is read with `syn`, those inside macro calls and
//! attributes too; comments and tests may name what they like.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

/// A table whose rows are a file each.
struct Table {
    /// What a row is.
    what: &'static str,
    /// The folder of its files below `src/`.
    folder: &'static str,
    /// The constant that holds a row, one in each file; for commands there is none, and the table has the
    /// names.
    row: Option<&'static str>,
    /// The rows' names.
    names: Vec<String>,
    /// How a string of the source names a row.
    finds: fn(&str, &str) -> bool,
    /// Files where the same word says something else, with what it says there.
    other_meanings: &'static [(&'static str, &'static str, &'static str)],
}

/// The string is the name.
fn is_name(text: &str, name: &str) -> bool {
    text == name
}

/// The name is a word of the string: `"svg,png"` and `"image/png"` name formats too.
fn has_word(text: &str, name: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == name)
}

fn tables() -> Vec<Table> {
    let names = |all: &mut dyn Iterator<Item = &'static str>| all.map(str::to_owned).collect();
    vec![
        Table {
            what: "format",
            folder: "output",
            row: Some("FORMAT"),
            names: names(&mut tracefig::output::FORMATS.iter().map(|f| f.name)),
            finds: has_word,
            other_meanings: &[
                ("svg", "output/html.rs", "the element inside a page"),
                ("png", "output/mod.rs", "the option `--png`"),
                ("html", "cli/check.rs", "the page of findings, which is no figure"),
                ("html", "drift/report", "the page of findings, which is no figure"),
            ],
        },
        Table {
            what: "shape kind",
            folder: "geometry/shape",
            row: Some("KIND"),
            names: names(&mut tracefig::geometry::shape::KINDS.iter().map(|k| k.name)),
            finds: is_name,
            other_meanings: &[
                ("circle", "output/svg", "the element of SVG"),
                ("box", "figure/layer/bounds.rs", "the part of a figure that is a bounding box"),
                ("aabb", "collision", "the shape that the article compares extents of"),
            ],
        },
        Table {
            what: "theme",
            folder: "figure/theme",
            row: Some("THEME"),
            names: names(&mut tracefig::figure::theme::THEMES.iter().map(|t| t.name)),
            finds: is_name,
            other_meanings: &[],
        },
        Table {
            what: "command",
            folder: "cli",
            row: None,
            names: commands(),
            finds: is_name,
            other_meanings: &[
                ("trace", "drift/moved.rs", "a key of the metadata"),
                ("describe", "report/files.rs", "`git describe`"),
            ],
        },
    ]
}

/// The names in the table of commands, as `row::<…>("NAME", …)`.
fn commands() -> Vec<String> {
    struct Rows(Vec<String>);
    impl<'ast> Visit<'ast> for Rows {
        fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
            if let syn::Expr::Path(path) = &*call.func
                && path.path.segments.last().is_some_and(|s| s.ident == "row")
                && let Some(syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(name), .. })) = call.args.first()
            {
                self.0.push(name.value());
            }
            visit::visit_expr_call(self, call);
        }
    }
    let mut rows = Rows(Vec::new());
    rows.visit_file(&syn::parse_file(&fs::read_to_string(src().join("cli/mod.rs")).unwrap()).unwrap());
    rows.0
}

/// What one file says.
#[derive(Default)]
struct Strings {
    /// Every string with its line.
    found: Vec<(usize, String)>,
    /// Names of modules under `#[cfg(test)]`.
    test_modules: Vec<String>,
    /// Constants with a field `name` that is a string.
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
            let name = row.fields.iter().find(|f| matches!(&f.member, syn::Member::Named(n) if n == "name"));
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
    let mut paths = Vec::new();
    rust_files(&src(), &mut paths);
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

fn rust_files(folder: &Path, into: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            rust_files(&path, into);
        } else if path.extension().is_some_and(|e| e == "rs") {
            into.push(path);
        }
    }
}

fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
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
            if path.starts_with(&own) || listed || other {
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
