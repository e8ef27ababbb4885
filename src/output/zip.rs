//! ZIP archives: what a presentation and a package of questions are.
//!
//! All files are dated 1980, where the format's calendar begins, so that the same files give the same bytes.

use std::io::{Cursor, Write};

use zip::write::{SimpleFileOptions, ZipWriter};
use zip::{CompressionMethod, DateTime};

use super::OutputError;

/// What archives begin with (PKWARE, *APPNOTE.TXT*, 6.3.10, section 4.3.7).
pub(super) const BEGINS: &[u8] = b"PK\x03\x04";
/// What archives of ours end with: the length of their comment, which is none.
pub(super) const ENDS: &[u8] = &[0, 0];

/// Whether a file's bytes are found in the archive as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    /// Packed.
    Shorter,
    /// Byte for byte.
    Plain,
}

/// An archive being written.
#[derive(Debug)]
pub(super) struct Zip(ZipWriter<Cursor<Vec<u8>>>);

impl Default for Zip {
    fn default() -> Self {
        Self(ZipWriter::new(Cursor::default()))
    }
}

impl Zip {
    /// Adds a file; its name may have folders, parted by slashes.
    pub(super) fn add(&mut self, name: &str, content: &[u8], packing: Packing) -> Result<(), OutputError> {
        // The format has two bytes for the length of a name, and the crate panics on more.
        u16::try_from(name.len()).map_err(|error| OutputError::encoder(&error))?;
        let method = match packing {
            Packing::Shorter => CompressionMethod::Deflated,
            Packing::Plain => CompressionMethod::Stored,
        };
        let options =
            SimpleFileOptions::default().compression_method(method).last_modified_time(DateTime::default());
        self.0.start_file(name, options).map_err(|error| OutputError::encoder(&error))?;
        self.0.write_all(content).map_err(|error| OutputError::encoder(&error))
    }

    /// The archive, whole.
    pub(super) fn finish(self) -> Result<Vec<u8>, OutputError> {
        Ok(self.0.finish().map_err(|error| OutputError::encoder(&error))?.into_inner())
    }
}

/// The files of an archive by name, unpacked; for tests.
#[cfg(test)]
pub(super) fn unzipped(archive: &[u8]) -> Vec<(String, Vec<u8>)> {
    use std::io::Read;

    let mut archive = zip::ZipArchive::new(Cursor::new(archive)).unwrap();
    let mut files = Vec::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).unwrap();
        let mut content = Vec::new();
        file.read_to_end(&mut content).unwrap();
        files.push((file.name().to_owned(), content));
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_come_back_and_long_ones_are_packed() {
        let (long, short) = (b"so ".repeat(1000), b"x".to_vec());
        let long_bytes = long.len();
        let mut zip = Zip::default();
        zip.add("a/long", &long, Packing::Shorter).unwrap();
        zip.add("short", &short, Packing::Shorter).unwrap();
        zip.add("é", &long, Packing::Plain).unwrap();
        zip.add("none", b"", Packing::Shorter).unwrap();
        let archive = zip.finish().unwrap();
        assert!(archive.len() > long.len() && archive.len() < long.len() + 600, "{}", archive.len());
        let files = [("a/long", long.clone()), ("short", short), ("é", long), ("none", Vec::new())];
        assert_eq!(unzipped(&archive), files.map(|(name, content)| (name.to_owned(), content)));
        assert!(archive.starts_with(BEGINS) && archive.ends_with(ENDS));
        // What a reader finds of a file is where it was put, byte for byte.
        assert!(archive.windows(long_bytes).any(|bytes| bytes == b"so ".repeat(1000)));
    }

    #[test]
    fn no_name_is_longer_than_its_count_of_bytes_can_say() {
        assert!(Zip::default().add(&"n".repeat(70_000), b"", Packing::Plain).is_err());
    }
}
