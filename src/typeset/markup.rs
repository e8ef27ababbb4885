//! Markup: plain text with `$…$` for LaTeX maths; `\$` is a dollar sign.

use super::line::TypesetError;

/// A piece of markup with its first byte's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Piece<'m> {
    /// Characters as they are, `\$` still written so.
    Words(usize, &'m str),
    /// LaTeX between two dollar signs.
    Formula(usize, &'m str),
}

/// Cuts markup into words and formulas.
pub(crate) fn pieces(markup: &str) -> Result<Vec<Piece<'_>>, TypesetError> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while at < markup.len() {
        let Some(open) = opening(markup, at) else {
            pieces.push(Piece::Words(at, &markup[at..]));
            break;
        };
        if open > at {
            pieces.push(Piece::Words(at, &markup[at..open]));
        }
        let inside = open + 1;
        let Some(close) = closing(markup, inside) else {
            let message = "a formula begins here that no `$` ends; write `\\$` for a dollar sign".to_owned();
            return Err(TypesetError { offset: open, message });
        };
        pieces.push(Piece::Formula(inside, &markup[inside..close]));
        at = close + 1;
    }
    Ok(pieces)
}

/// Whether the end of a text stands within a formula that is not closed yet.
#[must_use]
pub(crate) fn ends_in_formula(markup: &str) -> bool {
    pieces(markup).is_err()
}

/// Where a formula opens: the next dollar sign of words that no backslash precedes.
fn opening(markup: &str, from: usize) -> Option<usize> {
    let bytes = markup.as_bytes();
    (from..bytes.len()).find(|&at| bytes[at] == b'$' && (at == from || bytes[at - 1] != b'\\'))
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

/// Characters of words with their places, `\$` as one dollar sign.
pub(crate) fn characters(offset: usize, words: &str) -> impl Iterator<Item = (usize, char)> + '_ {
    let mut rest = words.char_indices().peekable();
    std::iter::from_fn(move || {
        let (at, character) = rest.next()?;
        if character == '\\' && rest.next_if(|&(_, next)| next == '$').is_some() {
            return Some((offset + at, '$'));
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
}
