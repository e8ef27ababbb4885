//! The first line in which two texts differ.

use std::fmt;

/// The first difference of two texts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineDrift {
    /// Number of the line, from 1.
    pub line: usize,
    /// Column of the first character that differs, from 1.
    pub column: usize,
    /// The old text from there, cut short; empty where the old text ends.
    pub expected: String,
    /// The new text from there, cut short; empty where the new text ends.
    pub actual: String,
}

/// Characters that are shown of each line: two quotes of this length fit a terminal's line or two.
const SHOWN: usize = 60;

/// Characters before the difference that are shown with it, enough for the name of an attribute.
const BEFORE: usize = 12;

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
            let cut = |text: &str| {
                text.chars()
                    .skip(same.saturating_sub(BEFORE))
                    .take(SHOWN)
                    .collect::<String>()
                    .trim_end()
                    .to_owned()
            };
            return Some(LineDrift { line, column: same + 1, expected: cut(a), actual: cut(b) });
        }
    }
    None
}

impl fmt::Display for LineDrift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, column, expected, actual } = self;
        write!(f, "line {line}, column {column}: expected `{expected}`, got `{actual}`")
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
    }
}
