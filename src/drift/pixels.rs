//! Where two images differ, as numbers and as a picture.

use std::fmt;

use super::shows;
use crate::output::{Format, IMAGE, Picture, Pixels, encode_pixels, rasterize};

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
    /// };
    /// assert!(drift.under_tolerances().starts_with("pixels beyond a tolerance of 0: 12, 1: 3, 2: 0"));
    /// ```
    #[must_use]
    pub fn under_tolerances(&self) -> String {
        let each: Vec<_> = TOLERANCES.iter().zip(self.beyond).map(|(t, n)| format!("{t}: {n}")).collect();
        format!("pixels beyond a tolerance of {}", each.join(", "))
    }

    /// Whether the images have one size and no channel differs by more than `tolerance` levels.
    pub(super) fn is_within(&self, tolerance: u8) -> bool {
        self.expected_size == self.actual_size && self.worst <= tolerance
    }
}

impl fmt::Display for PixelDrift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { expected_size: (w, h), actual_size: (x, y), changed, worst, area, .. } = self;
        if (w, h) != (x, y) {
            write!(f, "expected {w} × {h} pixels, got {x} × {y}; ")?;
        }
        write!(f, "{changed} pixels differ, by {worst} of 255 levels at most")?;
        if let Some([x0, y0, x1, y1]) = area {
            write!(f, ", within x {x0} – {x1}, y {y0} – {y1}")?;
        }
        Ok(())
    }
}

/// The format of a [`triptych`].
pub const TRIPTYCH_FORMAT: &Format = &IMAGE;

/// Grey columns between the three pictures of a [`triptych`].
const GAP: u32 = 16;

/// How dark an unchanged pixel stays in the difference picture, out of 255: enough to recognise the figure.
/// At twice it competes with the marks; at half a thin line is gone.
const FADED: u32 = 60;

/// The colour of a pixel that differs, a pink that no theme has.
const MARK: [u8; 4] = [255, 0, 255, 255];

/// The pixels of a picture; outlines are drawn at `scale` pixels for a page pixel. `None` where that is more
/// than an image may have.
pub(super) fn image(picture: &Picture, scale: f64) -> Option<Pixels> {
    match picture {
        Picture::Pixels(pixels) => Some(pixels.clone()),
        Picture::Drawing { drawing, .. } => rasterize(drawing, scale).ok(),
    }
}

/// A pixel of an image; `None` outside it.
fn at(image: &Pixels, x: u32, y: u32) -> Option<[u8; 4]> {
    if x >= image.width || y >= image.height {
        return None;
    }
    let i = 4 * (y as usize * image.width as usize + x as usize);
    image.rgba.get(i..i + 4)?.try_into().ok()
}

/// How two images differ; `None` where all pixels are the same.
pub(super) fn drift(old: &Pixels, new: &Pixels) -> Option<PixelDrift> {
    let (mut beyond, mut worst, mut area) = ([0; TOLERANCES.len()], 0, None::<[u32; 4]>);
    for y in 0..old.height.min(new.height) {
        for x in 0..old.width.min(new.width) {
            let (Some(a), Some(b)) = (at(old, x, y), at(new, x, y)) else { continue };
            if a == b {
                continue;
            }
            let difference = a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).fold(0, u8::max);
            worst = worst.max(difference);
            for (count, tolerance) in beyond.iter_mut().zip(TOLERANCES) {
                *count += u64::from(difference > tolerance);
            }
            let [x0, y0, x1, y1] = area.unwrap_or([x, y, x + 1, y + 1]);
            area = Some([x0.min(x), y0.min(y), x1.max(x + 1), y1.max(y + 1)]);
        }
    }
    let (expected_size, actual_size) = ((old.width, old.height), (new.width, new.height));
    let changed = beyond[0];
    (changed > 0 || expected_size != actual_size).then_some(PixelDrift {
        expected_size,
        actual_size,
        changed,
        beyond,
        worst,
        area,
    })
}

/// An image of expected · difference · actual beside one another, in [`TRIPTYCH_FORMAT`]; in the middle the
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
    let read = |bytes| image(&shows(format, bytes)?, scale);
    encode_pixels(&beside(&read(expected)?, &read(actual)?)?)
}

/// The three pictures in one; `None` where no pixel differs.
fn beside(old: &Pixels, new: &Pixels) -> Option<Pixels> {
    drift(old, new)?;
    let (each, height) = (old.width.max(new.width), old.height.max(new.height));
    let width = each.checked_mul(3)?.checked_add(2 * GAP)?;
    let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
    let nothing = [128, 128, 128, 255];
    for y in 0..height {
        rgba.extend((0..each).flat_map(|x| at(old, x, y).unwrap_or(nothing)));
        rgba.extend((0..GAP).flat_map(|_| nothing));
        rgba.extend((0..each).flat_map(|x| match (at(old, x, y), at(new, x, y)) {
            (a, Some(b)) if a == Some(b) => faded(b),
            (None, None) => nothing,
            _ => MARK,
        }));
        rgba.extend((0..GAP).flat_map(|_| nothing));
        rgba.extend((0..each).flat_map(|x| at(new, x, y).unwrap_or(nothing)));
    }
    Some(Pixels { width, height, rgba })
}

#[expect(clippy::cast_possible_truncation, reason = "a weighted mean of bytes is a byte")]
fn faded(pixel: [u8; 4]) -> [u8; 4] {
    let fade = |c: u8| (255 - (255 - u32::from(c)) * FADED / 255) as u8;
    [fade(pixel[0]), fade(pixel[1]), fade(pixel[2]), 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(width: u32, height: u32, dot: Option<(u32, u32)>) -> Pixels {
        let pixel = |i: u32| if dot == Some((i % width, i / width)) { [0, 90, 0, 255] } else { [255; 4] };
        Pixels { width, height, rgba: (0..width * height).flat_map(pixel).collect() }
    }

    #[test]
    fn a_dot_is_found_where_it_is() {
        let (old, new) = (plain(9, 5, None), plain(9, 5, Some((7, 2))));
        let got = drift(&old, &new).unwrap();
        assert_eq!((got.changed, got.worst, got.area), (1, 255, Some([7, 2, 8, 3])));
        assert_eq!(drift(&old, &old), None);
    }

    #[test]
    fn another_size_is_a_difference() {
        let got = drift(&plain(9, 5, None), &plain(9, 6, None)).unwrap();
        assert_eq!((got.changed, got.area), (0, None));
        assert!(got.to_string().starts_with("expected 9 × 5 pixels, got 9 × 6"));
    }

    #[test]
    fn the_picture_marks_what_differs_and_nothing_else() {
        let files = [None, Some((7, 2))].map(|dot| encode_pixels(&plain(9, 5, dot)).unwrap());
        let bytes = triptych(TRIPTYCH_FORMAT, &files[0], &files[1], 1.0).unwrap();
        let image = image(&shows(TRIPTYCH_FORMAT, &bytes).unwrap(), 1.0).unwrap();
        assert_eq!((image.width, image.height), (3 * 9 + 2 * GAP, 5));
        let marked = |&(x, y): &(u32, u32)| at(&image, x, y) == Some(MARK);
        let all = (0..image.height).flat_map(|y| (0..image.width).map(move |x| (x, y)));
        assert_eq!(all.filter(marked).collect::<Vec<_>>(), [(9 + GAP + 7, 2)]);
    }
}
