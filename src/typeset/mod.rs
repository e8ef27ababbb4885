//! Words and `$…$` formulas to runs of glyphs with their extents.
//!
//! Markup is plain text in which `$…$` holds LaTeX maths and `\$` is a dollar sign; `\text{…}` in a formula
//! is words again. `{a|the red box}` are words that wear a role: they are semibold, and the line's [`Tint`]
//! says where they are. [`typeset`] sets it on
//! one [`Line`], [`wrap`] breaks it into lines. A line is placed with its baseline's left end at the origin
//! of its own frame, x right, y down, in page pixels; whoever draws it adds the place.
//!
//! Glyphs are references into the embedded faces; [`Glyph::outline`] gives the contours, built once and kept.

mod accents;
#[cfg(not(tracefig_page))]
mod beyond;
mod brought;
mod digits;
mod draft;
mod face;
mod formula;
mod inner_words;
mod kept;
#[cfg(test)]
mod language;
mod line;
mod markup;
#[cfg(not(tracefig_page))]
mod needed;
#[cfg(not(tracefig_page))]
mod own;
#[cfg(not(tracefig_page))]
mod packed;
mod pairs;
mod paragraph;
mod plain;
mod vec_accent;
mod words;

#[cfg(not(tracefig_page))]
pub(crate) use beyond::beyond;
#[cfg(test)]
pub(crate) use beyond::lacking;
pub(crate) use brought::{NAMES as PACKED, bring};
pub(crate) use inner_words::{escaped, group};
#[cfg(not(tracefig_page))]
pub(crate) use kept::said;
pub(crate) use kept::{line, paragraph};
pub(crate) use markup::{Piece, as_markup, ends_in_formula, pieces};
#[cfg(not(tracefig_page))]
pub(crate) use needed::Glyphs;
pub(crate) use plain::{command_in_words, plain};
pub(crate) use words::advance_of;

pub use face::{Outline, OutlineSegment, UNITS_PER_EM};
pub use line::{Face, Glyph, Line, PlacedGlyph, Rule, Run, Style, Tint, TypesetError, Weight};

use paragraph::{Newlines, Paragraph};

/// Sets `markup` on one line, newlines as spaces.
///
/// # Errors
///
/// A [`TypesetError`] with the byte offset in `markup` of malformed LaTeX, an unclosed `$`, or a character
/// that the embedded fonts do not have.
///
/// ```
/// use tracefig::typeset::{Style, typeset};
/// let line = typeset(r"distance $= \|D\| - r$", Style::regular(14.0)).unwrap();
/// assert!(line.width > 80.0 && line.width < 140.0);
/// assert_eq!(typeset(r"$a + \foo$", Style::regular(14.0)).unwrap_err().offset, 5);
/// ```
pub fn typeset(markup: &str, style: Style) -> Result<Line, TypesetError> {
    let paragraph = Paragraph::of(markup, style, Newlines::Spaces)?;
    Ok(paragraph.lines(f64::INFINITY).into_iter().next().unwrap_or_else(|| Line::empty(markup, style)))
}

/// Sets `markup` on as few lines as fit into `width` page pixels, broken at spaces outside formulas and at
/// newlines.
///
/// # Errors
///
/// A [`TypesetError`], as [`typeset`] gives it.
///
/// ```
/// use tracefig::typeset::{Style, wrap};
/// let lines = wrap("A moves along $v_A$ and first touches B as A′.", Style::regular(14.0), 150.0).unwrap();
/// assert_eq!(lines.len(), 2);
/// assert!(lines.iter().all(|line| line.width <= 150.0));
/// ```
pub fn wrap(markup: &str, style: Style, width: f64) -> Result<Vec<Line>, TypesetError> {
    Ok(Paragraph::of(markup, style, Newlines::Breaks)?.lines(width))
}
