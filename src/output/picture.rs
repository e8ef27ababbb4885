//! What a file shows when it is read again, and its rows of pixels from the top, one at a time.
//!
//! Files that are read again were written by anyone: a pull request brings them along. So no image is in
//! memory as a whole, and what has more of anything than a figure of ours may have is refused with the limit.

use std::fmt;

use super::png::{Image, ImageRows};
use super::raster::{self, Pixel};
use crate::drawing::Drawing;

/// Pixels a side of the largest image of ours: the largest page at the largest scale of the command line.
pub(super) const MOST_A_SIDE: usize = 32_768;

/// Million page pixels of all areas of a page, those of lines by the boxes around them: 0.8 s at two pixels
/// for a page pixel.
const MOST_MEGAPIXELS: usize = 400;
/// Pieces of outlines that are looked at: an area is painted in bands of rows, and all of its outline is
/// looked at for each. Figures of the usual size have 8 bands, the largest images 256.
const MOST_LOOKED_AT: usize = 20_000_000;

/// What a file shows, ready to be compared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Picture<'b> {
    /// An image in a file.
    Image(Image<'b>),
    /// A page of outlines.
    Drawing {
        /// What the page shows. Texts are outlines.
        drawing: Box<Drawing>,
        /// The style sheet, which other pages and dark systems follow and no image does.
        sheet: String,
        /// The words that a reader finds in it and nobody sees, one line below the other.
        found: String,
        /// The languages, and what its parts are called to who does not see them, one line below the other.
        told: String,
    },
}

/// Why a file shows nothing that could be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unread {
    /// The file is of another kind, broken, or was changed into something that we do not write.
    Other,
    /// The file has too much of something.
    TooMuch(TooMuch),
}

/// More of something than a file of ours has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooMuch {
    /// What there is too much of, as "elements".
    pub what: &'static str,
    /// How many a file of ours has at most.
    pub most: usize,
}

impl From<TooMuch> for Unread {
    fn from(too_much: TooMuch) -> Self {
        Self::TooMuch(too_much)
    }
}

impl fmt::Display for TooMuch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "more than {} {}", self.most, self.what)
    }
}

/// How a file that plays is played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Pace {
    /// How many pictures it has.
    pub(crate) pictures: u32,
    /// How many times it is played; 0 stands for without end.
    pub(crate) plays: u32,
    /// How long a picture is shown, as a fraction of a second; `None` where the file's image is none of them.
    pub(crate) delay: Option<(u16, u16)>,
}

/// What comes after a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Later {
    /// Another picture.
    Next,
    /// Nothing: it was the last one.
    End,
    /// Something that none of our files has, or nothing that could be read.
    Unread,
}

/// The rows of a picture, from the top.
pub(crate) enum Rows<'b> {
    /// Rows of a page that is being drawn.
    Drawn(Box<raster::Rows>),
    /// Rows of an image that is being read.
    Read(Box<ImageRows<'b>>),
}

impl Picture<'_> {
    /// The picture's rows; outlines are drawn at `scale` pixels for a page pixel.
    pub(crate) fn rows(&self, scale: f64) -> Result<Rows<'_>, Unread> {
        match self {
            Self::Image(image) => Ok(Rows::Read(Box::new(image.rows().ok_or(Unread::Other)?))),
            Self::Drawing { drawing, .. } => {
                let rows = raster::open(drawing, scale).map_err(|_| Unread::Other)?;
                let (pixels, pieces) = rows.work();
                #[expect(clippy::cast_precision_loss, reason = "only compared")]
                if pixels as f64 > MOST_MEGAPIXELS as f64 * 1e6 * (scale * scale).max(1.0) {
                    return Err(TooMuch { what: "megapixels of areas", most: MOST_MEGAPIXELS }.into());
                }
                if pieces > MOST_LOOKED_AT {
                    let what = "pieces of lines, each for every band of the page";
                    return Err(TooMuch { what, most: MOST_LOOKED_AT }.into());
                }
                Ok(Rows::Drawn(Box::new(rows)))
            }
        }
    }
}

impl Rows<'_> {
    /// Width and height of the picture in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        match self {
            Self::Drawn(rows) => rows.size(),
            Self::Read(rows) => rows.size(),
        }
    }

    /// How the file plays, and how long it shows this picture; `None` where it does not.
    pub(crate) fn pace(&self) -> Option<Pace> {
        match self {
            Self::Drawn(_) => None,
            Self::Read(rows) => rows.pace(),
        }
    }

    /// Goes on to the next picture, after the last row of the one before.
    pub(crate) fn next_picture(&mut self) -> Later {
        match self {
            Self::Drawn(_) => Later::End,
            Self::Read(rows) => rows.next_picture(),
        }
    }

    /// Puts the next row into `row`; false after the last one, and where the file is broken.
    pub(crate) fn next_into(&mut self, row: &mut Vec<Pixel>) -> bool {
        row.clear();
        match self {
            Self::Drawn(rows) => rows.next().map(|(_, next)| row.extend_from_slice(next)).is_some(),
            Self::Read(rows) => rows.next_into(row).is_some(),
        }
    }
}
