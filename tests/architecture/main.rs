//! The house stands as designed: each room of `src/` uses only the rooms that its row allows.
//!
//! Every path of every source file is read, `super::` chains from nested modules and paths in macro calls
//! too. A room re-exports only what is its own, so that no arrow can go round through a neighbour, and
//! nothing but `cli` speaks to the library's root.
//!
//! A room may have rooms within it, with rows of their own. A module obeys the longest row that it is in: an
//! inner row forbids what the outer one allows, the outer room itself included. A room may always use what
//! lies within it; what it re-exports from there counts as what it is, not as the outer room's. Test code,
//! modules named `tests`, obeys the outermost row alone.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod circles;
mod re_exports;
mod rooms;
mod sources;

use std::fs;
use std::path::Path;

use syn::visit::{self, Visit};

use re_exports::re_exports;
use rooms::{ROOMS, is_within, row_of};
use sources::{Named, module_of, paths, rust_files, src};

/// A path that leaves its room.
#[derive(Debug, PartialEq)]
struct Wrong {
    line: usize,
    what: String,
}

/// What is wrong with one source file of a room.
fn wrong_arrows(relative: &Path, source: &str) -> Vec<Wrong> {
    if row_of(&module_of(relative)).is_none() {
        return vec![Wrong { line: 1, what: format!("{} is in no room of the design", relative.display()) }];
    }
    match paths(relative, source) {
        Ok(paths) => paths.iter().filter_map(wrong).collect(),
        Err(error) => vec![Wrong { line: error.span().start().line, what: error.to_string() }],
    }
}

/// What a path does against the design, if anything.
fn wrong(path: &Named) -> Option<Wrong> {
    let target = path.resolved()?;
    let what = what_is_wrong_with(&path.module, &target, path.is_public)?;
    Some(Wrong { line: path.line, what: format!("`{}`{what}", path.segments.join("::")) })
}

fn what_is_wrong_with(module: &[String], path: &[String], is_public: bool) -> Option<String> {
    if path.is_empty() {
        return Some(" takes in the crate's root".into());
    }
    let Some((room, allowed)) = row_of(module) else { return Some(" is used outside any room".into()) };
    if is_within(path, room) {
        return None;
    }
    let Some((target, _)) = row_of(path) else { return Some(" goes through the crate's root".into()) };
    if !allowed.iter().any(|other| is_within(path, other)) {
        Some(format!(": {room} may not use {target}"))
    } else if is_public {
        Some(format!(": {room} re-exports what is {target}'s"))
    } else {
        None
    }
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
fn an_inner_row_forbids_what_the_outer_one_allows() {
    planted("collision/certified/impact/search.rs", "use crate::trace::Event;");
    planted("collision/certified/sweep/ray.rs", "fn f() -> crate::collision::query::Query { loop {} }");
    planted("collision/certified/distance/pair.rs", "use super::super::super::algorithm::view;");
    planted("collision/feature.rs", "use crate::collision::answer::Outcome;");
    planted("collision/answer/mod.rs", "use crate::trace::Event;");
    fine("collision/algorithm/gjk.rs", "use crate::trace::Event; use crate::collision::query::Query;");
    fine("collision/certified/impact/search.rs", "use crate::collision::answer::Outcome;");
    fine("collision/mod.rs", "pub use algorithm::ALGORITHMS; use crate::collision::certified::sweep::Sweep;");
}

#[test]
fn an_inner_room_is_not_gone_round() {
    planted("collision/certified/impact/search.rs", "use crate::collision::Query;");
    planted("collision/certified/impact/search.rs", "use super::super::super::{Outcome, ALGORITHMS};");
    planted("collision/certified/sweep/ray.rs", "use super::Sweep;");
    planted("collision/certified/sweep/ray.rs", "use crate::collision::certified::impact::by_axes;");
    planted("collision/certified/impact/search.rs", "use crate::collision::certified::sweep::Sweep;");
    planted(
        "collision/certified/impact/search.rs",
        "pub(crate) use crate::collision::certified::sweep::ray::Entry;",
    );
    planted(
        "collision/certified/sweep/filter/mod.rs",
        "use crate::collision::certified::sweep::balls::entry;",
    );
    planted("collision/certified/impact/filter/mod.rs", "use super::search::Search;");
    fine("collision/certified/impact/search.rs", "use crate::collision::Outcome;");
    fine("collision/certified/impact/filter/mod.rs", "use crate::collision::certified::impact::MovingPair;");
    fine("collision/certified/impact/mod.rs", "use crate::collision::certified::sweep::ray::Entry;");
}

#[test]
fn test_code_obeys_the_outermost_row_alone() {
    let everywhere = "use crate::collision::algorithm::gjk; use crate::trace::Trace;";
    fine("collision/certified/sweep/filter/tests.rs", everywhere);
    fine("collision/certified/sweep/ray.rs", &format!("#[cfg(test)] mod tests {{ {everywhere} }}"));
    fine("collision/tests/storyboard.rs", everywhere);
    planted("collision/certified/sweep/filter/tests.rs", "use crate::scene::Scene;");
    planted("collision/certified/sweep/ray.rs", "mod test { use crate::trace::Trace; }");
}

#[test]
fn a_re_export_is_known_by_what_it_is() {
    let re_exported = |source: &str| {
        let found = re_exports("a/b", source);
        found.iter().map(|(named, is)| format!("{} {}", named.join("/"), is.join("/"))).collect::<Vec<_>>()
    };
    assert_eq!(re_exported("mod c; pub use c::{D, e::F as G};"), ["a/b/D a/b/c/D", "a/b/G a/b/c/e/F"]);
    assert!(re_exported("mod c; use c::D; pub use glam::DVec2; pub use c::c;").is_empty());
}

/// Rooms that ask a filter first. Only speed needs it: whoever doubts it leaves the one call out.
const FILTERED: &[&str] =
    &["collision/certified/distance", "collision/certified/sweep", "collision/certified/impact"];

#[test]
fn each_filter_is_called_from_one_line_of_its_room() {
    for room in FILTERED {
        let mut files = Vec::new();
        rust_files(&src().join(room), &mut files);
        let mut calls = Vec::new();
        for file in files {
            let relative = file.strip_prefix(src()).unwrap().to_path_buf();
            let source = fs::read_to_string(&file).unwrap();
            calls.extend(
                calls_of_filter(room, &relative, &source).iter().map(|line| (relative.clone(), *line)),
            );
        }
        let [(file, _)] = &calls[..] else {
            panic!("{room} calls its filter {} times: {calls:?}", calls.len())
        };
        assert_eq!(*file, Path::new(room).join("mod.rs"));
    }
}

#[test]
fn a_planted_call_of_a_filter_is_found() {
    let calls = |file: &str, source: &str| {
        calls_of_filter("collision/certified/sweep", Path::new(file), source).len()
    };
    let (room, search) = ("collision/certified/sweep/mod.rs", "collision/certified/sweep/ray.rs");
    assert_eq!(calls(room, "mod filter; fn f() { filter::entry() }"), 1);
    assert_eq!(calls(room, "mod filter; use filter::Found; fn f() { filter::entry() }"), 2);
    assert_eq!(calls(search, "use super::filter; fn f() { x.filter(y) }"), 1);
    assert_eq!(calls(search, "fn f() { crate::collision::certified::sweep::filter::entry() }"), 1);
    assert_eq!(calls("collision/certified/sweep/filter/mod.rs", "use super::filter::entry;"), 0);
    assert_eq!(calls(room, "mod filter; #[cfg(test)] mod tests { use super::filter::entry; }"), 0);
}

/// Lines of a file of a room's library code, the filter's own aside, that name the room's filter or what is
/// in it.
fn calls_of_filter(room: &str, relative: &Path, source: &str) -> Vec<usize> {
    let module = module_of(relative);
    let filter = format!("{room}/filter");
    if is_within(&module, &filter) || module.iter().any(|segment| segment == "tests") {
        return Vec::new();
    }
    let names_filter = |path: &&Named| match path.resolved() {
        Some(resolved) => is_within(&resolved, &filter),
        None => path.segments[0] == "filter" && path.module.join("/") == room,
    };
    let found = paths(relative, source).unwrap();
    let library = found.iter().filter(|path| !path.module.iter().any(|segment| segment == "tests"));
    library.filter(names_filter).map(|path| path.line).collect()
}

#[test]
fn cli_speaks_to_the_public_library_only() {
    planted("cli/render.rs", "use crate::collision::Query;");
    planted("cli/render.rs", "use super::super::output;");
    fine("cli/render.rs", "use tracefig::render; use super::exit;");
}
