//! HTML: one self-contained page with the figure, its alternative text and its numbers.
//!
//! The SVG is inline, so that the reader's dark switch reaches it; the long text stands below for everyone,
//! as what is drawn is for some only there. Nothing is loaded from elsewhere and nothing runs.

use super::svg::{Sheet, document, read};
use super::xml::escape;
use super::{Depends, Format, Options, OutputError, Reader, Stamped, Writer, validity};
use crate::drawing::Drawing;

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "html",
    about: "self-contained page: the picture inline, its description below",
    usual: false,
    depends: Depends::Page,
    write: Writer::One(write),
    // The words around the picture count too, so pages are compared as texts.
    read: Some(Reader { stamp, picture: None }),
};

/// Style sheet of the page around the picture: that may shrink to a narrow window but not grow.
const STYLE: &str = "body{margin:0 auto;padding:1rem;font:1rem/1.5 system-ui,sans-serif}\
                     figure{margin:0}svg{max-width:100%;height:auto}figcaption{max-width:45rem}";

/// What the picture inside a page says of itself.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    read::stamp(read::inside(bytes)?)
}

fn write(drawing: &Drawing, _options: &Options) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    let mut out = String::from("<!DOCTYPE html>\n<html lang=\"");
    escape(&mut out, drawing.lang.as_deref().unwrap_or(Drawing::OWN_LANG));
    out.push_str("\">\n<head>\n<meta charset=\"utf-8\">\n");
    out.push_str("<meta name=\"viewport\" content=\"width=device-width\">\n");
    // A page that asks for nothing says so: even a text that became markup could load and run nothing.
    out.push_str("<meta http-equiv=\"Content-Security-Policy\" ");
    out.push_str("content=\"default-src 'none'; style-src 'unsafe-inline'\">\n");
    let [of_title, of_desc] = drawing.languages_of_words();
    open(&mut out, "title", of_title);
    escape(&mut out, &drawing.title);
    out.push_str("</title>\n<style>");
    out.push_str(STYLE);
    out.push_str("</style>\n</head>\n<body>\n<figure>\n");
    out.push_str(&document(drawing, Sheet::Inside));
    open(&mut out, "figcaption", of_desc);
    escape(&mut out, &drawing.desc);
    out.push_str("</figcaption>\n</figure>\n</body>\n</html>\n");
    Ok(out.into_bytes())
}

/// The start of an element, with its language where that is not the page's.
fn open(out: &mut String, name: &str, lang: Option<&str>) {
    out.extend(["<", name]);
    if let Some(lang) = lang {
        out.extend([" lang=\"", lang, "\""]);
    }
    out.push('>');
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn a_page_has_the_language_of_its_scene_and_words_of_ours_have_theirs() {
        let page =
            |drawing: &Drawing| String::from_utf8(write(drawing, &Options::default()).unwrap()).unwrap();
        let mut drawing = everything();
        assert!(page(&drawing).contains("<html lang=\"en\">") && !page(&drawing).contains("xml:lang"));
        drawing.lang = Some("pt-BR".into());
        drawing.is_titled = true;
        let text = page(&drawing);
        assert!(text.contains("<html lang=\"pt-BR\">") && text.contains(" xml:lang=\"pt-BR\" role=\"img\""));
        assert!(text.contains("<title>Circle") && text.contains("<figcaption lang=\"en\">"));
        assert!(text.contains("<desc id=\"sample-desc\" xml:lang=\"en\">"));
    }

    #[test]
    fn a_page_holds_the_picture_and_its_words_and_no_script() {
        let mut drawing = everything();
        drawing.title = "A & B</title><script>alert(1)</script>".into();
        drawing.desc = "</figcaption><img src=x onerror=alert(1)>".into();
        let page = String::from_utf8(write(&drawing, &Options::default()).unwrap()).unwrap();
        assert!(page.contains("<svg") && page.contains("A &amp; B&lt;/title&gt;"));
        assert!(!page.contains("<script") && !page.contains("<img"));
    }
}
