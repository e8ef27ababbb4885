//! What pages of HTML around one picture have in common: their head, with the colours of the figure.

use std::fmt::Write as _;

use super::page_colors::{colored, push_schemes};
use super::xml::escape;
use crate::drawing::Drawing;

/// What a page without a script lets itself run: a page that asks for nothing says so, so that even a text
/// that became markup could load and run nothing.
pub(super) const NO_SCRIPT: &str = "";

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

/// The start of an element, with its language where that is not the page's.
pub(super) fn open(out: &mut String, name: &str, lang: Option<&str>) {
    out.extend(["<", name]);
    if let Some(lang) = lang {
        out.extend([" lang=\"", lang, "\""]);
    }
    out.push('>');
}
