//! PNG: the pixels of the display list with the scene's hash as text.
//!
//! Rows come from the rasterizer one at a time, and only what changes between them is kept ([`changes`]): how
//! many colours there are is known after the last row. At most 256 become a palette ([`palette`]), which is
//! lossless and half the bytes; more are written as RGB. Then the rows are made whole again, one at a time,
//! for the `png` crate, which packs them and writes the chunks. So the image itself is never in memory.

mod changes;
mod image;
mod palette;

use std::io::Write;

use super::{Bracket, Depends, Format, Options, OutputError, PngEffort, Writer, raster};
use crate::drawing::Drawing;
use changes::Changes;
use palette::Palette;
use raster::Pixel;

pub(super) use image::READER;
pub(crate) use image::{Image, ImageRows, ImageWriter};

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "png",
    about: "image at --scale pixels for a page pixel",
    media_type: "image/png",
    usual: true,
    in_the_dark: false,
    depends: Depends::Packing,
    write: Writer::One(write),
    in_steps: None,
    in_motion: None,
    bind: None,
    bracket: BRACKET,
    read: Some(READER),
    live: None,
};

/// The signature and the empty last chunk with its checksum (*PNG*, third edition, sections 5.2 and 11.2.4).
pub(super) const BRACKET: Bracket =
    Bracket { begins: &[b"\x89PNG\r\n\x1a\n".as_slice()], ends: &[b"IEND\xae\x42\x60\x82".as_slice()] };

/// Keyword of the text chunk with the scene's hash.
pub(super) const KEYWORD: &str = "tracefig";

/// How many bytes a figure takes at most, as a rule; saves growing the buffer.
const TYPICAL_SIZE: usize = 128 * 1024;

/// Bytes of a chunk of pixels. Each takes twelve more for its length, name and checksum.
const CHUNK: usize = 32 * 1024;

fn write(drawing: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
    let image = draw(drawing, options.scale)?;
    encode(&image, &drawing.hash, options.png).map_err(|error| OutputError::encoder(&error))
}

/// The image of a drawing.
fn draw(drawing: &Drawing, scale: f64) -> Result<Changes, OutputError> {
    let (width, _) = raster::size(drawing, scale)?;
    let mut image = Changes::new(width, raster::background(drawing));
    raster::rows(drawing, scale, |above, row| image.row(above, row))?;
    Ok(image)
}

/// The file of an image.
fn encode(image: &Changes, hash: &str, effort: PngEffort) -> Result<Vec<u8>, png::EncodingError> {
    let mut out = Vec::with_capacity(TYPICAL_SIZE);
    let mut encoder = encoder(&mut out, (image.width, image.height), effort);
    if !hash.is_empty() {
        encoder.add_text_chunk(KEYWORD.to_owned(), hash.to_owned())?;
    }
    let (above, new) = if let Some((palette, numbers)) = Palette::of(image) {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette.bytes());
        if let Some(opacities) = palette.opacities() {
            encoder.set_trns(opacities);
        }
        (vec![0], numbers)
    } else if image.pixels.iter().chain([&image.above]).all(|pixel| is_opaque(*pixel)) {
        (rgb(&[image.above]), rgb(&image.pixels))
    } else {
        encoder.set_color(png::ColorType::Rgba);
        (image.above.to_vec(), image.pixels.as_flattened().to_vec())
    };
    let mut writer = encoder.write_header()?;
    let mut rows = writer.stream_writer_with_size(CHUNK)?;
    image.write_rows(&above, &new, &mut rows)?;
    rows.finish()?;
    writer.finish()?;
    Ok(out)
}

/// An encoder of RGB images of 8 bits a channel that packs as drawings need it.
///
/// No filter: a colour's number says nothing about its neighbours' numbers, and the flat areas of an RGB
/// drawing repeat as they are, so differences between rows make files a tenth larger.
pub(super) fn encoder<W: Write>(
    out: W,
    (width, height): (u32, u32),
    effort: PngEffort,
) -> png::Encoder<'static, W> {
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(level(effort)));
    encoder
}

/// How hard repetitions are looked for, from 1 to 9.
///
/// Tuned on the article's eight figures at scale 2. Level 1 would make files 1.6 times as large as 2 does and
/// save a fortieth of the program's time; 3 saves a twenty-fifth of the bytes and 6 a ninth, in 1.03 and 1.3
/// times the time. 9 saves a fifth in 4 times the time, 25 ms a figure more.
fn level(effort: PngEffort) -> u8 {
    match effort {
        PngEffort::Fast => 2,
        PngEffort::Small => 9,
    }
}

/// Whether nothing below a pixel is seen.
fn is_opaque(pixel: Pixel) -> bool {
    pixel[3] == 255
}

/// Red, green and blue of each pixel.
fn rgb(pixels: &[Pixel]) -> Vec<u8> {
    pixels.iter().flat_map(|p| [p[0], p[1], p[2]]).collect()
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
                    let (back, color) = decoded(&encode(&image(&pixels), "ab12", effort).unwrap());
                    assert!(back == pixels, "{width} × {height}, {colors} colours, {effort:?}");
                    if colors <= 250 {
                        assert_eq!(color, png::ColorType::Indexed, "a palette where the colours fit");
                    }
                }
            }
        }
    }

    #[test]
    fn more_effort_makes_a_file_smaller() {
        for colors in [250, 100_000] {
            let image = image(&picture(300, 200, colors));
            let size = |effort| encode(&image, "", effort).unwrap().len();
            assert!(size(PngEffort::Small) < size(PngEffort::Fast), "{colors} colours");
        }
    }

    #[test]
    fn the_hash_is_in_the_file() {
        let file = encode(&image(&picture(4, 4, 2)), "ab12", PngEffort::Fast).unwrap();
        let reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let text = &reader.info().uncompressed_latin1_text[0];
        assert_eq!((text.keyword.as_str(), text.text.as_str()), (KEYWORD, "ab12"));
    }
}
