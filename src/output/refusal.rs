//! Why a drawing can't be written.

use std::fmt;

/// Why a drawing can't be written.
#[derive(Clone, Debug, PartialEq)]
pub enum OutputError {
    /// The image would have more than [`super::MOST_PIXELS`] pixels.
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
        /// Name of the outermost group that it is in: the panel.
        outer: String,
        /// Name of the innermost group that it is in.
        group: String,
    },
    /// An animation would have more than [`super::MOST_DOTS`] dots.
    TooLong {
        /// How many pictures it has.
        pictures: usize,
        /// How many of that size fit.
        most: f64,
    },
    /// The drawings of a sequence differ in size, or there are none.
    Sequence,
    /// The format has no sheets, or there are no figures for them.
    NoSheets,
    /// The format has no slides, or there are no figures for them.
    NoSlides,
    /// The encoder refused its input, which is a fault of this program.
    Encoder {
        /// What the encoder says.
        message: String,
    },
}

impl OutputError {
    /// What an encoder answers where it refuses what it was given.
    pub(super) fn encoder(error: &dyn std::error::Error) -> Self {
        Self::Encoder { message: error.to_string() }
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { group, .. } => {
                write!(f, "the drawing's group `{group}` has a place that is not on any page")
            }
            // No page writes pixels.
            _ if cfg!(tracefig_page) => Ok(()),
            Self::TooLarge { scale, largest } => {
                write!(
                    f,
                    "a scale of {scale} gives more than 2^26 pixels; the largest that fits is {largest}"
                )
            }
            Self::Empty { width, height, scale } => {
                write!(f, "a page of {width} × {height} at a scale of {scale} has no pixels")
            }
            Self::TooLong { pictures, most } => write!(
                f,
                "{pictures} pictures of that size are more than 2^30 dots: take fewer than {most:.0}, or a \
                 smaller scale"
            ),
            Self::Sequence => write!(f, "the drawings of a sequence must have one size"),
            Self::NoSheets => write!(f, "a handout is at least one figure in a format that has sheets"),
            Self::NoSlides => write!(f, "a presentation is at least one figure in a format that has slides"),
            Self::Encoder { message } => write!(f, "the encoder says: {message}"),
        }
    }
}

impl std::error::Error for OutputError {}
