//! Faces as live pages have them: what pictures ask of some glyphs, packed.
//!
//! A font file serves many programs; read as it is, with a reader of all that it may hold, it weighs several
//! times what our pictures need. A packed face is written here and read by the module of live pages
//! (`live/module/ttf-parser`). It consists of pieces: the module has one, a page may bring another.
//!
//! A piece has numbers of seven bits a byte, the lowest first, and `±` is one of either sign: 0, −1, 1, −2 as
//! 0, 1, 2, 3. All of a kind stand after each other, as what is alike packs better:
//!
//! 1. 0 for words, 1 for formulas; how far letters reach up and down, ±; 0, or one more than the height
//!    of x.
//! 2. How many glyphs; the number of each, ± from the one before.
//! 3. For each how many characters it stands for, and those, each ± from the one before in the face.
//! 4. For each its width; for each the pieces of its outline, a byte each, up to a 0: 1 begins a
//!    contour, 2 is a line, 3 one to where the contour began, 4 a quadratic curve, 5 one that ends
//!    halfway to the next control point, 6 one that ends where the contour began, 7 a cubic curve, 8 one
//!    that ends there, 9 ends the contour.
//! 5. For each point that these take its x, ± from the point before in the glyph; then its y.
//! 6. Of words, as the semibold weight has all the same pieces: ± by how much more its widths, x, y are.
//!    In the first piece how many kinds of glyphs there are to the left of a pair and to the right; the
//!    kind of each glyph to the left, and to the right, where 0 has no kerning; ± the kerning of each
//!    kind to the left with each to the right; ± by how much more it is in the semibold weight. In
//!    others how many pairs with a new glyph have any; the place of the left glyph of each among all,
//!    from the one before, that of the right one, and both ±.
//! 7. Of formulas: how many constants, and those, ±; for each glyph ± how far it leans; 0, or one more
//!    than where an accent stands, ±; its form in scripts, and in scripts of scripts, ± from its own
//!    number; how many glyphs grow, and of each its number, its higher and its wider forms as under 2,
//!    the parts of a form of any width so too, and of each part its overlaps at the start and at the
//!    end, its length, and 1 where it repeats.

mod formulas;
mod glyphs;
#[cfg(test)]
mod named;
mod numbers;
mod outline;
#[cfg(test)]
mod tests;
mod words;

pub(super) use formulas::{formulas, grown, script_forms};
#[cfg(test)]
pub(super) use named::named;
pub(super) use words::words;
