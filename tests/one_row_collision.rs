//! An algorithm is one file and one row, and so is a kind of question: each is named as its file is, and
//! nothing else in `src/` knows it by name.
//!
//! What the house has to know of an algorithm or a question is a column of its table, so that a new one is
//! made by writing its file. Every string of every source file is read with `syn`, those inside macro calls
//! too; docs and tests may name what they like. Where the same word means something else, [`HOMONYMS`] says
//! what.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

use tracefig::collision::{ALGORITHMS, QUERIES};

/// Rooms or files, as they begin, in which a word that is also an algorithm's or a question's means something
/// else.
const HOMONYMS: &[(&str, &str, &str)] = &[
    ("collision/answer.rs", "overlap", "a part of an answer"),
    ("collision/answer.rs", "separation", "a part of an answer"),
    ("drift/moved.rs", "circles", "words for an event"),
    ("drift/moved.rs", "extents", "words for an event"),
    ("figure", "arc", "a layer"),
    ("figure", "bounds", "a layer"),
    ("figure", "clamp", "a layer"),
    ("figure", "separation", "a layer, its labels, a value of texts"),
    ("output/samples.rs", "clamp", "a group of a sample drawing"),
];

/// A table whose rows are a file each.
struct Table {
    /// The folder of its files below `src/`.
    folder: &'static str,
    /// The constant in each file that is its row.
    row: &'static str,
    /// The names of its rows, in order.
    names: Vec<&'static str>,
}

fn tables() -> [Table; 2] {
    [
        Table {
            folder: "collision/algorithm",
            row: "ALGORITHM",
            names: ALGORITHMS.iter().map(|algorithm| algorithm.name).collect(),
        },
        Table {
            folder: "collision/query",
            row: "QUESTION",
            names: QUERIES.iter().map(|question| question.word).collect(),
        },
    ]
}

impl Table {
    /// The file of a row, from `src/`.
    fn file(&self, name: &str) -> String {
        format!("{}/{}.rs", self.folder, name.replace('-', "_"))
    }
}

/// What one file says outside its tests, docs and attributes.
#[derive(Default)]
struct Said {
    /// Its strings, each with its line.
    strings: Vec<(usize, String)>,
    /// Its constants.
    constants: Vec<String>,
    /// The number of variants of each of its enums.
    variants: BTreeMap<String, usize>,
}

impl Said {
    fn by(source: &str) -> Self {
        let mut said = Self::default();
        said.visit_file(&syn::parse_file(source).unwrap());
        said
    }

    fn tokens(&mut self, stream: TokenStream) {
        for token in stream {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Literal(literal) => {
                    let line = literal.span().start().line;
                    if let syn::Lit::Str(text) = syn::Lit::new(literal) {
                        self.strings.push((line, text.value()));
                    }
                }
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Said {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !item.attrs.iter().any(|attribute| attribute.path().is_ident("cfg")) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        self.constants.push(item.ident.to_string());
        visit::visit_item_const(self, item);
    }

    fn visit_item_enum(&mut self, item: &'ast syn::ItemEnum) {
        self.variants.insert(item.ident.to_string(), item.variants.len());
        visit::visit_item_enum(self, item);
    }

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}

    fn visit_lit_str(&mut self, text: &'ast syn::LitStr) {
        self.strings.push((text.span().start().line, text.value()));
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        self.tokens(mac.tokens.clone());
    }
}

/// What each file of `src/` says, by its path from there; files of tests are left out.
fn house() -> BTreeMap<String, Said> {
    fn visit(src: &Path, folder: &Path, into: &mut BTreeMap<String, Said>) {
        for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            let is_test = path.file_stem().is_some_and(|stem| stem == "tests");
            if path.is_dir() && !is_test {
                visit(src, &path, into);
            } else if path.extension().is_some_and(|e| e == "rs") && !is_test {
                let relative = path.strip_prefix(src).unwrap().to_string_lossy().replace('\\', "/");
                into.insert(relative, Said::by(&fs::read_to_string(&path).unwrap()));
            }
        }
    }
    let src: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut house = BTreeMap::new();
    visit(&src, &src, &mut house);
    house
}

/// Whether a word in a file is known to mean something else there.
fn is_homonym(file: &str, word: &str) -> bool {
    HOMONYMS.iter().any(|(place, known, _)| file.starts_with(place) && *known == word)
}

/// Where a file says one of these names and should not, as `FILE:LINE: "NAME"`.
fn named(file: &str, said: &Said, table: &Table) -> Vec<String> {
    let names = table.names.iter().filter(|name| table.file(name) != file && !is_homonym(file, name));
    let strings = |name| said.strings.iter().filter(move |(_, text)| text == name);
    names
        .flat_map(|name| strings(name).map(move |(line, _)| format!("src/{file}:{line}: \"{name}\"")))
        .collect()
}

#[test]
fn each_row_stands_in_a_file_of_its_name_and_each_such_file_is_a_row() {
    let house = house();
    for table in tables() {
        let has_row = |(_, said): &(&String, &Said)| said.constants.iter().any(|name| name == table.row);
        let in_folder = house.iter().filter(|(file, _)| file.starts_with(table.folder));
        let files: Vec<&String> = in_folder.filter(has_row).map(|(file, _)| file).collect();
        let mut expected: Vec<String> = table.names.iter().map(|name| table.file(name)).collect();
        expected.sort();
        assert_eq!(files, expected.iter().collect::<Vec<_>>(), "files with a row, and rows of the table");
        for name in &table.names {
            let said = &house[&table.file(name)];
            let count = said.strings.iter().filter(|(_, text)| text == name).count();
            assert_eq!(count, 1, "{} names {name:?} once, in its row", table.file(name));
        }
    }
}

#[test]
fn each_kind_of_question_has_its_row() {
    let variants = house()["collision/query/mod.rs"].variants["QueryKind"];
    assert_eq!(QUERIES.len(), variants);
    for question in QUERIES {
        assert_eq!(question.kind.question().word, question.word);
        let answered = ALGORITHMS.iter().any(|algorithm| algorithm.kinds.contains(&question.kind));
        assert!(answered, "no algorithm answers {}", question.word);
    }
}

#[test]
fn no_other_file_knows_an_algorithm_or_a_question_by_name() {
    let house = house();
    let tables = tables();
    let wrong: Vec<String> = house
        .iter()
        .flat_map(|(file, said)| tables.iter().flat_map(move |table| named(file, said, table)))
        .collect();
    assert!(wrong.is_empty(), "names of algorithms or questions:\n{}", wrong.join("\n"));
}

#[test]
fn every_homonym_stands_where_it_is_said_to() {
    let house = house();
    for (place, word, meaning) in HOMONYMS {
        let says = |said: &Said| said.strings.iter().any(|(_, text)| text == word);
        let stands = house.iter().any(|(file, said)| file.starts_with(place) && says(said));
        assert!(stands, "src/{place} no longer says {word:?} for {meaning}: take the row away");
        assert!(tables().iter().any(|table| table.names.contains(word)), "{word:?} is no name");
    }
}

#[test]
fn a_name_is_found_wherever_code_says_it_and_nowhere_else() {
    let [algorithms, _] = tables();
    let found = |source: &str| named("report/planted.rs", &Said::by(source), &algorithms).len();
    for source in [
        "fn f(name: &str) -> bool { name == \"gjk\" }",
        "const ITERATIVE: [&str; 1] = [\"gjk\"];",
        "fn f(name: &str) -> bool { matches!(name, \"gjk\") }",
        "mod inner { pub fn f() -> [&'static str; 1] { [\"gjk\"] } }",
    ] {
        assert_eq!(found(source), 1, "{source}");
    }
    for source in [
        "/// As \"gjk\" does.\nfn f() {}",
        "fn f() -> &'static str { \"gjk and more\" }",
        "#[cfg(test)]\nmod tests { fn f() -> &'static str { \"gjk\" } }",
    ] {
        assert_eq!(found(source), 0, "{source}");
    }
}
