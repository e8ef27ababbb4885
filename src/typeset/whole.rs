//! Which faces a live page must bring along, as its module has cut ones.
//!
//! It is known before the page is opened: a reader changes numbers and no words.

use std::sync::OnceLock;

use super::cut::file;
use super::face::{Loaded, build, file as whole};
use super::line::{Face, Glyph, Line, Style};

/// Page pixels of an em; the glyphs of a text are the same at any.
const SIZE: f64 = 16.0;

/// The whole faces, each with its file, that a page must bring along to set these texts: markup, and parts of
/// it. A text that is none may be a part of one, so that each of its characters counts.
pub(crate) fn beyond<'t>(texts: impl Iterator<Item = &'t str>) -> Vec<(Face, &'static [u8])> {
    let lacks = texts.flat_map(set_somehow).fold([false; 3], |mut lacks, glyph| {
        lacks[glyph.face as usize] = lacks[glyph.face as usize] || !has(glyph);
        lacks
    });
    Face::ALL.into_iter().filter(|&face| lacks[face as usize]).map(|face| (face, whole(face))).collect()
}

/// The glyphs of a text in both weights; of a single letter, as may be a name, also in a formula and as its
/// script.
fn set_somehow(text: &str) -> Vec<Glyph> {
    let mut found = Vec::new();
    let mut take = |line: Line| found.extend(line.glyphs.iter().map(|placed| placed.glyph));
    let mut set = |markup: &str| -> bool {
        let styles = [Style::regular(SIZE), Style::semibold(SIZE)];
        styles.map(|style| super::typeset(markup, style).map(&mut take).is_ok()) == [true; 2]
    };
    if !set(text) {
        for character in text.chars() {
            set(&character.to_string());
        }
    }
    if text.chars().count() == 1 {
        set(&format!("${text}_{{{text}}}$"));
    }
    found
}

/// Whether a cut face has the outline of a glyph.
pub(crate) fn has(glyph: Glyph) -> bool {
    static CUT: [OnceLock<Option<Loaded>>; 3] = [OnceLock::new(), OnceLock::new(), OnceLock::new()];
    let cut = CUT[glyph.face as usize].get_or_init(|| Loaded::load(glyph.face, file(glyph.face)));
    let outline = cut.as_ref().map(|cut| build(cut.face(), glyph.id)).unwrap_or_default();
    outline == *glyph.outline()
}

#[cfg(test)]
mod tests {
    use ttf_parser::{GlyphId, RawFace, Tag};

    use super::*;

    #[test]
    fn what_a_cut_face_has_it_lays_out_as_the_whole_one() {
        for face in Face::ALL {
            let (whole, cut) = (Loaded::of(face).unwrap(), Loaded::load(face, file(face)).unwrap());
            let mut count = 0;
            for id in 0..cut.face().number_of_glyphs() {
                let glyph = Glyph { face, id };
                if has(glyph) && !glyph.outline().segments.is_empty() {
                    count += 1;
                    let advance = |face: &ttf_parser::Face| face.glyph_hor_advance(GlyphId(id));
                    assert_eq!(advance(cut.face()), advance(whole.face()), "{glyph:?}");
                }
            }
            assert!(count > 200, "{face:?}: {count}");
        }
        let constants = |bytes| RawFace::parse(bytes, 0).unwrap().table(Tag::from_bytes(b"MATH")).unwrap();
        assert_eq!(constants(file(Face::Math)), constants(whole(Face::Math)));
    }
}
