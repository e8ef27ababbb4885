//! Letters that are written as a letter and an accent after it, as some systems write the names of files.
//!
//! The faces have no table that places marks over letters. They have the common letters of Latin, Greek and
//! Cyrillic with their accents on, so a letter and a mark that make one of those become it. Source: the
//! Unicode Standard, canonical decompositions (`UnicodeData.txt`), of U+00C0 to U+017F, U+0390 to U+03CF,
//! U+0400 to U+045F and U+1EA0 to U+1EF9.

/// A mark, the letters that it can stand on, and in the same order the letters with it.
const MARKS: [(char, &str, &str); 15] = [
    ('\u{300}', "AEIOUaeiouЕИеиÂâĂăÊêÔôƠơƯưYy", "ÀÈÌÒÙàèìòùЀЍѐѝẦầẰằỀềỒồỜờỪừỲỳ"),
    (
        '\u{301}',
        "AEIOUYaeiouyCcLlNnRrSsZzϊαεηιϋουωГКгкÂâĂăÊêÔôƠơƯư",
        "ÁÉÍÓÚÝáéíóúýĆćĹĺŃńŔŕŚśŹźΐάέήίΰόύώЃЌѓќẤấẮắẾếỐốỚớỨứ",
    ),
    ('\u{302}', "AEIOUaeiouCcGgHhJjSsWwYyẠạẸẹỌọ", "ÂÊÎÔÛâêîôûĈĉĜĝĤĥĴĵŜŝŴŵŶŷẬậỆệỘộ"),
    ('\u{303}', "ANOanoIiUuÂâĂăEeÊêÔôƠơƯưYy", "ÃÑÕãñõĨĩŨũẪẫẴẵẼẽỄễỖỗỠỡỮữỸỹ"),
    ('\u{304}', "AaEeIiOoUu", "ĀāĒēĪīŌōŪū"),
    ('\u{306}', "AaEeGgIiOoUuУИиуẠạ", "ĂăĔĕĞğĬĭŎŏŬŭЎЙйўẶặ"),
    ('\u{307}', "CcEeGgIZz", "ĊċĖėĠġİŻż"),
    ('\u{308}', "AEIOUaeiouyYΙΥιυЕІеі", "ÄËÏÖÜäëïöüÿŸΪΫϊϋЁЇёї"),
    ('\u{309}', "AaÂâĂăEeÊêIiOoÔôƠơUuƯưYy", "ẢảẨẩẲẳẺẻỂểỈỉỎỏỔổỞởỦủỬửỶỷ"),
    ('\u{30a}', "AaUu", "ÅåŮů"),
    ('\u{30b}', "OoUu", "ŐőŰű"),
    ('\u{30c}', "CcDdEeLlNnRrSsTtZz", "ČčĎďĚěĽľŇňŘřŠšŤťŽž"),
    ('\u{323}', "AaEeIiOoƠơUuƯưYy", "ẠạẸẹỊịỌọỢợỤụỰựỴỵ"),
    ('\u{327}', "CcGgKkLlNnRrSsTt", "ÇçĢģĶķĻļŅņŖŗŞşŢţ"),
    ('\u{328}', "AaEeIiUu", "ĄąĘęĮįŲų"),
];

/// Characters with their places, each letter and the marks on it as one where there is such a letter.
pub(super) fn composed(
    characters: impl Iterator<Item = (usize, char)>,
) -> impl Iterator<Item = (usize, char)> {
    let mut rest = characters.peekable();
    std::iter::from_fn(move || {
        let (at, mut letter) = rest.next()?;
        while let Some(whole) = rest.peek().and_then(|&(_, mark)| with(letter, mark)) {
            letter = whole;
            rest.next();
        }
        Some((at, letter))
    })
}

/// A letter with a mark on it; `None` where there is no such letter.
fn with(letter: char, mark: char) -> Option<char> {
    let (_, bases, whole) = MARKS.iter().find(|(known, ..)| *known == mark)?;
    bases.chars().zip(whole.chars()).find(|&(base, _)| base == letter).map(|(_, whole)| whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_and_its_marks_become_the_letter_with_them() {
        let read = |text: &str| composed(text.char_indices()).collect::<Vec<_>>();
        assert_eq!(read("e\u{301}a"), [(0, 'é'), (3, 'a')]);
        assert_eq!(read("o\u{302}\u{301}"), [(0, 'ố')]);
        assert_eq!(read("a\u{323}\u{302}"), [(0, 'ậ')]);
        assert_eq!(read("и\u{306}"), [(0, 'й')]);
        assert_eq!(read("x\u{301}"), [(0, 'x'), (1, '\u{301}')]);
    }

    #[test]
    fn every_mark_has_as_many_letters_with_it_as_without() {
        for (mark, bases, whole) in MARKS {
            assert_eq!(bases.chars().count(), whole.chars().count(), "{mark:?}");
        }
    }
}
