//! The house stands as designed: each room of `src/` uses only the rooms that its row allows.
//!
//! Every path of every source file is read with `syn`: `use` trees, paths in expressions, types and patterns, paths
//! inside macro calls, `super::` chains from nested modules. A room re-exports only what is its own, so that no arrow
//! can go round through a neighbour, and nothing but `cli` speaks to the library's root.
//!
//! A room may have rooms within it, with rows of their own. A module obeys the longest row that it is in: an inner row
//! forbids what the outer one allows, the outer room's own items included. A room may always use what lies within it.
//! Test code, modules named `tests`, obeys the outermost row alone.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// A room, as its path below `src/`, and the rooms that it may use with all that is within them.
type Row = (&'static str, &'static [&'static str]);

/// The rooms of the house. These are all the arrows there are.
const ROOMS: &[Row] = &[
    ("geometry", &[]),
    ("trace", &["geometry"]),
    ("collision", &["geometry", "trace"]),
    ("scene", &["geometry", "collision"]),
    ("typeset", &[]),
    ("drawing", &["typeset"]),
    ("figure", &["geometry", "trace", "collision", "scene", "typeset", "drawing"]),
    ("output", &["drawing", "typeset"]),
    ("drift", &["scene", "trace", "figure", "drawing", "output"]),
    ("report", &["geometry", "trace", "collision", "scene", "typeset", "drawing", "figure", "output"]),
    // Speaks to the library from outside, as `tracefig::…`, so it sees the public API and no more.
    ("cli", &[]),
];

/// Whether a module or an item, given as the segments of its path, is a room or lies within it.
fn is_within(path: &[String], room: &str) -> bool {
    let mut at = path.iter();
    room.split('/').all(|segment| at.next().is_some_and(|own| own == segment))
}

/// The row that a module obeys.
fn row_of(module: &[String]) -> Option<&'static Row> {
    let is_test = module.iter().any(|segment| segment == "tests");
    let rows = ROOMS.iter().filter(|(room, _)| is_within(module, room) && !(is_test && room.contains('/')));
    rows.max_by_key(|(room, _)| room.len())
}

/// A path that leaves its room.
#[derive(Debug, PartialEq)]
struct Wrong {
    line: usize,
    what: String,
}

/// Reads the paths of one file.
struct Reader {
    /// Module path from the crate root, inline modules included.
    module: Vec<String>,
    wrong: Vec<Wrong>,
}

impl Reader {
    /// Judges a path given as its segments. `public` marks a re-export.
    fn judge(&mut self, segments: &[String], line: usize, public: bool) {
        let Some(what) = self.what_is_wrong_with(segments, public) else { return };
        self.wrong.push(Wrong { line, what: format!("`{}`{what}", segments.join("::")) });
    }

    /// What a path does against the design, if anything.
    fn what_is_wrong_with(&self, segments: &[String], public: bool) -> Option<String> {
        let path = self.resolve(segments)?;
        if path.is_empty() {
            return Some(" takes in the crate's root".into());
        }
        let Some((room, allowed)) = row_of(&self.module) else {
            return Some(" is used outside any room".into());
        };
        if is_within(&path, room) {
            return None;
        }
        let Some((target, _)) = row_of(&path) else { return Some(" goes through the crate's root".into()) };
        if !allowed.iter().any(|other| is_within(&path, other)) {
            Some(format!(": {room} may not use {target}"))
        } else if public {
            Some(format!(": {room} re-exports what is {target}'s"))
        } else {
            None
        }
    }

    /// Segments from the crate's root, or None for a path that does not start in this crate.
    fn resolve(&self, segments: &[String]) -> Option<Vec<String>> {
        let mut rest = segments;
        let mut base = match rest.first()?.as_str() {
            "tracefig" if is_within(&self.module, "cli") => return None,
            "crate" | "tracefig" => {
                rest = &rest[1..];
                Vec::new()
            }
            "self" => {
                rest = &rest[1..];
                self.module.clone()
            }
            "super" => self.module.clone(),
            _ => return None,
        };
        while rest.first().is_some_and(|s| s == "super") {
            base.pop();
            rest = &rest[1..];
        }
        base.extend(rest.iter().filter(|s| *s != "*" && *s != "self").cloned());
        Some(base)
    }

    fn use_tree(&mut self, prefix: &[String], tree: &syn::UseTree, line: usize, public: bool) {
        let mut path = prefix.to_vec();
        match tree {
            syn::UseTree::Path(p) => {
                path.push(p.ident.to_string());
                self.use_tree(&path, &p.tree, line, public);
            }
            syn::UseTree::Name(n) => {
                path.push(n.ident.to_string());
                self.judge(&path, line, public);
            }
            syn::UseTree::Rename(r) => {
                path.push(r.ident.to_string());
                self.judge(&path, line, public);
            }
            syn::UseTree::Glob(_) => {
                path.push("*".into());
                self.judge(&path, line, public);
            }
            syn::UseTree::Group(g) => {
                for tree in &g.items {
                    self.use_tree(&path, tree, line, public);
                }
            }
        }
    }

    /// Paths in the tokens of a macro call.
    fn tokens(&mut self, stream: TokenStream) {
        let mut path: Vec<String> = Vec::new();
        let mut line = 0;
        let mut colons = 0;
        for token in stream {
            match token {
                TokenTree::Ident(ident) => {
                    if colons != 2 {
                        self.end_of_path(&mut path, line);
                    }
                    line = ident.span().start().line;
                    path.push(ident.to_string());
                    colons = 0;
                }
                TokenTree::Punct(p) if p.as_char() == ':' => colons += 1,
                TokenTree::Group(group) => {
                    self.end_of_path(&mut path, line);
                    colons = 0;
                    self.tokens(group.stream());
                }
                _ => {
                    self.end_of_path(&mut path, line);
                    colons = 0;
                }
            }
        }
        self.end_of_path(&mut path, line);
    }

    fn end_of_path(&mut self, path: &mut Vec<String>, line: usize) {
        if path.len() > 1 {
            self.judge(path, line, false);
        }
        path.clear();
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        self.module.push(item.ident.to_string());
        visit::visit_item_mod(self, item);
        self.module.pop();
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        let public = !matches!(item.vis, syn::Visibility::Inherited);
        self.use_tree(&[], &item.tree, item.span().start().line, public);
    }

    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let segments: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
        if segments.len() > 1 {
            self.judge(&segments, path.span().start().line, false);
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        self.tokens(mac.tokens.clone());
        visit::visit_macro(self, mac);
    }
}

/// Module path of a file below `src/`.
fn module_of(relative: &Path) -> Vec<String> {
    let mut parts: Vec<String> =
        relative.with_extension("").iter().map(|p| p.to_string_lossy().into_owned()).collect();
    if parts.last().is_some_and(|p| p == "mod") {
        parts.pop();
    }
    parts
}

/// What is wrong with one source file of a room.
fn wrong_arrows(relative: &Path, source: &str) -> Vec<Wrong> {
    let module = module_of(relative);
    if row_of(&module).is_none() {
        return vec![Wrong { line: 1, what: format!("{} is in no room of the design", relative.display()) }];
    }
    let file = match syn::parse_file(source) {
        Ok(file) => file,
        Err(error) => return vec![Wrong { line: error.span().start().line, what: error.to_string() }],
    };
    let mut reader = Reader { module, wrong: Vec::new() };
    reader.visit_file(&file);
    reader.wrong
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

#[test]
fn every_arrow_is_one_of_the_design() {
    let mut files = Vec::new();
    rust_files(&src(), &mut files);
    let mut report = Vec::new();
    for file in files {
        let relative = file.strip_prefix(src()).unwrap().to_path_buf();
        if relative == Path::new("lib.rs") || relative == Path::new("main.rs") {
            continue;
        }
        let source = fs::read_to_string(&file).unwrap();
        for wrong in wrong_arrows(&relative, &source) {
            report.push(format!("src/{}:{}: {}", relative.display(), wrong.line, wrong.what));
        }
    }
    assert!(report.is_empty(), "wrong arrows:\n{}", report.join("\n"));
}

#[test]
fn the_rooms_of_the_design_are_the_folders_of_src() {
    let mut folders: Vec<String> = fs::read_dir(src())
        .unwrap()
        .map(|e| e.unwrap())
        .filter(|e| e.path().is_dir())
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    folders.sort();
    let mut rooms: Vec<&str> =
        ROOMS.iter().map(|(room, _)| *room).filter(|room| !room.contains('/')).collect();
    rooms.sort_unstable();
    assert_eq!(folders, rooms);
}

#[test]
fn every_room_that_a_row_names_is_there_and_has_one_row_at_most() {
    for (k, (room, allowed)) in ROOMS.iter().enumerate() {
        for named in allowed.iter().chain([room]) {
            let path = src().join(named);
            assert!(path.is_dir() || path.with_extension("rs").is_file(), "{room}: no {named} in src/");
        }
        assert!(ROOMS[..k].iter().all(|(other, _)| other != room), "{room} has two rows");
    }
}

#[test]
fn a_module_named_tests_is_compiled_for_tests_only() {
    let mut files = Vec::new();
    rust_files(&src(), &mut files);
    for file in files {
        let source = fs::read_to_string(&file).unwrap();
        let wrong = modules_of_tests_for_all(&source);
        assert_eq!(wrong, 0, "{}: `mod tests` without `#[cfg(test)]`", file.display());
    }
    assert_eq!(modules_of_tests_for_all("#[cfg(test)] mod tests; mod a { #[cfg(test)] mod tests {} }"), 0);
    assert_eq!(modules_of_tests_for_all("mod tests; mod a { pub mod tests {} }"), 2);
}

/// How many modules named `tests` a file has that are part of the library.
fn modules_of_tests_for_all(source: &str) -> usize {
    struct Modules(usize);
    impl<'ast> Visit<'ast> for Modules {
        fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
            let is_for_tests = |attribute: &syn::Attribute| {
                attribute.path().is_ident("cfg")
                    && attribute.parse_args::<syn::Path>().is_ok_and(|flag| flag.is_ident("test"))
            };
            let is_part = item.ident == "tests" && !item.attrs.iter().any(is_for_tests);
            self.0 += usize::from(is_part);
            visit::visit_item_mod(self, item);
        }
    }
    let mut modules = Modules(0);
    modules.visit_file(&syn::parse_file(source).unwrap());
    modules.0
}

#[test]
fn main_does_nothing_but_hand_over_to_cli() {
    let main = fs::read_to_string(src().join("main.rs")).unwrap();
    assert!(main.lines().count() < 12 && main.contains("cli::run()"), "{main}");
}

/// Plants source in a file and expects exactly one wrong arrow.
fn planted(file: &str, source: &str) {
    let wrong = wrong_arrows(Path::new(file), source);
    assert_eq!(wrong.len(), 1, "{source}: {wrong:?}");
}

/// Source that keeps to the arrows.
fn fine(file: &str, source: &str) {
    let wrong = wrong_arrows(Path::new(file), source);
    assert!(wrong.is_empty(), "{source}: {wrong:?}");
}

#[test]
fn a_planted_use_is_found() {
    planted("geometry/shape/circle.rs", "use crate::collision::Query;");
    planted("trace/mod.rs", "use crate::{geometry::DVec2, scene::Scene};");
    planted("collision/gjk.rs", "use crate::figure as f;");
    planted("drift/mod.rs", "use crate::geometry::*;");
    fine("trace/mod.rs", "use crate::{geometry::{DVec2, Side}}; use std::fmt;");
}

#[test]
fn a_planted_inline_path_is_found() {
    planted("geometry/mod.rs", "fn f() -> crate::trace::Event { loop {} }");
    planted("output/svg.rs", "fn f() { let x = crate::scene::load(); }");
    planted("output/svg.rs", "fn f() { assert_eq!(crate::scene::load(), 1); }");
    planted("scene/mod.rs", "fn f() { vec![vec![crate::figure::plan()]]; }");
    fine("output/svg.rs", "fn f() { assert_eq!(crate::drawing::load(), output::x()); }");
}

#[test]
fn a_planted_super_chain_is_found() {
    planted("scene/mod.rs", "use super::figure::plan;");
    planted("figure/layer/ray.rs", "use super::super::super::output::png;");
    planted("scene/mod.rs", "mod tests { fn f() { super::super::drift::x(); } }");
    fine("scene/mod.rs", "mod tests { use super::*; }");
    fine("figure/layer/ray.rs", "use super::super::sketch::Sketch;");
}

#[test]
fn a_planted_re_export_is_found() {
    planted("collision/mod.rs", "pub use crate::geometry::Body;");
    planted("figure/mod.rs", "pub(crate) use crate::scene::{Scene};");
    fine("collision/mod.rs", "pub use self::gjk::Gjk; use crate::geometry::Body;");
}

#[test]
fn a_detour_through_the_root_is_found() {
    planted("figure/mod.rs", "use crate::render;");
    planted("figure/mod.rs", "use crate::*;");
    planted("output/svg.rs", "fn f() { tracefig::solve(); }");
}

#[test]
fn cli_speaks_to_the_public_library_only() {
    planted("cli/render.rs", "use crate::collision::Query;");
    planted("cli/render.rs", "use super::super::output;");
    fine("cli/render.rs", "use tracefig::render; use super::exit;");
}
