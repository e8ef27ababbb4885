//! A picture inside another text: as an element of the page, or as the address of an image.

use std::fmt::Write as _;

use super::{Drawing, OutputError, Sheet, document, identifier};

/// The picture as an element for the middle of an HTML page, in one line, so that Markdown takes it as it is.
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
    super::super::validity::page(drawing)?;
    Ok(document(drawing, Sheet::Inside).trim_end().replace('\n', " "))
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
    let text = inline(drawing)?;
    let mut out = String::from("data:image/svg+xml;base64,");
    push_base64(&mut out, text.as_bytes());
    Ok(out)
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

/// Appends bytes by RFC 4648, section 4, with padding.
fn push_base64(out: &mut String, bytes: &[u8]) {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for chunk in bytes.chunks(3) {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for place in 0..4 {
            let letter = usize::try_from(bits >> (18 - 6 * place) & 63).unwrap_or(0);
            let _ = if place <= chunk.len() {
                out.write_char(char::from(LETTERS[letter]))
            } else {
                out.write_char('=')
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_written_as_the_rfc_has_them() {
        // Its own test vectors, section 10.
        let pairs = [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("fooba", "Zm9vYmE=")];
        for (bytes, want) in pairs {
            let mut out = String::new();
            push_base64(&mut out, bytes.as_bytes());
            assert_eq!(out, want);
        }
    }
}
