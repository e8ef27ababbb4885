//! The smallest PNG that is worth tenths of a second: the `png` crate at its highest level.

use super::KEYWORD;
use super::palette::Palette;
use super::rows;
use crate::output::Pixels;

/// The file for opaque pixels.
pub(super) fn encode(pixels: &Pixels, hash: &str) -> Result<Vec<u8>, png::EncodingError> {
    let (all, width) = (pixels.rgba.as_chunks::<4>().0, pixels.width as usize);
    let background = all.first().copied().unwrap_or_default();
    let palette = Palette::of(all, width, &rows::spans(all, width, background), background);
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixels.width, pixels.height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let bytes: Vec<u8> = if let Some(palette) = &palette {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette.bytes());
        // The numbers of colours have no order, so their differences mean nothing.
        encoder.set_filter(png::Filter::NoFilter);
        all.iter().map(|&color| palette.index(color)).collect()
    } else {
        encoder.set_color(png::ColorType::Rgb);
        all.iter().flat_map(|c| [c[0], c[1], c[2]]).collect()
    };
    if !hash.is_empty() {
        encoder.add_text_chunk(KEYWORD.to_owned(), hash.to_owned())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    Ok(out)
}
