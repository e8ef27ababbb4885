//! Where two images differ, as numbers and as a picture.

use std::fmt;
use std::io::Cursor;

use super::picture;
use crate::output::{Pixels, rasterize};

/// An image in memory: rows of red, green, blue, alpha.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Image {
    width: u32,
    height: u32,
    rgba: Vec<u8>,
}

/// How the pixels of two images differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PixelDrift {
    /// Width and height of the old image in pixels.
    pub expected_size: (u32, u32),
    /// Width and height of the new one.
    pub actual_size: (u32, u32),
    /// Pixels that differ, of those that both have.
    pub changed: u64,
    /// Pixels that differ by more than each of [`TOLERANCES`].
    pub beyond: [u64; TOLERANCES.len()],
    /// Largest difference of a channel, of 255.
    pub worst: u8,
    /// Left, top, right, bottom of the changed area in pixels, right and bottom not included; None where only the
    /// size changed.
    pub area: Option<[u32; 4]>,
}

/// Channel levels for which a drift says how many pixels would still differ.
pub const TOLERANCES: [u8; 6] = [0, 1, 2, 4, 8, 16];

impl PixelDrift {
    /// How many pixels would differ under each tolerance: `tolerance 0: 12 pixels, 1: 3, 2: 0, …`.
    #[must_use]
    pub fn under_tolerances(&self) -> String {
        let each: Vec<_> = TOLERANCES.iter().zip(self.beyond).map(|(t, n)| format!("{t}: {n}")).collect();
        format!("pixels beyond a tolerance of {}", each.join(", "))
    }

    /// Whether the images have one size and no channel differs by more than `tolerance` levels.
    #[must_use]
    pub fn is_within(&self, tolerance: u8) -> bool {
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

/// Pixels between the three pictures of a [`triptych`].
const GAP: u32 = 16;

/// Of a pixel's darkness, in the middle picture, so many parts of 255 remain: enough to see where one is.
const FADED: u32 = 60;

/// The colour of a pixel that differs; no theme has it.
const MARK: [u8; 4] = [255, 0, 255, 255];

/// The picture of a PNG, or of an SVG of ours at so many pixels a page pixel; None where the bytes are neither.
pub(super) fn image(bytes: &[u8], scale: f64) -> Option<Image> {
    if bytes.starts_with(b"\x89PNG") {
        return decode(bytes);
    }
    let Pixels { width, height, rgba } = rasterize(&picture::read(bytes)?.drawing, scale).ok()?;
    Some(Image { width, height, rgba })
}

/// None where the bytes are no PNG.
fn decode(bytes: &[u8]) -> Option<Image> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
    let mut reader = decoder.read_info().ok()?;
    let mut buffer = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut buffer).ok()?;
    let rgba = match info.color_type {
        png::ColorType::Rgba => buffer,
        png::ColorType::GrayscaleAlpha => {
            buffer.chunks_exact(2).flat_map(|p| [p[0], p[0], p[0], p[1]]).collect()
        }
        _ => return None,
    };
    Some(Image { width: info.width, height: info.height, rgba })
}

impl Image {
    fn at(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let i = 4 * (y as usize * self.width as usize + x as usize);
        self.rgba.get(i..i + 4)?.try_into().ok()
    }
}

/// None where all pixels are the same.
pub(super) fn drift(old: &Image, new: &Image) -> Option<PixelDrift> {
    let (mut beyond, mut worst, mut area) = ([0; TOLERANCES.len()], 0, None::<[u32; 4]>);
    for y in 0..old.height.min(new.height) {
        for x in 0..old.width.min(new.width) {
            let (Some(a), Some(b)) = (old.at(x, y), new.at(x, y)) else { continue };
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

/// A PNG of expected · difference · actual beside one another; in the middle the new image faded, with every pixel
/// that differs marked. None where one of them is neither a PNG nor an SVG of ours, which is drawn at `scale`, or where no
/// pixel differs.
#[must_use]
pub fn triptych(expected: &[u8], actual: &[u8], scale: f64) -> Option<Vec<u8>> {
    let (old, new) = (image(expected, scale)?, image(actual, scale)?);
    drift(&old, &new)?;
    let (width, height) = (old.width.max(new.width), old.height.max(new.height));
    let total = width.checked_mul(3)?.checked_add(2 * GAP)?;
    let mut rgba = Vec::with_capacity(4 * total as usize * height as usize);
    let nothing = [128, 128, 128, 255];
    for y in 0..height {
        rgba.extend((0..width).flat_map(|x| old.at(x, y).unwrap_or(nothing)));
        rgba.extend((0..GAP).flat_map(|_| nothing));
        rgba.extend((0..width).flat_map(|x| match (old.at(x, y), new.at(x, y)) {
            (a, Some(b)) if a == Some(b) => faded(b),
            (None, None) => nothing,
            _ => MARK,
        }));
        rgba.extend((0..GAP).flat_map(|_| nothing));
        rgba.extend((0..width).flat_map(|x| new.at(x, y).unwrap_or(nothing)));
    }
    encode(total, height, &rgba)
}

#[expect(clippy::cast_possible_truncation, reason = "a weighted mean of bytes is a byte")]
fn faded(pixel: [u8; 4]) -> [u8; 4] {
    let fade = |c: u8| (255 - (255 - u32::from(c)) * FADED / 255) as u8;
    [fade(pixel[0]), fade(pixel[1]), fade(pixel[2]), 255]
}

fn encode(width: u32, height: u32, rgba: &[u8]) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(rgba).ok()?;
    writer.finish().ok()?;
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(width: u32, height: u32, dot: Option<(u32, u32)>) -> Vec<u8> {
        let pixel = |i: u32| if dot == Some((i % width, i / width)) { [0, 90, 0, 255] } else { [255; 4] };
        let rgba: Vec<u8> = (0..width * height).flat_map(pixel).collect();
        encode(width, height, &rgba).unwrap()
    }

    #[test]
    fn a_dot_is_found_where_it_is() {
        let (old, new) = (decode(&plain(9, 5, None)).unwrap(), decode(&plain(9, 5, Some((7, 2)))).unwrap());
        let got = drift(&old, &new).unwrap();
        assert_eq!((got.changed, got.worst, got.area), (1, 255, Some([7, 2, 8, 3])));
        assert_eq!(drift(&old, &old), None);
    }

    #[test]
    fn another_size_is_a_difference() {
        let (old, new) = (decode(&plain(9, 5, None)).unwrap(), decode(&plain(9, 6, None)).unwrap());
        let got = drift(&old, &new).unwrap();
        assert_eq!((got.changed, got.area), (0, None));
        assert!(got.to_string().starts_with("expected 9 × 5 pixels, got 9 × 6"));
    }

    #[test]
    fn the_picture_marks_what_differs_and_nothing_else() {
        let image = decode(&triptych(&plain(9, 5, None), &plain(9, 5, Some((7, 2))), 1.0).unwrap()).unwrap();
        assert_eq!((image.width, image.height), (3 * 9 + 2 * GAP, 5));
        let marked = |&(x, y): &(u32, u32)| image.at(x, y) == Some(MARK);
        let all = (0..image.height).flat_map(|y| (0..image.width).map(move |x| (x, y)));
        assert_eq!(all.filter(marked).collect::<Vec<_>>(), [(9 + GAP + 7, 2)]);
    }
}
