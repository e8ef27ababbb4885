//! Files that appear whole or not at all: written beside their place under another name, then renamed.
//!
//! The other name is `.tracefig-….part`. A run that is killed can't take it away again, so the next run does.
//! How does it know a dead run's part from one that is being written? A run holds a lock on its part, and the
//! system lets go of a lock when its holder ends, however it ends. No clock and no process number is asked,
//! both of which deceive between machines and containers that share a folder.

use std::fs::{File, TryLockError};
use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use super::regular::replaceable;

/// What the name of a part begins with; the dot hides it.
const PREFIX: &str = ".tracefig-";
/// What the name of a part ends with.
const SUFFIX: &str = ".part";

/// Whether a file is waited for until the disk has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wait {
    /// The system writes it when it likes. After a loss of power its place may hold an old file, or an empty
    /// one; after anything else, the whole file.
    No,
    /// File and name are on the disk when it is written: some milliseconds a file.
    ForDisk,
}

impl Wait {
    /// Whether a command was asked to wait.
    pub(crate) fn asked(sync: bool) -> Self {
        if sync { Self::ForDisk } else { Self::No }
    }
}

/// Writes a file. Whatever goes wrong, its place holds all of the new bytes or what it held before. Who may
/// read and write it stays as it was.
///
/// # Errors
/// Where the place holds what is no regular file, and what the system says.
pub(crate) fn write_whole(path: &Path, bytes: &[u8], wait: Wait) -> io::Result<()> {
    replaceable(path)?;
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let file = part_in(folder)?;
    if let Ok(old) = path.symlink_metadata() {
        file.as_file().set_permissions(old.permissions())?;
    }
    // Through the file itself, as an error of the part would say its name.
    file.as_file().write_all(bytes)?;
    if wait == Wait::ForDisk {
        file.as_file().sync_all()?;
    }
    file.persist(path).map_err(|e| e.error)?;
    // So that the name, too, survives a loss of power. Some file systems refuse to sync a folder; the file is
    // whole.
    if wait == Wait::ForDisk
        && let Ok(folder) = File::open(folder)
    {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// Takes away the parts that dead runs left in a folder. What can't be read, locked or removed stays: a
/// leftover harms no one.
pub(crate) fn clear_leftovers(folder: &Path) {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    for entry in folder.read_dir().into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        // Of a link the lock would be on something else.
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if !(is_file && name.starts_with(PREFIX) && name.ends_with(SUFFIX)) {
            continue;
        }
        // Locks of NFS want a file that is open for writing.
        let Ok(part) = File::options().write(true).open(entry.path()) else { continue };
        if part.try_lock().is_ok() {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// A new empty part, locked.
fn part_in(folder: &Path) -> io::Result<NamedTempFile> {
    loop {
        let part = named_part_in(folder)?;
        if is_ours(&part) {
            return Ok(part);
        }
    }
}

/// Locks a part. Between its making and its locking, another run may have taken it for a leftover: that one
/// has the lock, or has removed the name already. Once we hold the lock of a part with a name, nobody removes
/// it. Where files can't be locked, nobody clears either.
fn is_ours(part: &NamedTempFile) -> bool {
    match part.as_file().try_lock() {
        Ok(()) => part.path().exists(),
        Err(TryLockError::WouldBlock) => false,
        Err(TryLockError::Error(_)) => true,
    }
}

/// A new empty part, not yet locked.
fn named_part_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    #[cfg(unix)]
    let builder = {
        use std::os::unix::fs::PermissionsExt;
        // As `File::create`: the umask takes away what others may not do.
        builder.permissions(std::fs::Permissions::from_mode(0o666))
    };
    builder.tempfile_in(folder).map_err(|error| nameless(&error))
}

/// An error without the name of the part, which means nothing to whoever asked for a file: what the system
/// said, before the words that `tempfile` adds.
fn nameless(error: &io::Error) -> io::Error {
    let text = error.to_string();
    let said = text.split_once(" at path ").map_or(text.as_str(), |(said, _)| said);
    io::Error::new(error.kind(), said)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> =
            folder.read_dir().unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn what_cannot_be_put_in_place_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("figure.svg");
        std::fs::create_dir(&place).unwrap();
        assert!(write_whole(&place, b"<svg/>", Wait::No).is_err());
        assert_eq!(names(folder.path()), ["figure.svg"]);
    }

    #[test]
    fn an_error_names_no_part() {
        let folder = tempfile::tempdir().unwrap();
        let error = write_whole(&folder.path().join("nowhere/figure.svg"), b"<svg/>", Wait::No).unwrap_err();
        let system = folder.path().join("nowhere").read_dir().unwrap_err();
        assert_eq!((error.kind(), error.to_string()), (io::ErrorKind::NotFound, system.to_string()));
    }

    #[test]
    fn a_file_is_replaced_whole() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("figure.svg");
        write_whole(&place, b"first, and longer", Wait::ForDisk).unwrap();
        write_whole(&place, b"second", Wait::No).unwrap();
        assert_eq!(std::fs::read(&place).unwrap(), b"second");
    }

    #[cfg(unix)]
    #[test]
    fn who_may_read_a_file_stays_as_it_was() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("figure.svg");
        write_whole(&place, b"first", Wait::No).unwrap();
        for mode in [0o600, 0o444, 0o664] {
            std::fs::set_permissions(&place, std::fs::Permissions::from_mode(mode)).unwrap();
            write_whole(&place, b"second", Wait::No).unwrap();
            assert_eq!(place.metadata().unwrap().permissions().mode() & 0o777, mode);
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_neither_replaced_nor_followed() {
        let folder = tempfile::tempdir().unwrap();
        let (place, other) = (folder.path().join("figure.svg"), folder.path().join("other"));
        std::fs::write(&other, "theirs").unwrap();
        std::os::unix::fs::symlink(&other, &place).unwrap();
        let error = write_whole(&place, b"<svg/>", Wait::No).unwrap_err().to_string();
        assert_eq!(error, "it is a link, not a regular file");
        assert!(place.is_symlink() && std::fs::read(&other).unwrap() == b"theirs");
        assert_eq!(names(folder.path()), ["figure.svg", "other"]);
    }

    #[test]
    fn only_parts_of_dead_runs_are_cleared() {
        let folder = tempfile::tempdir().unwrap();
        let mine = part_in(folder.path()).unwrap();
        for name in [".tracefig-dead.part", ".tracefig-notes", "figure.svg.part", "figure.svg"] {
            std::fs::write(folder.path().join(name), "x").unwrap();
        }
        std::fs::create_dir(folder.path().join(".tracefig-folder.part")).unwrap();
        clear_leftovers(folder.path());
        let mine = mine.path().file_name().unwrap().to_str().unwrap().to_owned();
        let mut left =
            vec![".tracefig-folder.part", ".tracefig-notes", &mine, "figure.svg", "figure.svg.part"];
        left.sort_unstable();
        assert_eq!(names(folder.path()), left);
    }

    #[test]
    fn a_part_that_another_run_took_for_a_leftover_is_made_anew() {
        let folder = tempfile::tempdir().unwrap();
        let (held, gone) = (named_part_in(folder.path()).unwrap(), named_part_in(folder.path()).unwrap());
        let other = File::options().write(true).open(held.path()).unwrap();
        other.lock().unwrap();
        assert!(!is_ours(&held));
        std::fs::remove_file(gone.path()).unwrap();
        assert!(!is_ours(&gone));
    }

    #[test]
    fn clearing_takes_no_file_from_those_who_write() {
        let folder = tempfile::tempdir().unwrap();
        std::thread::scope(|scope| {
            let writers: Vec<_> = (0..3)
                .map(|i| {
                    let place = folder.path().join(format!("{i}.svg"));
                    scope.spawn(move || (0..200).all(|_| write_whole(&place, b"<svg/>", Wait::No).is_ok()))
                })
                .collect();
            while writers.iter().any(|w| !w.is_finished()) {
                clear_leftovers(folder.path());
            }
            assert!(writers.into_iter().all(|w| w.join().unwrap()));
        });
        assert_eq!(names(folder.path()), ["0.svg", "1.svg", "2.svg"]);
    }
}
