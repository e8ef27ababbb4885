//! What typesetting gives: a line of placed glyphs and rules, in page pixels.

use std::fmt;

/// How words and formulas are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Em size in page pixels.
    pub size: f64,
    /// Weight and slant of the words; formulas have their own.
    pub weight: Weight,
}

impl Style {
    /// Regular words at `size` page pixels an em.
    #[must_use]
    pub fn regular(size: f64) -> Self {
        Self { size, weight: Weight::Regular }
    }

    /// Semibold words at `size` page pixels an em.
    #[must_use]
    pub fn semibold(size: f64) -> Self {
        Self { size, weight: Weight::Semibold }
    }
}

/// The face of the words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// Running text.
    Regular,
    /// Titles.
    Semibold,
}

/// An embedded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Face {
    /// Words, regular.
    Regular,
    /// Words, semibold.
    Semibold,
    /// Formulas.
    Math,
}

/// A glyph of an embedded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Glyph {
    /// The face.
    pub face: Face,
    /// Its number in that face.
    pub id: u16,
}

/// A glyph on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedGlyph {
    /// Which glyph.
    pub glyph: Glyph,
    /// Its origin, page pixels right of the line's start.
    pub x: f64,
    /// Its origin, page pixels below the line's baseline.
    pub y: f64,
    /// Page pixels an em.
    pub size: f64,
}

/// A filled rectangle on a line: a fraction bar, the roof of a root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// Left edge, page pixels right of the line's start.
    pub x: f64,
    /// Top edge, page pixels below the line's baseline.
    pub y: f64,
    /// Width in page pixels.
    pub width: f64,
    /// Height in page pixels.
    pub height: f64,
}

/// A line of text: glyphs and rules with the extent that they need, baseline at y = 0, y down.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// What was set.
    pub markup: String,
    /// The glyphs, left to right as set.
    pub glyphs: Vec<PlacedGlyph>,
    /// The rules.
    pub rules: Vec<Rule>,
    /// Advance width in page pixels.
    pub width: f64,
    /// Page pixels above the baseline that belong to the line: its ink, and the letters' x-height at least.
    pub ascent: f64,
    /// Page pixels below the baseline that belong to the line, at least 0.
    pub descent: f64,
}

impl Line {
    /// A line without anything on it, as high as one.
    pub(super) fn empty(markup: &str, style: Style) -> Self {
        Self { markup: markup.to_owned(), ascent: 0.5 * style.size, ..Self::default() }
    }

    /// Ascent and descent together, in page pixels.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.ascent + self.descent
    }
}

/// Why a markup can't be set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypesetError {
    /// Byte offset in the markup.
    pub offset: usize,
    /// What is wrong, in a sentence without a full stop.
    pub message: String,
}

impl fmt::Display for TypesetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for TypesetError {}
