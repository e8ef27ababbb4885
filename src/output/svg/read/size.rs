//! How large a document may be that is read again, told from its text before anything is made of it.
//!
//! Anyone may have written the file. A parser takes some twenty times the bytes of a file of tiny elements,
//! compares all attributes of an element in pairs, and whoever walks the elements goes as deep as they are
//! nested. Each limit is far above what the largest figure has.

use super::super::super::picture::{TooMuch, Unread};

/// Bytes of a document. A figure with as many points as one may have takes some 4 MB.
const MOST_BYTES: usize = 16 << 20;
/// Elements of a document. The largest figure has one for each letter, twice where it has a halo, and one for
/// each of its lines: some 60,000.
const MOST_ELEMENTS: usize = 150_000;
/// Elements in one another, also by reference; a figure has a letter in a line of a label in a layer in a
/// panel.
pub(super) const MOST_LEVELS: usize = 24;
/// Attributes of an element; ours have up to twelve.
const MOST_ATTRIBUTES: usize = 32;
/// What is drawn, each time that it is.
pub(super) const MOST_DRAWN: usize = 200_000;

fn too_much<T>(what: &'static str, most: usize) -> Result<T, Unread> {
    Err(Unread::TooMuch(TooMuch { what, most }))
}

/// Refuses a document that is too large, or holds what we never write: declarations, comments, entities.
pub(super) fn modest(text: &str) -> Result<(), Unread> {
    if text.len() > MOST_BYTES {
        return too_much("bytes", MOST_BYTES);
    }
    let (mut elements, mut levels) = (0, 0_usize);
    let mut rest = text.split_once('<').ok_or(Unread::Other)?.1;
    loop {
        let Tag { kind, attributes, after } = tag(rest)?;
        match kind {
            Kind::Start => levels += 1,
            Kind::End => levels = levels.saturating_sub(1),
            Kind::Empty => {}
        }
        elements += usize::from(kind != Kind::End);
        if attributes > MOST_ATTRIBUTES {
            return too_much("attributes of an element", MOST_ATTRIBUTES);
        }
        if levels > MOST_LEVELS {
            return too_much("elements in one another", MOST_LEVELS);
        }
        if elements > MOST_ELEMENTS {
            return too_much("elements", MOST_ELEMENTS);
        }
        match after.split_once('<') {
            Some((_, next)) => rest = next,
            None => return Ok(()),
        }
    }
}

/// Which tag it is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// An element begins.
    Start,
    /// An element ends.
    End,
    /// An element without content.
    Empty,
}

/// A tag, from behind its `<`.
struct Tag<'t> {
    /// Which it is.
    kind: Kind,
    /// How many attributes it has.
    attributes: usize,
    /// The text behind its `>`.
    after: &'t str,
}

fn tag(text: &str) -> Result<Tag<'_>, Unread> {
    let bytes = text.as_bytes();
    if matches!(bytes.first(), Some(b'!' | b'?')) {
        return Err(Unread::Other);
    }
    let (mut at, mut attributes) = (0, 0);
    loop {
        match bytes.get(at).ok_or(Unread::Other)? {
            b'>' => break,
            &quote @ (b'"' | b'\'') => {
                let end = bytes[at + 1..].iter().position(|&b| b == quote).ok_or(Unread::Other)?;
                at += end + 2;
                attributes += 1;
            }
            _ => at += 1,
        }
    }
    let kind = match bytes {
        [b'/', ..] => Kind::End,
        _ if at > 0 && bytes[at - 1] == b'/' => Kind::Empty,
        _ => Kind::Start,
    };
    Ok(Tag { kind, attributes, after: &text[at + 1..] })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> Option<&'static str> {
        match modest(text) {
            Ok(()) => None,
            Err(Unread::Other) => Some("other"),
            Err(Unread::TooMuch(too_much)) => Some(too_much.what),
        }
    }

    fn nested(levels: usize) -> String {
        format!("{}{}", "<g a='>'>".repeat(levels), "</g>".repeat(levels))
    }

    #[test]
    fn elements_levels_and_attributes_are_counted_before_anything_is_parsed() {
        assert_eq!(refused(&nested(MOST_LEVELS)), None);
        assert_eq!(refused(&nested(MOST_LEVELS + 1)), Some("elements in one another"));
        let flat = |count: usize| format!("<svg>{}</svg>", "<g/>\n".repeat(count - 1));
        assert_eq!(refused(&flat(MOST_ELEMENTS)), None);
        assert_eq!(refused(&flat(MOST_ELEMENTS + 1)), Some("elements"));
        let wide = |count: usize| format!("<g {}/>", "a=\"'\" b='\"'".repeat(count / 2));
        assert_eq!(refused(&wide(MOST_ATTRIBUTES)), None);
        assert_eq!(refused(&wide(MOST_ATTRIBUTES + 2)), Some("attributes of an element"));
        assert_eq!(refused(&" ".repeat(MOST_BYTES + 1)), Some("bytes"));
    }

    #[test]
    fn what_we_never_write_is_not_looked_at() {
        for text in
            ["", "<", "<g", "<g a='", "<!-- <g> -->", "<?xml?>", "<g><![CDATA[x]]></g>", "<!DOCTYPE svg>"]
        {
            assert_eq!(refused(text), Some("other"), "{text}");
        }
    }
}
