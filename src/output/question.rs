//! A question whose answer is a number, as banks of questions keep it: its words, and where its figures lie.

use super::embedded::image;
use super::xml::Xml;
use super::{Options, OutputError, PngEffort};
use crate::drawing::Drawing;

/// Characters of a name; the columns of question banks hold 255.
pub(super) const NAME: usize = 200;

/// A question whose answer is a number, in plain words.
#[derive(Clone, Debug)]
pub struct Numerical<'d> {
    /// What the teacher finds it by.
    pub name: String,
    /// What is given and asked, a paragraph each.
    pub asks: Vec<String>,
    /// The figure below the question; it must not show the answer.
    pub figure: &'d Drawing,
    /// The answer.
    pub answer: f64,
    /// How far from the answer a number may lie that counts as right.
    pub tolerance: f64,
    /// What the student reads after the answer, a paragraph each.
    pub told: Vec<String>,
    /// The way to the answer, step by step.
    pub way: Vec<String>,
    /// The figure that shows the answer.
    pub solved: &'d Drawing,
}

/// Cuts a name to what a question bank keeps.
pub(super) fn short(name: &str) -> String {
    name.chars().take(NAME).collect()
}

/// A figure as an image that says nothing of itself, in few bytes.
pub(super) fn small_image(figure: &Drawing) -> Result<Vec<u8>, OutputError> {
    image(figure, &Options { png: PngEffort::Small, ..Options::default() })
}

/// Writes paragraphs, the figure below them by its address, and numbered steps.
pub(super) fn push_words(html: &mut Xml, paragraphs: &[String], steps: &[String], image: (&Drawing, &str)) {
    for paragraph in paragraphs {
        html.start("p");
        html.text(paragraph);
        html.end();
    }
    let (figure, address) = image;
    html.start("p");
    html.start("img");
    html.attribute("src", address);
    html.attribute("alt", &figure.title);
    html.attribute("class", "img-fluid");
    html.number("width", figure.width.round());
    html.number("height", figure.height.round());
    html.end();
    html.end();
    if !steps.is_empty() {
        html.start("ol");
        for step in steps {
            html.start("li");
            html.text(step);
            html.end();
        }
        html.end();
    }
}
