//! Text of others in a line of ours: nothing in it steers a terminal, ends the line or fills the screen.

use std::borrow::Cow;

/// Characters of a message that are shown: some twenty lines of a terminal. What is longer is a key or a name
/// that nobody reads to its end.
const SHOWN: usize = 1_500;

/// The text with a sign for each character that has none or acts: control characters, line breaks, marks that
/// turn the direction of what follows.
///
/// ```
/// use tracefig::scene::visible;
/// assert_eq!(visible("a\n\u{1b}[31mb"), "a␊␛[31mb");
/// assert_eq!(visible("\u{85}\u{202e}gnp.x"), "��gnp.x");
/// assert_eq!(visible("δ = 1"), "δ = 1");
/// ```
#[must_use]
pub fn visible(text: &str) -> Cow<'_, str> {
    if text.chars().all(|c| sign(c) == c) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.chars().map(sign).collect())
}

/// What stands for a character.
fn sign(c: char) -> char {
    match c {
        '\0'..='\u{1f}' => char::from_u32(0x2400 + u32::from(c)).unwrap_or(char::REPLACEMENT_CHARACTER),
        '\u{7f}' => '␡',
        '\u{80}'..='\u{9f}'
        | '\u{200e}'
        | '\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2066}'..='\u{2069}'
        | '\u{fffe}'
        | '\u{ffff}' => char::REPLACEMENT_CHARACTER,
        other => other,
    }
}

/// The text as [`visible`] shows it, its middle left out where it is longer than a screen.
pub(crate) fn brief(text: &str) -> String {
    let count = text.chars().count();
    if count <= SHOWN {
        return visible(text).into_owned();
    }
    let (head, tail) = (SHOWN * 2 / 3, SHOWN / 3);
    let head: String = text.chars().take(head).map(sign).collect();
    let tail: String = text.chars().skip(count - tail).map(sign).collect();
    format!("{head} … {tail}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_is_cut_in_its_middle_and_a_short_one_is_whole() {
        let short = "δ".repeat(SHOWN);
        assert_eq!(brief(&short), short);
        let long = brief(&format!("begin{}end", "\u{1b}".repeat(900_000)));
        assert!(long.starts_with("begin␛") && long.ends_with("␛end"), "{long}");
        assert_eq!(long.chars().count(), SHOWN + 3);
    }
}
