//! What glyphs of words and of formulas have alike: numbers, characters, widths, outlines.

use ttf_parser::GlyphId;
use ttf_parser::cmap::Subtable;

use super::super::face::Loaded;
use super::numbers::Numbers;
use super::outline::Outline;

/// What words and formulas have alike.
pub(super) fn glyphs_of(out: &mut Numbers, loaded: &Loaded, ids: &[u16], outlines: &[Outline]) {
    let face = loaded.face();
    out.signed(face.ascender().into());
    out.signed(face.descender().into());
    out.number(face.x_height().map_or(0, |height| u32::from(height.unsigned_abs()) + 1));
    out.ids(0, ids);
    let mut before = 0;
    let characters = characters(face);
    for &id in ids {
        let own: Vec<i32> =
            characters.iter().filter(|(_, glyph)| *glyph == id).map(|(code, _)| *code).collect();
        out.count(own.len());
        for code in own {
            out.signed(code - before);
            before = code;
        }
    }
    out.numbers(ids.iter().map(|&id| width(loaded, id).into()));
    for outline in outlines {
        out.0.extend(&outline.pieces);
    }
    for axis in 0..2 {
        out.all_signed(outlines.iter().flat_map(|outline| &outline.ways[axis]).copied());
    }
}

/// All characters of a face, with their glyphs.
pub(super) fn characters(face: &ttf_parser::Face) -> Vec<(i32, u16)> {
    let mut found = Vec::new();
    for table in face.tables().cmap.iter().flat_map(|cmap| cmap.subtables).filter(Subtable::is_unicode) {
        table.codepoints(|code| {
            found.extend(table.glyph_index(code).map(|glyph| (code.cast_signed(), glyph.0)));
        });
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// The width of a glyph.
pub(super) fn width(loaded: &Loaded, id: u16) -> u16 {
    loaded.face().glyph_hor_advance(GlyphId(id)).unwrap_or(0)
}
