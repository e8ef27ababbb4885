//! What typesetting gives: a line of placed glyphs and rules, in page pixels.

use std::fmt;

/// How words and formulas are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Page pixels of an em.
    pub size: f64,
    /// The weight of the words; formulas have their own face.
    pub weight: Weight,
}

impl Style {
    /// Regular words at `size` page pixels an em.
    ///
    /// ```
    /// use tracefig::typeset::{Style, Weight};
    /// assert_eq!(Style::regular(14.0), Style { size: 14.0, weight: Weight::Regular });
    /// ```
    #[must_use]
    pub fn regular(size: f64) -> Self {
        Self { size, weight: Weight::Regular }
    }

    /// Semibold words at `size` page pixels an em.
    ///
    /// ```
    /// use tracefig::typeset::{Style, typeset};
    /// let width = |style| typeset("World", style).unwrap().width;
    /// assert!(width(Style::semibold(14.0)) > width(Style::regular(14.0)));
    /// ```
    #[must_use]
    pub fn semibold(size: f64) -> Self {
        Self { size, weight: Weight::Semibold }
    }
}

/// How bold words are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// The weight of captions and labels.
    Regular,
    /// The weight of titles.
    Semibold,
}

/// An embedded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Face {
    /// The face of regular words.
    Regular,
    /// The face of semibold words.
    Semibold,
    /// The face of formulas.
    Math,
}

/// A glyph of an embedded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Glyph {
    /// The face that it is in.
    pub face: Face,
    /// The glyph's number in that face.
    pub id: u16,
}

/// A glyph on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedGlyph {
    /// Which glyph.
    pub glyph: Glyph,
    /// Page pixels from the line's start to the glyph's origin, to the right.
    pub x: f64,
    /// Page pixels from the line's baseline to the glyph's origin, down.
    pub y: f64,
    /// Page pixels of an em.
    pub size: f64,
}

/// A filled rectangle on a line: a fraction bar, the roof of a root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// Page pixels from the line's start to the left edge.
    pub x: f64,
    /// Page pixels from the line's baseline down to the top edge.
    pub y: f64,
    /// Width in page pixels.
    pub width: f64,
    /// Height in page pixels.
    pub height: f64,
}

/// A line of text: glyphs and rules with the extent that they need, baseline at y = 0, y down.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// The markup that was set.
    pub markup: String,
    /// The glyphs, left to right as set.
    pub glyphs: Vec<PlacedGlyph>,
    /// Fraction bars and the roofs of roots.
    pub rules: Vec<Rule>,
    /// Advance width in page pixels.
    pub width: f64,
    /// Page pixels above the baseline that belong to the line: its ink, and the letters' x-height at least.
    pub ascent: f64,
    /// Page pixels below the baseline that belong to the line: its ink, and at least 0.
    pub descent: f64,
}

impl Line {
    /// A line without anything on it, as high as one.
    pub(super) fn empty(markup: &str, style: Style) -> Self {
        Self { markup: markup.to_owned(), ascent: 0.5 * style.size, ..Self::default() }
    }

    /// Ascent and descent together, in page pixels.
    ///
    /// ```
    /// let line = tracefig::typeset::typeset("$h_x$", tracefig::typeset::Style::regular(16.0)).unwrap();
    /// assert_eq!(line.height(), line.ascent + line.descent);
    /// ```
    #[must_use]
    pub fn height(&self) -> f64 {
        self.ascent + self.descent
    }
}

/// Why a markup can't be set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypesetError {
    /// The byte of the markup where it goes wrong.
    pub offset: usize,
    /// The fault, in a sentence without a full stop.
    pub message: String,
}

impl fmt::Display for TypesetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for TypesetError {}
