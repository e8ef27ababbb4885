//! Words that are found and copied: letters without ink, over the outlines that are seen.
//!
//! A reader marks and copies text by its characters' codes, places and widths, which outlines do not have. So
//! each word and formula is shown once more, by a font whose glyphs draw nothing (Type 3, section 9.6.5) and
//! whose `ToUnicode` table says what each code is (section 9.10.3). A word is stretched to the width that its
//! outlines take, so that what is marked lies over what is seen.

use std::collections::{BTreeMap, BTreeSet};

use flate2::CompressError;
use pdf_writer::types::{SystemInfo, TextRenderingMode, UnicodeCmap};
use pdf_writer::{Content as Operators, Finish, Name, Pdf, Rect, Ref, Str};

use super::super::number::hundredths;
use super::{Packer, SETTINGS};
use crate::drawing::Point;
use crate::typeset::{Run, UNITS_PER_EM, advance_of};

/// Codes of a font: a byte each.
const CODES: usize = 256;

/// Widths of letters are multiples of this, in thousandths of an em. Within a word a mark is then at most a
/// fortieth of an em a letter beside what is seen, and a figure has some 15 widths, each a stream.
const GRAIN: f64 = 50.0;

/// What a mark covers below and above the baseline, in thousandths of an em.
const REACH: [f32; 2] = [-250.0, 800.0];

/// The characters that are shown, in the order of their codes.
#[derive(Default)]
pub(super) struct Letters {
    /// Each character's number.
    numbers: BTreeMap<char, usize>,
    /// The characters by number.
    all: Vec<char>,
}

impl Letters {
    /// Shows a word from its line's place on, in page pixels, y down.
    pub(super) fn show(&mut self, operators: &mut Operators, run: &Run, origin: Point) {
        let natural: f64 = run.text.trim_end().chars().map(width).sum::<f64>() / UNITS_PER_EM * run.size;
        let [from, to] = run.x;
        if natural <= 0.0 || to <= from {
            return;
        }
        operators.begin_text().set_text_rendering_mode(TextRenderingMode::Invisible);
        operators.set_horizontal_scaling(hundredths(100.0 * (to - from) / natural));
        operators.set_text_matrix([1.0, 0.0, 0.0, -1.0, hundredths(origin.x + from), hundredths(origin.y)]);
        let numbers: Vec<usize> = run.text.chars().map(|character| self.number(character)).collect();
        for part in numbers.chunk_by(|a, b| a / CODES == b / CODES) {
            operators.set_font(Name(name(part[0] / CODES).as_bytes()), hundredths(run.size));
            let codes: Vec<u8> = part.iter().filter_map(|number| u8::try_from(number % CODES).ok()).collect();
            operators.show(Str(&codes));
        }
        operators.end_text();
    }

    fn number(&mut self, character: char) -> usize {
        *self.numbers.entry(character).or_insert_with(|| {
            self.all.push(character);
            self.all.len() - 1
        })
    }

    /// Writes the fonts, and gives the name and the object of each.
    pub(super) fn write(
        &self,
        pdf: &mut Pdf,
        free: &mut Ref,
        packer: &mut Packer,
    ) -> Result<Vec<(String, Ref)>, CompressError> {
        let widths: BTreeSet<u32> = self.all.iter().map(|&character| grains(character)).collect();
        let glyphs: BTreeMap<u32, Ref> = widths.into_iter().map(|grains| (grains, free.bump())).collect();
        for (&grains, &object) in &glyphs {
            let mut nothing = Operators::with_settings(SETTINGS);
            let [bottom, top] = REACH;
            let width = thousandths(grains);
            nothing.start_shape_glyph(width, 0.0, bottom, width, top);
            pdf.stream(object, &nothing.finish());
        }
        let mut fonts = Vec::new();
        for (number, characters) in self.all.chunks(CODES).enumerate() {
            let [font, table] = [free.bump(), free.bump()];
            let name = name(number);
            write_font(pdf, font, table, characters, &glyphs);
            let unicode = unicode(&name, characters);
            let (bytes, filter) = packer.pack(&unicode)?;
            pdf.stream(table, &bytes).pairs(filter);
            fonts.push((name, font));
        }
        Ok(fonts)
    }
}

/// Writes a font: which glyph a code has, how wide it is, and the table that says what it means.
fn write_font(pdf: &mut Pdf, font: Ref, table: Ref, characters: &[char], glyphs: &BTreeMap<u32, Ref>) {
    let [bottom, top] = REACH;
    let unit = 1.0 / 1000.0;
    let widths: Vec<u32> = characters.iter().map(|&character| grains(character)).collect();
    let names: Vec<String> = widths.iter().map(|&grains| glyph(grains)).collect();
    let last = u8::try_from(characters.len().saturating_sub(1)).unwrap_or(u8::MAX);
    let mut written = pdf.type3_font(font);
    written.bbox(Rect::new(0.0, bottom, 1000.0, top)).matrix([unit, 0.0, 0.0, unit, 0.0, 0.0]);
    let mut procedures = written.char_procs();
    for (&grains, &object) in glyphs {
        procedures.pair(Name(glyph(grains).as_bytes()), object);
    }
    procedures.finish();
    let mut encoding = written.encoding_custom();
    encoding.differences().consecutive(0, names.iter().map(|name| Name(name.as_bytes())));
    encoding.finish();
    written.first_char(0).last_char(last).widths(widths.iter().map(|&grains| thousandths(grains)));
    written.resources();
    written.to_unicode(table);
}

/// The table of what each code of a font means.
fn unicode(name: &str, characters: &[char]) -> Vec<u8> {
    let system = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"UCS"), supplement: 0 };
    let mut table = UnicodeCmap::<u8>::new(Name(name.as_bytes()), system);
    for (code, &character) in (0..=u8::MAX).zip(characters) {
        table.pair(code, character);
    }
    table.finish().into_vec()
}

/// The name of a font among the page's resources.
fn name(number: usize) -> String {
    format!("T{number}")
}

/// The name of the glyph of a width.
fn glyph(grains: u32) -> String {
    format!("w{grains}")
}

/// Width of a character, in grains.
fn grains(character: char) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some 20 at most")]
    let grains = (advance_of(character) * UNITS_PER_EM / GRAIN).round() as u32;
    grains.max(1)
}

/// A width of so many grains, in thousandths of an em.
fn thousandths(grains: u32) -> f32 {
    hundredths(f64::from(grains) * GRAIN)
}

/// Width of a character, in thousandths of an em.
fn width(character: char) -> f64 {
    f64::from(grains(character)) * GRAIN
}

#[cfg(test)]
mod tests {
    use super::super::content::Content;
    use super::*;
    use crate::output::handout::{Placed, Sheet};
    use crate::output::samples::everything;

    fn run(text: &str, x: [f64; 2]) -> Run {
        Run { text: text.to_owned(), x, size: 10.0 }
    }

    fn shown(letters: &mut Letters, run: &Run) -> String {
        let mut operators = Operators::with_settings(SETTINGS);
        letters.show(&mut operators, run, Point::new(100.0, 50.0));
        String::from_utf8_lossy(&operators.finish()).into_owned()
    }

    #[test]
    fn a_word_is_as_wide_as_its_outlines_and_stands_where_they_do() {
        let natural = "box".chars().map(width).sum::<f64>() / 100.0;
        let operators = shown(&mut Letters::default(), &run("box ", [7.0, 7.0 + 0.8 * natural]));
        assert!(operators.contains("3 Tr") && operators.contains("80 Tz"), "{operators:?}");
        assert!(operators.contains("1 0 0 -1 107 50 Tm"), "{operators:?}");
    }

    #[test]
    fn a_page_shows_the_codes_of_its_words_and_formulas() {
        let drawing = everything();
        let figures = vec![Placed { drawing: &drawing, at: [0.0; 2], scale: 0.5 }];
        let sheet = Sheet { size: [480.0, 270.0], figures, words: Vec::new() };
        let mut content = Content::of(&[sheet]);
        for text in ["distance ", "= ‖D‖ − r = 3/2", "half-extents ", "h_x ", "Жизнь"] {
            let numbers = text.chars().map(|character| content.letters.number(character));
            let codes: Vec<u8> = numbers.map(|number| u8::try_from(number).unwrap()).collect();
            let mut operators = Operators::with_settings(SETTINGS);
            operators.show(Str(&codes));
            let shown = operators.finish().into_vec();
            assert!(content.pages[0].windows(shown.len()).any(|part| part == shown), "{text}");
        }
        let table = String::from_utf8(unicode("T0", &content.letters.all)).unwrap();
        for (code, character) in content.letters.all.iter().enumerate() {
            assert!(table.contains(&format!("<{code:02X}> <{:04X}>", u32::from(*character))), "{character}");
        }
    }

    #[test]
    fn more_characters_than_a_font_has_codes_are_in_another_font() {
        let mut letters = Letters::default();
        let text: String = ('\u{400}'..).take(CODES + 2).collect();
        let operators = shown(&mut letters, &run(&text, [0.0, 900.0]));
        assert!(operators.contains("/T0 10 Tf") && operators.contains("/T1 10 Tf"), "{operators:?}");
        let table = String::from_utf8(unicode("T1", &letters.all[CODES..])).unwrap();
        assert!(table.contains("<00> <0500>") && table.contains("<01> <0501>"), "{table}");
    }
}
