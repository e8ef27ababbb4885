//! HTML: one self-contained page with the figure, its alternative text and its numbers.
//!
//! The page has the figure's colours, also in the dark where the figure follows the reader's system, and says
//! so (`color-scheme`), so that scroll bars and what the browser draws before the page are of them too. The
//! SVG is inline, so that the reader's dark switch reaches it; the long text stands below for everyone,
//! as what is drawn is for some only there. Nothing is loaded from elsewhere and nothing runs.

use super::live_page;
use super::svg::{read, searchable};
use super::{
    Bracket, Depends, Format, Options, OutputError, Reader, Stamped, Writer, page, stepper, validity,
};
use crate::drawing::Drawing;

/// The row of the table.
pub(super) const FORMAT: Format = Format {
    name: "html",
    about: "self-contained page: the picture inline, its description below",
    media_type: "text/html",
    usual: false,
    in_the_dark: true,
    depends: Depends::Page,
    write: Writer::One(write),
    in_steps: Some(stepper::write),
    in_motion: None,
    bind: None,
    bracket: Bracket { begins: &[b"<".as_slice()], ends: &[b"</html>".as_slice(), b"-->"] },
    // The words around the picture count too, so pages are compared as texts.
    read: Some(Reader { stamp, picture: None }),
    live: Some(live_page::write),
};

/// What the picture inside a page says of itself.
fn stamp(bytes: &[u8]) -> Option<Stamped> {
    read::stamp(read::inside(bytes)?)
}

fn write(drawing: &Drawing, _options: &Options) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    let [_, of_desc] = drawing.languages_of_words();
    let mut out = page::head(drawing, page::NO_SCRIPT);
    out.push_str("</style>\n</head>\n<body>\n<main>\n<figure>\n");
    out.push_str(&searchable(drawing, None));
    page::open(&mut out, "figcaption", of_desc);
    page::push_words(&mut out, &drawing.desc);
    out.push_str("</figcaption>\n</figure>\n</main>\n</body>\n</html>\n");
    Ok(out.into_bytes())
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;
    use crate::drawing::{Color, Dark, Paint, Role};

    fn page(drawing: &Drawing) -> String {
        String::from_utf8(write(drawing, &Options::default()).unwrap()).unwrap()
    }

    #[test]
    fn the_page_has_the_colours_of_its_figure() {
        let light = everything();
        let [night, day] = [0x12_161C, 0xE8_EAED].map(Color::hex);
        let (colors, words) = (vec![(Role::Background, night)], Vec::new());
        let both = Dark { colors, ink: day, words, fill_opacity: 0.2 };
        let dark = Drawing { background: Paint::role(Role::Background, night), ink: day, ..everything() };
        let colors = "{background:var(--tracefig-background,#12161C);color:var(--tracefig-ink,#E8EAED)}";
        let in_the_dark = format!("@media (prefers-color-scheme:dark){{:root{colors}}}");
        for (drawing, schemes) in [
            (&light, "light"),
            (&dark, "dark"),
            (&Drawing { dark: Some(both), ..everything() }, "light dark"),
        ] {
            let page = page(drawing);
            assert!(page.contains(&format!("<meta name=\"color-scheme\" content=\"{schemes}\">")), "{page}");
            assert!(page.contains(&format!(":root{{color-scheme:{schemes};background:")), "{page}");
            assert_eq!(page.contains(&in_the_dark), drawing.dark.is_some());
        }
    }

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
        let page = page(&drawing);
        assert!(page.contains("<svg") && page.contains("A &amp; B&lt;/title&gt;"));
        assert!(!page.contains("<script") && !page.contains("<img"));
        let (main, rest) = page.split_once("<main>").unwrap();
        assert!(rest.contains("<svg") && rest.ends_with("</main>\n</body>\n</html>\n"));
        assert!(main.contains("<html lang=") && main.contains("<title"));
    }
}
