//! Moodle XML: questions whose answer is a number, for the question bank of a course.
//!
//! Each question holds its figures, as PNG, so that the one file is all that is imported. Texts are plain:
//! a site needs no filter for formulas to show them. What is written is what Moodle's own import reads, field
//! by field (`question/format/xml/format.php`, `question/format.php`).

use super::base64::base64;
use super::question::{Numerical, push_words, short, small_image};
use super::xml::Xml;
use super::{IMAGE, OutputError};
use crate::drawing::Drawing;

/// Where the files of a text lie.
const FILES: &str = "@@PLUGINFILE@@/";

/// Categories of questions, as one file.
#[derive(Debug)]
pub struct Quiz {
    /// The file so far; its root is open.
    xml: Xml,
}

impl Default for Quiz {
    fn default() -> Self {
        Self::new()
    }
}

impl Quiz {
    /// A file without questions.
    ///
    /// ```
    /// use tracefig::output::Quiz;
    /// let file = Quiz::new().finish();
    /// assert!(file.ends_with("<quiz/>\n"), "{file}");
    /// ```
    #[must_use]
    pub fn new() -> Self {
        let mut xml = Xml::default();
        xml.start("quiz");
        Self { xml }
    }

    /// Begins a category: what is added from now on belongs to it.
    ///
    /// ```
    /// use tracefig::output::Quiz;
    /// let mut quiz = Quiz::new();
    /// quiz.category("AABB/OBB");
    /// assert!(quiz.finish().contains("<text>AABB//OBB</text>"));
    /// ```
    pub fn category(&mut self, name: &str) {
        // A single slash would part a category from one within it.
        let name = kept_words(name).replace('/', "//");
        // A name that begins with a dollar sign may be one of a context; one within the top is none.
        let name = if name.starts_with('$') { format!("top/{name}") } else { name };
        self.of_type("category");
        self.worded("category", &name);
        self.xml.end();
    }

    /// Adds a question.
    ///
    /// # Errors
    /// Where a figure can't be written as an image.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, output::{Numerical, Quiz}, scene::open_text};
    /// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let scene = open_text("s.toml", text)?.scene;
    /// let plan = plan(&scene).unwrap();
    /// let figure = &draw(&plan, plan.theme, "f").drawing;
    /// let (asks, told, way) = (vec!["How wide is half of A?".into()], Vec::new(), Vec::new());
    /// let (name, solved) = ("Width".into(), figure);
    /// let mut quiz = Quiz::new();
    /// quiz.category("Boxes");
    /// let (answer, tolerance) = (1.0, 0.005);
    /// quiz.add(&Numerical { name, asks, figure, answer, tolerance, told, way, solved }).unwrap();
    /// assert!(quiz.finish().contains("<tolerance>0.005</tolerance>"));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    pub fn add(&mut self, question: &Numerical<'_>) -> Result<(), OutputError> {
        let Numerical { name, asks, figure, answer, tolerance, told, way, solved } = question;
        self.of_type("numerical");
        self.worded("name", &kept_words(name));
        self.figured("questiontext", &html(asks, &[], figure), figure)?;
        self.figured("generalfeedback", &html(told, way, solved), solved)?;
        self.element("defaultgrade", "1");
        self.element("penalty", "0.3333333");
        self.element("hidden", "0");
        self.xml.start("answer");
        self.xml.attribute("fraction", "100");
        self.element("text", &format!("{}", answer + 0.0));
        self.element("tolerance", &format!("{tolerance}"));
        self.xml.end();
        // The question says the unit: what is typed is a number alone.
        self.element("unitgradingtype", "0");
        self.element("unitpenalty", "0.1");
        self.element("showunits", "3");
        self.element("unitsleft", "0");
        self.xml.end();
        Ok(())
    }

    /// The file, whole.
    ///
    /// ```
    /// use tracefig::output::Quiz;
    /// assert!(Quiz::default().finish().starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>"));
    /// ```
    #[must_use]
    pub fn finish(self) -> String {
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}", self.xml.finish())
    }

    /// Opens an entry of the file.
    fn of_type(&mut self, kind: &str) {
        self.xml.start("question");
        self.xml.attribute("type", kind);
    }

    /// Writes an element that holds a text.
    fn element(&mut self, name: &'static str, text: &str) {
        self.xml.start(name);
        self.xml.text(text);
        self.xml.end();
    }

    /// Writes an element that holds its text in one of its own, as all do that a teacher may word.
    fn worded(&mut self, name: &'static str, text: &str) {
        self.xml.start(name);
        self.element("text", text);
        self.xml.end();
    }

    /// Writes an element of HTML with its figure.
    fn figured(&mut self, name: &'static str, html: &str, figure: &Drawing) -> Result<(), OutputError> {
        let image = small_image(figure)?;
        self.xml.start(name);
        self.xml.attribute("format", "html");
        self.element("text", html);
        self.xml.start("file");
        self.xml.attribute("name", &file_name());
        self.xml.attribute("path", "/");
        self.xml.attribute("encoding", "base64");
        self.xml.text(&base64(&image));
        self.xml.end();
        self.xml.end();
        Ok(())
    }
}

/// A name of which nothing is lost: a question bank cuts it, and takes away all that looks like an element,
/// which is all from a `<` on that no blank follows.
fn kept_words(name: &str) -> String {
    let mut parts = name.split('<');
    let mut kept = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        kept.push('<');
        if !part.starts_with(char::is_whitespace) {
            kept.push(' ');
        }
        kept.push_str(part);
    }
    short(&kept)
}

/// The name of the figure of a text, among the files of that text.
fn file_name() -> String {
    format!("figure.{}", IMAGE.name)
}

/// Paragraphs, the figure below them, and numbered steps.
fn html(paragraphs: &[String], steps: &[String], figure: &Drawing) -> String {
    let mut html = Xml::default();
    push_words(&mut html, paragraphs, steps, (figure, &format!("{FILES}{}", file_name())));
    html.finish()
}

#[cfg(test)]
mod tests {
    use super::super::question::NAME;
    use super::super::samples::everything;
    use super::*;

    #[test]
    fn any_words_stay_words_and_names_fit_their_columns() {
        let nasty = "a < b/c & \"d\" </p><script>alert(1)</script> ]]>";
        let figure = Drawing { title: nasty.into(), hash: "the answer".into(), ..everything() };
        let mut quiz = Quiz::new();
        quiz.category(nasty);
        let (asks, told, way) = (vec![nasty.to_owned()], vec![nasty.to_owned()], vec![nasty.to_owned()]);
        let (figure, solved, name) = (&figure, &figure, "n".repeat(300));
        quiz.add(&Numerical { name, asks, figure, answer: -0.0, tolerance: 5e-7, told, way, solved })
            .unwrap();
        let file = quiz.finish();
        let parsed = roxmltree::Document::parse(&file).unwrap();
        let text = |name: &str| {
            let found = parsed.descendants().rfind(|node| node.has_tag_name(name)).unwrap();
            found.descendants().filter_map(|node| node.text()).find(|text| !text.trim().is_empty()).unwrap()
        };
        let kept = "a < b/c & \"d\" < /p>< script>alert(1)< /script> ]]>";
        assert_eq!(text("category"), kept.replace('/', "//"));
        assert_eq!((text("name").len(), text("answer"), text("tolerance")), (NAME, "0", "0.0000005"));
        for (part, elements) in [("questiontext", 3), ("generalfeedback", 5)] {
            let html = format!("<div>{}</div>", text(part));
            let html = roxmltree::Document::parse(&html).unwrap();
            assert_eq!(html.descendants().filter(roxmltree::Node::is_element).count(), elements + 1);
            let words: Vec<_> = html.descendants().filter_map(|node| node.text()).collect();
            assert!(words.contains(&nasty) && html.descendants().any(|n| n.attribute("alt") == Some(nasty)));
        }
        assert!(!small_image(figure).unwrap().windows(6).any(|bytes| bytes == b"answer"));
    }

    #[test]
    fn a_category_is_no_context_and_its_name_keeps_what_follows_a_less_than() {
        let mut quiz = Quiz::new();
        quiz.category("$course$");
        quiz.category("hits at t<1");
        let file = quiz.finish();
        assert!(file.contains("<text>top/$course$</text>"), "{file}");
        assert!(file.contains("<text>hits at t&lt; 1</text>"), "{file}");
    }
}
