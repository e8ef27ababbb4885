//! The script forms of letters, as the feature `ssty` of a font file has them.

use std::marker::PhantomData;

use crate::packed::Packed;
use crate::{GlyphId, Tag};

/// All features: there is one.
#[derive(Clone, Copy)]
pub struct Table<'a> {
    /// By their names.
    pub features: Features,
    /// What they do.
    pub lookups: Lookups<'a>,
}

impl Table<'_> {
    pub(crate) fn new(packed: &'static Packed) -> Self {
        Self { features: Features, lookups: Lookups { packed, file: PhantomData } }
    }
}

/// Features by their names.
#[derive(Clone, Copy)]
pub struct Features;

impl Features {
    /// The feature of a name.
    #[must_use]
    pub fn find(self, name: Tag) -> Option<Feature> {
        (name == Tag::from_bytes(b"ssty")).then_some(Feature { lookup_indices: [0] })
    }
}

/// A feature.
#[derive(Clone, Copy)]
pub struct Feature {
    /// What it does.
    pub lookup_indices: [u16; 1],
}

/// What features do.
#[derive(Clone, Copy)]
pub struct Lookups<'a> {
    packed: &'static Packed,
    file: PhantomData<&'a [u8]>,
}

impl<'a> Lookups<'a> {
    /// What a feature does.
    #[must_use]
    pub fn get(self, _: u16) -> Option<Lookup<'a>> {
        Some(Lookup { subtables: Subtables(self) })
    }
}

/// What a feature does.
#[derive(Clone, Copy)]
pub struct Lookup<'a> {
    /// In its parts.
    pub subtables: Subtables<'a>,
}

/// The parts of what a feature does: one.
#[derive(Clone, Copy)]
pub struct Subtables<'a>(Lookups<'a>);

impl<'a> Subtables<'a> {
    /// All parts.
    #[expect(clippy::should_implement_trait, reason = "the kind of part is asked for")]
    pub fn into_iter<T: From<Alternate<'a>>>(self) -> impl Iterator<Item = T> {
        let Lookups { packed, file } = self.0;
        let alternate =
            Alternate { coverage: Coverage { packed, file }, alternate_sets: Sets { packed, file } };
        std::iter::once(T::from(alternate))
    }
}

/// A part of what a feature does.
#[derive(Clone, Copy)]
pub enum SubstitutionSubtable<'a> {
    /// Other forms of a glyph.
    Alternate(Alternate<'a>),
}

impl<'a> From<Alternate<'a>> for SubstitutionSubtable<'a> {
    fn from(alternate: Alternate<'a>) -> Self {
        Self::Alternate(alternate)
    }
}

/// Other forms of glyphs.
#[derive(Clone, Copy)]
pub struct Alternate<'a> {
    /// The places of glyphs, which here are their numbers.
    pub coverage: Coverage<'a>,
    /// The forms of each.
    pub alternate_sets: Sets<'a>,
}

/// Which glyphs have other forms.
#[derive(Clone, Copy)]
pub struct Coverage<'a> {
    packed: &'static Packed,
    file: PhantomData<&'a [u8]>,
}

impl Coverage<'_> {
    /// The place of a glyph that has any.
    #[must_use]
    pub fn get(self, glyph: GlyphId) -> Option<u16> {
        self.packed.glyph(glyph).filter(|glyph| glyph.forms > 0).map(|glyph| glyph.id)
    }
}

/// The forms of glyphs.
#[derive(Clone, Copy)]
pub struct Sets<'a> {
    packed: &'static Packed,
    file: PhantomData<&'a [u8]>,
}

impl Sets<'_> {
    /// Those of the glyph at a place.
    #[must_use]
    pub fn get(self, place: u16) -> Option<Set> {
        let glyph = self.packed.glyph(GlyphId(place))?;
        Some(Set { alternates: glyph.scripts.get(..glyph.forms)? })
    }
}

/// The forms of a glyph.
#[derive(Clone, Copy)]
pub struct Set {
    /// In their order.
    pub alternates: &'static [GlyphId],
}
