//! Which glyphs texts need: those that are seen, and those that are measured before another is seen.

use std::collections::BTreeSet;

use latex_rust::{BoxContent, MathBox};
use ttf_parser::GlyphId;

use super::face::Loaded;
use super::line::{Face, Glyph, Line, Style};
use super::markup::{Piece, pieces};
use super::{formula, packed};

/// Page pixels of an em; the glyphs of a text are the same at any.
const SIZE: f64 = 16.0;

/// Bytes of a formula that may be a name.
const LONGEST_NAME: usize = 24;

/// Glyphs by the packed face that has them; a glyph of words has one number in both weights.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Glyphs {
    /// Glyphs of words.
    pub(crate) words: BTreeSet<u16>,
    /// Glyphs of formulas.
    pub(crate) formulas: BTreeSet<u16>,
}

impl Glyphs {
    /// What these texts need, markup and parts of it, these that are `set` as they are, and these characters
    /// among words. A text that is no markup may be a part of one, so that each of its characters counts.
    pub(crate) fn of<'t>(
        texts: impl Iterator<Item = &'t str>,
        set: impl Iterator<Item = &'t str>,
        characters: &str,
    ) -> Self {
        let mut needed = Self::default();
        texts.for_each(|text| needed.take_somehow(text));
        set.for_each(|text| needed.take(text));
        characters.chars().for_each(|character| needed.take_character(character));
        needed.grow();
        needed
    }

    /// Takes the glyphs of a text; of a single letter, as may be a name, also in a formula and as its script.
    fn take_somehow(&mut self, text: &str) {
        if super::typeset(text, Style::regular(SIZE)).is_ok() {
            self.take(text);
        } else {
            text.chars().for_each(|character| self.take_character(character));
        }
        self.take_name(text);
    }

    /// Takes what formulas make of a name that is a letter, as A′, or a formula: in scripts, primed, small.
    fn take_name(&mut self, name: &str) {
        let letter = name.trim_end_matches(['\'', '′']);
        if letter.chars().count() == 1 {
            for letter in [letter.to_owned(), letter.to_lowercase()] {
                self.take(&format!("${letter}_{{{letter}''}}''$"));
            }
        }
        let formula = name.strip_prefix('$').and_then(|rest| rest.strip_suffix('$'));
        if let Some(latex) = formula.filter(|latex| latex.len() <= LONGEST_NAME && !latex.contains('$')) {
            self.take(&format!("$x_{{{latex}''}}'$"));
        }
    }

    /// Takes the glyph of a character among words.
    pub(super) fn take_character(&mut self, character: char) {
        self.take(&character.to_string());
    }

    /// Takes the glyphs of a markup, and those of its formulas that are measured and not seen.
    pub(super) fn take(&mut self, markup: &str) {
        for style in [Style::regular(SIZE), Style::semibold(SIZE)] {
            let line = super::typeset(markup, style);
            line.iter().flat_map(|line: &Line| &line.glyphs).for_each(|placed| self.insert(placed.glyph));
        }
        for piece in pieces(markup).unwrap_or_default() {
            if let Piece::Formula(_, latex) = piece
                && let Some(tree) = formula::layout(latex)
            {
                self.take_boxes(&tree);
            }
        }
    }

    /// Takes a glyph that is seen.
    fn insert(&mut self, glyph: Glyph) {
        match glyph.face {
            Face::Regular | Face::Semibold => self.words.insert(glyph.id),
            Face::Math => self.formulas.insert(glyph.id),
        };
    }

    /// Takes the glyphs of a layout, and those of their characters, which forms of them are found by.
    fn take_boxes(&mut self, piece: &MathBox) {
        match &piece.content {
            BoxContent::Glyph { ch, glyph_id, .. } => {
                let face = Loaded::of(Face::Math).map(Loaded::face);
                let base = face.and_then(|face| face.glyph_index(*ch));
                self.formulas.extend(base.into_iter().chain([GlyphId(*glyph_id)]).map(|id| id.0));
            }
            BoxContent::HList(all) | BoxContent::VList(all) | BoxContent::Overlap(all) => {
                for piece in all {
                    self.take_boxes(piece);
                }
            }
            _ => {}
        }
    }

    /// Takes all forms of what has grown, as they are tried one after the other.
    pub(super) fn grow(&mut self) {
        let Some(font) = Loaded::of(Face::Math).and_then(Loaded::math) else { return };
        for (id, forms) in packed::grown(font) {
            let scripts = |form: &u16| packed::script_forms(font.face(), *form);
            let has_script = forms.iter().flat_map(scripts).any(|script| self.formulas.contains(&script));
            if forms.iter().any(|form| *form != id && self.formulas.contains(form)) {
                self.formulas.insert(id);
                self.formulas.extend(&forms);
                if has_script {
                    self.formulas.extend(forms.iter().flat_map(scripts));
                }
            }
        }
    }
}
