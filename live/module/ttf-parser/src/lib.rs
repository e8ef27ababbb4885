//! Reads the packed faces of live pages, under the name by which the setter of formulas asks for a face.
//!
//! A face as font files have it is laid out for many programs: its reader knows three kinds of outlines, five
//! of tables of characters, and rules for pairs in nested tables. Pictures ask for little of it: glyphs of
//! characters, widths, outlines, kerning, and the measures of formulas. tracefig packs just that
//! (`typeset/packed.rs`, where the form is told), and this reads it. All that is read here is of the same
//! name and says the same as in the `ttf-parser` that tracefig is built with elsewhere; what nobody asks for
//! is not here.

pub mod gsub;
pub mod math;
mod outline;
mod packed;

use std::marker::PhantomData;

use packed::Packed;

/// The number of a glyph in its face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct GlyphId(pub u16);

/// The name of a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tag([u8; 4]);

impl Tag {
    /// The tag of four letters.
    #[must_use]
    pub const fn from_bytes(letters: &[u8; 4]) -> Self {
        Self(*letters)
    }
}

/// What a rectangle around an outline reaches, y up, in units of the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// The least x.
    pub x_min: i16,
    /// The least y.
    pub y_min: i16,
    /// The greatest x.
    pub x_max: i16,
    /// The greatest y.
    pub y_max: i16,
}

/// Who is told an outline, piece by piece, y up, in units of the face.
pub trait OutlineBuilder {
    /// Begins a contour.
    fn move_to(&mut self, x: f32, y: f32);
    /// A straight line.
    fn line_to(&mut self, x: f32, y: f32);
    /// A quadratic Bézier curve.
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32);
    /// A cubic Bézier curve.
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32);
    /// Ends a contour.
    fn close(&mut self);
}

/// Bytes that are no packed face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceParsingError;

/// What a face says beside its glyphs.
#[derive(Clone, Copy)]
pub struct FaceTables<'a> {
    /// The script forms of letters.
    pub gsub: Option<gsub::Table<'a>>,
    /// The measures of formulas.
    pub math: Option<math::Table<'a>>,
}

/// A face.
#[derive(Clone)]
pub struct Face<'a> {
    packed: &'static Packed,
    tables: FaceTables<'a>,
    bytes: PhantomData<&'a [u8]>,
}

impl Face<'_> {
    /// Reads a face from one or more packed pieces; of words, 0 is the regular weight and 1 the semibold one.
    /// What is read stays for good.
    ///
    /// # Errors
    /// Where the bytes are something else.
    pub fn parse(bytes: &[u8], weight: u32) -> Result<Self, FaceParsingError> {
        let packed: &'static Packed =
            Box::leak(Box::new(Packed::read(bytes, weight).ok_or(FaceParsingError)?));
        let tables = FaceTables { gsub: Some(gsub::Table::new(packed)), math: math::Table::new(packed) };
        Ok(Self { packed, tables, bytes: PhantomData })
    }

    /// Units in an em.
    #[must_use]
    pub fn units_per_em(&self) -> u16 {
        1000
    }

    /// How far letters reach up, by the face.
    #[must_use]
    pub fn ascender(&self) -> i16 {
        self.packed.ascender
    }

    /// How far letters reach down, by the face, below 0.
    #[must_use]
    pub fn descender(&self) -> i16 {
        self.packed.descender
    }

    /// How high small letters are, where the face says it.
    #[must_use]
    pub fn x_height(&self) -> Option<i16> {
        self.packed.x_height
    }

    /// One more than the greatest number of a glyph.
    #[must_use]
    pub fn number_of_glyphs(&self) -> u16 {
        self.packed.count()
    }

    /// The glyph of a character.
    #[must_use]
    pub fn glyph_index(&self, character: char) -> Option<GlyphId> {
        self.packed.of_character(character).map(GlyphId)
    }

    /// The width that a glyph advances by.
    #[must_use]
    pub fn glyph_hor_advance(&self, glyph: GlyphId) -> Option<u16> {
        self.packed.glyph(glyph).map(|glyph| glyph.advance)
    }

    /// By how much more the second glyph of a pair stands from the first, mostly below 0.
    #[must_use]
    pub fn kerning(&self, left: GlyphId, right: GlyphId) -> Option<i16> {
        self.packed.kerning(left, right)
    }

    /// What a glyph reaches; none for one without ink.
    #[must_use]
    pub fn glyph_bounding_box(&self, glyph: GlyphId) -> Option<Rect> {
        self.outline_glyph(glyph, &mut outline::Untold)
    }

    /// Tells the outline of a glyph, and gives what it reaches; none for a glyph without ink.
    pub fn outline_glyph(&self, glyph: GlyphId, builder: &mut dyn OutlineBuilder) -> Option<Rect> {
        outline::tell(self.packed, self.packed.glyph(glyph)?, builder)
    }
}

impl<'a> Face<'a> {
    /// What it says beside its glyphs.
    #[must_use]
    pub fn tables(&self) -> &FaceTables<'a> {
        &self.tables
    }
}
