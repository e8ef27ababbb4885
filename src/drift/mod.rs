//! Whether a figure is still what lies on disk, and if not, where it differs.
//!
//! A [`Rendered`] file is compared with the bytes that are there: texts by their first differing line, images by their
//! pixels, with a picture of *expected · difference · actual* beside one another. What both files say of themselves (a
//! [`Stamp`]) tells whether the scene changed or what tracefig makes of it, and which numbers moved.

mod elements;
mod moved;
mod pixels;
pub mod report;
mod stamp;
mod text;

pub use elements::elements_in;
pub use moved::moved;
pub use pixels::{PixelDrift, TOLERANCES, triptych};
pub use stamp::{STAMP_FORMAT, Stamp, facts, fingerprint, metadata, text_chunk};
pub use text::LineDrift;

/// A file that the scene gives now.
#[derive(Clone, Copy, Debug)]
pub struct Rendered<'b> {
    /// The end of its name: "svg", "png", …
    pub extension: &'b str,
    /// Its bytes.
    pub bytes: &'b [u8],
}

/// What became of a figure's file.
#[derive(Clone, Debug, PartialEq)]
pub enum State {
    /// The same bytes.
    Identical,
    /// Other bytes, of the same scene and options.
    Changed(Change),
    /// Other bytes, and the scene or the options have changed since.
    Stale(Change),
    /// There is no file.
    Missing,
}

/// How two files differ.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// Images with different pixels.
    Pixels(PixelDrift),
    /// Images with the same pixels in other bytes: packed otherwise, or with another text inside.
    Packing,
    /// Texts.
    Line(LineDrift),
    /// Files of other kinds, or that can't be read as what they should be.
    Bytes {
        /// Offset of the first byte that differs.
        at: usize,
    },
}

impl State {
    /// Its word: "identical", "changed", "stale" or "missing".
    ///
    /// ```
    /// use tracefig::drift::{Rendered, State, compare};
    /// let now = Rendered { extension: "svg", bytes: b"<svg/>" };
    /// assert_eq!(compare(Some(b"<svg/>"), now).word(), "identical");
    /// assert_eq!(compare(None, now).word(), "missing");
    /// assert_eq!(compare(Some(b"<svg />"), now).word(), "changed");
    /// ```
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Identical => "identical",
            Self::Changed(_) => "changed",
            Self::Stale(_) => "stale",
            Self::Missing => "missing",
        }
    }
}

/// Compares a file with what lies in its place; `on_disk` is None where nothing does.
#[must_use]
pub fn compare(on_disk: Option<&[u8]>, rendered: Rendered<'_>) -> State {
    match on_disk {
        None => State::Missing,
        Some(old) if old == rendered.bytes => State::Identical,
        Some(old) => {
            let change = change(old, rendered);
            match (Stamp::read(old), Stamp::read(rendered.bytes)) {
                (Some(then), Some(now)) if then.hash != now.hash => State::Stale(change),
                _ => State::Changed(change),
            }
        }
    }
}

/// What moved between two files of a figure, in words; empty where they do not say.
#[must_use]
pub fn what_moved(old: &[u8], new: &[u8]) -> Vec<String> {
    let facts = |bytes| Stamp::read(bytes).and_then(|stamp| stamp.facts);
    match (facts(old), facts(new)) {
        (Some(old), Some(new)) => moved(&old, &new),
        _ => Vec::new(),
    }
}

fn change(old: &[u8], rendered: Rendered<'_>) -> Change {
    let new = rendered.bytes;
    if rendered.extension == "png"
        && let (Some(old), Some(new)) = (pixels::decode(old), pixels::decode(new))
    {
        return pixels::drift(&old, &new).map_or(Change::Packing, Change::Pixels);
    }
    if let (Ok(old), Ok(new)) = (std::str::from_utf8(old), std::str::from_utf8(new))
        && let Some(line) = text::drift(old, new)
    {
        return Change::Line(line);
    }
    let at = old.iter().zip(new).position(|(a, b)| a != b).unwrap_or(old.len().min(new.len()));
    Change::Bytes { at }
}

impl std::fmt::Display for Change {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Pixels(drift) => drift.fmt(f),
            Self::Packing => f.write_str("the same pixels in other bytes (packing, or the text inside)"),
            Self::Line(line) => line.fmt(f),
            Self::Bytes { at } => write!(f, "the files differ from byte {at} on"),
        }
    }
}
