//! The caption, broken into lines, and its words for readers who do not see it.
//!
//! A text that can't be set is told with its place before anything is drawn.

use crate::figure::context::Context;
use crate::figure::fault::{Fault, Problem};
use crate::figure::name::as_markup;
use crate::figure::page::{CAPTION_SIZE, Page, type_size};
use crate::scene::{Scene, Spanned};
use crate::typeset::{Line, Style, TypesetError, wrap};

use super::fill::fill;
use super::plain;
use super::wording::{bad_markup, no_value};

/// A text of the scene, filled and set by `typeset`; `None`, with the reason in `problems`, where it can't
/// be. What the answer lacks for it is in `notes`.
pub(crate) fn set<T>(
    text: &Spanned<String>,
    context: &Context,
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
    typeset: impl Fn(&str) -> Result<T, TypesetError>,
) -> Option<T> {
    let filled = match fill(&text.value, context, &text.span) {
        Ok((filled, lacking)) => {
            notes.extend(lacking.into_iter().map(|value| no_value(value, context, &text.span)));
            filled
        }
        Err(problem) => {
            problems.push(problem);
            return None;
        }
    };
    typeset(&filled).map_err(|e| problems.push(bad_markup(e, filled.clone(), &text.span))).ok()
}

/// The lines of the caption; none where the page has no room for all of them, which is a warning. Its values
/// are those of `context`, the first panel's.
pub(crate) fn caption(
    context: &Context,
    problems: &mut Vec<Problem>,
    warnings: &mut Vec<Problem>,
) -> Vec<Line> {
    let Some(text) = &context.scene.caption else { return Vec::new() };
    let (style, measure, most) = room(context.scene);
    let lines = set(text, context, (problems, warnings), |t| wrap(t, style, measure)).unwrap_or_default();
    if lines.len() > most {
        let fault = Fault::CaptionDropped { lines: lines.len(), room: most };
        warnings.push(Problem::new(fault, text.span.clone()));
        return Vec::new();
    }
    lines
}

/// The lines of a caption in `words` of ours; none where the page has no room for it, or the font a letter.
pub(crate) fn caption_of_words(scene: &Scene, words: &str) -> Vec<Line> {
    let (style, measure, most) = room(scene);
    wrap(&with_powers(&as_markup(words)), style, measure)
        .ok()
        .filter(|lines| lines.len() <= most)
        .unwrap_or_default()
}

/// Words as markup whose powers of ten, `10^−6` in words, are formulas.
fn with_powers(words: &str) -> String {
    let mut pieces = words.split("10^");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find(|c: char| c != '−' && !c.is_ascii_digit()).unwrap_or(piece.len());
        let (exponent, rest) = piece.split_at(end);
        match exponent {
            // A name may hold it, too.
            "" => text.extend(["10^", piece]),
            _ => text.extend(["$10^{", &exponent.replace('−', "-"), "}$", rest]),
        }
    }
    text
}

/// How a caption is set, how wide its lines are in page pixels, and how many the page takes.
fn room(scene: &Scene) -> (Style, f64, usize) {
    let (width, height) = (scene.canvas.width, scene.canvas.height);
    let measure = Page::new(width, height, 1, false, 2).measure;
    (Style::regular(type_size(width, height, CAPTION_SIZE)), measure, Page::caption_lines(width, height))
}

/// The caption in plain words, with the values of `context`; `None` without a caption.
pub(crate) fn caption_words(context: &Context) -> Option<String> {
    let text = context.scene.caption.as_ref()?;
    Some(plain(&fill(&text.value, context, &text.span).ok()?.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_ten_in_words_becomes_a_formula() {
        assert_eq!(with_powers("at (1.5 × 10^−6, 2)."), "at (1.5 × $10^{-6}$, 2).");
        assert_eq!(with_powers("10^12"), "$10^{12}$");
        assert_eq!(with_powers("no power"), "no power");
    }
}
