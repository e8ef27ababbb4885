//! What rooms re-export from within, so that a path is known by what it names and not by the door it takes.

use std::fs;
use std::sync::LazyLock;

use crate::rooms::ROOMS;
use crate::sources::src;

/// What a room re-exports from within: the path by which others name it, and the path of what it is.
pub(crate) type ReExport = (Vec<String>, Vec<String>);

/// The path of what a path names, through the rooms' re-exports.
pub(crate) fn defined(mut path: Vec<String>) -> Vec<String> {
    static RE_EXPORTS: LazyLock<Vec<ReExport>> = LazyLock::new(|| {
        let rooms = ROOMS.iter().map(|(room, _)| (*room, src().join(room)));
        let roots = rooms.flat_map(|(room, path)| {
            [path.join("mod.rs"), path.with_extension("rs")].map(|file| (room, file))
        });
        let sources = roots.filter_map(|(room, file)| Some((room, fs::read_to_string(file).ok()?)));
        sources.flat_map(|(room, source)| re_exports(room, &source)).collect()
    });
    while let Some((named, is)) = RE_EXPORTS.iter().find(|(named, _)| path.starts_with(named)) {
        path.splice(..named.len(), is.iter().cloned());
    }
    path
}

/// What the root source of a room re-exports from the modules that it declares, by paths relative to
/// it.
pub(crate) fn re_exports(room: &str, source: &str) -> Vec<ReExport> {
    let module: Vec<String> = room.split('/').map(str::to_owned).collect();
    let items = syn::parse_file(source).unwrap().items;
    let declares = |name: &String| items.iter().any(|x| matches!(x, syn::Item::Mod(x) if x.ident == name));
    let mut found = Vec::new();
    for item in &items {
        if let syn::Item::Use(item) = item
            && !matches!(item.vis, syn::Visibility::Inherited)
        {
            leaves(&[], &item.tree, &mut |path, name| {
                // An item named as its module is not to be told from it by its path.
                if declares(&path[0]) && path[0] != name {
                    found.push(([&module[..], &[name]].concat(), [&module[..], &path].concat()));
                }
            });
        }
    }
    found
}

/// Calls `visit` with the path and the name of each item of a `use` tree.
fn leaves(prefix: &[String], tree: &syn::UseTree, visit: &mut impl FnMut(Vec<String>, String)) {
    let longer = |ident: &syn::Ident| [prefix, &[ident.to_string()]].concat();
    match tree {
        syn::UseTree::Path(p) => leaves(&longer(&p.ident), &p.tree, visit),
        syn::UseTree::Name(n) => visit(longer(&n.ident), n.ident.to_string()),
        syn::UseTree::Rename(r) => visit(longer(&r.ident), r.rename.to_string()),
        syn::UseTree::Glob(_) => {}
        syn::UseTree::Group(g) => g.items.iter().for_each(|tree| leaves(prefix, tree, visit)),
    }
}
