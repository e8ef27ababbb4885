//! The caption, broken into lines, and its words for readers who do not see it.
//!
//! A text that can't be set is told with its place before anything is drawn.

use crate::figure::context::Context;
use crate::figure::fault::{Fault, Problem};
use crate::figure::page::{CAPTION_SIZE, Page, type_size};
use crate::scene::Spanned;
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
    let (width, height) = (context.scene.canvas.width, context.scene.canvas.height);
    let measure = Page::new(width, height, 1, false, 2).measure;
    let style = Style::regular(type_size(width, height, CAPTION_SIZE));
    let lines = set(text, context, (problems, warnings), |t| wrap(t, style, measure)).unwrap_or_default();
    let most = Page::caption_lines(width, height);
    if lines.len() > most {
        let fault = Fault::CaptionDropped { lines: lines.len(), room: most };
        warnings.push(Problem::new(fault, text.span.clone()));
        return Vec::new();
    }
    lines
}

/// The caption in plain words, with the values of `context`; `None` without a caption.
pub(crate) fn caption_words(context: &Context) -> Option<String> {
    let text = context.scene.caption.as_ref()?;
    Some(plain(&fill(&text.value, context, &text.span).ok()?.0))
}
