//! From a file, a stream or a text to a checked scene, or to everything that is wrong with it.

use std::fmt;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::explain::Explain;
use super::limits::MAX_FILE_BYTES;
use super::meaning::meaning;
use super::message::{Ink, Severity, message_at};
use super::node::Node;
use super::problem::{Fault, Problem};
use super::read::from_tree;
use super::source::{Source, Syntax};
use super::{Scene, json};

/// A scene and the text that it was read from.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// The text, for messages about later problems.
    pub source: Source,
    /// What it says.
    pub scene: Scene,
    /// What it says as one text, the same however the file is written: comments, blanks, the order of keys
    /// and the language are not in it, nor is what is not read, as the `id`.
    pub meaning: String,
    /// The values as they were read.
    pub(super) tree: Node,
}

impl SceneFile {
    /// What the file says, as JSON, keys in its order; with the page of its project, where it was given one.
    ///
    /// ```
    /// let text = "query = { kind = 'bounds', of = ['A'] }\nshapes.A = { kind = 'circle', radius = 2 }";
    /// let json = tracefig::scene::open_text("s.toml", text)?.json();
    /// assert!(json.starts_with(r#"{"query":{"kind":"bounds","of":["A"]},"shapes":{"A":{"kind":"circle","#));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    #[must_use]
    pub fn json(&self) -> String {
        self.json_value().to_string()
    }

    /// What the file says, as a JSON value.
    pub(crate) fn json_value(&self) -> serde_json::Value {
        json::value(&self.tree)
    }
}

/// A scene that can't be answered or drawn, with all the reasons.
#[derive(Clone, Debug)]
pub struct Refused<F = Fault> {
    /// The text, as far as it could be read.
    pub source: Source,
    /// What is wrong, in the order of the text; at least one.
    pub problems: Vec<Problem<F>>,
}

impl<F: Explain> Refused<F> {
    /// All messages, a blank line between two; each quotes the line at fault.
    ///
    /// ```
    /// use tracefig::scene::{Ink, open_text};
    /// let refused = open_text("s.toml", "title = 1").unwrap_err();
    /// let text = refused.render(Ink::Plain);
    /// assert!(text.starts_with("error[missing-key]: the scene lacks `shapes`"), "{text}");
    /// assert!(text.contains("1 | title = 1"), "{text}");
    /// ```
    #[must_use]
    pub fn render(&self, ink: Ink) -> String {
        // One reading for the pointers of all.
        let root = match self.source.syntax {
            Syntax::Json => self.source.tree().ok(),
            Syntax::Toml => None,
        };
        let messages: Vec<_> = self
            .problems
            .iter()
            .map(|p| {
                let pointer = root.as_ref().map(|root| json::pointer(root, p.span.start));
                message_at(&self.source, p, pointer, Severity::Error, ink)
            })
            .collect();
        messages.join("\n")
    }
}

/// All that is wrong with a scene that a program made of values, as one error: it quotes no text.
///
/// ```
/// use tracefig::{collision::QueryKind, figure, scene::{Refused, Scene}};
/// fn figure_of(scene: &Scene) -> Result<figure::Figure, Box<dyn std::error::Error>> {
///     let plan = figure::plan(scene).map_err(Refused::from)?;
///     Ok(figure::draw(&plan, plan.theme, "figure"))
/// }
/// let refused = Scene::asking(QueryKind::Separation, &[]).map_err(Refused::from).unwrap_err();
/// assert_eq!(refused.to_string(), "error[wrong-count]: `of`: a `separation` query is of two shapes, got 0");
/// ```
impl<F> From<Vec<Problem<F>>> for Refused<F> {
    fn from(problems: Vec<Problem<F>>) -> Self {
        Self { source: Source::new("", ""), problems }
    }
}

impl<F: Explain> fmt::Display for Refused<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.render(Ink::Plain).trim_end())
    }
}

impl<F: Explain + fmt::Debug> std::error::Error for Refused<F> {}

/// Reads a scene file; TOML, unless its first character is `{`.
///
/// # Errors
/// When the file can't be read, is too large, is no UTF-8, or is no scene.
///
/// ```
/// let refused = tracefig::scene::open("no/such.toml".as_ref()).unwrap_err();
/// assert_eq!(refused.problems[0].fault.code(), "unreadable-file");
/// assert!(refused.to_string().contains("--> no/such.toml"));
/// ```
pub fn open(path: &Path) -> Result<SceneFile, Box<Refused>> {
    let name = path.display().to_string();
    match File::open(path) {
        Ok(file) => {
            // What has no length, as a pipe, is read to the limit.
            let length = file.metadata().map_or(0, |place| if place.is_file() { place.len() } else { 0 });
            match usize::try_from(length) {
                Ok(got) if got > MAX_FILE_BYTES => Err(Box::new(refuse(&name, too_long(got)))),
                _ => open_reader(&name, file),
            }
        }
        Err(error) => Err(Box::new(refuse(&name, Fault::Unreadable { reason: error.to_string() }))),
    }
}

/// Reads a scene from a stream, as standard input; `name` is what messages call it.
///
/// # Errors
/// When it can't be read to its end, is too large, is no UTF-8, or is no scene.
///
/// ```
/// let refused = tracefig::scene::open_reader("<stdin>", &b"\xff"[..]).unwrap_err();
/// assert_eq!(refused.problems[0].fault.code(), "not-utf8");
/// let refused = tracefig::scene::open_reader("<stdin>", std::io::repeat(b' ')).unwrap_err();
/// assert_eq!(refused.problems[0].fault.code(), "over-limit");
/// ```
pub fn open_reader(name: &str, reader: impl Read) -> Result<SceneFile, Box<Refused>> {
    let mut bytes = Vec::new();
    if let Err(error) = reader.take(MAX_FILE_BYTES as u64 + 1).read_to_end(&mut bytes) {
        return Err(Box::new(refuse(name, Fault::Unreadable { reason: error.to_string() })));
    }
    if bytes.len() > MAX_FILE_BYTES {
        return Err(Box::new(refuse(name, Fault::Endless { limit: MAX_FILE_BYTES, unit: "bytes" })));
    }
    match String::from_utf8(bytes) {
        Ok(text) => open_text(name, &text),
        Err(error) => {
            // The text up to the first byte that is none, so that the place can be counted and quoted.
            let valid = error.utf8_error().valid_up_to();
            let text = String::from_utf8_lossy(&error.as_bytes()[..valid]).into_owned();
            let problem = Problem::new(Fault::NotUtf8, valid..valid);
            Err(Box::new(Refused { source: Source::new(name, &text), problems: vec![problem] }))
        }
    }
}

/// Reads a scene from a text; `name` is what messages call it.
///
/// # Errors
/// When it is no scene: with all that is wrong, in the order of the text.
///
/// ```
/// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
/// assert_eq!(tracefig::scene::open_text("s.toml", text)?.scene.shapes().len(), 1);
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
pub fn open_text(name: &str, text: &str) -> Result<SceneFile, Box<Refused>> {
    let source = Source::new(name, text.strip_prefix('\u{feff}').unwrap_or(text));
    checked(source, Source::tree)
}

/// A source with the scene that its tree says.
pub(super) fn checked(
    source: Source,
    tree: impl FnOnce(&Source) -> Result<Node, Vec<Problem>>,
) -> Result<SceneFile, Box<Refused>> {
    match tree(&source).and_then(|root| Ok((from_tree(&root)?, meaning(&root), root))) {
        Ok((scene, meaning, tree)) => Ok(SceneFile { source, scene, meaning, tree }),
        Err(problems) => Err(Box::new(Refused { source, problems })),
    }
}

fn too_long(got: usize) -> Fault {
    Fault::OverLimit { what: "the file".to_owned(), limit: MAX_FILE_BYTES, unit: "bytes", got }
}

fn refuse(name: &str, fault: Fault) -> Refused {
    Refused { source: Source::new(name, ""), problems: vec![Problem::new(fault, 0..0)] }
}
