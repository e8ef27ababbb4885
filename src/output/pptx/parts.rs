//! The parts of a presentation: what kind each is, and which it refers to.
//!
//! Source: ECMA-376-2:2021, *Open Packaging Conventions*, sections 7 and 10.

use super::super::OutputError;
use super::super::xml::Xml;
use super::super::zip::{Packing, Zip};

/// What comes before the root of a part.
pub(super) const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
/// What kinds of relations begin with.
const RELATIONS: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";

/// A reference of one part to another.
#[derive(Clone, Debug)]
pub(super) struct Relation {
    /// The name by which the part refers to it.
    pub(super) id: String,
    /// The kind of relation.
    kind: String,
    /// The other part, as seen from the folder of this one.
    target: String,
}

/// References of one part, named by their numbers from 1 on.
pub(super) fn relations<T: AsRef<str>>(all: impl IntoIterator<Item = (&'static str, T)>) -> Vec<Relation> {
    let relation = |(number, (kind, target)): (usize, (&str, T))| Relation {
        id: format!("rId{number}"),
        // Some kinds are of packages of all sorts, and are named whole.
        kind: if kind.contains(':') { kind.to_owned() } else { format!("{RELATIONS}{kind}") },
        target: target.as_ref().to_owned(),
    };
    (1..).zip(all).map(relation).collect()
}

/// A package being written.
#[derive(Default)]
pub(super) struct Package {
    /// Its files so far.
    zip: Zip,
    /// The parts and their kinds.
    kinds: Vec<(String, String)>,
}

impl Package {
    /// Adds a part of XML, of a kind, with its references.
    pub(super) fn part(
        &mut self,
        name: &str,
        kind: &str,
        content: &str,
        relations: &[Relation],
    ) -> Result<(), OutputError> {
        self.kinds.push((format!("/{name}"), kind.to_owned()));
        self.zip.add(name, content.as_bytes(), Packing::Shorter)?;
        self.references(name, relations)
    }

    /// Adds a part that is found in the file as it is.
    pub(super) fn plain(&mut self, name: &str, kind: &str, content: &str) -> Result<(), OutputError> {
        self.kinds.push((format!("/{name}"), kind.to_owned()));
        self.zip.add(name, content.as_bytes(), Packing::Plain)
    }

    /// Adds a file whose kind its ending says.
    pub(super) fn file(&mut self, name: &str, content: &[u8]) -> Result<(), OutputError> {
        self.zip.add(name, content, Packing::Shorter)
    }

    /// Adds what a part refers to; the name of the whole package is empty.
    pub(super) fn references(&mut self, name: &str, relations: &[Relation]) -> Result<(), OutputError> {
        if relations.is_empty() {
            return Ok(());
        }
        let (folder, file) = name.rsplit_once('/').map_or(("", name), |(folder, file)| (folder, file));
        let slash = if folder.is_empty() { "" } else { "/" };
        let mut xml = Xml::default();
        xml.start("Relationships");
        xml.attribute("xmlns", "http://schemas.openxmlformats.org/package/2006/relationships");
        for Relation { id, kind, target } in relations {
            xml.start("Relationship");
            xml.attribute("Id", id);
            xml.attribute("Type", kind);
            xml.attribute("Target", target);
            xml.end();
        }
        let text = format!("{DECLARATION}{}", xml.finish());
        self.zip.add(&format!("{folder}{slash}_rels/{file}.rels"), text.as_bytes(), Packing::Shorter)
    }

    /// The package, whole; files with these endings are of these kinds.
    pub(super) fn finish(mut self, endings: &[(&str, &str)]) -> Result<Vec<u8>, OutputError> {
        let mut xml = Xml::default();
        xml.start("Types");
        xml.attribute("xmlns", "http://schemas.openxmlformats.org/package/2006/content-types");
        for (ending, kind) in endings {
            xml.start("Default");
            xml.attribute("Extension", ending);
            xml.attribute("ContentType", kind);
            xml.end();
        }
        for (part, kind) in &self.kinds {
            xml.start("Override");
            xml.attribute("PartName", part);
            xml.attribute("ContentType", kind);
            xml.end();
        }
        let text = format!("{DECLARATION}{}", xml.finish());
        self.zip.add("[Content_Types].xml", text.as_bytes(), Packing::Shorter)?;
        self.zip.finish()
    }
}
