//! How large a scene's own text for a label is set: words as other words are, whatever they stand for.
//!
//! Symbols are set larger than words, for their indices and since they are read one by one. A scene that says
//! `shortest push` in place of `d`, or `$A$ at $t_1$` in place of `A`, has words
//! there; a name and a length stay what they are.

use crate::figure::sketch::Size;
use crate::typeset::{Piece, pieces};

/// Letters of a word: two may be a symbol that was written without dollar signs.
const WORD: usize = 3;

/// The size of a label with lines of the scene's, where the layer's own has `size`.
pub(super) fn letters(size: Size, lines: &[String]) -> Size {
    let [markup] = lines else { return size };
    let Ok(pieces) = pieces(markup) else { return size };
    let has_formula = pieces.iter().any(|piece| matches!(piece, Piece::Formula(..)));
    match size {
        // A length with its word before it stays as large as other lengths.
        Size::Point if !has_formula && !has_number(markup) && has_words(&pieces, WORD) => Size::Note,
        // A body's name may be words: beside a symbol they say something of it.
        Size::Name if has_formula && has_words(&pieces, 1) => Size::Note,
        _ => size,
    }
}

/// Whether a number stands in a text, or a value that will be one.
fn has_number(markup: &str) -> bool {
    markup.contains("{=") || markup.contains(|c: char| c.is_ascii_digit())
}

/// Whether a word of so many letters stands outside formulas.
fn has_words(pieces: &[Piece], letters: usize) -> bool {
    let is_word = |word: &str| word.chars().count() >= letters;
    pieces.iter().any(|piece| match piece {
        Piece::Words(_, words) => words.split(|c: char| !c.is_alphabetic()).any(is_word),
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_set_as_words_and_symbols_names_and_units_stay() {
        let of = |size| move |markup: &str| letters(size, &[markup.to_owned()]);
        let small = [Size::Note; 3];
        assert_eq!(["shortest push", "pivot", "aller trop loin"].map(of(Size::Point)), small);
        assert_eq!(
            ["radius $r$", "distance = {=separation}", "2.5 px"].map(of(Size::Point)),
            [Size::Point; 3]
        );
        assert_eq!(["$A$ at $t_1$", "$A$ turned", "turned {a|$A$}"].map(of(Size::Name)), small);
        assert_eq!(["$A$", "the wall", "{a|$A$}"].map(of(Size::Name)), [Size::Name; 3]);
        assert_eq!(of(Size::Small)("farther out"), Size::Small);
    }
}
