//! QTI 2.1: questions whose answer is a number, as a content package that learning platforms import.
//!
//! The archive holds an item a question, the images of its figures, and a manifest. An item has the answer in
//! its declaration, where whoever scores it reads it, and the way in a feedback that stands outside of what
//! is asked; images are named by their bytes, so that no name tells what it shows.
//! Source: IMS Global, *Question and Test Interoperability: Assessment Test, Section and Item Information
//! Model*, version 2.1, 2012; *Content Packaging*, version 1.1.4, 2004.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::question::{Numerical, push_words, short, small_image};
use super::sha256::sha256;
use super::xml::Xml;
use super::zip::{Packing, Zip};
use super::{IMAGE, OutputError};
use crate::drawing::Drawing;

/// What comes before the root of a file.
const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
/// Names of what a student answers, of what is reached, and of what is then shown.
const VARIABLES: [&str; 3] = ["RESPONSE", "SCORE", "FEEDBACK"];
/// The name of the feedback with the way.
const WAY: &str = "WAY";
/// Bytes of a hash that make a name: 64 bits, of which no two questions of a course share all.
const NAME_BYTES: usize = 8;
/// Characters that fit into the field of an answer: a sign, three digits, a point and more.
const ANSWER: &str = "12";

/// Questions as items of one package.
#[derive(Debug, Default)]
pub struct ItemPackage {
    /// The archive so far.
    zip: Zip,
    /// The names of the files in it.
    names: BTreeSet<String>,
    /// The items: the name of each, and its files, the item first.
    items: Vec<(String, Vec<String>)>,
}

impl ItemPackage {
    /// Adds a question.
    ///
    /// # Errors
    /// Where a figure can't be written as an image, or there are more files than an archive holds.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, output::{ItemPackage, Numerical}, scene::open_text};
    /// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let scene = open_text("s.toml", text)?.scene;
    /// let plan = plan(&scene).unwrap();
    /// let figure = &draw(&plan, plan.theme, "f").drawing;
    /// let (asks, told, way) = (vec!["How wide is half of A?".into()], Vec::new(), Vec::new());
    /// let (name, answer, tolerance) = ("Width".into(), 1.0, 0.005);
    /// let mut package = ItemPackage::default();
    /// package.add(&Numerical { name, asks, figure, answer, tolerance, told, way, solved: figure }).unwrap();
    /// assert!(package.finish().unwrap().starts_with(b"PK"));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    pub fn add(&mut self, question: &Numerical<'_>) -> Result<(), OutputError> {
        let figures = [question.figure, question.solved];
        let mut images = Vec::new();
        for figure in figures {
            images.push(self.image(figure)?);
        }
        let [asked, solved] = &images[..] else { return Ok(()) };
        let of_question = [&question.name, &question.asks.join("\n"), asked].map(String::as_str).join("\n");
        let name = self.free_name(&format!("q{}", hash(of_question.as_bytes())));
        let item = DECLARATION.to_owned() + &item(&name, question, [asked, solved]);
        let file = format!("{name}.xml");
        self.zip.add(&file, item.as_bytes(), Packing::Shorter)?;
        let mut files = vec![file, asked.clone(), solved.clone()];
        files.dedup();
        self.items.push((name, files));
        Ok(())
    }

    /// The package, whole.
    ///
    /// # Errors
    /// Where it is larger than an archive may be.
    ///
    /// ```
    /// use tracefig::output::ItemPackage;
    /// assert!(ItemPackage::default().finish().unwrap().windows(11).any(|part| part == b"imsmanifest"));
    /// ```
    pub fn finish(mut self) -> Result<Vec<u8>, OutputError> {
        let manifest = DECLARATION.to_owned() + &manifest(&self.items);
        self.zip.add("imsmanifest.xml", manifest.as_bytes(), Packing::Shorter)?;
        self.zip.finish()
    }

    /// The name of the file of a figure, which is added where it is not there.
    fn image(&mut self, figure: &Drawing) -> Result<String, OutputError> {
        let bytes = small_image(figure)?;
        let name = format!("{}.{}", hash(&bytes), IMAGE.name);
        if self.names.insert(name.clone()) {
            self.zip.add(&name, &bytes, Packing::Shorter)?;
        }
        Ok(name)
    }

    /// A name that no item has.
    fn free_name(&mut self, wanted: &str) -> String {
        let (mut name, mut count) = (wanted.to_owned(), 1);
        while !self.names.insert(name.clone()) {
            count += 1;
            name = format!("{wanted}-{count}");
        }
        name
    }
}

/// The beginning of a hash, in digits.
fn hash(bytes: &[u8]) -> String {
    sha256(bytes)[..NAME_BYTES].iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// Opens an element with attributes.
fn open(xml: &mut Xml, name: &'static str, attributes: &[(&str, &str)]) {
    xml.start(name);
    for (name, value) in attributes {
        xml.attribute(name, value);
    }
}

/// Writes an element with attributes and a text.
fn leaf(xml: &mut Xml, name: &'static str, attributes: &[(&str, &str)], text: &str) {
    open(xml, name, attributes);
    if !text.is_empty() {
        xml.text(text);
    }
    xml.end();
}

/// Opens the declaration of a variable of one value.
fn declare(xml: &mut Xml, element: &'static str, name: &str, base: &str) {
    open(xml, element, &[("identifier", name), ("cardinality", "single"), ("baseType", base)]);
}

/// An item: what is declared, asked, scored, and told afterwards.
fn item(name: &str, question: &Numerical<'_>, [asked, solved]: [&str; 2]) -> String {
    let [response, score, feedback] = VARIABLES;
    let Numerical { name: title, asks, figure, answer, tolerance, told, way, solved: key } = question;
    let mut xml = Xml::default();
    let fixed = [("adaptive", "false"), ("timeDependent", "false"), ("toolName", "tracefig")];
    open(&mut xml, "assessmentItem", &[("xmlns", "http://www.imsglobal.org/xsd/imsqti_v2p1")]);
    for (name, value) in [("identifier", name), ("title", &short(title))].into_iter().chain(fixed) {
        xml.attribute(name, value);
    }
    declare(&mut xml, "responseDeclaration", response, "float");
    xml.start("correctResponse");
    leaf(&mut xml, "value", &[], &format!("{}", answer + 0.0));
    xml.end();
    xml.end();
    declare(&mut xml, "outcomeDeclaration", score, "float");
    xml.attribute("normalMaximum", "1");
    xml.start("defaultValue");
    leaf(&mut xml, "value", &[], "0");
    xml.end();
    xml.end();
    declare(&mut xml, "outcomeDeclaration", feedback, "identifier");
    xml.end();
    xml.start("itemBody");
    push_words(&mut xml, asks, &[], (figure, asked));
    xml.start("p");
    leaf(
        &mut xml,
        "textEntryInteraction",
        &[("responseIdentifier", response), ("expectedLength", ANSWER)],
        "",
    );
    xml.end();
    xml.end();
    processing(&mut xml, *tolerance);
    let shown = [("outcomeIdentifier", feedback), ("identifier", WAY), ("showHide", "show")];
    open(&mut xml, "modalFeedback", &shown);
    push_words(&mut xml, told, way, (key, solved));
    xml.finish()
}

/// How an answer is scored: right within the tolerance. Whatever it is, the way is shown.
fn processing(xml: &mut Xml, tolerance: f64) {
    let [response, score, feedback] = VARIABLES;
    xml.start("responseProcessing");
    xml.start("responseCondition");
    xml.start("responseIf");
    let within = [("toleranceMode", "absolute"), ("tolerance", &format!("{tolerance}"))];
    open(xml, "equal", &within);
    leaf(xml, "variable", &[("identifier", response)], "");
    leaf(xml, "correct", &[("identifier", response)], "");
    xml.end();
    open(xml, "setOutcomeValue", &[("identifier", score)]);
    leaf(xml, "baseValue", &[("baseType", "float")], "1");
    (0..3).for_each(|_| xml.end());
    open(xml, "setOutcomeValue", &[("identifier", feedback)]);
    leaf(xml, "baseValue", &[("baseType", "identifier")], WAY);
    xml.end();
    xml.end();
}

/// What the package holds: each item with its files.
fn manifest(items: &[(String, Vec<String>)]) -> String {
    let mut xml = Xml::default();
    let space = "http://www.imsglobal.org/xsd/imscp_v1p1";
    open(&mut xml, "manifest", &[("xmlns", space), ("identifier", "tracefig")]);
    xml.start("metadata");
    leaf(&mut xml, "schema", &[], "QTIv2.1 Package");
    leaf(&mut xml, "schemaversion", &[], "1.0.0");
    xml.end();
    leaf(&mut xml, "organizations", &[], "");
    xml.start("resources");
    for (name, files) in items {
        let [item, ..] = &files[..] else { continue };
        open(&mut xml, "resource", &[("identifier", name), ("type", "imsqti_item_xmlv2p1"), ("href", item)]);
        for file in files {
            leaf(&mut xml, "file", &[("href", file)], "");
        }
        xml.end();
    }
    xml.finish()
}
