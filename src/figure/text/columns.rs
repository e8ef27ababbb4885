//! A caption in two columns: a line across a wide page has more letters than the eye finds its way back over.
//!
//! The second column begins with a sentence, the one that leaves both columns of the most equal length. A
//! text that fits on one line, or whose sentences would leave more than half of a column empty, has one.

use crate::typeset::{Piece, Style, TypesetError, line, pieces};

/// The least share of the longer column's text that the shorter one has.
const LEAST: f64 = 0.4;

/// Cuts markup into the texts of two columns; one, all of it, where it is no longer than `ease` page pixels
/// or can't be cut well.
///
/// # Errors
/// Where the markup can't be typeset.
pub(super) fn columns(markup: &str, style: Style, ease: f64) -> Result<Vec<&str>, TypesetError> {
    let mut ends = sentence_ends(markup)?;
    if ends.is_empty() || line(markup, style)?.width <= ease {
        return Ok(vec![markup]);
    }
    ends.push(markup.len());
    let (mut widths, mut from) = (Vec::new(), 0);
    for &end in &ends {
        widths.push(line(&markup[from..end], style)?.width);
        from = end;
    }
    let all: f64 = widths.iter().sum();
    let (mut best, mut before) = (None, 0.0);
    for (&end, width) in ends.iter().zip(widths) {
        before += width;
        let (less, more) = (before.min(all - before), before.max(all - before));
        if less >= LEAST * more && best.is_none_or(|(_, least)| more < least) {
            best = Some((end, more));
        }
    }
    Ok(best.map_or(vec![markup], |(end, _)| vec![&markup[..end], &markup[end..]]))
}

/// Where a sentence other than the last ends, after the space behind it: outside of formulas and of words
/// that wear a role.
fn sentence_ends(markup: &str) -> Result<Vec<usize>, TypesetError> {
    let (mut ends, mut is_worn) = (Vec::new(), false);
    for piece in pieces(markup)? {
        match piece {
            Piece::Role(..) => is_worn = true,
            Piece::Plain => is_worn = false,
            Piece::Words(at, words) if !is_worn => {
                let marks = words.match_indices(['.', '!', '?']).map(|(i, _)| i + 1);
                ends.extend(marks.filter(|&i| begins(&words[i..], &markup[at + i..])).map(|i| at + i + 1));
            }
            _ => {}
        }
    }
    Ok(ends)
}

/// Whether a sentence begins after the mark that ends another: a space, and no small letter after it.
fn begins(words: &str, rest: &str) -> bool {
    let next = rest.strip_prefix(' ').and_then(|rest| rest.chars().next());
    words.starts_with(' ') && next.is_some_and(|c| !c.is_lowercase() && !c.is_whitespace())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(markup: &str) -> Vec<&str> {
        columns(markup, Style::regular(14.0), 200.0).unwrap()
    }

    #[test]
    fn the_second_column_begins_with_a_sentence() {
        let text = "{a|$A$. Here.} One is long, e.g. this one. $B$ is as long as that. No.";
        assert_eq!(cut(text).concat(), text);
        assert_eq!(cut(text)[1], "$B$ is as long as that. No.");
    }

    #[test]
    fn a_short_text_and_one_that_cannot_be_halved_have_one_column() {
        assert_eq!(cut("It is short. So is this.").len(), 1);
        assert_eq!(cut("Only this one, which is as long as two others would be, or as three.").len(), 1);
        assert_eq!(cut("No. This one is as long as two others would be, or as three of them.").len(), 1);
    }
}
