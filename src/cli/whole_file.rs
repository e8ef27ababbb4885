//! Files that appear whole or not at all: written beside their place under another name, synced, then renamed.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

/// Writes a file. Whatever goes wrong, its place holds all of the new bytes or what it held before.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".tracefig-").suffix(".part");
    #[cfg(unix)]
    let builder = {
        use std::os::unix::fs::PermissionsExt;
        // As `File::create`: the umask takes away what others may not do.
        builder.permissions(std::fs::Permissions::from_mode(0o666))
    };
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|e| e.error)?;
    // So that the name, too, survives a loss of power. Some file systems refuse to sync a folder; the file is whole.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_put_in_place_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("figure.svg");
        std::fs::create_dir(&place).unwrap();
        assert!(write_whole(&place, b"<svg/>").is_err());
        let names: Vec<_> = folder.path().read_dir().unwrap().map(|e| e.unwrap().file_name()).collect();
        assert_eq!(names, ["figure.svg"]);
    }

    #[test]
    fn a_file_is_replaced_whole() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("figure.svg");
        write_whole(&place, b"first, and longer").unwrap();
        write_whole(&place, b"second").unwrap();
        assert_eq!(std::fs::read(&place).unwrap(), b"second");
    }
}
