//! What became of a file that is no picture any more: empty, cut short, something else, broken.

use std::fmt;

use super::first_other_byte;
use crate::output::Format;

/// What is wrong with a file that can't be compared as what it should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damage {
    /// The file has no bytes.
    Empty,
    /// The file ends where a file of its format goes on.
    CutShort {
        /// Bytes that are left.
        after: usize,
    },
    /// The file goes on after its end.
    Appended {
        /// Offset of the first byte after it.
        from: usize,
    },
    /// The file only says where Git LFS keeps the one that should be here.
    Pointer,
    /// The file does not begin as one of its format does.
    Other {
        /// Name of the format that its name promises.
        format: &'static str,
    },
    /// The file begins and ends as it should, and can't be read in between.
    Broken {
        /// Name of its format.
        format: &'static str,
        /// Offset of the first byte that is another one than today's.
        at: usize,
    },
}

/// What a pointer of Git LFS begins with (*Git LFS Specification*, "The Pointer").
const POINTER: &[u8] = b"version https://git-lfs.github.com/spec/";

/// Whether a file begins and ends as one of its format does: one that is cut short does not.
///
/// ```
/// use tracefig::{drift::is_whole, output::format};
/// let svg = format("svg").unwrap();
/// assert!(is_whole(svg, b"<svg></svg>\n") && !is_whole(svg, b"<svg></sv"));
/// ```
#[must_use]
pub fn is_whole(format: &Format, bytes: &[u8]) -> bool {
    let text = std::str::from_utf8(bytes).map(str::trim_ascii);
    let ended = text.map_or(bytes, str::as_bytes);
    format.bracket.begins.iter().any(|begin| ended.starts_with(begin))
        && format.bracket.ends.iter().any(|end| ended.ends_with(end))
}

/// What is wrong with a file of a format, which could not be read; `new` is what it should be. `None` where
/// it may be one of its format after all.
pub(super) fn damage(format: &'static Format, old: &[u8], new: &[u8]) -> Option<Damage> {
    let text = std::str::from_utf8(old).map(str::trim_ascii);
    let ended = text.map_or(old, str::as_bytes);
    if old.is_empty() {
        Some(Damage::Empty)
    } else if old.len() < new.len() && new.starts_with(old) {
        Some(Damage::CutShort { after: old.len() })
    } else if old.len() > new.len() && old.starts_with(new) {
        Some(Damage::Appended { from: new.len() })
    } else if old.starts_with(POINTER) {
        Some(Damage::Pointer)
    } else if !format.bracket.begins.iter().any(|begin| ended.starts_with(begin)) {
        Some(Damage::Other { format: format.name })
    } else if !format.bracket.ends.iter().any(|end| ended.ends_with(end)) {
        // What is appended to another picture of the format has that one's end before it.
        let end = format.bracket.ends.iter().filter_map(|end| Some(rfind(old, end)? + end.len())).max();
        Some(end.map_or(Damage::CutShort { after: old.len() }, |from| Damage::Appended { from }))
    } else if text.is_err() && format.read.is_some_and(|reader| reader.picture.is_some()) {
        Some(Damage::Broken { format: format.name, at: first_other_byte(old, new) })
    } else {
        None
    }
}

/// Where bytes are found last.
fn rfind(bytes: &[u8], sought: &[u8]) -> Option<usize> {
    bytes.windows(sought.len()).rposition(|found| found == sought)
}

impl fmt::Display for Damage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("the file is empty"),
            Self::CutShort { after } => write!(f, "the file is cut short after {} bytes", grouped(*after)),
            Self::Appended { from } => {
                write!(f, "the file goes on after its end, from byte {} on", grouped(*from))
            }
            Self::Pointer => f.write_str(
                "a Git LFS pointer and not the picture: `git lfs pull` fetches it, in a checkout of CI \
                 `lfs: true`",
            ),
            Self::Other { format } => write!(f, "the file is not {}", named(format)),
            Self::Broken { format, at } => {
                let (name, at) = (named(format), grouped(*at));
                write!(f, "the file can't be read as {name}; it differs from byte {at} on")
            }
        }
    }
}

/// A format with its article, by how its letters are said.
fn named(format: &str) -> String {
    let name = format.to_uppercase();
    let article = if name.starts_with(|c| "AEFHILMNORSX".contains(c)) { "an" } else { "a" };
    format!("{article} {name}")
}

/// A whole number with a comma between thousands.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::format;

    #[test]
    fn each_kind_of_damage_is_named() {
        let new = |name: &str| {
            let bracket = format(name).unwrap().bracket;
            [bracket.begins[0], &[b'x'; 6000], bracket.ends[0]].concat()
        };
        let said = |name: &'static str, old: &[u8]| {
            damage(format(name).unwrap(), old, &new(name)).map_or(String::new(), |found| found.to_string())
        };
        for name in ["svg", "png", "pdf", "html", "apng"] {
            assert_eq!(said(name, b""), "the file is empty");
            assert_eq!(said(name, &new(name)[..5000]), "the file is cut short after 5,000 bytes");
            let mut older = new(name)[..5000].to_vec();
            older[100] = b'y';
            assert_eq!(said(name, &older), "the file is cut short after 5,000 bytes", "an older one");
            let mut longer = new(name);
            longer[100] = b'y';
            let end = grouped(longer.len());
            longer.extend(b"zz");
            let goes_on = format!("the file goes on after its end, from byte {end} on");
            assert_eq!(said(name, &longer), goes_on, "an older one");
        }
        assert_eq!(said("png", b"<html>not found</html>"), "the file is not a PNG");
        assert_eq!(said("svg", b"version https://git-lfs.example/spec/v1"), "the file is not an SVG");
        let pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
        assert!(said("png", pointer).starts_with("a Git LFS pointer and not the picture: `git lfs pull`"));
        let mut broken = new("png");
        broken[2000] = 0xff;
        assert_eq!(said("png", &broken), "the file can't be read as a PNG; it differs from byte 2,000 on");
        assert_eq!(said("svg", b"<svg><ellipse/></svg>\n"), "", "a text of its kind has lines");
    }
}
