//! Which glyphs a live page must bring along, as its module has those that our own words and layers say.
//!
//! It is known before the page is opened: a reader changes numbers and no words.

use super::needed::Glyphs;
use super::own::own;
use super::{PACKED, packed};

/// The pieces of packed faces, each with its name, that a page must bring along for these glyphs.
pub(crate) fn beyond(needed: &Glyphs) -> Vec<(&'static str, Vec<u8>)> {
    let own = own();
    let mut brought = Vec::new();
    if !needed.words.is_subset(&own.words) {
        brought.push((PACKED[0], packed::words(&own.words, &needed.words)));
    }
    if !needed.formulas.is_subset(&own.formulas) {
        brought.push((PACKED[1], packed::formulas(&own.formulas, &needed.formulas)));
    }
    brought
}

/// A glyph that a page which brings some lacks to set a markup.
#[cfg(test)]
pub(crate) fn lacking(brought: &Glyphs, markup: &str) -> Option<String> {
    use super::line::Face;
    let mut asked = Glyphs::default();
    asked.take(markup);
    asked.grow();
    let own = own();
    let mut of_words = asked.words.iter().filter(|id| !brought.words.contains(id) && !own.words.contains(id));
    let mut of_formulas =
        asked.formulas.iter().filter(|id| !brought.formulas.contains(id) && !own.formulas.contains(id));
    let word = of_words.next().map(|&id| packed::named(Face::Regular, id));
    word.or_else(|| of_formulas.next().map(|&id| packed::named(Face::Math, id)))
}
