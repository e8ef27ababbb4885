//! Pixels, straight from the display list.
//!
//! An image is made in three stages:
//!
//! 1. The display list becomes [`steps`]: areas in painting order, each with its colour and the pixels that
//!    hold it. Contours become paths of tiny-skia, which also makes outlines of lines and dashes ([`paths`]);
//!    glyphs become stamps that are made once ([`glyphs`]).
//! 2. tiny-skia fills a path into a mask, a byte of coverage a pixel, which is read as spans of equal
//!    coverage ([`coverage`]). It draws nothing else: no colour of ours goes through its pipeline.
//! 3. Spans become colours ([`blend`]), with so few levels at edges that most images fit a palette.
//!
//! The last two go over the steps once for each band of rows ([`paint`]), and the rows of a finished band
//! are handed on one by one. So there is never an image in memory unless someone collects the rows, and masks
//! and colours stay in the cache.
//!
//! What is see-through needs no image of its own: the pixels below a group are kept, the group is drawn
//! solid, and both are mixed. A clip is a rectangle, so it cuts spans by arithmetic. The area under a
//! pattern's marks is a second mask; the two meet by their product.
//!
//! The same drawing gives the same pixels on every machine: places are rounded to 1/256 of a pixel, coverage
//! is integers, and what comes before are sums, products, quotients and square roots, with `libm` for angles.
//! Source: the scan converter and the stroker of *Skia*, of which tiny-skia is a port.

mod blend;
mod coverage;
mod glyphs;
mod paint;
mod paths;
mod steps;

use super::{Options, OutputError, validity};
use crate::drawing::Drawing;

pub(crate) use paint::{Pixel, Rows};

/// An image; opaque where its page is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels of a row.
    pub width: u32,
    /// The number of rows.
    pub height: u32,
    /// Four bytes a pixel: red, green, blue, opacity. Rows from the top, pixels from the left.
    pub rgba: Vec<u8>,
}

/// The pixels of a drawing, at `scale` image pixels for a page pixel.
///
/// # Errors
///
/// [`OutputError`] for a page without pixels, too many of them, or places that are not finite.
///
/// ```
/// use tracefig::drawing::{Color, Drawing, Paint, Role};
/// let background = Paint::role(Role::Background, Color::hex(0xFF8000));
/// let drawing = Drawing {
///     width: 3.0, height: 2.0, id: "x".into(), lang: None, title: String::new(), is_titled: false,
///     heading: None,
///     desc: String::new(), background, ink: Color::hex(0), words: vec![], fill_opacity: 0.14, dark: None,
///     metadata: String::new(), hash: String::new(), items: vec![], steps: vec![], motion: vec![],
///     narrow: None,
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

/// Draws row by row from the top: `each` is given the row above and the row. Above the first one is the
/// background.
pub(super) fn rows(
    drawing: &Drawing,
    scale: f64,
    mut each: impl FnMut(&[Pixel], &[Pixel]),
) -> Result<(), OutputError> {
    let mut rows = open(drawing, scale)?;
    while let Some((above, row)) = rows.next() {
        each(above, row);
    }
    Ok(())
}

/// The rows of a drawing, which are drawn as they are asked for.
pub(super) fn open(drawing: &Drawing, scale: f64) -> Result<Rows, OutputError> {
    let (width, height) = size(drawing, scale)?;
    let size = (width as usize, height as usize);
    Ok(Rows::new(steps::of(&drawing.items, size, scale), (width, height), background(drawing)))
}

/// The page's colour; nothing where the page is transparent.
pub(super) fn background(drawing: &Drawing) -> Pixel {
    if drawing.is_transparent() {
        return [0; 4];
    }
    let crate::drawing::Color { r, g, b } = drawing.background.color;
    [r, g, b, 255]
}

#[cfg(test)]
mod tests;
