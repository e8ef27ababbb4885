//! The project file `tracefig.toml`: which scenes a folder has, how they are drawn, and canvas defaults.
//!
//! Read as a scene is, by a table of rows: an unknown key, a wrong type and a number out of range are told
//! with line and nearest word. Formats and themes stay words with their place, as no scene knows those.

use super::checked::{Checked, as_list, as_text, check};
use super::exercise::Variant;
use super::fields::CANVAS;
use super::node::{Node, NodeValue};
use super::open::{SceneFile, checked};
use super::problem::{Fault, Problem, Problems};
use super::project_fields::{HANDOUT, PROJECT, RENDER};
use super::source::Source;
use super::{Refused, Spanned, toml};

/// Name of a project file.
pub const PROJECT_FILE: &str = "tracefig.toml";

/// What a project file says. Paths are as written: relative to the folder of the file.
#[derive(Clone, Debug, Default)]
pub struct Project {
    /// Scene files, and folders that are searched for them; empty where it does not say.
    pub scenes: Vec<Spanned<String>>,
    /// The folder that figures go to; beside each scene where it is `None`.
    pub output: Option<Spanned<String>>,
    /// Words for the formats that are written; empty where it does not say.
    pub formats: Vec<Spanned<String>>,
    /// Words for the themes, or theme files; empty where it does not say.
    pub themes: Vec<Spanned<String>>,
    /// Dots of an image for each page pixel.
    pub scale: Option<Spanned<f64>>,
    /// What the steps of a figure become, one of [`STEP_FILES`](super::STEP_FILES); the finished figure alone
    /// where it is `None`.
    pub steps: Option<String>,
    /// Documents of several figures.
    pub handouts: Vec<DeclaredHandout>,
    /// The page of scenes that do not say otherwise.
    pub canvas: CanvasDefaults,
}

/// A document of several figures that a project keeps. Its paths are as written, as those of the project.
#[derive(Clone, Debug)]
pub struct DeclaredHandout {
    /// The document.
    pub file: Spanned<String>,
    /// What is on it, files and folders; empty where it does not say.
    pub scenes: Vec<Spanned<String>>,
    /// The word for its theme, or a theme file.
    pub theme: Option<Spanned<String>>,
    /// What is drawn of exercises; empty where figures are.
    pub variants: Vec<Variant>,
    /// Numbers of variants of exercises, each one or a range; empty for the scenes themselves.
    pub seeds: Vec<Spanned<String>>,
    /// Figures on a sheet.
    pub per_page: Option<Spanned<usize>>,
    /// The word for its paper.
    pub paper: Option<Spanned<String>>,
    /// Whether each figure has its number below it.
    pub numbers: Option<Spanned<bool>>,
    /// Words above the figures of its first sheet.
    pub heading: Option<Spanned<String>>,
    /// Whether that has a line for a name.
    pub name_line: Option<Spanned<bool>>,
}

/// Keys of `[canvas]` for scenes that do not have them.
#[derive(Clone, Debug, Default)]
pub struct CanvasDefaults {
    /// The keys with their values, in the order of the file.
    entries: Vec<(Spanned<String>, Node)>,
}

/// Reads a project file, checked but for the words for formats and themes.
///
/// # Errors
/// All problems of the text, in its order.
///
/// ```
/// use tracefig::scene::{Source, project};
/// let text = "[render]\nscenes = ['docs']\nformats = ['svg']\n[canvas]\nwidth = 700";
/// let read = project(&Source::new("tracefig.toml", text)).unwrap();
/// assert_eq!((read.scenes[0].value.as_str(), read.formats.len(), read.output), ("docs", 1, None));
/// let problems = project(&Source::new("tracefig.toml", "[render]\nscale = 'big'")).unwrap_err();
/// assert_eq!(problems[0].fault.to_string(), "`scale`: expected a number, got the text \"big\"");
/// ```
pub fn project(source: &Source) -> Result<Project, Vec<Problem>> {
    // A project file without a word is one that leaves everything as it is.
    let root = toml::parse(&source.text)?;
    let mut problems = Problems::default();
    let project = read(&root, &mut problems);
    match project {
        Some(project) if problems.is_empty() => Ok(project),
        _ => Err(problems.into_sorted()),
    }
}

fn read(root: &Node, p: &mut Problems) -> Option<Project> {
    let top = check(root, "project", PROJECT.place, PROJECT.fields, p)?;
    let mut project = Project::default();
    if let Some(node) = top.get("canvas") {
        check(node, "canvas", CANVAS.place, CANVAS.fields, p)?;
        project.canvas.entries = node.entries().unwrap_or_default().to_vec();
    }
    if let Some(node) = top.get("render") {
        let render = check(node, "render", RENDER.place, RENDER.fields, p)?;
        project.scenes = words(&render, "scenes", p);
        project.output = render.text("output");
        project.formats = words(&render, "formats", p);
        project.themes = words(&render, "themes", p);
        project.scale = render.number("scale");
        project.steps = render.text("steps").map(|word| word.value);
    }
    if let Some(node) = top.get("handout") {
        let items = as_list(node).unwrap_or_default();
        project.handouts = items.iter().filter_map(|item| handout(item, p)).collect();
    }
    Some(project)
}

/// A document of several figures; what is wrong is told.
fn handout(node: &Node, p: &mut Problems) -> Option<DeclaredHandout> {
    let table = check(node, "handout", HANDOUT.place, HANDOUT.fields, p)?;
    let mut variants = Vec::new();
    for word in table.texts("variants") {
        let Some(variant) = Variant::of_word(&word.value) else {
            let known = Variant::OF_AN_EXERCISE.map(|variant| variant.word().to_owned()).to_vec();
            p.add(Fault::UnknownWord { what: "variant", got: word.value, known }, &word.span);
            continue;
        };
        variants.push(variant);
    }
    let switch = |key| {
        let span = table.get(key)?.span.clone();
        table.switch(key).map(|value| Spanned { value, span })
    };
    Some(DeclaredHandout {
        scenes: words(&table, "scenes", p),
        theme: table.text("theme"),
        variants,
        seeds: table.texts("seeds"),
        per_page: table.count("per_page"),
        paper: table.text("paper"),
        numbers: switch("numbers"),
        heading: table.text("heading"),
        name_line: switch("name_line"),
        file: table.text("file")?,
    })
}

/// The texts of a list; one that is there has at least one.
fn words(table: &Checked<'_>, key: &str, p: &mut Problems) -> Vec<Spanned<String>> {
    let Some(node) = table.get(key) else { return Vec::new() };
    let items = as_list(node).unwrap_or_default();
    let word = |item: &Node| {
        let text = as_text(item).filter(|text| !text.is_empty())?;
        Some(Spanned { value: text.to_owned(), span: item.span.clone() })
    };
    let found: Vec<_> = items.iter().filter_map(word).collect();
    if found.is_empty() || found.len() < items.len() {
        let expected = "a list of texts, at least one".to_owned();
        let wrong = items.iter().find(|item| word(item).is_none()).unwrap_or(node);
        let fault = Fault::WrongType { key: key.to_owned(), expected, got: wrong.describe() };
        p.add(fault, &wrong.span);
    }
    found
}

impl CanvasDefaults {
    /// The theme that is named for scenes that name none, with its place in the project file.
    ///
    /// ```
    /// use tracefig::scene::{Source, project};
    /// let read = project(&Source::new("tracefig.toml", "canvas.theme = 'dark'")).unwrap();
    /// assert_eq!(read.canvas.theme().unwrap().value, "dark");
    /// ```
    #[must_use]
    pub fn theme(&self) -> Option<Spanned<String>> {
        let (_, node) = self.entries.iter().find(|(key, _)| key.value == "theme")?;
        as_text(node).map(|text| Spanned { value: text.to_owned(), span: node.span.clone() })
    }

    /// The tree of a scene with these keys in its `[canvas]`, where it does not have them.
    fn merged(&self, mut root: Node) -> Node {
        let NodeValue::Table(tables) = &mut root.value else { return root };
        if self.entries.is_empty() {
            return root;
        }
        // A value of the project file stands nowhere in the scene: what is wrong with it is told at the top.
        let own = self.entries.iter().map(|(key, node)| {
            let key = Spanned { value: key.value.clone(), span: 0..0 };
            (key, Node { value: node.value.clone(), span: 0..0 })
        });
        match tables.iter_mut().find(|(key, _)| key.value == "canvas") {
            Some((_, Node { value: NodeValue::Table(entries), .. })) => {
                for (key, node) in own {
                    if entries.iter().all(|(known, _)| known.value != key.value) {
                        entries.push((key, node));
                    }
                }
            }
            Some(_) => {}
            None => {
                let canvas = Node { value: NodeValue::Table(own.collect()), span: 0..0 };
                tables.push((Spanned { value: "canvas".to_owned(), span: 0..0 }, canvas));
            }
        }
        root
    }
}

impl SceneFile {
    /// The scene with a project's page where it does not say otherwise.
    ///
    /// # Errors
    /// When the scene does not go with those values.
    ///
    /// ```
    /// use tracefig::scene::{Source, open_text, project};
    /// let text = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']";
    /// let ours = project(&Source::new("tracefig.toml", "canvas = { width = 700, height = 300 }")).unwrap();
    /// let file = open_text("s.toml", &format!("{text}\n[canvas]\nheight = 400"))?;
    /// let canvas = file.with_canvas(&ours.canvas)?.scene.canvas;
    /// assert_eq!(canvas.width, Some(700.0));
    /// # Ok::<(), Box<tracefig::Refused>>(())
    /// ```
    pub fn with_canvas(self, defaults: &CanvasDefaults) -> Result<Self, Box<Refused>> {
        if defaults.entries.is_empty() {
            return Ok(self);
        }
        checked(self.source, |source| Ok(defaults.merged(source.tree()?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    const SCENE: &str = "[shapes.A]\nkind = 'circle'\nradius = 2\n[query]\nkind = 'bounds'\nof = ['A']\n";

    fn problem(text: &str) -> (String, Option<String>, String) {
        let problems = project(&Source::new(PROJECT_FILE, text)).unwrap_err();
        assert_eq!(problems.len(), 1, "{problems:?}");
        let Problem { fault, span } = &problems[0];
        (fault.to_string(), fault.help(), text[span.clone()].to_owned())
    }

    #[test]
    fn an_unknown_key_is_told_with_its_place_and_the_nearest_word() {
        let (said, help, at) = problem("[render]\nformat = ['x']\n");
        assert_eq!((said.as_str(), at.as_str()), ("unknown key `format` in `[render]`", "format"));
        assert_eq!(help.as_deref(), Some("did you mean `formats`?"));
        assert_eq!(problem("[rendr]\n").1.as_deref(), Some("did you mean `render`?"));
        assert_eq!(problem("[canvas]\nwidht = 3\n").1.as_deref(), Some("did you mean `width`?"));
    }

    #[test]
    fn a_list_holds_texts_and_is_not_empty() {
        for (list, at) in [("[]", "[]"), ("['a', 1]", "1"), ("['']", "''"), ("[['a']]", "['a']")] {
            let (said, _, quoted) = problem(&format!("render.scenes = {list}"));
            assert!(said.starts_with("`scenes`: expected a list of texts, at least one, got "), "{said}");
            assert_eq!(quoted, at);
        }
        assert_eq!(
            problem("render.scenes = 'docs'").0,
            "`scenes`: expected a list of files and folders, got the text \"docs\""
        );
        assert_eq!(problem("render.scale = 9").0, "`scale`: expected a number in [0, 8], got 9");
    }

    #[test]
    fn an_empty_project_file_says_nothing() {
        let read = project(&Source::new(PROJECT_FILE, "# nothing yet\n")).unwrap();
        assert!(read.scenes.is_empty() && read.output.is_none() && read.scale.is_none());
    }

    #[test]
    fn the_scene_has_the_last_word_on_its_page() {
        let ours = project(&Source::new(PROJECT_FILE, "canvas = { width = 700, theme = 'dark' }")).unwrap();
        let opened = |more: &str| open_text("s.toml", &format!("{SCENE}{more}")).unwrap();
        let with = |more: &str| opened(more).with_canvas(&ours.canvas).unwrap();
        let page =
            |file: &SceneFile| (file.scene.canvas.width, file.scene.canvas.theme.clone().unwrap().value);
        assert_eq!(page(&with("")), (Some(700.0), "dark".to_owned()));
        assert_eq!(page(&with("[canvas]\ntheme = 'print'")), (Some(700.0), "print".to_owned()));
        // What is drawn is what counts, whoever said it.
        assert_eq!(with("").meaning, opened("[canvas]\ntheme = 'dark'\nwidth = 700").meaning);
        assert_ne!(with("").meaning, opened("").meaning);
    }
}
