//! What pages of HTML around one picture have in common: their head, with the colours of the figure.

use std::fmt::Write as _;

use super::page_colors::{colored, push_schemes};
use super::xml::escape;
use crate::drawing::Drawing;

/// What a page without a script lets itself run: a page that asks for nothing says so, so that even a text
/// that became markup could load and run nothing.
pub(super) const NO_SCRIPT: &str = "";

/// Languages of which we have words.
pub(super) const LANGUAGES: usize = 4;

/// Style sheet of the page around the picture: that may shrink to a narrow window but not grow.
const STYLE: &str = "body{margin:0 auto;padding:1rem;font:1rem/1.5 system-ui,sans-serif}\
                     figure{margin:0}svg{max-width:100%;height:auto}figcaption{max-width:45rem}";

/// A page up to the end of its style sheet, which is left open; `scripts` is what may run, as a rule of the
/// content security policy.
pub(super) fn head(drawing: &Drawing, scripts: &str) -> String {
    let mut out = String::from("<!DOCTYPE html>\n<html lang=\"");
    escape(&mut out, drawing.lang.as_deref().unwrap_or(Drawing::OWN_LANG));
    out.push_str("\">\n<head>\n<meta charset=\"utf-8\">\n");
    out.push_str("<meta name=\"viewport\" content=\"width=device-width\">\n");
    push_schemes(&mut out, drawing);
    out.push_str("<meta http-equiv=\"Content-Security-Policy\" ");
    let _ = writeln!(out, "content=\"default-src 'none'; style-src 'unsafe-inline'{scripts}\">");
    let [of_title, _] = drawing.languages_of_words();
    open(&mut out, "title", of_title);
    escape(&mut out, &drawing.title);
    out.push_str("</title>\n<style>");
    let _ = write!(out, "{STYLE}{}", colored(drawing));
    out
}

/// What a table has for the language of a drawing; its first row is for all others.
pub(super) fn in_language<T: Copy>(drawing: &Drawing, table: &[(&str, T); LANGUAGES]) -> T {
    let of = drawing.lang.as_deref().and_then(|lang| lang.split('-').next()).unwrap_or_default();
    table.iter().find(|(lang, _)| lang.eq_ignore_ascii_case(of)).unwrap_or(&table[0]).1
}

/// The start of an element, with its language where that is not the page's.
pub(super) fn open(out: &mut String, name: &str, lang: Option<&str>) {
    out.extend(["<", name]);
    if let Some(lang) = lang {
        out.extend([" lang=\"", lang, "\""]);
    }
    out.push('>');
}

/// Appends words for a reader of a page: escaped, with a power of ten, `10^−13` in plain words, in the raised
/// figures that every face of a browser has.
pub(super) fn push_words(out: &mut String, words: &str) {
    let mut pieces = words.split(POWER);
    escape(out, pieces.next().unwrap_or_default());
    for piece in pieces {
        let end = piece.find(|c| raised(c).is_none()).unwrap_or(piece.len());
        let (exponent, rest) = piece.split_at(end);
        // Without a number it is a part of a name.
        out.push_str(if exponent.is_empty() { POWER } else { "10" });
        out.extend(exponent.chars().filter_map(raised));
        escape(out, rest);
    }
}

/// How a power of ten begins in plain words.
const POWER: &str = "10^";

/// A digit or a minus as an exponent.
fn raised(c: char) -> Option<char> {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match c {
        '−' => Some('⁻'),
        _ => c.to_digit(10).and_then(|digit| digits.get(usize::try_from(digit).ok()?).copied()),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_power_of_ten_has_raised_figures_on_a_page() {
        let written = |words: &str| {
            let mut out = String::new();
            super::push_words(&mut out, words);
            out
        };
        assert_eq!(written("at (1.5 × 10^−13, 10^2) < x"), "at (1.5 × 10⁻¹³, 10²) &lt; x");
        assert_eq!(written("10^ & up"), "10^ &amp; up");
    }
}
