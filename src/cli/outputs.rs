//! What a run may write: never a file that it reads, and never what is no regular file.
//!
//! Every output of every command is held to this: files of figures, pictures of differences, reports. A link
//! is not followed and not replaced, as what it leads to was not named on the command line; a device or a
//! pipe that was named for a report is written into.

use std::collections::BTreeMap;
use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::atomic_file::{Wait, write_whole};

/// Files of a run that none of its outputs may replace, each with what it is, as "a scene".
#[derive(Clone, Debug, Default)]
pub(crate) struct Kept(BTreeMap<PathBuf, &'static str>);

impl Kept {
    /// Keeps a file, and what it leads to where it is a link.
    pub(crate) fn keep(&mut self, path: &Path, what: &'static str) {
        self.0.entry(one_name(path)).or_insert(what);
        if let Ok(path) = path.canonicalize() {
            self.0.entry(path).or_insert(what);
        }
    }

    /// What the file in that place is, where it must stay.
    pub(crate) fn what(&self, path: &Path) -> Option<&'static str> {
        self.0.get(&one_name(path)).copied()
    }
}

/// A path that is the same for the same place, however its folder is written.
pub(crate) fn one_name(path: &Path) -> PathBuf {
    let is_link = path.symlink_metadata().is_ok_and(|place| place.file_type().is_symlink());
    if !is_link && let Ok(path) = path.canonicalize() {
        return path;
    }
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    folder.join(path.file_name().unwrap_or_default())
}

/// Writes a report to the place that was named for it: into a device or a pipe, or else as a whole file.
pub(crate) fn write_report(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if is_stream(path) {
        return OpenOptions::new().write(true).open(path)?.write_all(bytes);
    }
    write_whole(path, bytes, Wait::No)
}

/// Whether a place takes bytes one after the other and keeps none, as a device or a pipe, also behind a link.
fn is_stream(path: &Path) -> bool {
    path.metadata().is_ok_and(|place| !place.is_file() && !place.is_dir())
}
