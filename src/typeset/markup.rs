//! Markup: plain text with `$…$` for LaTeX maths; `\$` is a dollar sign.
//!
//! `{a|the red box}` are words that wear a role, here that of the word `a`: who draws them gives them its
//! colour. A role is a word of small letters; braces without one are signs like any other, and `\{a|` is the
//! sign with no meaning.

use super::line::TypesetError;

/// A piece of markup with its first byte's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Piece<'m> {
    /// Characters as they are, `\$` still written so.
    Words(usize, &'m str),
    /// LaTeX between two dollar signs.
    Formula(usize, &'m str),
    /// The word of a role, which all pieces wear up to the next [`Piece::Plain`]; the place is where what
    /// wears it begins.
    Role(usize, &'m str),
    /// The end of what wears a role.
    Plain,
}

/// What begins in a markup and does not end there, with the place of its first byte.
enum Unclosed {
    /// A formula.
    Formula(usize),
    /// Words that wear a role.
    Role(usize),
}

/// Cuts markup into words and formulas, with or without a role.
pub(crate) fn pieces(markup: &str) -> Result<Vec<Piece<'_>>, TypesetError> {
    cut(markup).map_err(|unclosed| match unclosed {
        Unclosed::Formula(offset) => {
            let message = "a formula begins here that no `$` ends; write `\\$` for a dollar sign".to_owned();
            TypesetError { offset, message }
        }
        Unclosed::Role(offset) => {
            let message = "words in a role begin here that no `}` ends; write `\\{` for a brace".to_owned();
            TypesetError { offset, message }
        }
    })
}

/// Whether the end of a text stands within a formula that is not closed yet.
#[must_use]
pub(crate) fn ends_in_formula(markup: &str) -> bool {
    matches!(cut(markup), Err(Unclosed::Formula(_)))
}

fn cut(markup: &str) -> Result<Vec<Piece<'_>>, Unclosed> {
    let mut pieces = Vec::new();
    // Where the role that is worn was begun.
    let mut worn = None;
    let mut at = 0;
    while at < markup.len() {
        let open = opening(markup, at, worn.is_some()).unwrap_or(markup.len());
        if open > at {
            pieces.push(Piece::Words(at, &markup[at..open]));
        }
        at = open + 1;
        match markup.as_bytes().get(open) {
            Some(b'$') => {
                let close = closing(markup, at).ok_or(Unclosed::Formula(open))?;
                pieces.push(Piece::Formula(at, &markup[at..close]));
                at = close + 1;
            }
            Some(b'}') => {
                pieces.push(Piece::Plain);
                worn = None;
            }
            Some(_) => {
                let role = role_at(&markup[open..]).unwrap_or("");
                // The brace before the role's word, and the bar after it.
                at += role.len() + 1;
                pieces.push(Piece::Role(at, role));
                worn = Some(open);
            }
            None => {}
        }
    }
    worn.map_or(Ok(pieces), |open| Err(Unclosed::Role(open)))
}

/// Where something opens or ends among words: the next dollar sign that no backslash precedes, the next
/// brace with a role that none precedes, or, where a role is worn, the brace that ends it.
fn opening(markup: &str, from: usize, is_worn: bool) -> Option<usize> {
    let bytes = markup.as_bytes();
    (from..bytes.len()).find(|&at| {
        let is_free = at == from || bytes[at - 1] != b'\\';
        match bytes[at] {
            b'$' => is_free,
            b'}' => is_worn,
            b'{' => is_free && !is_worn && role_at(&markup[at..]).is_some(),
            _ => false,
        }
    })
}

/// The word of the role that a text begins with, as `a` of `{a|`.
fn role_at(text: &str) -> Option<&str> {
    let (word, _) = text.strip_prefix('{')?.split_once('|')?;
    let is_word = word.starts_with(|c: char| c.is_ascii_lowercase())
        && word.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
    is_word.then_some(word)
}

/// Plain text as markup: a dollar sign is written `\$`, and the brace of what would be a role `\{`.
#[must_use]
pub(crate) fn as_markup(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        if c == '$' || c == '{' && role_at(&text[at..]).is_some() {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

/// Where a formula closes: the next dollar sign that is not the sign after a backslash.
fn closing(markup: &str, from: usize) -> Option<usize> {
    let bytes = markup.as_bytes();
    let mut at = from;
    while at < bytes.len() {
        match bytes[at] {
            b'\\' => at += 2,
            b'$' => return Some(at),
            _ => at += 1,
        }
    }
    None
}

/// Characters of words with their places, `\$` as one dollar sign and `\{` before a role as one brace.
pub(crate) fn characters(offset: usize, words: &str) -> impl Iterator<Item = (usize, char)> + '_ {
    let mut next = 0;
    std::iter::from_fn(move || {
        let at = next;
        let character = words[at..].chars().next()?;
        next += character.len_utf8();
        let rest = &words[next..];
        if character == '\\' && (rest.starts_with('$') || role_at(rest).is_some()) {
            next += 1;
            return rest.chars().next().map(|escaped| (offset + at, escaped));
        }
        Some((offset + at, character))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_escaped_dollar_begins_no_formula() {
        assert_eq!(pieces(r"5\$ or $x$").unwrap(), [Piece::Words(0, r"5\$ or "), Piece::Formula(8, "x")]);
        let text: String = characters(0, r"5\$ a\b").map(|(_, c)| c).collect();
        assert_eq!(text, r"5$ a\b");
    }

    #[test]
    fn a_backslash_among_words_is_one_unless_a_dollar_follows() {
        assert_eq!(pieces(r"a\\\$b $x$").unwrap()[1], Piece::Formula(8, "x"));
        let text: String = characters(0, r"a\\\$b").map(|(_, c)| c).collect();
        assert_eq!(text, r"a\\$b");
        assert_eq!(pieces(r"$a \\$").unwrap(), [Piece::Formula(1, r"a \\")]);
        assert!(ends_in_formula("costs $x = ") && !ends_in_formula(r"costs 5 \$ and "));
    }

    #[test]
    fn an_unclosed_formula_is_an_error_at_its_dollar() {
        assert_eq!(pieces("é $x").unwrap_err().offset, 3);
        assert_eq!(pieces("$x$$").unwrap_err().offset, 3);
    }

    #[test]
    fn words_wear_a_role_with_their_formulas_and_up_to_the_brace() {
        let expected = [
            Piece::Words(0, "so "),
            Piece::Role(6, "a"),
            Piece::Words(6, "box "),
            Piece::Formula(11, "v_{x}"),
            Piece::Plain,
            Piece::Words(18, "."),
        ];
        assert_eq!(pieces("so {a|box $v_{x}$}.").unwrap(), expected);
        assert_eq!(pieces("{a|b").unwrap_err().offset, 0);
        assert_eq!(pieces("{now|{a|b}").unwrap()[1], Piece::Words(5, "{a|b"), "a role holds no other");
        assert!(ends_in_formula("{a|at $t = ") && !ends_in_formula("{a|at $t$"));
    }

    #[test]
    fn braces_without_a_role_are_signs_and_so_is_one_after_a_backslash() {
        for text in ["{}", "{x}", "{A|b}", "{a b|c}", "{|}", "{=time}", "a}b{", "{1|2}", "|a|", r"\{a\}"] {
            assert_eq!(pieces(text).unwrap(), [Piece::Words(0, text)]);
            assert_eq!(as_markup(text), text);
        }
        let text = "{x|x > 0} and $5";
        assert_eq!(as_markup(text), r"\{x|x > 0} and \$5");
        assert_eq!(pieces(&as_markup(text)).unwrap().len(), 1);
        let read: String = characters(0, &as_markup(text)).map(|(_, c)| c).collect();
        assert_eq!(read, text);
        let read: String = characters(0, &as_markup(r"\{x|")).map(|(_, c)| c).collect();
        assert_eq!(read, r"\{x|");
    }
}
