//! Searching a folder in depth, in the order of the names: what lies in it that may be a scene.
//!
//! Links to folders are not followed, as they may lead out of the folder or back into it. Folders that are
//! hidden, and those in which builds and packages lie, are passed by.

use std::io;
use std::path::{Path, PathBuf};

use tracefig::scene::limits::MAX_FILE_BYTES;
use tracefig::scene::{PROJECT_FILE, is_scene};

use super::regular::read_regular;

/// Folders of others that no scene lies in: what cargo builds, what npm installs.
const PASSED_BY: [&str; 2] = ["target", "node_modules"];

/// What a search found.
#[derive(Debug, Default)]
pub(crate) struct Walked {
    /// The scenes, by path.
    pub(crate) scenes: Vec<PathBuf>,
    /// The files that end as a scene's do and are none, by path.
    pub(crate) others: Vec<PathBuf>,
    /// The folders that were searched.
    pub(crate) folders: Vec<PathBuf>,
    /// The folders among these that can't be read, and why.
    pub(crate) unread: Vec<(PathBuf, io::Error)>,
}

/// The scenes of a folder and of those in it.
///
/// # Errors
/// When the folder itself can't be read.
pub(crate) fn walk(folder: &Path) -> io::Result<Walked> {
    let mut walked = Walked { folders: folders(folder)?, ..Walked::default() };
    for folder in &walked.folders {
        let entries = match folder.read_dir() {
            Ok(entries) => entries,
            Err(error) => {
                walked.unread.push((folder.clone(), error));
                continue;
            }
        };
        for path in entries.flatten().map(|entry| entry.path()) {
            if !may_be_scene(&path) {
                continue;
            }
            if reads_as_scene(&path) {
                walked.scenes.push(path);
            } else {
                walked.others.push(path);
            }
        }
    }
    walked.scenes.sort();
    walked.others.sort();
    Ok(walked)
}

/// A folder and all in it that are searched, each before those in it.
///
/// # Errors
/// When the folder itself can't be read.
pub(crate) fn folders(folder: &Path) -> io::Result<Vec<PathBuf>> {
    folder.read_dir()?;
    let (mut found, mut open) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(folder) = open.pop() {
        for entry in folder.read_dir().into_iter().flatten().flatten() {
            let name = entry.file_name();
            let name = name.to_string_lossy();
            let is_passed_by = name.starts_with('.') || PASSED_BY.contains(&name.as_ref());
            // The kind of the entry itself: a link is none.
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) && !is_passed_by {
                open.push(entry.path());
            }
        }
        found.push(folder);
    }
    found.sort();
    Ok(found)
}

/// Whether a file ends as a scene does. What is neither a file nor a link is no scene, whatever its name: a
/// pipe would keep the others waiting.
fn may_be_scene(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "toml" || e == "json")
        && path.file_name().is_none_or(|name| name != PROJECT_FILE)
        && (path.metadata().is_ok_and(|place| place.is_file()) || leads_nowhere(path))
}

/// Whether a file is a scene, right or wrong. What can't be read is told when it is opened.
fn reads_as_scene(path: &Path) -> bool {
    leads_nowhere(path)
        || read_regular(path, MAX_FILE_BYTES).map_or(true, |bytes| is_scene(&String::from_utf8_lossy(&bytes)))
}

/// Whether it is a link to what is not there.
fn leads_nowhere(path: &Path) -> bool {
    path.is_symlink() && !path.exists()
}
