//! Words: characters to glyphs, left to right, with the face's kerning.
//!
//! Latin, Greek and Cyrillic need no shaping beyond that. A letter and an accent after it become one. A sign
//! that the word face lacks is taken from the formula face; a character that neither has is an error that
//! names it, never an empty box.

use ttf_parser::GlyphId;
#[cfg(not(tracefig_page))]
use ttf_parser::gpos::{PairAdjustment, PositioningSubtable};

use super::accents::composed;
use super::face::Loaded;
use super::line::{Face, Glyph, PlacedGlyph, Style, TypesetError, Weight};

/// Glyphs of a word and its advance width, in page pixels.
pub(super) struct Word {
    /// The glyphs, from the word's start.
    pub(super) glyphs: Vec<PlacedGlyph>,
    /// The advance width in page pixels.
    pub(super) width: f64,
}

/// Sets characters, each with its byte offset in the markup.
pub(super) fn set(
    characters: impl Iterator<Item = (usize, char)>,
    style: Style,
) -> Result<Word, TypesetError> {
    let mut word = Word { glyphs: Vec::new(), width: 0.0 };
    let mut before: Option<Glyph> = None;
    for (offset, character) in composed(characters) {
        let glyph = glyph_of(character, style.weight).ok_or_else(|| missing(offset, character))?;
        if let Some(kern) = before.and_then(|left| kerning(left, glyph)) {
            word.width += kern * style.size;
        }
        word.glyphs.push(PlacedGlyph { glyph, x: word.width, y: 0.0, size: style.size });
        word.width += advance(glyph) * style.size;
        before = Some(glyph);
    }
    Ok(word)
}

/// Width of a character among regular words, in ems; that of a figure where the fonts lack it.
pub(crate) fn advance_of(character: char) -> f64 {
    glyph_of(character, Weight::Regular).map_or(0.5, advance)
}

/// Width of a space, in page pixels.
pub(super) fn space(style: Style) -> f64 {
    glyph_of(' ', style.weight).map_or(0.25, advance) * style.size
}

/// The error that names a character without a glyph.
pub(super) fn missing(offset: usize, character: char) -> TypesetError {
    let code = u32::from(character);
    TypesetError { offset, message: format!("the fonts have no glyph for {character:?} (U+{code:04X})") }
}

fn glyph_of(character: char, weight: Weight) -> Option<Glyph> {
    let words = match weight {
        Weight::Regular => Face::Regular,
        Weight::Semibold => Face::Semibold,
    };
    [words, Face::Math].into_iter().find_map(|face| {
        // Without mark positioning a combining accent would stand beside its letter.
        let is_combining = matches!(character, '\u{300}'..='\u{36F}' | '\u{20D0}'..='\u{20FF}');
        let loaded = Loaded::of(face)?;
        let ask = || loaded.face().glyph_index(character).map_or(0, |glyph| glyph.0);
        let id = loaded.pairs.glyph(character, ask);
        (!is_combining && id != 0).then_some(Glyph { face, id })
    })
}

/// The advance width of a glyph, in ems.
fn advance(glyph: Glyph) -> f64 {
    let Some(loaded) = Loaded::of(glyph.face) else { return 0.0 };
    let units = loaded.face().glyph_hor_advance(GlyphId(glyph.id)).unwrap_or(0);
    f64::from(units) * loaded.em()
}

/// How far the face moves the right glyph of a pair, in ems, mostly below 0; `None` across faces or without a
/// rule for the pair.
fn kerning(left: Glyph, right: Glyph) -> Option<f64> {
    if left.face != right.face || left.face == Face::Math {
        return None;
    }
    let loaded = Loaded::of(left.face)?;
    let ask = || rule(loaded, GlyphId(left.id), GlyphId(right.id));
    let units = loaded.pairs.kerning((left.id, right.id), ask);
    units.map(|units| f64::from(units) * loaded.em())
}

/// The kerning of two glyphs of a face of words, in its units.
#[cfg(not(tracefig_page))]
pub(super) fn units(loaded: &Loaded, left: u16, right: u16) -> i16 {
    rule(loaded, GlyphId(left), GlyphId(right)).unwrap_or(0)
}

/// The rule of a packed face for a pair, in its units.
#[cfg(tracefig_page)]
fn rule(loaded: &Loaded, left: GlyphId, right: GlyphId) -> Option<i16> {
    loaded.face().kerning(left, right)
}

/// The rule of a face for a pair, in its units.
#[cfg(not(tracefig_page))]
fn rule(loaded: &Loaded, left: GlyphId, right: GlyphId) -> Option<i16> {
    let lookups = loaded.face().tables().gpos?.lookups;
    // The first subtable that covers the pair decides; the embedded faces have no other kind of lookup.
    lookups
        .into_iter()
        .flat_map(|lookup| lookup.subtables.into_iter::<PositioningSubtable>())
        .find_map(|table| pair(&table, left, right))
}

/// The kerning of a pair in one table, in units of the face.
#[cfg(not(tracefig_page))]
fn pair(table: &PositioningSubtable, left: GlyphId, right: GlyphId) -> Option<i16> {
    let PositioningSubtable::Pair(adjustment) = table else { return None };
    match adjustment {
        PairAdjustment::Format1 { coverage, sets } => {
            let (first, _) = sets.get(coverage.get(left)?)?.get(right)?;
            Some(first.x_advance)
        }
        PairAdjustment::Format2 { coverage, classes, matrix } => {
            coverage.get(left)?;
            let (first, _) = matrix.get((classes.0.get(left), classes.1.get(right)))?;
            Some(first.x_advance)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn width(text: &str) -> f64 {
        set(text.char_indices(), Style::regular(1000.0)).unwrap().width
    }

    #[test]
    fn the_pair_av_is_kerned() {
        assert!(width("AV") < width("A") + width("V") - 10.0, "{} {}", width("AV"), width("A") + width("V"));
        assert_eq!(width("nn"), 2.0 * width("n"));
    }

    #[test]
    fn common_latin_greek_and_cyrillic_have_glyphs_in_both_weights() {
        let text = "Ärger über façade, ñandú; Łódź, čeština; αβγδ Ωμέγα; Жизнь, ёлка, їжак \
                    – “quotes” … ≤ ≥ ≠ × → ′ ‖ ⊖ ∈";
        for style in [Style::regular(14.0), Style::semibold(14.0)] {
            let word = set(text.char_indices(), style).unwrap();
            for placed in &word.glyphs {
                assert_ne!(placed.glyph.id, 0, "no empty box");
            }
        }
    }

    #[test]
    fn a_character_without_a_glyph_is_named_with_its_place() {
        let Err(error) = set("ab ש".char_indices(), Style::regular(14.0)) else {
            panic!("Hebrew was set without a font for it")
        };
        assert_eq!(error.offset, 3);
        assert!(error.message.contains('ש') && error.message.contains("U+05E9"), "{}", error.message);
    }
}
