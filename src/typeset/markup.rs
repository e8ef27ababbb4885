//! Markup: plain text with `$…$` for LaTeX maths; `\$` is a dollar sign.

use super::line::TypesetError;

/// A piece of markup with its first byte's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Piece<'m> {
    /// Characters as they are, `\$` still written so.
    Words(usize, &'m str),
    /// LaTeX between two dollar signs.
    Formula(usize, &'m str),
}

/// Cuts markup into words and formulas.
pub(super) fn pieces(markup: &str) -> Result<Vec<Piece<'_>>, TypesetError> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while at < markup.len() {
        let Some(open) = find_dollar(markup, at) else {
            pieces.push(Piece::Words(at, &markup[at..]));
            break;
        };
        if open > at {
            pieces.push(Piece::Words(at, &markup[at..open]));
        }
        let inside = open + 1;
        let Some(close) = find_dollar(markup, inside) else {
            let message = "a formula begins here that no `$` ends; write `\\$` for a dollar sign".to_owned();
            return Err(TypesetError { offset: open, message });
        };
        pieces.push(Piece::Formula(inside, &markup[inside..close]));
        at = close + 1;
    }
    Ok(pieces)
}

/// The next dollar sign that no backslash precedes.
fn find_dollar(markup: &str, from: usize) -> Option<usize> {
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
pub(super) fn characters(offset: usize, words: &str) -> impl Iterator<Item = (usize, char)> + '_ {
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
    fn an_unclosed_formula_is_an_error_at_its_dollar() {
        assert_eq!(pieces("é $x").unwrap_err().offset, 3);
        assert_eq!(pieces("$x$$").unwrap_err().offset, 3);
    }
}
