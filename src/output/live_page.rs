//! A live page: the figure as it stands, and what draws it again while a reader drags it.
//!
//! The picture is the SVG file, byte for byte, and stands alone until the module has drawn the same. The page
//! carries all that it needs, or takes it from one file beside it that many pages share; it asks for nothing
//! else, and its policy allows nothing else. Without scripts it is the picture and its words.

use std::fmt::Write as _;

use super::base64::base64;
use super::page_colors::{colored, push_schemes};
use super::sha256::sha256;
use super::svg::searchable;
use super::xml::escape;
use super::{OutputError, page, validity};
use crate::drawing::Drawing;

/// The script of live figures, as one.
const SCRIPT: &str = concat!(
    "\"use strict\";{\n",
    "const WORDS = ",
    include_str!("../../live/words.json"),
    include_str!("../../live/values.js"),
    include_str!("../../live/picture.js"),
    include_str!("../../live/edited.js"),
    include_str!("../../live/live.js"),
    include_str!("../../live/controls.js"),
    include_str!("../../live/start.js"),
    "}\n",
);
/// How the controls of a live figure look.
pub(super) const STYLE: &str = include_str!("../../live/live.css");
/// How the page around it looks.
const PAGE: &str = "body{margin:0 auto;padding:1rem;max-width:62rem;font:1rem/1.5 system-ui,sans-serif}\
                    h1{font-size:1rem;margin:0 0 .5rem}\
                    nav a{color:inherit;display:inline-block;padding:.6rem 0}\
                    @media print{nav{display:none}}";

/// What a live page has besides the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LivePage<'p> {
    /// What the module is opened with, as JSON: the scene, the drawing's id and the theme.
    pub request: &'p str,
    /// The heading, in plain words.
    pub heading: &'p str,
    /// Where the module is.
    pub module: Module<'p>,
    /// The address of a page that lists this one among others, where there is one.
    pub index: Option<&'p str>,
}

/// Where a live page has its module from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Module<'p> {
    /// The page holds it: the module, packed by gzip.
    Inside(&'p [u8]),
    /// A file beside the page holds it, by its address: what [`live_runtime`] gives.
    Beside(&'p str),
}

/// The file that live pages share: the script with the module, which is packed by gzip.
///
/// ```
/// let runtime = tracefig::output::live_runtime(b"module");
/// assert!(runtime.starts_with("globalThis.tracefigModule=\"bW9kdWxl\";"));
/// ```
#[must_use]
pub fn live_runtime(module: &[u8]) -> String {
    format!("globalThis.tracefigModule=\"{}\";\n{SCRIPT}", base64(module))
}

/// What the way to the list and the long text are called, in each language of which we have words; the first
/// is for all others.
const WORDS: [(&str, [&str; 2]); page::LANGUAGES] = [
    (Drawing::OWN_LANG, ["All figures", "Description"]),
    ("de", ["Alle Figuren", "Beschreibung"]),
    ("fr", ["Toutes les figures", "Description"]),
    ("es", ["Todas las figuras", "Descripción"]),
];

/// The page of a drawing whose metadata are those of its SVG file.
pub(super) fn write(drawing: &Drawing, page: &LivePage<'_>) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    let mut out = String::from("<!DOCTYPE html>\n<html lang=\"");
    escape(&mut out, drawing.lang.as_deref().unwrap_or(Drawing::OWN_LANG));
    out.push_str("\">\n<head>\n<meta charset=\"utf-8\">\n");
    out.push_str("<meta name=\"viewport\" content=\"width=device-width\">\n");
    push_schemes(&mut out, drawing);
    let scripts = match page.module {
        Module::Inside(_) => format!("'sha256-{}'", base64(&sha256(SCRIPT.as_bytes()))),
        Module::Beside(_) => "'self' file:".to_owned(),
    };
    out.push_str("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; ");
    let _ = write!(out, "script-src {scripts} 'wasm-unsafe-eval'; style-src 'unsafe-inline'; ");
    out.push_str("base-uri 'none'; form-action 'none'\">\n<title>");
    escape(&mut out, &drawing.title);
    out.push_str("</title>\n<style>");
    out.push_str(PAGE);
    out.push_str(&colored(drawing));
    out.push_str(STYLE);
    out.push_str("</style>\n</head>\n<body>\n");
    if let Some(index) = page.index {
        out.push_str("<nav><a href=\"");
        escape(&mut out, index);
        let _ = writeln!(out, "\">{}</a></nav>", page::in_language(drawing, &WORDS)[0]);
    }
    out.push_str("<main>\n<h1>");
    escape(&mut out, page.heading);
    out.push_str("</h1>\n");
    push_figure(&mut out, drawing, page.request);
    out.push_str("</main>\n");
    match page.module {
        Module::Inside(module) => {
            out.push_str("<script type=\"application/gzip\" id=\"tracefig-module\">");
            out.push_str(&base64(module));
            out.extend(["</script>\n<script>", SCRIPT, "</script>\n"]);
        }
        Module::Beside(address) => {
            out.push_str("<script src=\"");
            escape(&mut out, address);
            out.push_str("\"></script>\n");
        }
    }
    out.push_str("</body>\n</html>\n");
    Ok(out.into_bytes())
}

/// The figure with what the script needs of it.
fn push_figure(out: &mut String, drawing: &Drawing, request: &str) {
    out.push_str("<div class=\"tracefig-live\">\n<figure>");
    out.push_str(searchable(drawing, None).trim_end());
    let _ = write!(
        out,
        "</figure>\n<details class=\"words\"><summary>{}</summary>",
        page::in_language(drawing, &WORDS)[1]
    );
    let [_, of_desc] = drawing.languages_of_words();
    page::open(out, "p", of_desc);
    page::push_words(out, &drawing.desc);
    out.push_str("</p></details>\n<script type=\"application/json\">");
    // A text of the scene must not end the element that it stands in.
    out.push_str(&request.replace('<', "\\u003c"));
    out.push_str("</script>\n</div>\n");
}

#[cfg(test)]
mod tests {
    use super::super::samples::everything;
    use super::*;

    fn page(drawing: &Drawing, page: &LivePage<'_>) -> String {
        String::from_utf8(write(drawing, page).unwrap()).unwrap()
    }

    const ALONE: LivePage<'_> =
        LivePage { request: "{}", heading: "A sample", module: Module::Inside(b"module"), index: None };

    #[test]
    fn the_picture_of_the_page_is_the_svg_file() {
        let drawing = everything();
        let page = page(&drawing, &ALONE);
        let file = searchable(&drawing, None);
        assert!(page.contains(&format!("<figure>{}</figure>", file.trim_end())));
    }

    #[test]
    fn the_policy_names_the_one_script_and_allows_nothing_else() {
        let page = page(&everything(), &ALONE);
        let (_, script) = page.rsplit_once("<script>").unwrap();
        let (script, rest) = script.split_once("</script>").unwrap();
        assert_eq!(rest, "\n</body>\n</html>\n");
        assert!(page.contains(&format!("script-src 'sha256-{}'", base64(&sha256(script.as_bytes())))));
        assert!(page.contains("content=\"default-src 'none';") && page.contains(">bW9kdWxl</script>"));
        assert!(!page.contains(" src=") && !page.contains("<link"), "nothing is loaded");
        for handler in ["onclick", "onload", "eval(", "new Function", "fetch("] {
            assert!(!script.contains(handler), "{handler}");
        }
    }

    #[test]
    fn controls_have_every_word_in_every_language() {
        let words: serde_json::Value = serde_json::from_str(include_str!("../../live/words.json")).unwrap();
        let own = words["en"].as_object().unwrap();
        let places = |said: &serde_json::Value| said.as_str().unwrap().matches("{}").count();
        for (language, table) in words.as_object().unwrap() {
            assert!(table.as_object().unwrap().keys().eq(own.keys()), "{language}");
            for (key, said) in own {
                assert_eq!(places(said), places(&table[key]), "{key} in {language}");
                let is_said = SCRIPT.contains(&format!("this.word(\"{key}\""));
                assert!(is_said, "{key} is said nowhere");
            }
        }
        let asked = SCRIPT.split("this.word(\"").skip(1).map(|rest| rest.split('"').next().unwrap());
        for key in asked {
            assert!(own.contains_key(key), "{key} has no words");
        }
        let known: Vec<_> = words.as_object().unwrap().keys().collect();
        assert_eq!(known, ["en", "de", "fr", "es"]);
    }

    #[test]
    fn words_of_the_scene_stay_words() {
        let mut drawing = everything();
        drawing.title = "</title><script>alert(1)</script>".into();
        drawing.desc = "</p><script>alert(1)</script>".into();
        let request = r#"{"scene": {"title": "</script><script>alert(1)</script>"}}"#;
        let said = LivePage { request, heading: "<script>", index: Some("\"><script>"), ..ALONE };
        assert_eq!(page(&drawing, &said).matches("<script").count(), 3);
    }

    #[test]
    fn a_page_that_shares_the_module_is_small_and_names_its_file() {
        let said = LivePage { module: Module::Beside("../tracefig-live.js"), ..ALONE };
        let page = page(&everything(), &said);
        assert!(page.contains("<script src=\"../tracefig-live.js\"></script>"));
        assert!(!page.contains("sha256-") && page.len() < 20_000 + searchable(&everything(), None).len());
    }

    #[test]
    fn the_words_of_a_page_are_those_of_its_language() {
        let mut drawing = everything();
        for (lang, said) in
            [(None, "Description"), (Some("de-AT"), "Beschreibung"), (Some("pl"), "Description")]
        {
            drawing.lang = lang.map(str::to_owned);
            assert!(page(&drawing, &ALONE).contains(&format!("<summary>{said}<")), "{lang:?}");
        }
    }
}
