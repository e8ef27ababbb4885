//! What packed faces say is what the whole ones say, read by the module's reader.

use std::collections::BTreeSet;

use packed_faces as read;
use ttf_parser::{GlyphId, OutlineBuilder};

use super::super::face::Loaded;
use super::super::line::Face;
use super::super::needed::Glyphs;
use super::super::own::own;
use super::super::words::units;
use super::glyphs::characters;
use super::outline::Told;
use super::{formulas, grown, script_forms, words};

impl read::OutlineBuilder for Told {
    fn move_to(&mut self, x: f32, y: f32) {
        OutlineBuilder::move_to(self, x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        OutlineBuilder::line_to(self, x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        OutlineBuilder::quad_to(self, x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        OutlineBuilder::curve_to(self, x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        OutlineBuilder::close(self);
    }
}

/// Holds what a packed face says of glyphs to what the whole one says.
fn compare(packed: &read::Face, face: Face, glyphs: &BTreeSet<u16>) {
    let whole = Loaded::of(face).unwrap().face();
    assert_eq!((packed.ascender(), packed.descender()), (whole.ascender(), whole.descender()));
    assert_eq!(packed.units_per_em(), whole.units_per_em());
    // Of words nobody asks it.
    assert!(face == Face::Semibold || packed.x_height() == whole.x_height());
    for (code, glyph) in characters(whole).into_iter().filter(|(_, glyph)| glyphs.contains(glyph)) {
        let character = char::from_u32(code.cast_unsigned()).unwrap();
        assert_eq!(packed.glyph_index(character).map(|id| id.0), Some(glyph), "the character of {glyph}");
    }
    for &glyph in glyphs {
        let (id, other) = (GlyphId(glyph), read::GlyphId(glyph));
        assert_eq!(packed.glyph_hor_advance(other), whole.glyph_hor_advance(id), "the width of {glyph}");
        let (mut told, mut wanted) = (Told::default(), Told::default());
        let reach = packed.outline_glyph(other, &mut told);
        let wanted_reach = whole.outline_glyph(id, &mut wanted);
        assert_eq!(told.0, wanted.0, "the outline of {glyph}");
        if face == Face::Math {
            let sides = reach.map(|r| [r.x_min, r.y_min, r.x_max, r.y_max]);
            assert_eq!(
                sides,
                wanted_reach.map(|r| [r.x_min, r.y_min, r.x_max, r.y_max]),
                "the reach of {glyph}"
            );
        }
    }
    assert_eq!(packed.glyph_index('\u{10FFFF}'), None);
}

#[test]
fn packed_words_say_what_the_whole_faces_say_of_them() {
    let all: BTreeSet<u16> = ('!'..='~')
        .chain('à'..='ž')
        .filter_map(|c| Some(Loaded::of(Face::Regular)?.face().glyph_index(c)?.0))
        .collect();
    let pieces = [words(&BTreeSet::new(), &own().words), words(&own().words, &all)];
    let all = &own().words | &all;
    for (pieces, glyphs) in [(&pieces[..1], &own().words), (&pieces[..], &all)] {
        for (weight, face) in [(0, Face::Regular), (1, Face::Semibold)] {
            let packed = read::Face::parse(&pieces.concat(), weight).unwrap();
            compare(&packed, face, glyphs);
            for (&left, &right) in
                glyphs.iter().flat_map(|left| glyphs.iter().map(move |right| (left, right)))
            {
                let kerning = packed.kerning(read::GlyphId(left), read::GlyphId(right)).unwrap_or(0);
                assert_eq!(kerning, units(Loaded::of(face).unwrap(), left, right));
            }
        }
    }
}

/// What a measure of a glyph is, of formulas, in both faces.
fn compare_measures(packed: &read::Face, glyphs: &BTreeSet<u16>) {
    let font = Loaded::of(Face::Math).unwrap().math().unwrap();
    let ours = font.face().tables().math.unwrap();
    let (info, theirs) = (ours.glyph_info.unwrap(), packed.tables().math.unwrap());
    let their_info = theirs.glyph_info.unwrap();
    for &glyph in glyphs {
        let (id, other) = (GlyphId(glyph), read::GlyphId(glyph));
        let italic = info.italic_corrections.unwrap().get(id).map_or(0, |value| value.value);
        assert_eq!(
            their_info.italic_corrections.unwrap().get(other).map(|v| v.value),
            Some(italic),
            "italic of {glyph}"
        );
        let accent = info.top_accent_attachments.unwrap().get(id).map(|value| value.value);
        assert_eq!(
            their_info.top_accent_attachments.unwrap().get(other).map(|v| v.value),
            accent,
            "accent of {glyph}"
        );
        let lookup = packed.tables().gsub.unwrap().lookups.get(0).unwrap();
        let forms = lookup.subtables.into_iter::<read::gsub::SubstitutionSubtable>().find_map(|table| {
            let read::gsub::SubstitutionSubtable::Alternate(all) = table;
            all.alternate_sets.get(all.coverage.get(other)?)
        });
        let forms: Vec<u16> =
            forms.map(|set| set.alternates.iter().map(|id| id.0).collect()).unwrap_or_default();
        assert_eq!(forms, script_forms(font.face(), glyph), "the forms of {glyph}");
    }
    let (own, read) = (ours.constants.unwrap(), theirs.constants.unwrap());
    assert_eq!(own.script_percent_scale_down(), read.script_percent_scale_down());
    assert_eq!(own.display_operator_min_height(), read.display_operator_min_height());
    assert_eq!(own.axis_height().value, read.axis_height().value);
    assert_eq!(own.accent_base_height().value, read.accent_base_height().value);
    assert_eq!(own.radical_kern_after_degree().value, read.radical_kern_after_degree().value);
    assert_eq!(own.radical_degree_bottom_raise_percent(), read.radical_degree_bottom_raise_percent());
}

#[test]
fn packed_formulas_say_what_the_whole_face_says_of_them() {
    let texts = [
        r"$\sqrt{\frac{a}{b}} \left( \frac{\frac{a}{b}}{c} \right)$",
        r"$\widehat{xyz}$",
        r"$\overrightarrow{abcde}$",
    ];
    let more = Glyphs::of(texts.into_iter(), std::iter::empty(), "");
    let pieces = [formulas(&BTreeSet::new(), &own().formulas), formulas(&own().formulas, &more.formulas)];
    let all = &own().formulas | &more.formulas;
    for (pieces, glyphs) in [(&pieces[..1], &own().formulas), (&pieces[..], &all)] {
        let packed = read::Face::parse(&pieces.concat(), 0).unwrap();
        compare(&packed, Face::Math, glyphs);
        compare_measures(&packed, glyphs);
    }
    let packed = read::Face::parse(&pieces.concat(), 0).unwrap();
    let font = Loaded::of(Face::Math).unwrap().math().unwrap();
    let grown = grown(font)
        .into_iter()
        .filter(|(_, forms)| forms.iter().skip(1).any(|form| more.formulas.contains(form)));
    let mut count = 0;
    for (glyph, _) in grown {
        count += 1;
        let variants = packed.tables().math.unwrap().variants.unwrap();
        let forms = |all: read::math::GlyphConstructions| -> Vec<u16> {
            let forms = all.get(read::GlyphId(glyph)).unwrap().variants;
            [glyph].into_iter().chain(forms.iter().map(|form| form.variant_glyph.0)).collect()
        };
        assert_eq!(
            forms(variants.vertical_constructions),
            font.vertical_variants(glyph),
            "the high forms of {glyph}"
        );
        assert_eq!(
            forms(variants.horizontal_constructions),
            font.horizontal_variants(glyph),
            "the wide forms of {glyph}"
        );
        let assembly = variants.horizontal_constructions.get(read::GlyphId(glyph)).unwrap().assembly;
        let parts: Vec<_> = assembly
            .iter()
            .flat_map(|assembly| assembly.parts)
            .map(|p| {
                let [start, end] = [p.start_connector_length, p.end_connector_length];
                (p.glyph_id.0, start, end, p.full_advance, p.part_flags.extender())
            })
            .collect();
        assert_eq!(parts, font.horizontal_assembly_parts(glyph), "the parts of {glyph}");
    }
    assert!(count > 3, "{count} grow");
}

#[test]
fn bytes_that_are_no_face_are_told() {
    let whole = words(&BTreeSet::new(), &own().words);
    assert!((1..whole.len()).all(|end| read::Face::parse(&whole[..end], 0).is_err()));
    assert!(read::Face::parse(&[1; 40], 0).is_err());
}
