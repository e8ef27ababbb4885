//! The page that lists live pages: each with its picture, its title and what it claims.

use std::fmt::Write as _;

use super::xml::escape;

/// How the list looks: as many columns as have room, in the colours of the reader's system.
const STYLE: &str = ":root{color-scheme:light dark}\
    body{margin:0 auto;padding:1rem;max-width:80rem;font:1rem/1.5 system-ui,sans-serif}\
    h1{font-size:1.5rem}ul{list-style:none;margin:0;padding:0;display:grid;gap:1.5rem;\
    grid-template-columns:repeat(auto-fill,minmax(min(20rem,100%),1fr))}\
    a{display:block;height:100%;box-sizing:border-box;color:inherit;text-decoration:none;border-radius:.6rem;\
    border:1px solid color-mix(in srgb,currentColor 18%,transparent);overflow:hidden}\
    a:hover,a:focus-visible{border-color:currentColor}\
    a:focus-visible{outline:2px solid currentColor;outline-offset:2px}\
    img{display:block;width:100%;height:13rem;object-fit:contain;background:#fff}\
    strong,span{display:block;padding:0 1rem}strong{padding-top:.75rem}span{padding-bottom:1rem}";

/// A page of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gallery {
    /// The address of the page.
    pub page: String,
    /// The address of its picture; may be empty.
    pub picture: String,
    /// The title, in plain words.
    pub title: String,
    /// What it claims, in plain words; may be empty.
    pub words: String,
    /// The language of both, as BCP 47 has it; `None` is English.
    pub lang: Option<String>,
}

/// The page that lists others, in their order. It runs nothing, and loads their pictures alone.
///
/// ```
/// use tracefig::output::{Gallery, gallery};
/// let [page, picture, title, words] = ["a.html", "a.svg", "A & B", "They touch"].map(str::to_owned);
/// let list = gallery(&[Gallery { page, picture, title, words, lang: Some("en".to_owned()) }]);
/// assert!(list.contains("<a lang=\"en\" href=\"a.html\">") && list.contains("<strong>A &amp; B</strong>"));
/// ```
#[must_use]
pub fn gallery(pages: &[Gallery]) -> String {
    let mut out = String::from("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    out.push_str("<meta name=\"viewport\" content=\"width=device-width\">\n");
    out.push_str("<meta name=\"color-scheme\" content=\"light dark\">\n");
    out.push_str("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; ");
    out.push_str("img-src 'self' file:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n");
    out.push_str("<title>Figures to move</title>\n<style>");
    out.push_str(STYLE);
    out.push_str("</style>\n</head>\n<body>\n<main>\n<h1>Figures to move</h1>\n<ul>\n");
    for Gallery { page, picture, title, words, lang } in pages {
        out.push_str("<li><a");
        if let Some(lang) = lang {
            out.push_str(" lang=\"");
            escape(&mut out, lang);
            out.push('"');
        }
        out.push_str(" href=\"");
        push_address(&mut out, page);
        out.push_str("\">");
        if !picture.is_empty() {
            out.push_str("<img loading=\"lazy\" alt=\"\" src=\"");
            push_address(&mut out, picture);
            out.push_str("\">");
        }
        out.push_str("<strong>");
        escape(&mut out, title);
        out.push_str("</strong>");
        if !words.is_empty() {
            out.push_str("<span>");
            escape(&mut out, words);
            out.push_str("</span>");
        }
        out.push_str("</a></li>\n");
    }
    out.push_str("</ul>\n</main>\n</body>\n</html>\n");
    out
}

/// Appends the path of a file as an address: what would end a path or has another meaning there is written by
/// its bytes.
fn push_address(out: &mut String, path: &str) {
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            out.push(char::from(byte));
        } else {
            let _ = write!(out, "%{byte:02X}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_addresses_and_words_stay_words() {
        let [page, picture] = ["über #1.html", "über #1.svg"].map(str::to_owned);
        let [title, words] = ["<b>", "a \"b\""].map(str::to_owned);
        let list = gallery(&[Gallery { page, picture, title, words, lang: None }]);
        assert!(list.contains("href=\"%C3%BCber%20%231.html\"") && list.contains("&lt;b"), "{list}");
        assert!(!list.contains("<script") && !list.contains("<b>"));
    }
}
