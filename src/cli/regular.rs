//! Regular files: what else there may be in their place, and reading those that only lie about, as figures
//! on disk and themes.
//!
//! A scene may come from anywhere, as its place was named. What is found beside it may be anything that
//! somebody put there: a link to a device without an end, a pipe into which nobody writes. Only regular files
//! are read, and only up to a length.

use std::fs::{File, FileType};
use std::io::{self, Read};
use std::path::Path;

/// The bytes of a regular file, or of the one that a link leads to: at most `most` and one more, by which a
/// longer file is known.
pub(crate) fn read_regular(path: &Path, most: usize) -> io::Result<Vec<u8>> {
    // Before it is opened, as to open a pipe is to wait for whoever writes into it.
    let kind = path.metadata()?.file_type();
    if !kind.is_file() {
        return Err(irregular(kind));
    }
    let file = File::open(path)?;
    let kind = file.metadata()?.file_type();
    if !kind.is_file() {
        return Err(irregular(kind));
    }
    let mut bytes = Vec::new();
    file.take(most as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Refuses a place that holds anything but a regular file, or nothing.
///
/// # Errors
/// What it holds.
pub(crate) fn replaceable(path: &Path) -> io::Result<()> {
    match path.symlink_metadata() {
        Ok(place) if !place.is_file() => Err(irregular(place.file_type())),
        _ => Ok(()),
    }
}

/// The error of something that is no regular file.
fn irregular(kind: FileType) -> io::Error {
    let what = match kind {
        _ if kind.is_symlink() => "a link",
        _ if kind.is_dir() => "a folder",
        _ => "a device, a pipe or a socket",
    };
    io::Error::new(io::ErrorKind::InvalidInput, format!("it is {what}, not a regular file"))
}
