//! The numbered objects of a PDF file, and the table that says where each begins.
//!
//! Source: ISO 32000-1:2008, sections 7.3 and 7.5.

use std::fmt::Write;

use super::flate;

/// What the dictionary of a compressed stream says.
const FILTER: &str = "/Filter /FlateDecode ";

/// Objects in the order of their numbers, which begin at 1.
pub(super) struct Objects {
    bodies: Vec<Vec<u8>>,
    packing: Packing,
}

/// How streams are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    /// Compressed, where that is shorter.
    Deflated,
    /// As text.
    #[cfg(test)]
    Plain,
}

impl Objects {
    pub(super) fn new(packing: Packing) -> Self {
        Self { bodies: Vec::new(), packing }
    }

    /// The number of an object that is set later.
    pub(super) fn reserve(&mut self) -> usize {
        self.bodies.push(Vec::new());
        self.bodies.len()
    }

    /// Sets a reserved object.
    pub(super) fn set(&mut self, number: usize, body: &str) {
        if let Some(slot) = self.bodies.get_mut(number - 1) {
            body.as_bytes().clone_into(slot);
        }
    }

    /// A stream whose dictionary has these entries besides its length.
    pub(super) fn stream(&mut self, entries: &str, content: &str) -> usize {
        let packed = match self.packing {
            Packing::Deflated if content.is_empty() => None,
            Packing::Deflated => Some(flate::compress(content.as_bytes())),
            #[cfg(test)]
            Packing::Plain => None,
        };
        let packed = packed.filter(|p| p.len() + FILTER.len() < content.len());
        let (filter, data) = packed.as_deref().map_or(("", content.as_bytes()), |packed| (FILTER, packed));
        let mut body = format!("<<{entries}{filter}/Length {}>>\nstream\n", data.len()).into_bytes();
        body.extend_from_slice(data);
        body.extend_from_slice(b"\nendstream");
        self.bodies.push(body);
        self.bodies.len()
    }

    /// A form: a piece of content that is drawn by its name.
    pub(super) fn form(&mut self, bounds: &str, entries: &str, content: &str) -> usize {
        self.stream(&format!("/Type /XObject /Subtype /Form /BBox {bounds} {entries}"), content)
    }

    /// Title and description of the document.
    pub(super) fn info(&mut self, title: &str, subject: &str) -> usize {
        let (title, subject) = (text_string(title), text_string(subject));
        self.bodies.push(format!("<</Title {title} /Subject {subject} /Creator (tracefig)>>").into_bytes());
        self.bodies.len()
    }

    /// The file.
    pub(super) fn finish(self, catalog: usize, info: usize) -> Vec<u8> {
        // A comment of bytes beyond ASCII tells programs that the file is not text.
        let mut out = b"%PDF-1.7\n%\xE2\xE3\xCF\xD3\n".to_vec();
        let mut table = String::from("0000000000 65535 f \n");
        for (i, body) in self.bodies.iter().enumerate() {
            // Writing to a string can't fail.
            let _ = writeln!(table, "{:010} 00000 n ", out.len());
            out.extend_from_slice(format!("{} 0 obj\n", i + 1).as_bytes());
            out.extend_from_slice(body);
            out.extend_from_slice(b"\nendobj\n");
        }
        let (start, size) = (out.len(), self.bodies.len() + 1);
        let mut end = format!("xref\n0 {size}\n{table}");
        let _ = write!(end, "trailer\n<</Size {size} /Root {catalog} 0 R /Info {info} 0 R>>\n");
        let _ = write!(end, "startxref\n{start}\n%%EOF\n");
        out.extend_from_slice(end.as_bytes());
        out
    }
}

/// Any text, as UTF-16 in hexadecimal digits: nothing in it can end the string.
fn text_string(text: &str) -> String {
    let mut out = String::from("<FEFF");
    for unit in text.encode_utf16() {
        let _ = write!(out, "{unit:04X}");
    }
    out.push('>');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_says_where_each_object_begins() {
        let mut objects = Objects::new(Packing::Plain);
        let catalog = objects.reserve();
        let info = objects.info("(a) \\ é", "");
        objects.set(catalog, "<</Type /Catalog>>");
        let file = objects.finish(catalog, info);
        // One character a byte.
        let file: String = file.into_iter().map(|b| if b.is_ascii() { char::from(b) } else { '?' }).collect();
        let table = file.split("xref\n0 3\n").nth(1).unwrap();
        for number in 1..=2 {
            let entry = table.lines().nth(number).unwrap();
            let offset: usize = entry[..10].parse().unwrap();
            assert!(file[offset..].starts_with(&format!("{number} 0 obj")));
            assert_eq!(entry.len(), 19, "with its end of line, twenty bytes");
        }
        let start: usize = file.lines().rev().nth(1).unwrap().parse().unwrap();
        assert!(file[start..].starts_with("xref"));
        assert!(file.contains("<FEFF00280061002900200"));
    }
}
