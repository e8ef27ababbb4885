//! Figures of the last build of a book, kept so that the next one draws only what has changed.
//!
//! They lie in one file a book and renderer in the user's folder for such things (`$XDG_CACHE_HOME`, else
//! `~/.cache`; `%LOCALAPPDATA%`), as mdBook empties the book's own before it writes. A figure is known by
//! all that it depends on; another tracefig, told by its file, starts anew. Whatever is wrong with the file,
//! it is as if there were none, and where there is no such folder nothing is kept.

use std::collections::BTreeMap;
use std::env;
use std::fmt::Write as _;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

use tracefig::drift::fingerprint;

use super::super::atomic_file::{Wait, clear_leftovers, write_whole};
use super::super::regular::read_regular;

/// Bytes of the largest file that is read again: some two thousand figures.
const MOST: usize = 128 << 20;

/// What the last build left.
#[derive(Debug, Default)]
pub(crate) struct Kept {
    /// The file; `None` where nothing is kept.
    file: Option<PathBuf>,
    /// The first line of a file of this tracefig.
    head: String,
    /// The text of the file.
    text: String,
    /// Where in it each figure stands, by its key.
    places: BTreeMap<String, Range<usize>>,
}

impl Kept {
    /// What was kept of a book for a renderer.
    pub(crate) fn open(root: &Path, renderer: &str) -> Self {
        let Some((folder, head)) = folder().zip(head()) else { return Self::default() };
        let name = fingerprint(&root.to_string_lossy(), renderer);
        let file = folder.join(name);
        let text = read_regular(&file, MOST).ok().filter(|bytes| bytes.len() <= MOST);
        let text = text.and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default();
        let places = places(&text, &head).unwrap_or_default();
        Self { file: Some(file), head, text, places }
    }

    /// The figure with that key.
    pub(crate) fn get(&self, key: &str) -> Option<&str> {
        self.text.get(self.places.get(key)?.clone())
    }

    /// Keeps the figures of this build, and no others. A file that can't be written costs the next build its
    /// time and nothing else.
    pub(crate) fn keep(self, figures: &BTreeMap<String, String>) {
        let Some(file) = self.file.filter(|_| !figures.keys().eq(self.places.keys())) else { return };
        let mut text = self.head;
        for (key, figure) in figures {
            let _ = write!(text, "{key} {}\n{figure}\n", figure.len());
        }
        if let Some(folder) = file.parent()
            && fs::create_dir_all(folder).is_ok()
        {
            clear_leftovers(folder);
            let _ = write_whole(&file, text.as_bytes(), Wait::No);
        }
    }
}

/// Where the figures of a text stand: its head, then for each a line of key and length, and the figure.
/// `None` for any other text.
fn places(text: &str, head: &str) -> Option<BTreeMap<String, Range<usize>>> {
    let (mut places, mut at) = (BTreeMap::new(), head.len());
    let mut rest = text.strip_prefix(head)?;
    while !rest.is_empty() {
        let (line, behind) = rest.split_once('\n')?;
        let (key, length) = line.split_once(' ')?;
        let length: usize = length.parse().ok()?;
        let start = at + line.len() + 1;
        rest = behind.get(length..)?.strip_prefix('\n')?;
        at = start + length + 1;
        places.insert(key.to_owned(), start..start + length);
    }
    Some(places)
}

/// The first line of a file of this tracefig; `None` where its own file can't be told apart.
fn head() -> Option<String> {
    let own = env::current_exe().and_then(fs::metadata).ok()?;
    let changed = own.modified().ok()?.duration_since(UNIX_EPOCH).ok()?;
    Some(format!("tracefig {} {} {}\n", env!("CARGO_PKG_VERSION"), own.len(), changed.as_nanos()))
}

/// The folder of what is kept, by the XDG Base Directory Specification: only an absolute one counts.
fn folder() -> Option<PathBuf> {
    let named = |name| env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let home = || named("HOME").map(|home| home.join(".cache"));
    let folder = named("XDG_CACHE_HOME").or_else(home).or_else(|| named("LOCALAPPDATA"))?;
    Some(folder.join("tracefig").join("books"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_as_it_was_written_and_any_other_is_none() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("new/kept");
        let open = || {
            let text = fs::read_to_string(&file).unwrap_or_default();
            let places = places(&text, "head\n").unwrap_or_default();
            Kept { file: Some(file.clone()), head: "head\n".to_owned(), text, places }
        };
        let figures: BTreeMap<_, _> =
            [("a", "<svg>α\n</svg>"), ("b", "")].map(|(k, v)| (k.to_owned(), v.to_owned())).into();
        open().keep(&figures);
        assert_eq!(
            (open().get("a"), open().get("b"), open().get("c")),
            (Some("<svg>α\n</svg>"), Some(""), None)
        );
        let whole = fs::read_to_string(&file).unwrap();
        for broken in ["", "other\n", &whole[..whole.len() - 3], &whole.replace("a 1", "a 9")] {
            assert!(places(broken, "head\n").is_none(), "{broken}");
        }
        open().keep(&BTreeMap::new());
        assert_eq!(fs::read_to_string(&file).unwrap(), "head\n", "what is no longer drawn is not kept");
    }
}
