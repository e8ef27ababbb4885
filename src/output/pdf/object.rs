//! The numbered objects of a PDF file, and the table that says where each begins.
//!
//! Source: ISO 32000-1:2008, sections 7.3 and 7.5.

use std::fmt::Write;

/// Objects in the order of their numbers, which begin at 1.
pub(super) struct Objects {
    bodies: Vec<String>,
}

impl Objects {
    pub(super) fn new() -> Self {
        Self { bodies: Vec::new() }
    }

    /// The number of an object that is set later.
    pub(super) fn reserve(&mut self) -> usize {
        self.bodies.push(String::new());
        self.bodies.len()
    }

    /// Sets a reserved object.
    pub(super) fn set(&mut self, number: usize, body: &str) {
        if let Some(slot) = self.bodies.get_mut(number - 1) {
            body.clone_into(slot);
        }
    }

    /// A stream whose dictionary has these entries besides its length.
    pub(super) fn stream(&mut self, entries: &str, content: &str) -> usize {
        let length = content.len();
        self.bodies.push(format!("<<{entries}/Length {length}>>\nstream\n{content}\nendstream"));
        self.bodies.len()
    }

    /// A form: a piece of content that is drawn by its name.
    pub(super) fn form(&mut self, bounds: &str, entries: &str, content: &str) -> usize {
        self.stream(&format!("/Type /XObject /Subtype /Form /BBox {bounds} {entries}"), content)
    }

    /// Title and description of the document.
    pub(super) fn info(&mut self, title: &str, subject: &str) -> usize {
        self.bodies.push(format!(
            "<</Title {} /Subject {} /Creator (tracefig)>>",
            text_string(title),
            text_string(subject)
        ));
        self.bodies.len()
    }

    /// The file.
    pub(super) fn finish(self, catalog: usize, info: usize) -> Vec<u8> {
        let mut out = String::from("%PDF-1.7\n");
        let mut table = String::from("0000000000 65535 f \n");
        for (i, body) in self.bodies.iter().enumerate() {
            // Writing to a string can't fail.
            let _ = writeln!(table, "{:010} 00000 n ", out.len());
            let _ = write!(out, "{} 0 obj\n{body}\nendobj\n", i + 1);
        }
        let (start, size) = (out.len(), self.bodies.len() + 1);
        let _ = write!(out, "xref\n0 {size}\n{table}");
        let _ = write!(out, "trailer\n<</Size {size} /Root {catalog} 0 R /Info {info} 0 R>>\n");
        let _ = write!(out, "startxref\n{start}\n%%EOF\n");
        out.into_bytes()
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
        let mut objects = Objects::new();
        let catalog = objects.reserve();
        let info = objects.info("(a) \\ é", "");
        objects.set(catalog, "<</Type /Catalog>>");
        let file = String::from_utf8(objects.finish(catalog, info)).unwrap();
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
