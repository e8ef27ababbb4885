//! A PNG read again, whoever wrote it; and an image that is in memory as a PNG.

use std::io::Cursor;

use super::super::{Picture, Pixels, Reader, Stamped};
use super::KEYWORD;

/// Reads PNG, and of APNG the first frame.
pub(in crate::output) const READER: Reader = Reader { stamp, picture: Some(picture) };

/// The hash in the text chunk of our keyword.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    let reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let text = reader.info().uncompressed_latin1_text.iter().find(|text| text.keyword == KEYWORD)?;
    Some(Stamped::Hash(text.text.clone()))
}

fn picture(bytes: &[u8]) -> Option<Picture> {
    decode(bytes).map(Picture::Pixels)
}

/// The pixels of a file, of any depth and colour type; `None` where it is no PNG.
pub(crate) fn decode(bytes: &[u8]) -> Option<Pixels> {
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
    Some(Pixels { width: info.width, height: info.height, rgba })
}

/// An image as a PNG, packed fast; `None` where its bytes are not those of its size.
pub(crate) fn encode(image: &Pixels) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, image.width, image.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(&image.rgba).ok()?;
    writer.finish().ok()?;
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_encoded_is_decoded_and_less_is_refused() {
        let image = Pixels { width: 2, height: 1, rgba: vec![1, 2, 3, 255, 250, 0, 9, 255] };
        assert_eq!(encode(&image).and_then(|bytes| decode(&bytes)), Some(image.clone()));
        assert_eq!(encode(&Pixels { width: 3, ..image }), None);
        assert_eq!((decode(b"\x89PNG\r\n"), stamp(b"\x89PNG\r\n").is_none()), (None, true));
    }
}
