//! The first line in which two texts differ.

use std::fmt;

/// The first difference of two texts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineDrift {
    /// Number of the line, from 1.
    pub line: usize,
    /// Column of the first character that differs, from 1.
    pub column: usize,
    /// The old text there, from the beginning of a word, with "…" where it is cut; empty where the old text
    /// ends.
    pub expected: String,
    /// The new text there, alike.
    pub actual: String,
}

/// Characters that are shown of each line: two quotes of this length fit a terminal's line or two.
const SHOWN: usize = 60;

/// Characters before the difference that are shown with it, enough for the name of an attribute.
const BEFORE: usize = 12;

/// Characters before those among which a quote looks for the beginning of a word: longer than most words.
const WORD: usize = 16;

/// Whether two texts are the same but for the ends of their lines, of which the old ones have a CR more.
pub(super) fn are_other_ends(old: &[u8], new: &[u8]) -> bool {
    let has_returned = |(i, byte): &(usize, &u8)| **byte == b'\r' && old.get(i + 1) == Some(&b'\n');
    let kept = old.iter().enumerate().filter(|at| !has_returned(at)).map(|(_, byte)| byte);
    old.len() > new.len() && kept.eq(new)
}

/// The first difference of two texts; `None` where they are the same.
pub(super) fn drift(old: &str, new: &str) -> Option<LineDrift> {
    let (mut old_lines, mut new_lines) = (old.split_inclusive('\n'), new.split_inclusive('\n'));
    for line in 1.. {
        let (a, b) = (old_lines.next(), new_lines.next());
        if a.is_none() && b.is_none() {
            return None;
        }
        let (a, b) = (a.unwrap_or_default(), b.unwrap_or_default());
        if a != b {
            let same = a.chars().zip(b.chars()).take_while(|(x, y)| x == y).count();
            let from = quoted_from(a, same);
            let (expected, actual) = (quote(a, from), quote(b, from));
            return Some(LineDrift { line, column: same + 1, expected, actual });
        }
    }
    None
}

/// Where a quote begins that shows what follows `same` characters of a line: some way before, with a word.
fn quoted_from(line: &str, same: usize) -> usize {
    let latest = same.saturating_sub(BEFORE);
    let before: Vec<char> = line.chars().take(latest).collect();
    let word = before.iter().rev().take(WORD).take_while(|c| !c.is_whitespace()).count();
    // A text without blanks, as the data of a path, is cut anywhere.
    if word < WORD { latest - word } else { latest }
}

/// A quote of a line from a character on, with "…" where something is left out; it ends with a word where one
/// ends late enough.
fn quote(line: &str, from: usize) -> String {
    let line: Vec<char> = line.trim_end().chars().collect();
    let Some(rest) = line.get(from..).filter(|rest| !rest.is_empty()) else { return String::new() };
    let before = if from > 0 { "…" } else { "" };
    if rest.len() <= SHOWN {
        return before.chars().chain(rest.iter().copied()).collect();
    }
    let is_within = rest.get(SHOWN).is_some_and(|c| !c.is_whitespace());
    let word = rest.iter().take(SHOWN).rev().take(WORD).take_while(|c| !c.is_whitespace()).count();
    let shown = if is_within && word < WORD { SHOWN - word } else { SHOWN };
    let shown = rest.iter().take(shown).collect::<String>();
    format!("{before}{}…", shown.trim_end())
}

impl fmt::Display for LineDrift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, column, expected, actual } = self;
        let said = |text: &str| if text.is_empty() { "nothing".to_owned() } else { format!("`{text}`") };
        write!(f, "line {line}, column {column}: on disk {}, now {}", said(expected), said(actual))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_difference_is_found() {
        let got = drift("a\nbcd\ne\n", "a\nbxd\nf\n").unwrap();
        assert_eq!((got.line, got.column), (2, 2));
        assert_eq!((got.expected.as_str(), got.actual.as_str()), ("bcd", "bxd"));
    }

    #[test]
    fn a_text_that_ends_early_differs_there() {
        let got = drift("a\n", "a\nb\n").unwrap();
        assert_eq!((got.line, got.column, got.expected.as_str()), (2, 1, ""));
        assert_eq!(drift("a\n", "a\n"), None);
        assert_eq!(drift("a\n", "a").unwrap().column, 2);
        assert_eq!(got.to_string(), "line 2, column 1: on disk nothing, now `b`");
    }

    #[test]
    fn a_quote_begins_with_a_word_and_says_where_it_is_cut() {
        let old = "Two circles, the Crate and the Barrel, apart by 0.226 along (0.94, 0.342), as the law of \
                   cosines says of them";
        let got = drift(old, &old.replace("0.226", "0.273")).unwrap();
        assert_eq!(got.expected, "…apart by 0.226 along (0.94, 0.342), as the law of cosines…");
        assert_eq!(got.actual, got.expected.replace("0.226", "0.273"));
        let path = "M1.5,2.5L3.5,4.5".repeat(9);
        let got = drift(&path, &(path.clone() + "Z")).unwrap();
        assert_eq!((got.expected.as_str(), got.actual.as_str()), ("…,2.5L3.5,4.5", "…,2.5L3.5,4.5Z"));
    }

    #[test]
    fn other_ends_of_lines_are_told_from_other_texts() {
        assert!(are_other_ends(b"a\r\nb\r\n", b"a\nb\n") && are_other_ends(b"a\r\nb\n", b"a\nb\n"));
        for old in [&b"a\nb\n"[..], b"a\r\nc\r\n", b"a\rb\n", b"a\nb\n\r"] {
            assert!(!are_other_ends(old, b"a\nb\n"), "{old:?}");
        }
    }
}
