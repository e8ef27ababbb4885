//! Pixels, straight from the display list.
//!
//! A contour becomes straight pieces ([`polyline`]), a line's width an outline ([`stroke`]), text the outlines of its glyphs
//! ([`glyphs`]). What is painted, and in which order, is a list of [`steps`]; their edges are dealt to bands of some rows
//! ([`edges`]). Then each band is painted by itself ([`paint`]): edges become the coverage of pixels ([`coverage`]), and
//! this the colours ([`blend`]). So there is never an image in memory unless someone collects the rows, and what is worked
//! on stays in the cache. A clip or the area under a pattern's marks is a coverage too; two of them meet by their product.
//!
//! Everything is additions, products, quotients and square roots of doubles, with `libm` for angles, so the pixels are the
//! same on every machine.

mod blend;
mod coverage;
mod edges;
mod glyphs;
mod paint;
mod polyline;
mod steps;
mod stroke;

use super::{Options, OutputError, validity};
use crate::drawing::Drawing;
use steps::Recorder;

pub(super) use paint::Pixel;

/// An opaque image, 4 bytes a pixel: red, green, blue, 255; rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The bytes.
    pub rgba: Vec<u8>,
}

/// Draws at `scale` image pixels for a page pixel.
///
/// # Errors
///
/// [`OutputError`] for a page without pixels, too many of them, or places that are not finite.
///
/// ```
/// use tracefig::drawing::{Color, Drawing, Paint, Role};
/// let background = Paint::role(Role::Background, Color::hex(0xFF8000));
/// let drawing = Drawing {
///     width: 3.0, height: 2.0, id: "x".into(), title: String::new(), desc: String::new(), background,
///     fill_opacity: 0.14, dark: None, metadata: String::new(), hash: String::new(), items: vec![],
/// };
/// let pixels = tracefig::output::rasterize(&drawing, 2.0).unwrap();
/// assert_eq!((pixels.width, pixels.height), (6, 4));
/// assert_eq!(pixels.rgba[..4], [255, 128, 0, 255]);
/// ```
pub fn rasterize(drawing: &Drawing, scale: f64) -> Result<Pixels, OutputError> {
    let (width, height) = size(drawing, scale)?;
    let mut all = Vec::with_capacity(width as usize * height as usize);
    rows(drawing, scale, |_, row| all.extend_from_slice(row))?;
    Ok(Pixels { width, height, rgba: all.into_flattened() })
}

/// Width and height of the image in pixels.
pub(super) fn size(drawing: &Drawing, scale: f64) -> Result<(u32, u32), OutputError> {
    validity::image_size(drawing, &Options { scale, ..Options::default() })
}

/// Draws row by row from the top: `each` is given the row above and the row. Above the first one is the background.
pub(super) fn rows(
    drawing: &Drawing,
    scale: f64,
    each: impl FnMut(&[Pixel], &[Pixel]),
) -> Result<(), OutputError> {
    let (width, height) = size(drawing, scale)?;
    let size = (width as usize, height as usize);
    let mut recorder = Recorder::new(size, scale);
    recorder.items(&drawing.items);
    paint::rows(recorder, size, background(drawing), each);
    Ok(())
}

/// The page's colour.
pub(super) fn background(drawing: &Drawing) -> Pixel {
    let crate::drawing::Color { r, g, b } = drawing.background.color;
    [r, g, b, 255]
}
