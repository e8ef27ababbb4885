//! Capital and small letters of the alphabets that names and sentences of figures are written in, by rule.
//!
//! The standard library knows all of Unicode, by tables of 24 kB, which every live page would load for the
//! first letter of a sentence. In the alphabets themselves small letters stand a fixed way behind their
//! capitals.

/// Capitals with their small letters: the first and the last of a row, how far each is from the one before,
/// and how far its small letter is from it.
const ROWS: [(char, char, u32, i32); 23] = [
    ('A', 'Z', 1, 32),
    ('À', 'Ö', 1, 32),
    ('Ø', 'Þ', 1, 32),
    ('Ā', 'Į', 2, 1),
    ('Ĳ', 'Ķ', 2, 1),
    ('Ĺ', 'Ň', 2, 1),
    ('Ŋ', 'Ŷ', 2, 1),
    ('Ÿ', 'Ÿ', 1, -121),
    ('Ź', 'Ž', 2, 1),
    ('Ά', 'Ά', 1, 38),
    ('Έ', 'Ί', 1, 37),
    ('Ό', 'Ό', 1, 64),
    ('Ύ', 'Ώ', 1, 63),
    ('Α', 'Ρ', 1, 32),
    ('Σ', 'Ϋ', 1, 32),
    ('Ѐ', 'Џ', 1, 80),
    ('А', 'Я', 1, 32),
    ('Ѡ', 'Ҁ', 2, 1),
    ('Ҋ', 'Ҿ', 2, 1),
    ('Ӂ', 'Ӎ', 2, 1),
    ('Ӑ', 'Ԯ', 2, 1),
    ('Ա', 'Ֆ', 1, 48),
    ('Ạ', 'Ỿ', 2, 1),
];

/// The capital of a small letter; any other letter as it is.
fn capital(letter: char) -> char {
    let in_row = |&(first, last, step, off): &(char, char, u32, i32)| {
        let capital = char::from_u32(u32::from(letter).checked_add_signed(-off)?)?;
        is_in((first, last, step), capital).then_some(capital)
    };
    ROWS.iter().find_map(in_row).unwrap_or(letter)
}

/// The small letter of a capital; any other letter as it is.
pub(crate) fn small(letter: char) -> char {
    let row = ROWS.iter().find(|&&(first, last, step, _)| is_in((first, last, step), letter));
    let small = row.and_then(|&(.., off)| char::from_u32(u32::from(letter).checked_add_signed(off)?));
    small.unwrap_or(letter)
}

/// A text that begins with a capital.
pub(crate) fn begun(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(capital).into_iter().chain(letters).collect()
}

/// Whether a capital is of a row.
fn is_in((first, last, step): (char, char, u32), capital: char) -> bool {
    (first..=last).contains(&capital) && (u32::from(capital) - u32::from(first)).is_multiple_of(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The letters of these alphabets that are no pair of one capital and one small letter.
    const ALONE: &str = "ßŉıſİςϐϑϕϖϰϱϵͅͰͱͲͳͶͷͻͼͽͿϏϗϘϙϚϛϜϝϞϟϠϡϢϣϤϥϦϧϨϩϪϫϬϭϮϯϲϳϴϷϸϹϺϻϽϾϿΐΰӀӏևµ";

    #[test]
    fn the_alphabets_are_those_of_unicode() {
        for block in ['\0'..='ſ', 'Ͱ'..='ԯ', 'Ա'..='և', 'Ạ'..='ỿ'] {
            for letter in block.filter(|&letter| !ALONE.contains(letter)) {
                assert_eq!(capital(letter).to_string(), letter.to_uppercase().to_string(), "{letter}");
                assert_eq!(small(letter).to_string(), letter.to_lowercase().to_string(), "{letter}");
            }
        }
    }

    #[test]
    fn sentences_begin_with_a_capital_and_other_letters_stay() {
        assert_eq!(
            ["über", "étape", "ωμέγα", "3 m", "ß", ""].map(begun),
            ["Über", "Étape", "Ωμέγα", "3 m", "ß", ""]
        );
        assert_eq!(['Ж', 'ა', '-'].map(small), ['ж', 'ა', '-']);
    }
}
