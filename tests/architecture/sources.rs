//! The sources of the house: their files, and every path that one names.
//!
//! Read with `syn`: `use` trees, paths in expressions, types and patterns, paths inside macro calls.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use crate::re_exports::defined;
use crate::rooms::is_within;

/// Every Rust file in a folder and below it, sorted.
pub(crate) fn rust_files(folder: &Path, into: &mut Vec<PathBuf>) {
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

/// The folder of the library's sources.
pub(crate) fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// Module path of a file below `src/`.
pub(crate) fn module_of(relative: &Path) -> Vec<String> {
    let mut parts: Vec<String> =
        relative.with_extension("").iter().map(|p| p.to_string_lossy().into_owned()).collect();
    if parts.last().is_some_and(|p| p == "mod") {
        parts.pop();
    }
    parts
}

/// A path as a file has it.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    /// The module that it stands in, from the crate's root, inline modules included.
    pub(crate) module: Vec<String>,
    /// Its segments as written.
    pub(crate) segments: Vec<String>,
    /// Its line.
    pub(crate) line: usize,
    /// Whether it is re-exported.
    pub(crate) is_public: bool,
}

/// Every path of more than one segment of a file, in order.
pub(crate) fn paths(relative: &Path, source: &str) -> syn::Result<Vec<Named>> {
    let mut reader = Reader { module: module_of(relative), found: Vec::new() };
    reader.visit_file(&syn::parse_file(source)?);
    Ok(reader.found)
}

impl Named {
    /// The path of what it names, from the crate's root; None for what is not of this crate, or not told by
    /// the path alone.
    pub(crate) fn resolved(&self) -> Option<Vec<String>> {
        let mut rest = &self.segments[..];
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
        Some(defined(base))
    }
}

/// Reads the paths of one file.
struct Reader {
    module: Vec<String>,
    found: Vec<Named>,
}

impl Reader {
    fn find(&mut self, segments: &[String], line: usize, is_public: bool) {
        let (module, segments) = (self.module.clone(), segments.to_vec());
        self.found.push(Named { module, segments, line, is_public });
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
                self.find(&path, line, public);
            }
            syn::UseTree::Rename(r) => {
                path.push(r.ident.to_string());
                self.find(&path, line, public);
            }
            syn::UseTree::Glob(_) => {
                path.push("*".into());
                self.find(&path, line, public);
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
            self.find(path, line, false);
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
            self.find(&segments, path.span().start().line, false);
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        self.tokens(mac.tokens.clone());
        visit::visit_macro(self, mac);
    }
}
