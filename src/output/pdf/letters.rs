//! Words that are found and copied: letters without ink, over the outlines that are seen.
//!
//! A reader marks and copies text by its characters' codes, places and widths, which outlines do not have. So
//! each word and formula is shown once more, by a font of empty glyphs ([`empty_font`](super::empty_font))
//! that the file carries, as journals want it, and whose `ToUnicode` table says what each code is (sections
//! 9.7 and 9.10.3). A word is stretched to the width that its outlines take, so that what is marked lies over
//! what is seen.

use std::collections::BTreeMap;

use flate2::CompressError;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, TextRenderingMode, UnicodeCmap};
use pdf_writer::{Content as Operators, Finish, Name, Pdf, Rect, Ref, Str};

use super::super::number::hundredths;
use super::Packer;
use super::empty_font::{self, REACH};
use crate::drawing::Point;
use crate::typeset::{Run, UNITS_PER_EM, advance_of};

/// The name of the font among the page's resources.
const NAME: &str = "T";

/// The name of the font. What stands before the plus says that it is a part of one.
const FONT: Name = Name(b"LETTER+TracefigLetters");

/// The characters that are shown, in the order of their codes, which count from 1.
#[derive(Default)]
pub(super) struct Letters {
    /// Each character's code.
    codes: BTreeMap<char, u16>,
    /// The characters by code.
    all: Vec<char>,
}

impl Letters {
    /// Shows a word from its line's place on, in page pixels, y down.
    pub(super) fn show(&mut self, operators: &mut Operators, run: &Run, origin: Point) {
        let thousandths: u32 = run.text.trim_end().chars().map(|c| u32::from(width(c))).sum();
        let natural = f64::from(thousandths) / 1000.0 * run.size;
        let [from, to] = run.x;
        if natural <= 0.0 || to <= from {
            return;
        }
        operators.begin_text().set_text_rendering_mode(TextRenderingMode::Invisible);
        operators.set_horizontal_scaling(hundredths(100.0 * (to - from) / natural));
        operators.set_text_matrix([1.0, 0.0, 0.0, -1.0, hundredths(origin.x + from), hundredths(origin.y)]);
        operators.set_font(Name(NAME.as_bytes()), hundredths(run.size));
        let codes: Vec<u8> =
            run.text.chars().flat_map(|character| self.code(character).to_be_bytes()).collect();
        operators.show(Str(&codes));
        operators.end_text();
    }

    /// The code of a character; that of no character where there are more than codes.
    fn code(&mut self, character: char) -> u16 {
        if let Some(&code) = self.codes.get(&character) {
            return code;
        }
        let next = u16::try_from(self.all.len() + 1).ok().filter(|&code| code < u16::MAX);
        let Some(code) = next else { return 0 };
        self.all.push(character);
        self.codes.insert(character, code);
        code
    }

    /// Writes the font, and gives its name and its object; nothing where nothing is shown.
    pub(super) fn write(
        &self,
        pdf: &mut Pdf,
        free: &mut Ref,
        packer: &mut Packer,
    ) -> Result<Option<(&'static str, Ref)>, CompressError> {
        if self.all.is_empty() {
            return Ok(None);
        }
        let [font, table, glyphs, descriptor, file] = std::array::from_fn(|_| free.bump());
        let mut written = pdf.type0_font(font);
        written.base_font(FONT).encoding_predefined(Name(b"Identity-H"));
        written.descendant_font(glyphs).to_unicode(table);
        written.finish();
        let widths: Vec<u16> = self.all.iter().copied().map(width).collect();
        let mut written = pdf.cid_font(glyphs);
        written.subtype(CidFontType::Type2).base_font(FONT).font_descriptor(descriptor);
        written.system_info(SystemInfo {
            registry: Str(b"Adobe"),
            ordering: Str(b"Identity"),
            supplement: 0,
        });
        written.cid_to_gid_map_predefined(Name(b"Identity"));
        written.widths().consecutive(1, widths.iter().map(|&width| f32::from(width)));
        written.finish();
        write_descriptor(pdf, descriptor, file);
        let meanings = unicode(&self.all);
        let (bytes, filter) = packer.pack(&meanings)?;
        pdf.stream(table, &bytes).pairs(filter);
        let empty = empty_font::of(&widths);
        let length = i32::try_from(empty.len()).unwrap_or(i32::MAX);
        let (bytes, filter) = packer.pack(&empty)?;
        let mut stream = pdf.stream(file, &bytes);
        stream.pairs(filter);
        stream.pair(Name(b"Length1"), length);
        stream.finish();
        Ok(Some((NAME, font)))
    }
}

/// Writes what a reader asks of a font that it would replace by another.
fn write_descriptor(pdf: &mut Pdf, descriptor: Ref, file: Ref) {
    let [bottom, top] = REACH.map(f32::from);
    let mut written = pdf.font_descriptor(descriptor);
    written.name(FONT).flags(FontFlags::SYMBOLIC).bbox(Rect::new(0.0, bottom, 1000.0, top));
    written.italic_angle(0.0).ascent(top).descent(bottom).cap_height(top).stem_v(0.0).font_file2(file);
}

/// The table of what each code means.
fn unicode(characters: &[char]) -> Vec<u8> {
    let system = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"UCS"), supplement: 0 };
    let mut table = UnicodeCmap::<u16>::new(Name(b"Letters"), system);
    for (code, &character) in (1..=u16::MAX).zip(characters) {
        table.pair(code, character);
    }
    table.finish().into_vec()
}

/// Width of a character, in thousandths of an em, at least 1.
fn width(character: char) -> u16 {
    let thousandths = (advance_of(character) * UNITS_PER_EM).round().clamp(1.0, f64::from(u16::MAX));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within its range")]
    let width = thousandths as u16;
    width
}

#[cfg(test)]
mod tests {
    use super::super::SETTINGS;
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
        let natural = "box".chars().map(|c| f64::from(width(c))).sum::<f64>() / 100.0;
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
            let codes: Vec<u8> = text.chars().flat_map(|c| content.letters.code(c).to_be_bytes()).collect();
            let mut operators = Operators::with_settings(SETTINGS);
            operators.show(Str(&codes));
            let shown = operators.finish().into_vec();
            assert!(content.pages[0].windows(shown.len()).any(|part| part == shown), "{text}");
        }
        let table = String::from_utf8(unicode(&content.letters.all)).unwrap();
        for (code, character) in (1..).zip(&content.letters.all) {
            assert!(table.contains(&format!("<{code:04X}> <{:04X}>", u32::from(*character))), "{character}");
        }
    }

    #[test]
    fn no_letters_are_no_font() {
        let (mut pdf, mut free) = (Pdf::new(), Ref::new(1));
        assert_eq!(Letters::default().write(&mut pdf, &mut free, &mut Packer::new()).unwrap(), None);
    }

    #[test]
    fn more_characters_than_codes_mean_nothing() {
        let mut letters = Letters::default();
        let last = ('\0'..).take(usize::from(u16::MAX)).map(|c| letters.code(c)).last();
        assert_eq!((letters.code('\0'), last), (1, Some(0)));
    }
}
