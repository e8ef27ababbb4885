//! Where two images differ, as numbers and as a picture.

use std::fmt;

use super::{Stamp, shows, text_chunk};
use crate::output::{Format, IMAGE, ImageWriter, Later, Pixel, Rows};

/// How the pixels of two images differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PixelDrift {
    /// Width and height of the old image in pixels.
    pub expected_size: (u32, u32),
    /// Width and height of the new one.
    pub actual_size: (u32, u32),
    /// How many pixels differ, of those that both images have.
    pub changed: u64,
    /// How many pixels differ by more than each of [`TOLERANCES`].
    pub beyond: [u64; TOLERANCES.len()],
    /// Largest difference of a channel, of 255.
    pub worst: u8,
    /// Left, top, right, bottom of the changed area in pixels, right and bottom not included; `None` where
    /// only the size changed.
    pub area: Option<[u32; 4]>,
    /// Which pictures differ, of files that play; numbers of pixels are then of all of them together.
    pub pictures: Option<PictureDrift>,
}

/// Which pictures of two files that play differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureDrift {
    /// How many pictures have pixels that differ.
    pub differ: u32,
    /// Number of the first of them, from 1.
    pub first: u32,
    /// How many pictures were compared.
    pub of: u32,
    /// Whether both files have as many pictures, each shown as long.
    pub play_alike: bool,
}

/// Channel levels for which a drift says how many pixels would still differ.
pub const TOLERANCES: [u8; 6] = [0, 1, 2, 4, 8, 16];

impl PixelDrift {
    /// How many pixels would still differ under each of [`TOLERANCES`], in a line for people.
    ///
    /// ```
    /// use tracefig::drift::PixelDrift;
    /// let (size, beyond) = ((9, 5), [12, 3, 0, 0, 0, 0]);
    /// let drift = PixelDrift {
    ///     expected_size: size, actual_size: size, changed: 12, beyond, worst: 2, area: Some([0, 0, 4, 3]),
    ///     pictures: None,
    /// };
    /// assert!(drift.under_tolerances().starts_with("pixels beyond a tolerance of 0: 12, 1: 3, 2: 0"));
    /// ```
    #[must_use]
    pub fn under_tolerances(&self) -> String {
        let each: Vec<_> = TOLERANCES.iter().zip(self.beyond).map(|(t, n)| format!("{t}: {n}")).collect();
        format!("pixels beyond a tolerance of {}", each.join(", "))
    }

    /// Whether the images have one size, are played alike, and no channel differs by more than `tolerance`
    /// levels.
    pub(super) fn is_within(&self, tolerance: u8) -> bool {
        let play_alike = self.pictures.is_none_or(|pictures| pictures.play_alike);
        play_alike && self.expected_size == self.actual_size && self.worst <= tolerance
    }
}

impl fmt::Display for PixelDrift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { expected_size: (w, h), actual_size: (x, y), changed, worst, area, pictures, .. } = self;
        if (w, h) != (x, y) {
            write!(f, "on disk {w} × {h} pixels, now {x} × {y}; ")?;
        }
        let pixels = if *changed == 1 { "pixel differs" } else { "pixels differ" };
        write!(f, "{changed} {pixels}, by {worst} of 255 levels at most")?;
        if let Some([x0, y0, x1, y1]) = area {
            write!(f, ", within x {x0} – {x1}, y {y0} – {y1}")?;
        }
        if let Some(PictureDrift { differ, first, of, play_alike }) = pictures {
            write!(f, "; in {differ} of {of} pictures, number {first} is the first")?;
            f.write_str(if *play_alike { "" } else { "; they are not played alike" })?;
        }
        Ok(())
    }
}

/// The format of a [`triptych`].
pub const TRIPTYCH_FORMAT: &Format = &IMAGE;

/// What stands in a [`triptych`] in the place of a figure's hash.
const TRIPTYCH_HASH: &str = "triptych";

/// Whether a file is a [`triptych`] of ours.
///
/// ```
/// assert!(!tracefig::drift::is_triptych(b"a picture of somebody else"));
/// ```
#[must_use]
pub fn is_triptych(bytes: &[u8]) -> bool {
    Stamp::read(TRIPTYCH_FORMAT, bytes).is_some_and(|stamp| stamp.hash == TRIPTYCH_HASH)
}

/// Grey columns between the three pictures of a [`triptych`].
const GAP: u32 = 16;

/// How dark an unchanged pixel stays in the difference picture, out of 255: enough to recognise the figure.
/// At twice it competes with the marks; at half a thin line is gone.
const FADED: u32 = 60;

/// The colour of a pixel that differs, a pink that no theme has.
const MARK: [u8; 4] = [255, 0, 255, 255];

/// How two files differ, or that they do not.
pub(super) struct Compared {
    /// How the pixels differ; `None` where all are the same.
    pub(super) drift: Option<PixelDrift>,
    /// Whether what they play has as many pictures, each shown as long.
    pub(super) play_alike: bool,
    /// The picture of it, where it was asked for and they differ; of files that play, of the first that does.
    pub(super) triptych: Option<Vec<u8>>,
}

/// Whether there is to be a picture of the difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shown {
    /// Numbers suffice.
    No,
    /// A picture is made, in [`TRIPTYCH_FORMAT`].
    Yes,
}

/// Compares two files row by row, and picture by picture where both are of one size and play; `None` where a
/// picture can't be read to its end.
pub(super) fn compared<'b>(mut old: Rows<'b>, mut new: Rows<'b>, shown: Shown) -> Option<Compared> {
    let (old_size, new_size) = (old.size(), new.size());
    let (mut found, mut triptych) = (Found::default(), None);
    let mut play_alike = old.pace() == new.pace();
    let mut pictures = PictureDrift { differ: 0, first: 0, of: 0, play_alike };
    loop {
        let before = found.beyond[0];
        let mut picture = match shown {
            Shown::Yes if triptych.is_none() => Some(Triptych::new(old_size, new_size)?),
            Shown::Yes | Shown::No => None,
        };
        rows_compared([&mut old, &mut new], &mut found, &mut picture)?;
        let picture = match picture {
            Some(picture) => Some(picture.rows.finish()?),
            None => None,
        };
        pictures.of += 1;
        if found.beyond[0] > before || old_size != new_size {
            pictures.differ += 1;
            pictures.first = if pictures.differ == 1 { pictures.of } else { pictures.first };
            triptych = triptych.or(picture);
        }
        // Files of one size are as much work as ours alone.
        if old_size != new_size {
            break;
        }
        match (old.next_picture(), new.next_picture()) {
            (Later::Next, Later::Next) => play_alike &= old.pace() == new.pace(),
            (Later::End, Later::End) => break,
            _ => {
                play_alike = false;
                break;
            }
        }
    }
    let mut drift = found.drift(old_size, new_size);
    if let Some(drift) = drift.as_mut().filter(|_| new.pace().is_some()) {
        drift.pictures = Some(PictureDrift { play_alike, ..pictures });
    }
    Some(Compared { drift, play_alike, triptych })
}

/// Compares a picture of each file, row by row into the picture of their difference where that is to be
/// shown; `None` where a file ends too early.
fn rows_compared(
    [old, new]: [&mut Rows<'_>; 2],
    found: &mut Found,
    picture: &mut Option<Triptych>,
) -> Option<()> {
    let (old_size, new_size) = (old.size(), new.size());
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for y in 0..old_size.1.max(new_size.1) {
        a.clear();
        b.clear();
        if y < old_size.1 && !old.next_into(&mut a) || y < new_size.1 && !new.next_into(&mut b) {
            return None;
        }
        found.row(y, &a, &b);
        if let Some(picture) = picture {
            picture.row(&a, &b)?;
        }
    }
    Some(())
}

/// What differs in the rows so far.
#[derive(Default)]
struct Found {
    /// How many pixels differ by more than each of [`TOLERANCES`].
    beyond: [u64; TOLERANCES.len()],
    /// Largest difference of a channel.
    worst: u8,
    /// Left, top, right, bottom of what differs.
    area: Option<[u32; 4]>,
}

impl Found {
    /// Compares the pixels that both rows have.
    fn row(&mut self, y: u32, old: &[Pixel], new: &[Pixel]) {
        let both = old.len().min(new.len());
        if old[..both] == new[..both] {
            return;
        }
        for (x, (a, b)) in (0_u32..).zip(old.iter().zip(new)).filter(|(_, (a, b))| a != b) {
            let difference = a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).fold(0, u8::max);
            self.worst = self.worst.max(difference);
            for (count, tolerance) in self.beyond.iter_mut().zip(TOLERANCES) {
                *count += u64::from(difference > tolerance);
            }
            let [x0, y0, x1, y1] = self.area.unwrap_or([x, y, x + 1, y + 1]);
            self.area = Some([x0.min(x), y0.min(y), x1.max(x + 1), y1.max(y + 1)]);
        }
    }

    fn drift(&self, expected_size: (u32, u32), actual_size: (u32, u32)) -> Option<PixelDrift> {
        let Self { beyond, worst, area } = *self;
        let changed = beyond[0];
        let differs = changed > 0 || expected_size != actual_size;
        differs.then_some(PixelDrift {
            expected_size,
            actual_size,
            changed,
            beyond,
            worst,
            area,
            pictures: None,
        })
    }
}

/// An image of on disk · difference · now beside one another, in [`TRIPTYCH_FORMAT`]; in the middle the
/// new image faded, with every pixel that differs marked. `expected` and `actual` are files of one format;
/// outlines are drawn at `scale` pixels for a page pixel. `None` where a file can't be read as a picture, or
/// where no pixel differs.
///
/// ```
/// use tracefig::{drift::triptych, output::format};
/// let svg = format("svg").unwrap();
/// assert_eq!(triptych(svg, b"<svg/>", b"<svg />", 1.0), None);
/// ```
#[must_use]
pub fn triptych(format: &Format, expected: &[u8], actual: &[u8], scale: f64) -> Option<Vec<u8>> {
    let (old, new) = (shows(format, expected).ok()?, shows(format, actual).ok()?);
    compared(old.rows(scale).ok()?, new.rows(scale).ok()?, Shown::Yes)?.triptych
}

/// The three pictures in one, row by row.
struct Triptych {
    /// Where the rows go.
    rows: ImageWriter,
    /// Pixels a row of each picture.
    each: usize,
    /// The last row.
    row: Vec<Pixel>,
}

impl Triptych {
    /// Grey, where a picture has no pixel.
    const NOTHING: Pixel = [128, 128, 128, 255];

    fn new(old: (u32, u32), new: (u32, u32)) -> Option<Self> {
        let (each, height) = (old.0.max(new.0), old.1.max(new.1));
        let width = each.checked_mul(3)?.checked_add(2 * GAP)?;
        let rows = ImageWriter::new((width, height), &text_chunk(TRIPTYCH_HASH))?;
        Some(Self { rows, each: each as usize, row: Vec::with_capacity(width as usize) })
    }

    fn row(&mut self, old: &[Pixel], new: &[Pixel]) -> Option<()> {
        let (each, row) = (self.each, &mut self.row);
        let gap = GAP as usize;
        row.clear();
        row.extend(old.iter().copied().map(on_white));
        row.resize(each + gap, Self::NOTHING);
        row.extend(old.iter().zip(new).map(|(a, b)| if a == b { faded(on_white(*b)) } else { MARK }));
        row.resize(each + gap + old.len().max(new.len()), MARK);
        row.resize(2 * (each + gap), Self::NOTHING);
        row.extend(new.iter().copied().map(on_white));
        row.resize(3 * each + 2 * gap, Self::NOTHING);
        self.rows.row(row)
    }
}

/// A pixel as it looks on white paper: the picture of a difference is opaque.
#[expect(clippy::cast_possible_truncation, reason = "a weighted mean of bytes is a byte")]
fn on_white(pixel: [u8; 4]) -> [u8; 4] {
    let opacity = u32::from(pixel[3]);
    let lay = |c: u8| ((u32::from(c) * opacity + 255 * (255 - opacity) + 127) / 255) as u8;
    [lay(pixel[0]), lay(pixel[1]), lay(pixel[2]), 255]
}

#[expect(clippy::cast_possible_truncation, reason = "a weighted mean of bytes is a byte")]
fn faded(pixel: [u8; 4]) -> [u8; 4] {
    let fade = |c: u8| (255 - (255 - u32::from(c)) * FADED / 255) as u8;
    [fade(pixel[0]), fade(pixel[1]), fade(pixel[2]), 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain((width, height): (u32, u32), dot: Option<(u32, u32)>) -> Vec<u8> {
        let mut rows = ImageWriter::new((width, height), "x 0").unwrap();
        for y in 0..height {
            let pixel = |x| if dot == Some((x, y)) { [0, 90, 0, 255] } else { [255; 4] };
            rows.row(&(0..width).map(pixel).collect::<Vec<_>>()).unwrap();
        }
        rows.finish().unwrap()
    }

    fn drift(old: &[u8], new: &[u8]) -> Option<PixelDrift> {
        let (old, new) = (shows(TRIPTYCH_FORMAT, old).unwrap(), shows(TRIPTYCH_FORMAT, new).unwrap());
        compared(old.rows(1.0).unwrap(), new.rows(1.0).unwrap(), Shown::No).unwrap().drift
    }

    #[test]
    fn a_dot_is_found_where_it_is() {
        let (old, new) = (plain((9, 5), None), plain((9, 5), Some((7, 2))));
        let got = drift(&old, &new).unwrap();
        assert_eq!((got.changed, got.worst, got.area), (1, 255, Some([7, 2, 8, 3])));
        assert_eq!(drift(&old, &old), None);
    }

    #[test]
    fn another_size_is_a_difference() {
        let got = drift(&plain((9, 5), None), &plain((9, 6), None)).unwrap();
        assert_eq!((got.changed, got.area), (0, None));
        assert!(got.to_string().starts_with("on disk 9 × 5 pixels, now 9 × 6"));
    }

    #[test]
    fn the_picture_marks_what_differs_and_nothing_else() {
        let (old, new) = (plain((9, 5), None), plain((8, 6), Some((7, 2))));
        let bytes = triptych(TRIPTYCH_FORMAT, &old, &new, 1.0).unwrap();
        let picture = shows(TRIPTYCH_FORMAT, &bytes).unwrap();
        let mut rows = picture.rows(1.0).unwrap();
        assert_eq!(rows.size(), (3 * 9 + 2 * GAP, 6));
        let (mut row, mut marked) = (Vec::new(), Vec::new());
        let mut y = 0_u32;
        while rows.next_into(&mut row) {
            marked.extend((0_u32..).zip(&row).filter(|(_, p)| **p == MARK).map(|(x, _)| (x, y)));
            y += 1;
        }
        let middle = 9 + GAP;
        // The dot, the column that only the old one has, the row that only the new one has.
        let mut expected: Vec<_> = (0..5).map(|y| (middle + 8, y)).chain([(middle + 7, 2)]).collect();
        expected.extend((0..8).map(|x| (middle + x, 5)));
        expected.sort_by_key(|&(x, y)| (y, x));
        assert_eq!(marked, expected);
    }
}
