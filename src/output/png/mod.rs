//! PNG: the pixels of the display list, opaque, with the scene's hash as text.
//!
//! The encoder is made for drawings: see [`changes`], [`rows`] and [`deflate`]. Rows come one by one, and only what changes
//! between them is kept. An image of at most 256 colours is written with a
//! palette, which is lossless; else as RGB.

mod changes;
pub(super) mod deflate;
mod huffman;
mod image;
mod palette;
mod rows;
mod small;

use super::{Depends, Format, Options, OutputError, PngEffort, Writer, raster};
use crate::drawing::Drawing;
use palette::Palette;
use raster::Pixel;

pub(super) use changes::Changes;
pub(super) use image::READER;
pub(crate) use image::encode as encode_pixels;

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "png",
    about: "opaque image at --scale pixels for a page pixel",
    usual: true,
    depends: Depends::Packing,
    write: Writer::One(write),
    read: Some(READER),
};

/// First bytes of every PNG.
pub(super) const SIGNATURE: [u8; 8] = [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1A, b'\n'];

/// Keyword of the text chunk with the scene's hash.
const KEYWORD: &str = "tracefig";

/// Bytes a figure takes; saves growing the buffer.
const TYPICAL_SIZE: usize = 128 * 1024;

fn write(drawing: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
    Ok(encode(draw(drawing, options.scale)?, &drawing.hash, options.png))
}

/// The image of a drawing.
pub(super) fn draw(drawing: &Drawing, scale: f64) -> Result<Changes, OutputError> {
    let (width, _) = raster::size(drawing, scale)?;
    let mut image = Changes::new(width, raster::background(drawing));
    raster::rows(drawing, scale, |above, row| image.row(above, row))?;
    Ok(image)
}

/// The file of an image.
fn encode(image: Changes, hash: &str, effort: PngEffort) -> Vec<u8> {
    match effort {
        PngEffort::Fast => pack(image).file(hash),
        PngEffort::Small => {
            let fast = pack(image.clone()).file(hash);
            // The encoder writes into memory and can't fail there; if it does, the fast file shows the same.
            small::encode(image, hash).ok().filter(|s| s.len() < fast.len()).unwrap_or(fast)
        }
    }
}

/// The parts of an image that depend on its pixels.
pub(super) struct Packed {
    /// The chunk `IHDR`.
    pub(super) header: [u8; 13],
    /// The chunk `PLTE`; empty for RGB.
    pub(super) palette: Vec<u8>,
    /// The zlib stream of filtered rows.
    pub(super) data: Vec<u8>,
}

impl Packed {
    fn file(&self, hash: &str) -> Vec<u8> {
        let mut out = Vec::with_capacity(self.data.len() + TYPICAL_SIZE / 16);
        out.extend_from_slice(&SIGNATURE);
        chunk(&mut out, *b"IHDR", &self.header);
        if !hash.is_empty() {
            chunk(&mut out, *b"tEXt", &[KEYWORD.as_bytes(), b"\0", hash.as_bytes()].concat());
        }
        if !self.palette.is_empty() {
            chunk(&mut out, *b"PLTE", &self.palette);
        }
        chunk(&mut out, *b"IDAT", &self.data);
        chunk(&mut out, *b"IEND", &[]);
        out
    }
}

/// Packs an image fast, with a palette where the colours fit.
fn pack(image: Changes) -> Packed {
    match Palette::of(&image) {
        Some((palette, numbers)) => {
            let data = zlib(&image, &numbers, 1);
            Packed { header: header(&image, 3), palette: palette.bytes(), data }
        }
        None => pack_rgb(image),
    }
}

/// Packs an image fast, as RGB.
pub(super) fn pack_rgb(image: Changes) -> Packed {
    let image = image.with_whole_first_row();
    Packed { header: header(&image, 2), palette: Vec::new(), data: zlib(&image, &rgb(&image.pixels), 3) }
}

fn rgb(pixels: &[Pixel]) -> Vec<u8> {
    pixels.iter().flat_map(|p| [p[0], p[1], p[2]]).collect()
}

fn zlib(image: &Changes, bytes: &[u8], unit: usize) -> Vec<u8> {
    let (tokens, adler) = rows::tokens(image, bytes, unit);
    let mut data = Vec::with_capacity(TYPICAL_SIZE);
    tokens.zlib(adler, &mut data);
    data
}

/// Size, 8 bits, the colour type, and 0 for the only compression, the only filters, and rows in order.
fn header(image: &Changes, color_type: u8) -> [u8; 13] {
    let (w, h) = (image.width.to_be_bytes(), image.height.to_be_bytes());
    [w[0], w[1], w[2], w[3], h[0], h[1], h[2], h[3], 8, color_type, 0, 0, 0]
}

/// Appends a chunk: length, name, bytes, checksum of name and bytes.
pub(super) fn chunk(out: &mut Vec<u8>, name: [u8; 4], bytes: &[u8]) {
    out.extend_from_slice(&u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_be_bytes());
    let start = out.len();
    out.extend_from_slice(&name);
    out.extend_from_slice(bytes);
    let checksum = crc32fast::hash(&out[start..]);
    out.extend_from_slice(&checksum.to_be_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::Pixels;

    /// The rows of an image, on another background than its own.
    fn image(pixels: &Pixels) -> Changes {
        let (all, width) = (pixels.rgba.as_chunks::<4>().0, pixels.width as usize);
        let first = vec![[9, 9, 9, 255]; width];
        let mut image = Changes::new(pixels.width, first[0]);
        let mut above = first.as_slice();
        for row in all.chunks_exact(width) {
            image.row(above, row);
            above = row;
        }
        image
    }

    /// What an independent decoder reads, as RGBA.
    fn decoded(file: &[u8]) -> (Pixels, png::ColorType) {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
        let color = decoder.read_header_info().unwrap().color_type;
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut rgb).unwrap();
        let rgba = rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
        (Pixels { width: info.width, height: info.height, rgba }, color)
    }

    /// Slanted edges, flat areas and noise, in about `colors` colours.
    fn picture(width: u32, height: u32, colors: u32) -> Pixels {
        let mut seed = 1_u32;
        let mut rgba = Vec::new();
        for y in 0..height {
            for x in 0..width {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let noisy = (x / 7 + y / 5) % 9 == 0;
                let value = if noisy { (seed >> 8) % colors } else { u32::from(2 * x + 5 < 3 * y) };
                let [r, g, b, _] = value.wrapping_mul(0x9E37_79B1).to_be_bytes();
                rgba.extend([r, g, b, 255]);
            }
        }
        Pixels { width, height, rgba }
    }

    #[test]
    fn pixels_come_back_as_they_were_with_few_colours_and_with_many() {
        for (width, height) in [(1, 1), (2, 3), (3, 1), (65, 40), (300, 200), (1, 500)] {
            for colors in [2, 250, 100_000] {
                let pixels = picture(width, height, colors);
                for effort in [PngEffort::Fast, PngEffort::Small] {
                    let (back, color) = decoded(&encode(image(&pixels), "ab12", effort));
                    assert!(back == pixels, "{width} × {height}, {colors} colours, {effort:?}");
                    if colors <= 250 {
                        assert_eq!(color, png::ColorType::Indexed, "a palette where the colours fit");
                    }
                }
            }
        }
    }

    #[test]
    fn the_hash_is_in_the_file() {
        let file = encode(image(&picture(4, 4, 2)), "ab12", PngEffort::Fast);
        let reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let text = &reader.info().uncompressed_latin1_text[0];
        assert_eq!((text.keyword.as_str(), text.text.as_str()), (KEYWORD, "ab12"));
    }
}
