//! A font whose glyphs have widths and no ink.
//!
//! A table directory, then the tables that a font of outlines must have (head, hhea, maxp, hmtx, loca, glyf),
//! of which each entry of `loca` says that the glyph is empty. Source: *ISO/IEC 14496-22, Open Font Format*,
//! sections 4 and 5.

/// Units of an em: the widths of a PDF are thousandths of one.
const EM: u16 = 1000;

/// What a mark covers below and above the baseline, in thousandths of an em.
pub(super) const REACH: [i16; 2] = [-250, 800];

/// `checkSumAdjustment` makes the sum of the whole file this number.
const WHOLE: u32 = 0xB1B0_AFBA;

/// Bytes of the directory before its entries, and of each entry.
const DIRECTORY: [usize; 2] = [12, 16];

/// Where the adjustment stands within `head`.
const ADJUSTMENT: usize = 8;

/// The font of glyphs that are so wide, in thousandths of an em, after one of no width.
pub(super) fn of(widths: &[u16]) -> Vec<u8> {
    let count = u16::try_from(widths.len() + 1).unwrap_or(u16::MAX);
    let widest = widths.iter().copied().max().unwrap_or(EM);
    let glyphs = usize::from(count);
    let metrics = std::iter::once(0).chain(widths.iter().copied()).take(glyphs);
    // In the order of their names. An empty `glyf` is refused by some readers.
    let tables: [(&[u8; 4], Vec<u8>); 6] = [
        (b"glyf", vec![0; 4]),
        (b"head", head(widest)),
        (b"hhea", hhea(widest, count)),
        (b"hmtx", metrics.flat_map(|width| shorts(&[width, 0])).collect()),
        (b"loca", vec![0; 2 * (glyphs + 1)]),
        (b"maxp", maxp(count)),
    ];
    // Version 1.0, six tables, and how they are searched by halves.
    let mut directory = shorts(&[1, 0, 6, 64, 2, 32]);
    let mut body = Vec::new();
    let [before, entry] = DIRECTORY;
    let start = before + entry * tables.len();
    let mut head_at = 0;
    for (name, table) in &tables {
        let at = start + body.len();
        if *name == b"head" {
            head_at = at;
        }
        directory.extend(*name);
        for number in [sum(table), long(at), long(table.len())] {
            directory.extend(number.to_be_bytes());
        }
        body.extend(table);
        body.resize(body.len().next_multiple_of(4), 0);
    }
    directory.extend(body);
    let adjustment = WHOLE.wrapping_sub(sum(&directory));
    directory[head_at + ADJUSTMENT..][..4].copy_from_slice(&adjustment.to_be_bytes());
    directory
}

/// The sum of a table's numbers of four bytes.
fn sum(table: &[u8]) -> u32 {
    let number = |part: &[u8]| {
        let mut bytes = [0; 4];
        bytes[..part.len()].copy_from_slice(part);
        u32::from_be_bytes(bytes)
    };
    table.chunks(4).fold(0, |sum, part| sum.wrapping_add(number(part)))
}

fn long(x: usize) -> u32 {
    u32::try_from(x).unwrap_or(u32::MAX)
}

fn shorts(numbers: &[u16]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_be_bytes()).collect()
}

/// Version 1.0, the magic number, units of an em, no dates, the box of all glyphs, short offsets in `loca`.
fn head(widest: u16) -> Vec<u8> {
    let [bottom, top] = REACH.map(i16::cast_unsigned);
    let mut table = shorts(&[1, 0, 1, 0, 0, 0, 0x5F0F, 0x3CF5, 0, EM]);
    table.extend([0; 16]);
    table.extend(shorts(&[0, bottom, widest, top, 0, 8, 2, 0, 0]));
    table
}

/// Version 1.0, what a line covers, the widest glyph, a caret that stands upright, how many widths there are.
fn hhea(widest: u16, count: u16) -> Vec<u8> {
    let [bottom, top] = REACH.map(i16::cast_unsigned);
    shorts(&[1, 0, top, bottom, 0, widest, 0, 0, widest, 1, 0, 0, 0, 0, 0, 0, 0, count])
}

/// Version 1.0: how many glyphs there are; they have no points, and one zone.
fn maxp(count: u16) -> Vec<u8> {
    shorts(&[1, 0, count, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reader_of_fonts_finds_each_width_and_no_outline() {
        struct Nothing;
        impl ttf_parser::OutlineBuilder for Nothing {
            fn move_to(&mut self, _: f32, _: f32) {}
            fn line_to(&mut self, _: f32, _: f32) {}
            fn quad_to(&mut self, _: f32, _: f32, _: f32, _: f32) {}
            fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {}
            fn close(&mut self) {}
        }
        let font = of(&[500, 250, 1000]);
        let face = ttf_parser::Face::parse(&font, 0).unwrap();
        assert_eq!((face.number_of_glyphs(), face.units_per_em()), (4, EM));
        for (glyph, width) in (0..).zip([0, 500, 250, 1000]) {
            let glyph = ttf_parser::GlyphId(glyph);
            assert_eq!(face.glyph_hor_advance(glyph), Some(width));
            assert_eq!(face.outline_glyph(glyph, &mut Nothing), None);
        }
        assert_eq!((face.ascender(), face.descender()), (REACH[1], REACH[0]));
        assert_eq!(sum(&font), WHOLE);
    }
}
