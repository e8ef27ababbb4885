//! XML elements with everything escaped that must be.
//!
//! Text from a scene can't leave its place: `& < >`, and in attributes `" '`, become references, and a
//! character that XML 1.0 or HTML forbids, a control character or none at all, becomes U+FFFD.

/// A document being written.
#[derive(Debug, Default)]
pub(super) struct Xml {
    /// Text so far.
    out: String,
    /// Names of the elements that are open, outer ones first.
    open: Vec<&'static str>,
    /// Whether the last start tag still takes attributes.
    in_tag: bool,
}

impl Xml {
    /// An empty document with room for some bytes.
    pub(super) fn with_capacity(bytes: usize) -> Self {
        Self { out: String::with_capacity(bytes), ..Self::default() }
    }

    /// Opens an element on a new line, inside the one that is open.
    pub(super) fn start(&mut self, name: &'static str) {
        self.end_tag();
        self.out.push_str(if self.out.is_empty() { "<" } else { "\n<" });
        self.out.push_str(name);
        self.open.push(name);
        self.in_tag = true;
    }

    /// Closes the element that was opened last; does nothing where none is open.
    pub(super) fn end(&mut self) {
        let Some(name) = self.open.pop() else { return };
        if self.in_tag {
            self.out.push_str("/>");
            self.in_tag = false;
        } else {
            self.out.push_str("</");
            self.out.push_str(name);
            self.out.push('>');
        }
    }

    /// Gives the element just opened an attribute with any text.
    pub(super) fn attribute(&mut self, name: &str, value: &str) {
        self.attribute_by(name, |out| escape_attribute(out, value));
    }

    /// Gives the element just opened an attribute whose value `write` appends; it must need no escaping.
    pub(super) fn attribute_by(&mut self, name: &str, write: impl FnOnce(&mut String)) {
        self.out.push(' ');
        self.out.push_str(name);
        self.out.push_str("=\"");
        write(&mut self.out);
        self.out.push('"');
    }

    /// Gives the element just opened a number as attribute, rounded to hundredths.
    pub(super) fn number(&mut self, name: &str, value: f64) {
        self.attribute_by(name, |out| super::number::push(out, value));
    }

    /// Writes text inside the element that is open.
    pub(super) fn text(&mut self, text: &str) {
        self.end_tag();
        escape(&mut self.out, text);
    }

    /// Writes an element inside the one that is open, given whole; nothing where the text is empty.
    pub(super) fn element(&mut self, text: &str) {
        let text = text.trim_end();
        if !text.is_empty() {
            self.end_tag();
            self.out.push('\n');
            self.out.push_str(text);
        }
    }

    /// Closes what is open, and gives the document.
    pub(super) fn finish(mut self) -> String {
        while !self.open.is_empty() {
            self.end();
        }
        self.out.push('\n');
        self.out
    }

    /// Ends the start tag of the element that is open: content follows.
    fn end_tag(&mut self) {
        if self.in_tag {
            self.out.push('>');
            self.in_tag = false;
        }
    }
}

/// Appends `text`, escaped for content: quotes stay, of which metadata has many.
pub(super) fn escape(out: &mut String, text: &str) {
    escape_in(out, text, true);
}

/// Appends `text`, escaped for an attribute in quotes.
fn escape_attribute(out: &mut String, text: &str) {
    escape_in(out, text, false);
}

/// Appends `text`, escaped, where quotes stay or don't.
///
/// Nearly all of it stands as it is: a stretch of that is appended at once.
fn escape_in(out: &mut String, mut text: &str, quotes_stay: bool) {
    let is_plain = |byte| match byte {
        b'"' | b'\'' => quotes_stay,
        b'&' | b'<' | b'>' => false,
        _ => matches!(byte, b'\t' | b'\n' | b'\r' | b' '..=b'~'),
    };
    while let Some(at) = text.bytes().position(|byte| !is_plain(byte)) {
        out.push_str(&text[..at]);
        let mut rest = text[at..].chars();
        if let Some(character) = rest.next() {
            push_reference(out, character);
        }
        text = rest.as_str();
    }
    out.push_str(text);
}

/// Appends a character that may not stand as it is.
fn push_reference(out: &mut String, character: char) {
    match character {
        '&' => out.push_str("&amp;"),
        '<' => out.push_str("&lt;"),
        '>' => out.push_str("&gt;"),
        '"' => out.push_str("&quot;"),
        '\'' => out.push_str("&#39;"),
        '\u{0}'..='\u{8}'
        | '\u{B}'
        | '\u{C}'
        | '\u{E}'..='\u{1F}'
        | '\u{7F}'..='\u{9F}'
        | '\u{FDD0}'..='\u{FDEF}' => out.push('\u{FFFD}'),
        _ if u32::from(character) & 0xFFFE == 0xFFFE => out.push('\u{FFFD}'),
        _ => out.push(character),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_text_comes_back_from_a_parser_and_stays_text() {
        let nasty = "]]> </desc><script>alert(\"1\")</script> & 'x' &lt; \u{1}\u{85}\u{1fffe}";
        let mut xml = Xml::default();
        xml.start("g");
        xml.attribute("label", nasty);
        xml.text(nasty);
        let document = xml.finish();
        let parsed = roxmltree::Document::parse(&document).unwrap();
        let expected = nasty.replace(['\u{1}', '\u{85}', '\u{1fffe}'], "\u{FFFD}");
        assert_eq!(parsed.root_element().attribute("label"), Some(expected.as_str()));
        assert_eq!(parsed.root_element().text().map(str::trim_end), Some(expected.as_str()));
        assert_eq!(parsed.root_element().children().filter(roxmltree::Node::is_element).count(), 0);
    }
}
