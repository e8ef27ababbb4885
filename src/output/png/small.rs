//! The smallest PNG that is worth tenths of a second: the `png` crate at its highest level.

use super::KEYWORD;
use super::changes::Changes;
use super::palette::Palette;

/// The file of an image.
pub(super) fn encode(image: Changes, hash: &str) -> Result<Vec<u8>, png::EncodingError> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, image.width, image.height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let bytes = if let Some((palette, numbers)) = Palette::of(&image) {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette.bytes());
        // The numbers of colours have no order, so their differences mean nothing.
        encoder.set_filter(png::Filter::NoFilter);
        image.whole_rows(&numbers, 1)
    } else {
        encoder.set_color(png::ColorType::Rgb);
        let image = image.with_whole_first_row();
        image.whole_rows(&super::rgb(&image.pixels), 3)
    };
    if !hash.is_empty() {
        encoder.add_text_chunk(KEYWORD.to_owned(), hash.to_owned())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    Ok(out)
}
