//! The colours of a page around a figure: those of the figure, also in the dark where it follows the reader.

use std::fmt::Write as _;

use crate::drawing::{Color, Dark, Drawing, Role};

/// Whether words are lighter than the page, by the weights that ITU-R BT.601 gives to the bytes of a colour.
fn is_dark(page: Color, ink: Color) -> bool {
    let luma = |Color { r, g, b }: Color| 299 * u32::from(r) + 587 * u32::from(g) + 114 * u32::from(b);
    luma(ink) > luma(page)
}

/// The colour schemes of the page, as CSS and `<meta>` name them.
fn schemes(drawing: &Drawing) -> &'static str {
    match &drawing.dark {
        Some(_) => "light dark",
        None if is_dark(drawing.background.color, drawing.ink) => "dark",
        None => "light",
    }
}

/// Appends what tells a browser the colour schemes of the page, before it reads any style.
pub(super) fn push_schemes(out: &mut String, drawing: &Drawing) {
    let _ = writeln!(out, "<meta name=\"color-scheme\" content=\"{}\">", schemes(drawing));
}

/// Appends a rule with the page's colours, which a host page may set as those of the figure.
fn push_colors(out: &mut String, page: Color, ink: Color) {
    let _ = write!(out, "background:var(--tracefig-background,{page});color:var(--tracefig-ink,{ink})");
}

/// The rules that give a page the colours of its figure, also in the dark where that follows the reader.
pub(super) fn colored(drawing: &Drawing) -> String {
    let mut out = format!(":root{{color-scheme:{};", schemes(drawing));
    push_colors(&mut out, drawing.background.color, drawing.ink);
    out.push('}');
    if let Some(Dark { colors, ink, .. }) = &drawing.dark {
        let page = colors.iter().find(|(role, _)| *role == Role::Background);
        out.push_str("@media (prefers-color-scheme:dark){:root{");
        push_colors(&mut out, page.map_or(drawing.background.color, |&(_, page)| page), *ink);
        out.push_str("}}");
    }
    out
}
