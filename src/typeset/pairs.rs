//! Glyphs of characters and the kerning of pairs, kept once they were asked for.
//!
//! A face says both by binary search through nested tables, which took more time than all else of setting
//! words. What is kept is a pure function of the face.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU16, AtomicU32, Ordering};

/// Characters from 0 up to this have their glyph kept: Latin, in which most texts are.
const CHARACTERS: usize = 0x180;
/// What stands for a glyph that was not asked for; no face has so many.
const UNASKED: u16 = u16::MAX;
/// The bit of a pair that was asked for.
const ASKED: u32 = 1 << 31;
/// The bit of a pair that has a rule.
const RULED: u32 = 1 << 30;

/// The kerning of a glyph with every glyph to its right, each asked for or not.
type Row = Box<[AtomicU32]>;

/// What a face said so far.
pub(super) struct Pairs {
    /// The glyph of each of the first characters.
    glyphs: Vec<AtomicU16>,
    /// For each glyph to the left its pairs.
    rows: Vec<OnceLock<Row>>,
}

impl Pairs {
    /// Nothing yet of a face with so many glyphs.
    pub(super) fn new(count: u16) -> Self {
        let mut rows = Vec::new();
        rows.resize_with(usize::from(count), OnceLock::new);
        Self { glyphs: (0..CHARACTERS).map(|_| AtomicU16::new(UNASKED)).collect(), rows }
    }

    /// The glyph of a character, 0 where there is none; `ask` asks the face.
    pub(super) fn glyph(&self, character: char, ask: impl FnOnce() -> u16) -> u16 {
        let place = usize::try_from(u32::from(character)).ok().and_then(|i| self.glyphs.get(i));
        let Some(place) = place else { return ask() };
        match place.load(Ordering::Relaxed) {
            UNASKED => {
                let glyph = ask();
                place.store(glyph, Ordering::Relaxed);
                glyph
            }
            known => known,
        }
    }

    /// The kerning of a pair in units of the face; `ask` asks the face.
    pub(super) fn kerning(
        &self,
        (left, right): (u16, u16),
        ask: impl FnOnce() -> Option<i16>,
    ) -> Option<i16> {
        let unasked = || self.rows.iter().map(|_| AtomicU32::new(0)).collect();
        let row = self.rows.get(usize::from(left)).map(|row| row.get_or_init(unasked));
        let place = row.and_then(|row| row.get(usize::from(right)));
        let Some(place) = place else { return ask() };
        match place.load(Ordering::Relaxed) {
            0 => {
                let rule = ask();
                place.store(packed(rule), Ordering::Relaxed);
                rule
            }
            known => unpacked(known),
        }
    }
}

/// A rule for a pair, or that there is none, in one number that is not 0.
fn packed(rule: Option<i16>) -> u32 {
    rule.map_or(ASKED, |units| ASKED | RULED | u32::from(units.cast_unsigned()))
}

/// The rule of such a number.
fn unpacked(packed: u32) -> Option<i16> {
    let units = u16::try_from(packed & u32::from(u16::MAX)).ok()?.cast_signed();
    (packed & RULED != 0).then_some(units)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_is_asked_once_for_a_letter_and_for_a_pair() {
        let pairs = Pairs::new(10);
        assert_eq!((pairs.glyph('A', || 7), pairs.glyph('A', || 8)), (7, 7));
        assert_eq!((pairs.glyph('Я', || 7), pairs.glyph('Я', || 8)), (7, 8), "no letter of Latin");
        for (right, rule) in [(1, None), (2, Some(-30)), (3, Some(i16::MIN)), (4, Some(0)), (5, Some(30))] {
            assert_eq!(pairs.kerning((9, right), || rule), rule);
            assert_eq!(pairs.kerning((9, right), || Some(1)), rule);
        }
        assert_eq!(pairs.kerning((10, 1), || Some(2)), Some(2), "no glyph of the face");
    }
}
