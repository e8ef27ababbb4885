//! Formulas, packed: their glyphs with the measures that the setter of formulas asks for.

use std::collections::BTreeSet;

use latex_rust::MathFont;
use ttf_parser::gsub::SubstitutionSubtable;
use ttf_parser::{GlyphId, RawFace, Tag};

use super::super::face::{Loaded, file};
use super::super::line::Face;
use super::glyphs::glyphs_of;
use super::numbers::{Numbers, folded};
use super::outline::Outline;

/// How many constants the table `MATH` has.
const CONSTANTS: usize = 56;

/// A piece of the face of formulas: some glyphs for a face that has others already. Of these larger forms are
/// said where one of them is a glyph of the face.
pub(in crate::typeset) fn formulas(known: &BTreeSet<u16>, glyphs: &BTreeSet<u16>) -> Vec<u8> {
    let ids: Vec<u16> = glyphs.difference(known).copied().collect();
    let Some((loaded, font)) = Loaded::of(Face::Math).and_then(|loaded| Some((loaded, loaded.math()?)))
    else {
        return Vec::new();
    };
    let mut out = Numbers(vec![1]);
    let outlines: Vec<_> = ids.iter().flat_map(|&id| Outline::of_all(&[loaded], id)).collect();
    glyphs_of(&mut out, loaded, &ids, &outlines);
    let constants = if known.is_empty() { constants() } else { Vec::new() };
    out.count(constants.len());
    out.all_signed(constants);
    let info = loaded.face().tables().math.and_then(|math| math.glyph_info);
    for &id in &ids {
        let italic = info.and_then(|info| info.italic_corrections?.get(GlyphId(id)));
        out.signed(italic.map_or(0, |italic| italic.value.into()));
    }
    for &id in &ids {
        let accent = info.and_then(|info| info.top_accent_attachments?.get(GlyphId(id)));
        out.number(accent.map_or(0, |accent| folded(accent.value.into()) + 1));
    }
    for form in 0..2 {
        let script = |id| script_forms(loaded.face(), id).get(form).copied().unwrap_or(id);
        out.all_signed(ids.iter().map(|&id| i32::from(script(id)) - i32::from(id)));
    }
    let growing: Vec<u16> = grown(font)
        .into_iter()
        .filter(|(id, forms)| {
            let is_new = |form: &u16| form != id && glyphs.contains(form) && !known.contains(form);
            forms.iter().any(is_new)
        })
        .map(|(id, _)| id)
        .collect();
    out.count(growing.len());
    for id in growing {
        growth(&mut out, font, id);
    }
    out.0
}

/// The constants of formulas.
fn constants() -> Vec<i32> {
    let table = RawFace::parse(file(Face::Math), 0).ok().and_then(|raw| raw.table(Tag::from_bytes(b"MATH")));
    let table = table.unwrap_or_default();
    let at = |place: usize| table.get(place..place + 2).map_or(0, |two| i16::from_be_bytes([two[0], two[1]]));
    let first = usize::try_from(at(4)).unwrap_or(0);
    // Four numbers, and then each with the place of corrections that screens would need.
    (0..CONSTANTS).map(|k| at(first + if k < 4 { 2 * k } else { 8 + 4 * (k - 4) }).into()).collect()
}

/// The forms of a glyph in scripts and in scripts of scripts, as far as it has them.
pub(in crate::typeset) fn script_forms(face: &ttf_parser::Face, id: u16) -> Vec<u16> {
    let lookups = face.tables().gsub.map(|gsub| gsub.lookups);
    let tables = lookups.into_iter().flatten();
    let mut tables = tables.flat_map(|lookup| lookup.subtables.into_iter::<SubstitutionSubtable>());
    let forms = tables.find_map(|table| match table {
        SubstitutionSubtable::Alternate(alternate) => {
            alternate.alternate_sets.get(alternate.coverage.get(GlyphId(id))?)
        }
        _ => None,
    });
    forms.into_iter().flat_map(|set| set.alternates).map(|form| form.0).take(2).collect()
}

/// The glyphs that grow, each with its forms and their parts.
pub(in crate::typeset) fn grown(font: &MathFont) -> Vec<(u16, Vec<u16>)> {
    let all = (0..font.face().number_of_glyphs()).map(|id| {
        let mut forms = font.vertical_variants(id);
        forms.extend(font.horizontal_variants(id));
        forms.extend(font.horizontal_assembly_parts(id).into_iter().map(|(part, ..)| part));
        (id, forms)
    });
    all.filter(|(id, forms)| forms.iter().any(|form| form != id)).collect()
}

/// What a glyph grows to.
fn growth(out: &mut Numbers, font: &MathFont, id: u16) {
    out.number(id.into());
    // Each list of ours begins with the glyph itself, which the reader's begins with anyway.
    out.ids(id, &font.vertical_variants(id)[1..]);
    out.ids(id, &font.horizontal_variants(id)[1..]);
    let parts = font.horizontal_assembly_parts(id);
    out.ids(id, &parts.iter().map(|&(part, ..)| part).collect::<Vec<_>>());
    for (_, start, end, length, repeats) in parts {
        out.numbers([start, end, length, u16::from(repeats)].map(u32::from));
    }
}
