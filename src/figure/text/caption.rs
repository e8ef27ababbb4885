//! Headline and caption, broken into lines, and their words for readers who do not see it.
//!
//! A text that can't be set is told with its place before anything is drawn.

use crate::figure::context::Context;
use crate::figure::fault::{Fault, Problem};
use crate::figure::lettering::Lettering;
use crate::figure::page::{CAPTION_SIZE, HEADLINE_SIZE, Measures};
use crate::scene::{Scene, Spanned};
use crate::typeset::{Line, Style, TypesetError, as_markup, wrap};

use super::fill::fill;
use super::plain;
use super::wording::{bad_markup, bad_role, no_value};

/// A text that stands across the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Block {
    /// The claim of the figure, above the panels.
    Headline,
    /// What leads through the figure, below the panels.
    Caption,
}

impl Block {
    /// What messages call it.
    fn name(self) -> &'static str {
        match self {
            Self::Headline => "headline",
            Self::Caption => "caption",
        }
    }

    /// The text of the scene for it.
    fn of(self, scene: &Scene) -> Option<&Spanned<String>> {
        match self {
            Self::Headline => scene.headline.as_ref(),
            Self::Caption => scene.caption.as_ref(),
        }
    }

    /// How it is set, how wide its lines are in page pixels, and how many the page takes.
    fn room(self, scene: &Scene) -> (Style, f64, usize) {
        let measures = Measures::of(&scene.canvas);
        let (style, most) = match self {
            Self::Headline => (Style::semibold(measures.type_size(HEADLINE_SIZE)), measures.headline_lines()),
            Self::Caption => (Style::regular(measures.type_size(CAPTION_SIZE)), measures.caption_lines()),
        };
        (style, measures.measure(), most)
    }
}

/// A text of the scene, filled and set by `typeset`; `None`, with the reason in `problems`, where it can't
/// be. What the answer lacks for it is in `notes`.
pub(crate) fn set(
    text: &Spanned<String>,
    context: &Context,
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
    typeset: impl Fn(&str) -> Result<Vec<Line>, TypesetError>,
) -> Option<Lettering> {
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
    if let Some(problem) = bad_role(&filled, &text.span) {
        problems.push(problem);
        return None;
    }
    let set = Lettering::new(&filled, typeset);
    set.map_err(|e| problems.push(bad_markup(e, filled.clone(), &text.span))).ok()
}

/// A text across the page, set.
#[derive(Clone, Debug, Default)]
pub(crate) struct Across {
    /// Its lines; none where there is no text, or no room for it on the page.
    pub(crate) lines: Lettering,
    /// Its plain words; `None` where there is no text.
    pub(crate) words: Option<String>,
}

/// A text across the page; without lines where the page has no room for all of them, which is a warning. Its
/// values are those of `context`, the first panel's.
pub(crate) fn across(
    block: Block,
    context: &Context,
    (problems, warnings): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Across {
    let Some(text) = block.of(context.scene) else { return Across::default() };
    let (style, measure, room) = block.room(context.scene);
    let lines = set(text, context, (problems, warnings), |t| wrap(t, style, measure)).unwrap_or_default();
    let filled = fill(&text.value, context, &text.span).ok();
    let words = filled.map(|(filled, _)| plain(&filled));
    if lines.len() <= room {
        return Across { lines, words };
    }
    let fault = Fault::TextDropped { what: block.name(), lines: lines.len(), room };
    warnings.push(Problem::new(fault, text.span.clone()));
    Across { lines: Lettering::default(), words }
}

/// A text of a scene in plain words, for those who do not see the figure; `None`, with the reason in
/// `problems`, where there is none that can be read. Its values are those of `context`.
pub(crate) fn spoken(
    text: Option<&Spanned<String>>,
    context: &Context,
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Option<String> {
    let text = text?;
    // What can't be set in type can be said all the same.
    match fill(&text.value, context, &text.span) {
        Ok((filled, lacking)) => {
            notes.extend(lacking.into_iter().map(|value| no_value(value, context, &text.span)));
            Some(plain(&filled))
        }
        Err(problem) => {
            problems.push(problem);
            None
        }
    }
}

/// A caption in `words` of ours; empty where the page has no room for it, or the font lacks a letter.
pub(crate) fn caption_of_words(scene: &Scene, words: String) -> Across {
    let (style, measure, room) = Block::Caption.room(scene);
    let set = Lettering::new(&with_powers(&as_markup(&words)), |t| wrap(t, style, measure));
    set.ok()
        .filter(|lines| lines.len() <= room)
        .map_or_else(Across::default, |lines| Across { lines, words: Some(words) })
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
