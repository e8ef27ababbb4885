//! PNG: the pixels of the display list, opaque, with the scene's hash as text.

use super::{Format, Options, OutputError, Pixels, PngEffort, Writer, rasterize};
use crate::drawing::Drawing;

pub(super) const FORMAT: Format = Format {
    name: "png",
    about: "opaque image at --scale pixels for a page pixel",
    write: Writer::One(write),
};

fn write(drawing: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
    let pixels = rasterize(drawing, options.scale)?;
    encode(&pixels, &drawing.hash, options.png).map_err(|_| OutputError::Sequence)
}

fn encode(pixels: &Pixels, hash: &str, effort: PngEffort) -> Result<Vec<u8>, png::EncodingError> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixels.width, pixels.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(match effort {
        PngEffort::Fast => png::Compression::Fastest,
        PngEffort::Small => png::Compression::High,
    });
    encoder.add_text_chunk("tracefig".to_owned(), hash.to_owned())?;
    let mut writer = encoder.write_header()?;
    let rgb: Vec<u8> = pixels.rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(out)
}
