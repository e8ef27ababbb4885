//! A picture inside another text: as an element of the page, or as the address of an image.

use super::super::base64::base64;
use super::{Drawing, OutputError, Sheet, document, found_words, identifier, text_with};

/// The picture as an element for the middle of an HTML page, in one line, so that Markdown takes it as it is.
/// A reader finds and copies its words.
/// All ids and classes begin with the drawing's id: two pictures of one page must differ in it.
///
/// # Errors
/// When the page or a place on it is no finite number.
///
/// ```
/// use tracefig::{figure::{draw, plan}, output::inline, scene::{Source, read}};
/// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let element = inline(&draw(&plan, plan.theme, "first").drawing).unwrap();
/// assert!(element.starts_with("<svg ") && element.ends_with("</svg>") && !element.contains('\n'));
/// assert!(element.contains("id=\"first-title\""));
/// ```
pub fn inline(drawing: &Drawing) -> Result<String, OutputError> {
    inline_with(drawing, &found_words(drawing, None))
}

/// The picture as [`inline`] has it, with the words that are found in it.
pub(crate) fn inline_with(drawing: &Drawing, words: &str) -> Result<String, OutputError> {
    Ok(in_one_line(&text_with(drawing, words)?))
}

/// A document as one line.
fn in_one_line(document: &str) -> String {
    document.trim_end().replace('\n', " ")
}

/// The picture as the address of an image, `data:` and all of it, for texts whose readers take no element.
///
/// # Errors
/// When the page or a place on it is no finite number.
///
/// ```
/// use tracefig::{figure::{draw, plan}, output::data_uri, scene::{Source, read}};
/// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let address = data_uri(&draw(&plan, plan.theme, "first").drawing).unwrap();
/// assert!(address.starts_with("data:image/svg+xml;base64,PHN2Zy"));
/// ```
pub fn data_uri(drawing: &Drawing) -> Result<String, OutputError> {
    super::super::validity::page(drawing)?;
    let text = in_one_line(&document(drawing, Sheet::Inside));
    Ok(format!("data:image/svg+xml;base64,{}", base64(text.as_bytes())))
}

/// An id for a drawing that stands in a page with others: a letter, and three letters or digits, one of 1.2
/// million from a hash. It stands some hundred times in a file, where a whole name would cost a fifth of its
/// bytes.
///
/// ```
/// use tracefig::output::short_id;
/// assert_eq!(short_id(0), "aaaa");
/// assert_eq!(short_id(26 + 25), "zbaa");
/// ```
#[must_use]
pub fn short_id(hash: u128) -> String {
    let mut rest = hash;
    let bases = [26, 36, 36, 36];
    let digit = |base: u128| {
        let digit = u8::try_from(rest % base).unwrap_or(0);
        rest /= base;
        char::from(if digit < 26 { b'a' + digit } else { b'0' + digit - 26 })
    };
    identifier(&bases.map(digit).iter().collect::<String>())
}
