//! Whether a figure is still what lies on disk, and if not, where it differs.
//!
//! A [`Rendered`] file is compared with the bytes that are there. Each [`Format`] says how its files are read
//! again: an image is compared by its pixels, and so is a page of outlines, which is drawn; other files are
//! texts, of which the first differing line is said. Where pixels differ there is a picture of *on disk ·
//! difference · now*. What both files say of themselves (a [`Stamp`]) tells whether the scene changed or
//! what tracefig makes of it, and which numbers moved; two pages of outlines also tell which of their
//! elements did.

mod damage;
mod elements;
mod measured;
mod moved;
mod pixels;
pub mod report;
mod shown;
mod stamp;
mod text;
mod visible;

pub use damage::{Damage, is_whole};
pub use elements::{Element, elements_in};
pub use measured::Measured;
pub use pixels::{PictureDrift, PixelDrift, TOLERANCES, TRIPTYCH_FORMAT, is_triptych, triptych};
pub use stamp::{
    Stamp, facts, fingerprint, hash_of_line, hash_of_part, metadata, restamped, text_chunk,
    text_chunk_of_several,
};
pub use text::LineDrift;

use crate::output::{Format, MOST_BYTES, Picture, TooMuch, Unread, sheets_apart};
use damage::damage;
use moved::moved;
use pixels::{Shown, compared};
use visible::seen;

/// A file that the scene gives now.
#[derive(Clone, Copy, Debug)]
pub struct Rendered<'b> {
    /// What it is written as.
    pub format: &'static Format,
    /// The file, byte for byte.
    pub bytes: &'b [u8],
    /// Pixels for a page pixel, at which outlines are drawn to be compared.
    pub scale: f64,
}

/// What became of a figure's file.
#[derive(Clone, Debug, PartialEq)]
pub enum State {
    /// What lies there has the same bytes.
    Identical,
    /// The bytes differ, though scene and options are the same: tracefig draws otherwise now.
    Changed(Change),
    /// The bytes differ, and the scene or the options have changed since.
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
    /// Pages of outlines, as SVG.
    Picture {
        /// How they differ when drawn; `None` where they do not.
        pixels: Option<PixelDrift>,
        /// The first difference of their texts.
        line: LineDrift,
        /// Largest difference of a colour of their style sheets, in levels of 255; `None` where anything else
        /// that is read, found or followed, title, description, words or rule, is another one.
        sheet: Option<u8>,
    },
    /// Texts that only end their lines otherwise: the old one by CR LF, as git may check it out.
    LineEnds {
        /// Name of their format.
        format: &'static str,
    },
    /// The file has more of something than any that we write, so it was not looked at further.
    NotOurs(TooMuch),
    /// The file is empty, cut short, of another kind or broken.
    Damaged(Damage),
    /// Texts that are no pictures of ours; their first difference.
    Line(LineDrift),
    /// Files of other kinds, or that can't be read as what they should be.
    Bytes {
        /// Offset of the first byte that differs.
        at: usize,
    },
}

impl Change {
    /// How the pixels differ; `None` where they do not, or where the files are no pictures.
    ///
    /// ```
    /// use tracefig::drift::Change;
    /// assert_eq!(Change::Packing.pixels(), None);
    /// ```
    #[must_use]
    pub fn pixels(&self) -> Option<&PixelDrift> {
        match self {
            Self::Pixels(drift) => Some(drift),
            Self::Picture { pixels, .. } => pixels.as_ref(),
            _ => None,
        }
    }

    /// Whether no channel of a pixel differs by more than `tolerance` levels of 255. What is no picture of
    /// ours is within no tolerance, and other bytes are not within 0.
    ///
    /// ```
    /// use tracefig::drift::Change;
    /// assert!(!Change::Packing.is_within(0) && Change::Packing.is_within(1));
    /// assert!(!Change::Bytes { at: 3 }.is_within(255));
    /// ```
    #[must_use]
    pub fn is_within(&self, tolerance: u8) -> bool {
        match self {
            Self::Pixels(drift) => drift.is_within(tolerance),
            Self::Packing | Self::LineEnds { .. } => tolerance > 0,
            Self::Picture { pixels, sheet, .. } => {
                let same = pixels.as_ref().is_none_or(|drift| drift.is_within(tolerance));
                same && tolerance > 0 && sheet.is_some_and(|levels| levels <= tolerance)
            }
            Self::NotOurs(_) | Self::Damaged(_) | Self::Line(_) | Self::Bytes { .. } => false,
        }
    }
}

impl State {
    /// The state's word: "identical", "changed", "stale" or "missing".
    ///
    /// ```
    /// use tracefig::{drift::{Rendered, State, compare}, output::format};
    /// let now = Rendered { format: format("svg").unwrap(), bytes: b"<svg/>", scale: 2.0 };
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

/// Compares a file with what lies in its place; `on_disk` is `None` where nothing does.
///
/// ```
/// use tracefig::{drift::{Change, Rendered, State, compare}, output::format};
/// let now = Rendered { format: format("svg").unwrap(), bytes: b"<svg/>", scale: 2.0 };
/// let State::Changed(Change::Line(drift)) = compare(Some(b"<svg />"), now) else { panic!("another text") };
/// assert_eq!((drift.line, drift.column), (1, 5));
/// ```
#[must_use]
pub fn compare(on_disk: Option<&[u8]>, rendered: Rendered<'_>) -> State {
    state(on_disk, rendered, Shown::No).0
}

/// What [`compare`] gives, and the picture that [`triptych`] gives, in one go.
///
/// ```
/// use tracefig::{drift::{Rendered, State, compare_and_show}, output::format};
/// let now = Rendered { format: format("svg").unwrap(), bytes: b"<svg/>", scale: 2.0 };
/// assert_eq!(compare_and_show(None, now), (State::Missing, None));
/// ```
#[must_use]
pub fn compare_and_show(on_disk: Option<&[u8]>, rendered: Rendered<'_>) -> (State, Option<Vec<u8>>) {
    state(on_disk, rendered, Shown::Yes)
}

fn state(on_disk: Option<&[u8]>, rendered: Rendered<'_>, shown: Shown) -> (State, Option<Vec<u8>>) {
    match on_disk {
        None => (State::Missing, None),
        Some(old) if old == rendered.bytes => (State::Identical, None),
        Some(old) if old.len() > MOST_BYTES => {
            let too_much = TooMuch { what: "bytes", most: MOST_BYTES };
            (State::Changed(Change::NotOurs(too_much)), None)
        }
        Some(old) => {
            let (change, triptych) = change(old, rendered, shown);
            let stamp = |bytes| Stamp::read(rendered.format, bytes);
            let state = match (stamp(old), stamp(rendered.bytes)) {
                (Some(then), Some(now)) if then.hash != now.hash => State::Stale(change),
                _ => State::Changed(change),
            };
            (state, triptych)
        }
    }
}

/// What moved between two files of a figure, of one format, in words: numbers of the answer and of the trace,
/// then what is seen. Empty where they do not say.
///
/// ```
/// use tracefig::{drift::{metadata, what_moved}, output::format};
/// let svg = |separation: f64| {
///     let facts = format!("\"answer\":{{\"separation\":{separation}}}");
///     format!("<svg><metadata>{}</metadata></svg>", metadata("00ff", &facts))
/// };
/// let lines = what_moved(format("svg").unwrap(), svg(1.42).as_bytes(), svg(1.37).as_bytes());
/// assert_eq!(lines, ["separation: 1.42 → 1.37"]);
/// ```
#[must_use]
pub fn what_moved(format: &Format, old: &[u8], new: &[u8]) -> Vec<String> {
    let facts = |bytes| Stamp::read(format, bytes).and_then(|stamp| stamp.facts);
    let mut lines = match (facts(old), facts(new)) {
        (Some(old), Some(new)) => moved(&old, &new),
        _ => Vec::new(),
    };
    if let (
        Ok(Picture::Drawing { drawing: old, sheet: old_sheet, found: old_found, told: old_told }),
        Ok(Picture::Drawing { drawing: new, sheet: new_sheet, found: new_found, told: new_told }),
    ) = (shows(format, old), shows(format, new))
    {
        lines.extend(seen(&old, &new));
        lines.extend(visible::words("words that are found", &old_found, &new_found));
        lines.extend(visible::words("words for a screen reader", &old_told, &new_told));
        if old_sheet != new_sheet {
            lines.push("the style sheet, which pages and dark systems follow, is another one".to_owned());
        }
    }
    lines
}

/// What a file of a format shows.
fn shows<'b>(format: &Format, bytes: &'b [u8]) -> Result<Picture<'b>, Unread> {
    let read = format.read.and_then(|reader| reader.picture).ok_or(Unread::Other)?;
    read(bytes)
}

/// How two files that differ do so, and the picture of it where it is to be shown.
fn change(old: &[u8], rendered: Rendered<'_>, shown: Shown) -> (Change, Option<Vec<u8>>) {
    let (new, read) = (rendered.bytes, |bytes| shows(rendered.format, bytes));
    if text::are_other_ends(old, new) {
        return (Change::LineEnds { format: rendered.format.name }, None);
    }
    match (read(old), read(new)) {
        (Err(Unread::TooMuch(too_much)), _) => return (Change::NotOurs(too_much), None),
        (Ok(a), Ok(b)) => match (a.rows(rendered.scale), b.rows(rendered.scale)) {
            (Err(Unread::TooMuch(too_much)), _) => return (Change::NotOurs(too_much), None),
            (Ok(old_rows), Ok(new_rows)) => {
                let compared = compared(old_rows, new_rows, shown);
                // The same pictures, shown longer, or followed by something that can't be read.
                if compared.as_ref().is_some_and(|found| found.drift.is_none() && !found.play_alike) {
                    return (Change::Bytes { at: first_other_byte(old, new) }, None);
                }
                if let Some(compared) = compared
                    && let Some(change) = picture_change(&a, &b, compared.drift, lines(old, new))
                {
                    return (change, compared.triptych);
                }
            }
            _ => {}
        },
        _ => {}
    }
    if let Some(damage) = damage(rendered.format, old, new) {
        return (Change::Damaged(damage), None);
    }
    let line = lines(old, new).map(Change::Line);
    (line.unwrap_or_else(|| Change::Bytes { at: first_other_byte(old, new) }), None)
}

/// Offset of the first byte that differs; where one file is the beginning of the other, its length.
fn first_other_byte(old: &[u8], new: &[u8]) -> usize {
    old.iter().zip(new).position(|(a, b)| a != b).unwrap_or(old.len().min(new.len()))
}

/// How two pictures differ, given how their pixels do; `None` where they are not of one kind.
fn picture_change(
    old: &Picture<'_>,
    new: &Picture<'_>,
    drift: Option<PixelDrift>,
    line: Option<LineDrift>,
) -> Option<Change> {
    match (old, new) {
        (Picture::Image(_), Picture::Image(_)) => Some(drift.map_or(Change::Packing, Change::Pixels)),
        (
            Picture::Drawing { drawing: a, sheet: old_sheet, found: old_found, told: old_told },
            Picture::Drawing { drawing: b, sheet: new_sheet, found: new_found, told: new_told },
        ) => {
            let same_unseen = old_found == new_found && old_told == new_told;
            let same_words = a.title == b.title && a.desc == b.desc && same_unseen;
            let sheet = if same_words { sheets_apart(old_sheet, new_sheet) } else { None };
            Some(Change::Picture { pixels: drift, line: line?, sheet })
        }
        _ => None,
    }
}

/// The first difference of two files as texts; `None` where one is no text.
fn lines(old: &[u8], new: &[u8]) -> Option<LineDrift> {
    text::drift(std::str::from_utf8(old).ok()?, std::str::from_utf8(new).ok()?)
}

impl std::fmt::Display for Change {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Pixels(drift) | Self::Picture { pixels: Some(drift), .. } => drift.fmt(f),
            Self::Packing => f.write_str("the same pixels in other bytes (packing, or the text inside)"),
            Self::LineEnds { format } => write!(
                f,
                "the same text, but its lines end in CR LF, as `core.autocrlf` of git makes them: a line \
                 `*.{format} -text` in .gitattributes keeps them"
            ),
            Self::Picture { pixels: None, line, .. } => write!(f, "the same picture in other bytes; {line}"),
            Self::NotOurs(too_much) => write!(f, "not what tracefig writes: {too_much}"),
            Self::Damaged(damage) => damage.fmt(f),
            Self::Line(line) => line.fmt(f),
            Self::Bytes { at } => write!(f, "the files differ from byte {at} on"),
        }
    }
}

#[cfg(test)]
mod tests;
