//! The measures of formulas, as the table `MATH` of a font file has them.

use std::marker::PhantomData;

use crate::GlyphId;
use crate::packed::{Glyph, Packed};

/// All measures.
#[derive(Clone, Copy)]
pub struct Table<'a> {
    /// Those of the face.
    pub constants: Option<Constants<'a>>,
    /// Those of its glyphs.
    pub glyph_info: Option<GlyphInfo<'a>>,
    /// What glyphs grow to.
    pub variants: Option<Variants<'a>>,
}

impl Table<'_> {
    pub(crate) fn new(packed: &'static Packed) -> Option<Self> {
        let file = PhantomData;
        let values = |of| Some(MathValues { packed, of, file });
        let glyph_info = GlyphInfo {
            italic_corrections: values(|glyph| Some(glyph.italic)),
            top_accent_attachments: values(|glyph| glyph.accent),
        };
        let growing = |way| GlyphConstructions { packed, way, file };
        let variants = Variants { vertical_constructions: growing(0), horizontal_constructions: growing(1) };
        (!packed.constants.is_empty()).then_some(Self {
            constants: Some(Constants { packed, file }),
            glyph_info: Some(glyph_info),
            variants: Some(variants),
        })
    }
}

/// A measure.
#[derive(Clone, Copy)]
pub struct MathValue {
    /// In units of the face.
    pub value: i16,
}

/// The measures of the face, in the order of the table.
#[derive(Clone, Copy)]
pub struct Constants<'a> {
    packed: &'static Packed,
    file: PhantomData<&'a [u8]>,
}

impl Constants<'_> {
    fn at(self, place: usize) -> i16 {
        self.packed.constants.get(place).copied().unwrap_or(0)
    }
}

/// The names of constants with their places in the table.
macro_rules! constants {
    ($($name:ident: $place:literal),+ $(,)?) => {
        impl Constants<'_> {$(
            /// The constant of this name.
            #[must_use]
            pub fn $name(self) -> MathValue {
                MathValue { value: self.at($place) }
            }
        )+}
    };
}

constants! {
    axis_height: 5,
    accent_base_height: 6,
    flattened_accent_base_height: 7,
    subscript_shift_down: 8,
    subscript_top_max: 9,
    subscript_baseline_drop_min: 10,
    superscript_shift_up: 11,
    superscript_shift_up_cramped: 12,
    superscript_bottom_min: 13,
    superscript_baseline_drop_max: 14,
    sub_superscript_gap_min: 15,
    superscript_bottom_max_with_subscript: 16,
    space_after_script: 17,
    upper_limit_gap_min: 18,
    upper_limit_baseline_rise_min: 19,
    lower_limit_gap_min: 20,
    lower_limit_baseline_drop_min: 21,
    stack_top_shift_up: 22,
    stack_bottom_shift_down: 24,
    stack_gap_min: 26,
    fraction_numerator_shift_up: 32,
    fraction_numerator_display_style_shift_up: 33,
    fraction_denominator_shift_down: 34,
    fraction_denominator_display_style_shift_down: 35,
    fraction_numerator_gap_min: 36,
    fraction_num_display_style_gap_min: 37,
    fraction_rule_thickness: 38,
    fraction_denominator_gap_min: 39,
    fraction_denom_display_style_gap_min: 40,
    overbar_vertical_gap: 43,
    overbar_rule_thickness: 44,
    overbar_extra_ascender: 45,
    underbar_vertical_gap: 46,
    underbar_rule_thickness: 47,
    underbar_extra_descender: 48,
    radical_vertical_gap: 49,
    radical_display_style_vertical_gap: 50,
    radical_rule_thickness: 51,
    radical_extra_ascender: 52,
    radical_kern_before_degree: 53,
    radical_kern_after_degree: 54,
}

impl Constants<'_> {
    /// The constant of this name, in hundredths.
    #[must_use]
    pub fn script_percent_scale_down(self) -> i16 {
        self.at(0)
    }

    /// The constant of this name, in hundredths.
    #[must_use]
    pub fn script_script_percent_scale_down(self) -> i16 {
        self.at(1)
    }

    /// The constant of this name.
    #[must_use]
    pub fn display_operator_min_height(self) -> u16 {
        self.at(3).cast_unsigned()
    }

    /// The constant of this name, in hundredths.
    #[must_use]
    pub fn radical_degree_bottom_raise_percent(self) -> i16 {
        self.at(55)
    }
}

/// The measures of glyphs.
#[derive(Clone, Copy)]
pub struct GlyphInfo<'a> {
    /// How far they lean over their width.
    pub italic_corrections: Option<MathValues<'a>>,
    /// Where an accent stands over them.
    pub top_accent_attachments: Option<MathValues<'a>>,
}

/// A measure of each glyph.
#[derive(Clone, Copy)]
pub struct MathValues<'a> {
    packed: &'static Packed,
    of: fn(&Glyph) -> Option<i16>,
    file: PhantomData<&'a [u8]>,
}

impl MathValues<'_> {
    /// That of a glyph.
    #[must_use]
    pub fn get(self, glyph: GlyphId) -> Option<MathValue> {
        (self.of)(self.packed.glyph(glyph)?).map(|value| MathValue { value })
    }
}

/// What glyphs grow to.
#[derive(Clone, Copy)]
pub struct Variants<'a> {
    /// Upwards.
    pub vertical_constructions: GlyphConstructions<'a>,
    /// Sideways.
    pub horizontal_constructions: GlyphConstructions<'a>,
}

/// What glyphs grow to, one way.
#[derive(Clone, Copy)]
pub struct GlyphConstructions<'a> {
    packed: &'static Packed,
    way: usize,
    file: PhantomData<&'a [u8]>,
}

impl GlyphConstructions<'_> {
    /// What a glyph grows to.
    #[must_use]
    pub fn get(self, glyph: GlyphId) -> Option<GlyphConstruction> {
        let growth = self.packed.growth(glyph)?;
        let parts = &growth.parts[..];
        let assembly = (self.way == 1 && !parts.is_empty()).then_some(GlyphAssembly { parts });
        Some(GlyphConstruction { assembly, variants: &growth.variants[self.way] })
    }
}

/// What a glyph grows to, one way.
#[derive(Clone, Copy)]
pub struct GlyphConstruction {
    /// The parts that a form of any size is made of; here of wide ones alone, as nobody asks for others.
    pub assembly: Option<GlyphAssembly>,
    /// Larger forms.
    pub variants: &'static [GlyphVariant],
}

/// The parts of a form of any size.
#[derive(Clone, Copy)]
pub struct GlyphAssembly {
    /// From left to right.
    pub parts: &'static [GlyphPart],
}

/// A larger form.
#[derive(Clone, Copy)]
pub struct GlyphVariant {
    /// Its glyph.
    pub variant_glyph: GlyphId,
}

/// A part of a form of any size.
#[derive(Clone, Copy)]
pub struct GlyphPart {
    /// Its glyph.
    pub glyph_id: GlyphId,
    /// By how much it may lie over the part before.
    pub start_connector_length: u16,
    /// By how much it may lie over the part after.
    pub end_connector_length: u16,
    /// How long it is.
    pub full_advance: u16,
    /// What it may do.
    pub part_flags: PartFlags,
}

/// What a part may do.
#[derive(Clone, Copy)]
pub struct PartFlags(bool);

impl PartFlags {
    /// Whether it may stand more than once.
    #[must_use]
    pub fn extender(self) -> bool {
        self.0
    }
}

impl GlyphPart {
    pub(crate) fn new(glyph: u16, measures: [u32; 4]) -> Option<Self> {
        let [start, end, full, extends] = measures;
        Some(Self {
            glyph_id: GlyphId(glyph),
            start_connector_length: start.try_into().ok()?,
            end_connector_length: end.try_into().ok()?,
            full_advance: full.try_into().ok()?,
            part_flags: PartFlags(extends > 0),
        })
    }
}
