//! ZIP archives: what a presentation and a package of questions are.
//!
//! Files one after the other, each packed where that is shorter, then a directory of them. All are dated
//! 1980, where the format's calendar begins, so that the same files give the same bytes.
//! Source: PKWARE, *APPNOTE.TXT – .ZIP File Format Specification*, version 6.3.10, section 4.3.

use flate2::{Compress, Compression, Crc, FlushCompress, Status};

use super::OutputError;

/// What each file begins with (section 4.3.7).
const LOCAL: &[u8; 4] = b"PK\x03\x04";
/// What each entry of the directory begins with (section 4.3.12).
const CENTRAL: &[u8; 4] = b"PK\x01\x02";
/// What the end of the directory begins with (section 4.3.16).
const END: &[u8; 4] = b"PK\x05\x06";
/// The version that a reader must know: 2.0, the first with this packing.
const VERSION: u16 = 20;
/// Names are UTF-8 (section 4.4.4).
const UTF_8: u16 = 1 << 11;
/// How a file is packed (section 4.4.5): not at all, or by RFC 1951.
const METHODS: [u16; 2] = [0, 8];
/// The first of January 1980, in the bits of MS-DOS.
const DATE: u16 = 1 << 5 | 1;

/// What archives begin with.
pub(super) const BEGINS: &[u8] = LOCAL;
/// What archives of ours end with: the length of their comment, which is none.
pub(super) const ENDS: &[u8] = &[0, 0];

/// Whether a file's bytes are found in the archive as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    /// Packed where that is shorter.
    Shorter,
    /// Byte for byte.
    Plain,
}

/// An archive being written.
#[derive(Debug, Default)]
pub(super) struct Zip {
    /// The files so far.
    files: Vec<u8>,
    /// Their entries in the directory.
    directory: Vec<u8>,
    /// How many they are.
    count: u16,
}

impl Zip {
    /// Adds a file; its name may have folders, parted by slashes.
    pub(super) fn add(&mut self, name: &str, content: &[u8], packing: Packing) -> Result<(), OutputError> {
        let packed = if packing == Packing::Shorter { packed(content)? } else { None };
        let method = METHODS[usize::from(packed.is_some())];
        let bytes = packed.as_deref().unwrap_or(content);
        let mut crc = Crc::new();
        crc.update(content);
        let mut entry = Vec::new();
        for number in [VERSION, UTF_8, method, 0, DATE] {
            entry.extend(number.to_le_bytes());
        }
        for number in [crc.sum(), size(bytes.len())?, size(content.len())?] {
            entry.extend(number.to_le_bytes());
        }
        entry.extend(number(name.len())?.to_le_bytes());
        // Nothing is added to what the name says.
        entry.extend(0u16.to_le_bytes());
        let at = size(self.files.len())?;
        self.directory.extend(CENTRAL);
        self.directory.extend(VERSION.to_le_bytes());
        self.directory.extend(&entry);
        // No comment, on the first disk, without attributes of any system.
        self.directory.extend([0; 10]);
        self.directory.extend(at.to_le_bytes());
        self.directory.extend(name.as_bytes());
        self.files.extend(LOCAL);
        self.files.extend(entry);
        self.files.extend(name.as_bytes());
        self.files.extend(bytes);
        self.count = number(usize::from(self.count) + 1)?;
        Ok(())
    }

    /// The archive, whole.
    pub(super) fn finish(mut self) -> Result<Vec<u8>, OutputError> {
        let sizes = [size(self.directory.len())?, size(self.files.len())?];
        self.files.extend(self.directory);
        self.files.extend(END);
        // On the first of one disk, all of its files, which are all of them.
        self.files.extend([0; 4]);
        self.files.extend(self.count.to_le_bytes());
        self.files.extend(self.count.to_le_bytes());
        self.files.extend(sizes.iter().flat_map(|size| size.to_le_bytes()));
        self.files.extend(ENDS);
        Ok(self.files)
    }
}

/// A size in the four bytes that the format has for it.
fn size(length: usize) -> Result<u32, OutputError> {
    u32::try_from(length).map_err(|error| OutputError::encoder(&error))
}

/// A number in the two bytes that the format has for it.
fn number(count: usize) -> Result<u16, OutputError> {
    u16::try_from(count).map_err(|error| OutputError::encoder(&error))
}

/// The packed bytes; `None` where they are not fewer.
fn packed(content: &[u8]) -> Result<Option<Vec<u8>>, OutputError> {
    let mut packed = Vec::with_capacity(content.len());
    // The packer fills the room there is and does not ask for more.
    let status = Compress::new(Compression::default(), false)
        .compress_vec(content, &mut packed, FlushCompress::Finish)
        .map_err(|error| OutputError::encoder(&error))?;
    Ok(Some(packed).filter(|packed| status == Status::StreamEnd && packed.len() < content.len()))
}

/// The files of an archive of ours by name, unpacked; for tests.
#[cfg(test)]
pub(super) fn unzipped(archive: &[u8]) -> Vec<(String, Vec<u8>)> {
    use std::io::Read;

    let two = |at: usize| usize::from(u16::from_le_bytes([archive[at], archive[at + 1]]));
    let four = |at: usize| two(at) | two(at + 2) << 16;
    let end = archive.len() - 22;
    assert_eq!(&archive[end..end + 4], END);
    let (mut at, mut files) = (four(end + 16), Vec::new());
    for _ in 0..two(end + 10) {
        assert_eq!(&archive[at..at + 4], CENTRAL);
        let name = String::from_utf8(archive[at + 46..at + 46 + two(at + 28)].to_vec()).unwrap();
        let local = four(at + 42);
        assert_eq!(&archive[local..local + 4], LOCAL);
        assert_eq!(archive[local + 4..local + 30], archive[at + 6..at + 32], "{name}");
        let begin = local + 30 + name.len();
        let bytes = &archive[begin..begin + four(at + 20)];
        let mut content = Vec::new();
        match two(at + 10) {
            0 => content.extend(bytes),
            _ => _ = flate2::read::DeflateDecoder::new(bytes).read_to_end(&mut content).unwrap(),
        }
        assert_eq!(content.len(), four(at + 24), "{name}");
        at += 46 + name.len();
        files.push((name, content));
    }
    assert_eq!(at, end);
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_come_back_and_long_ones_are_packed() {
        let (long, short) = (b"so ".repeat(1000), b"x".to_vec());
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
    }

    #[test]
    fn the_sum_of_nine_digits_is_that_of_the_specification() {
        let mut zip = Zip::default();
        zip.add("n", b"123456789", Packing::Plain).unwrap();
        // The check value of CRC-32, as all catalogues of such sums have it.
        assert_eq!(zip.finish().unwrap()[14..18], 0xCBF4_3926u32.to_le_bytes());
    }

    #[test]
    fn no_name_is_longer_than_its_count_of_bytes_can_say() {
        assert!(Zip::default().add(&"n".repeat(70_000), b"", Packing::Plain).is_err());
    }
}
