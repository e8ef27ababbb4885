//! One format a file: a [`Drawing`], or a sequence of them, to bytes.
//!
//! A format is a row in [`FORMATS`] and sees nothing but the display list, so every format shows the same. The same
//! drawing gives the same bytes on every machine.

mod apng;
mod check;
mod curves;
mod html;
mod number;
mod pdf;
mod png;
mod raster;
mod svg;
mod xml;

use std::fmt;

use crate::drawing::Drawing;

pub use raster::{Pixels, rasterize};

/// A row in the table of formats.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// Its word on the command line, and the end of its files' names.
    pub name: &'static str,
    /// One line for `tracefig list`.
    pub about: &'static str,
    /// Writes it.
    pub write: Writer,
}

/// What a format makes a file of.
#[derive(Clone, Copy, Debug)]
pub enum Writer {
    /// One drawing.
    One(fn(&Drawing, &Options) -> Result<Vec<u8>, OutputError>),
    /// Drawings of one size, one after the other.
    Sequence(fn(&[&Drawing], &Options) -> Result<Vec<u8>, OutputError>),
}

/// Every format.
pub const FORMATS: [Format; 5] = [svg::FORMAT, png::FORMAT, pdf::FORMAT, html::FORMAT, apng::FORMAT];

/// The format of that name.
///
/// ```
/// assert!(tracefig::output::format("svg").is_some());
/// assert!(tracefig::output::format("doc").is_none());
/// ```
#[must_use]
pub fn format(name: &str) -> Option<&'static Format> {
    FORMATS.iter().find(|format| format.name == name)
}

/// What may be asked of a format; those that it does not concern it ignores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Pixels of the image for a page pixel.
    pub scale: f64,
    /// How a PNG is packed.
    pub png: PngEffort,
}

impl Default for Options {
    /// Twice the page's size, packed fast.
    fn default() -> Self {
        Self { scale: 2.0, png: PngEffort::Fast }
    }
}

/// How much time goes into a smaller PNG; the pixels are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PngEffort {
    /// Milliseconds a figure.
    #[default]
    Fast,
    /// As small as is worth tenths of a second.
    Small,
}

/// Pixels of the largest image: 2²⁶, of which four bytes each are kept.
pub const MOST_PIXELS: f64 = 67_108_864.0;

/// Why a drawing can't be written.
#[derive(Clone, Debug, PartialEq)]
pub enum OutputError {
    /// The image would have more than [`MOST_PIXELS`] pixels.
    TooLarge {
        /// The scale asked for.
        scale: f64,
        /// The largest scale that fits.
        largest: f64,
    },
    /// The page or the scale is no positive number, or the image would have no pixels.
    Empty {
        /// Page width in pixels.
        width: f64,
        /// Page height in pixels.
        height: f64,
        /// The scale asked for.
        scale: f64,
    },
    /// A place or a length in the drawing is not a finite number, or beyond any page.
    NotFinite {
        /// Name of the innermost group that it is in.
        group: String,
    },
    /// The drawings of a sequence differ in size, or there are none.
    Sequence,
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { scale, largest } => {
                write!(
                    f,
                    "a scale of {scale} gives more than 2^26 pixels; the largest that fits is {largest}"
                )
            }
            Self::Empty { width, height, scale } => {
                write!(f, "a page of {width} × {height} at a scale of {scale} has no pixels")
            }
            Self::NotFinite { group } => {
                write!(f, "the drawing's group `{group}` has a place that is not on any page")
            }
            Self::Sequence => write!(f, "the drawings of a sequence must have one size"),
        }
    }
}

impl std::error::Error for OutputError {}

#[cfg(test)]
mod samples;
#[cfg(test)]
mod tests;
