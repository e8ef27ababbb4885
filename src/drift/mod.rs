//! Whether a figure is still what lies on disk, and if not, where it differs.
//!
//! A [`Rendered`] file is compared with the bytes that are there. A PNG is compared by its pixels, and so is an SVG of ours: it
//! is read again and drawn; other files are texts, of which the first differing line is said. Where pixels differ there is
//! a picture of *expected · difference · actual*. What both files say of themselves (a [`Stamp`]) tells whether the scene
//! changed or what tracefig makes of it, and which numbers moved; two SVGs also tell which of their elements did.

mod elements;
mod moved;
mod picture;
mod pixels;
pub mod report;
mod shown;
mod stamp;
mod text;
mod visible;

pub use elements::elements_in;
pub use moved::moved;
pub use pixels::{PixelDrift, TOLERANCES, triptych};
pub use stamp::{STAMP_FORMAT, Stamp, facts, fingerprint, metadata, text_chunk};
pub use text::LineDrift;
pub use visible::seen;

/// A file that the scene gives now.
#[derive(Clone, Copy, Debug)]
pub struct Rendered<'b> {
    /// The end of its name: "svg", "png", …
    pub extension: &'b str,
    /// Its bytes.
    pub bytes: &'b [u8],
    /// Pixels for a page pixel, at which SVGs are drawn to be compared.
    pub scale: f64,
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
    /// PNGs with different pixels.
    Pixels(PixelDrift),
    /// PNGs with the same pixels in other bytes: packed otherwise, or with another text inside.
    Packing,
    /// SVGs of ours.
    Picture {
        /// How they differ when drawn; None where they do not.
        pixels: Option<PixelDrift>,
        /// The first difference of their texts.
        line: LineDrift,
        /// Largest difference of a colour of their style sheets, in levels; None where anything else that is read or
        /// followed, title, description or rule, is another one.
        sheet: Option<u8>,
    },
    /// Texts.
    Line(LineDrift),
    /// Files of other kinds, or that can't be read as what they should be.
    Bytes {
        /// Offset of the first byte that differs.
        at: usize,
    },
}

impl Change {
    /// How the pixels differ, where they are known to.
    #[must_use]
    pub fn pixels(&self) -> Option<&PixelDrift> {
        match self {
            Self::Pixels(drift) => Some(drift),
            Self::Picture { pixels, .. } => pixels.as_ref(),
            _ => None,
        }
    }

    /// Whether no channel of a pixel differs by more than so many levels. What is no picture of ours is within none.
    #[must_use]
    pub fn is_within(&self, tolerance: u8) -> bool {
        match self {
            Self::Pixels(drift) => drift.is_within(tolerance),
            Self::Packing => tolerance > 0,
            Self::Picture { pixels, sheet, .. } => {
                let same = pixels.as_ref().is_none_or(|drift| drift.is_within(tolerance));
                same && tolerance > 0 && sheet.is_some_and(|levels| levels <= tolerance)
            }
            Self::Line(_) | Self::Bytes { .. } => false,
        }
    }
}

impl State {
    /// Its word: "identical", "changed", "stale" or "missing".
    ///
    /// ```
    /// use tracefig::drift::{Rendered, State, compare};
    /// let now = Rendered { extension: "svg", bytes: b"<svg/>", scale: 2.0 };
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

/// What moved between two files of a figure, in words: numbers of the answer and of the trace, then what is seen. Empty
/// where they do not say.
#[must_use]
pub fn what_moved(old: &[u8], new: &[u8]) -> Vec<String> {
    let facts = |bytes| Stamp::read(bytes).and_then(|stamp| stamp.facts);
    let mut lines = match (facts(old), facts(new)) {
        (Some(old), Some(new)) => moved(&old, &new),
        _ => Vec::new(),
    };
    if let (Some(old), Some(new)) = (picture::read(old), picture::read(new)) {
        lines.extend(seen(&old.drawing, &new.drawing));
        if old.sheet != new.sheet {
            lines.push("the style sheet, which pages and dark systems follow, is another one".to_owned());
        }
    }
    lines
}

fn change(old: &[u8], rendered: Rendered<'_>) -> Change {
    let new = rendered.bytes;
    let image = |bytes| pixels::image(bytes, rendered.scale);
    let drift = match (image(old), image(new)) {
        (Some(old), Some(new)) => Some(pixels::drift(&old, &new)),
        _ => None,
    };
    let texts = (std::str::from_utf8(old), std::str::from_utf8(new));
    let line = if let (Ok(old), Ok(new)) = texts { text::drift(old, new) } else { None };
    match (drift, line) {
        (Some(pixels), Some(line)) => {
            Change::Picture { pixels, line, sheet: picture::sheets_apart(old, new) }
        }
        (Some(Some(drift)), None) => Change::Pixels(drift),
        (Some(None), None) => Change::Packing,
        (None, Some(line)) => Change::Line(line),
        (None, None) => {
            let at = old.iter().zip(new).position(|(a, b)| a != b);
            Change::Bytes { at: at.unwrap_or(old.len().min(new.len())) }
        }
    }
}

impl std::fmt::Display for Change {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Pixels(drift) | Self::Picture { pixels: Some(drift), .. } => drift.fmt(f),
            Self::Packing => f.write_str("the same pixels in other bytes (packing, or the text inside)"),
            Self::Picture { pixels: None, line, .. } => write!(f, "the same picture in other bytes; {line}"),
            Self::Line(line) => line.fmt(f),
            Self::Bytes { at } => write!(f, "the files differ from byte {at} on"),
        }
    }
}

#[cfg(test)]
mod tests;
