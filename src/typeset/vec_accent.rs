//! The arrow over a vector, `\\vec v`: the short one of the face, over the middle of its letter.
//!
//! `latex-rust` takes the arrow of relations, an em wide, ends it where the letter ends, and moves the letter
//! aside for it. Such a box is known by that arrow; here the letter goes back to its place. Combining arrows
//! in a face stand over letters of accent base height, so over a higher letter they are lifted by the rest
//! (`OpenType`, table MATH; Knuth, *The `TeXbook`*, 1984, appendix G, rule 12).

use latex_rust::{BoxContent, MathBox};

use super::face::{Loaded, ems};
use super::line::{Face, Glyph};

/// Letters at least so wide, in ems, keep the long arrow.
const LONG: f64 = 1.0;

/// Letters with an arrow over them.
pub(super) struct Vector<'b> {
    /// The letters.
    pub(super) base: &'b MathBox,
    /// The arrow.
    pub(super) arrow: Glyph,
    /// The arrow's size over that of the letters' em.
    pub(super) scale: f64,
    /// The middle of a single letter's top, in ems from its origin.
    pub(super) middle: Option<f64>,
    /// How far up the arrow's glyph goes, in ems.
    pub(super) raise: f64,
}

impl<'b> Vector<'b> {
    /// Two boxes over each other as a vector, if the second is the arrow.
    pub(super) fn of(children: &'b [MathBox]) -> Option<Self> {
        let [shifted, accent] = children else { return None };
        let font = Loaded::of(Face::Math)?.math()?;
        let id = |c: char| font.face().glyph_index(c).map(|id| id.0);
        let (arrow, scale) = single(accent)?;
        if Some(arrow) != id('\u{2192}') {
            return None;
        }
        let base = match &shifted.content {
            BoxContent::HList(parts) => match parts.as_slice() {
                [MathBox { content: BoxContent::Kern(_), .. }, inner] => inner,
                _ => shifted,
            },
            _ => shifted,
        };
        let middle = single(base).and_then(|(id, scale)| Some(ems(&font.top_accent_attachment(id)?) * scale));
        let glyph = |id| Glyph { face: Face::Math, id };
        if ems(&base.width) >= LONG {
            return Some(Self { base, arrow: glyph(arrow), scale, middle: None, raise: ems(&accent.shift) });
        }
        let constants = font.face().tables().math.and_then(|math| math.constants);
        let usual = constants.map_or(0.0, |c| f64::from(c.accent_base_height().value));
        let usual = usual * Loaded::of(Face::Math)?.em() * scale;
        let raise = (ems(&base.height) - usual).max(0.0);
        Some(Self { base, arrow: glyph(id('\u{20D7}')?), scale, middle, raise })
    }
}

/// The only glyph of a box, and its size in ems.
fn single(piece: &MathBox) -> Option<(u16, f64)> {
    match &piece.content {
        BoxContent::Glyph { glyph_id, scale, .. } => Some((*glyph_id, ems(scale))),
        BoxContent::HList(parts) | BoxContent::VList(parts) => {
            let mut inked =
                parts.iter().filter(|p| !matches!(p.content, BoxContent::Empty | BoxContent::Kern(_)));
            let only = inked.next()?;
            if inked.next().is_some() { None } else { single(only) }
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::typeset::formula::set;
    use crate::typeset::{PlacedGlyph, UNITS_PER_EM};

    /// Left, top, right, bottom of a glyph's ink at 100 px an em.
    fn ink(placed: &PlacedGlyph) -> [f64; 4] {
        let [l, t, r, b] = placed.glyph.outline().bounds.map(|v| f64::from(v) / UNITS_PER_EM * placed.size);
        [placed.x + l, placed.y + t, placed.x + r, placed.y + b]
    }

    #[test]
    fn an_arrow_stands_over_its_letter() {
        for letter in ["v", "F", "n", "A", "x"] {
            let glyphs = set(&format!(r"\vec {letter}"), 0, 100.0).unwrap().glyphs;
            let alone = set(letter, 0, 100.0).unwrap().glyphs;
            let (arrow, letter) = (ink(&glyphs[0]), ink(&glyphs[1]));
            assert_eq!(letter, ink(&alone[0]), "the letter is where it is without an arrow");
            let apart = 0.5 * (arrow[0] + arrow[2] - letter[0] - letter[2]);
            assert!(apart.abs() < 20.0, "{apart}: {arrow:?} over {letter:?}");
            let gap = letter[1] - arrow[3];
            assert!(gap > 0.0 && gap < 25.0, "{gap}: {arrow:?} over {letter:?}");
            assert!(arrow[2] - arrow[0] < 60.0, "{arrow:?} is short");
        }
    }

    #[test]
    fn what_stands_around_a_vector_keeps_its_place() {
        let (with, without) = (set(r"a \vec v_A + b", 0, 16.0).unwrap(), set("a v_A + b", 0, 16.0).unwrap());
        assert!((with.width - without.width).abs() < 1.0, "{} and {}", with.width, without.width);
        let x = |f: &crate::typeset::formula::Formula| f.glyphs.last().map(|g| g.x).unwrap();
        assert!((x(&with) - x(&without)).abs() < 1.0);
    }

    #[test]
    fn a_long_arrow_stays_over_the_middle_of_its_letters() {
        let glyphs = set(r"\vec{ABC}", 0, 100.0).unwrap().glyphs;
        let inks: Vec<_> = glyphs.iter().map(ink).collect();
        let (left, right) = (inks[0][0], inks[3][2]);
        let arrow = inks[2];
        assert!((arrow[0] + arrow[2] - left - right).abs() < 20.0, "{inks:?}");
    }
}
