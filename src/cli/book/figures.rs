//! Draws what a page asks for, as a piece of its Markdown.

use std::fmt::Write as _;
use std::path::{Component, Path, PathBuf};

use tracefig::drift::fingerprint;
use tracefig::figure::{draw, plan, plan_in};
use tracefig::output::{data_uri, inline};
use tracefig::scene::{
    CanvasDefaults, Explain, Ink, Refused, SceneFile, Source, Spanned, message, open, open_text, project,
    visible,
};

use super::super::inputs::Input;
use super::super::live::{Inline, request};
use super::super::own_themes::OwnThemes;
use super::super::project::nearest;
use super::super::themes::{ChosenTheme, theme_in};
use super::super::unplanned::{Unplanned, unread};
use super::attributes::Attributes;
use super::colors::Colors;
use super::kept::Kept;
use super::links::address;
use super::markdown::{Place, What};

/// Width of the page of figures that say none, page pixels: that of mdBook's text, so that letters have the
/// size that they say.
const WIDTH: &str = "canvas.width = 750";

/// How the renderer of a book takes a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Takes {
    /// It stands in the page as an element.
    Element,
    /// It stands there as an image.
    Image,
}

/// What a figure is drawn for.
pub(crate) struct Desk<'d> {
    /// How figures are taken.
    pub(crate) takes: Takes,
    /// How figures look that follow the book.
    pub(crate) colors: &'d Colors,
    /// Figures of the last build.
    pub(crate) kept: Kept,
    /// The theme files that scenes name.
    pub(crate) own_themes: OwnThemes,
    /// How messages are written.
    pub(crate) ink: Ink,
    /// The address of the book's folder where its repository is shown.
    pub(crate) code: Option<&'d str>,
    /// The folder of the pages, from that of the book.
    pub(crate) src: &'d Path,
}

/// A place of a page, with what it takes to draw it.
#[derive(Debug)]
pub(crate) struct Order<'p> {
    /// The place.
    pub(crate) place: &'p Place,
    /// What the page is called in messages.
    pub(crate) name: &'p str,
    /// The page's file, from whose folder paths count.
    pub(crate) file: &'p Path,
    /// Number of the place's line in that file; `None` where it was included from another.
    pub(crate) line: Option<usize>,
    /// What ids of the figure begin with.
    pub(crate) id: String,
    /// Whether the style sheet comes with it.
    pub(crate) with_sheet: bool,
}

/// What comes of an order.
#[derive(Debug, Default)]
pub(crate) struct Served {
    /// What stands in the page instead; `None` where something is wrong.
    pub(crate) text: Option<String>,
    /// Messages, ready to be shown.
    pub(crate) messages: String,
    /// The pictures, each with its messages where it has some, by what it depends on.
    pub(crate) kept: Vec<(String, String)>,
    /// Whether it is a figure that a reader may drag.
    pub(crate) is_live: bool,
}

/// A scene that was drawn, now or for the last build.
pub(super) struct Drawn {
    /// The picture, as an element or an image in Markdown.
    pub(super) picture: String,
    /// Warnings, ready to be shown.
    pub(super) messages: String,
    /// What it is kept by.
    key: String,
}

impl Drawn {
    /// What is kept of it for the next build.
    pub(super) fn kept(&self) -> (String, String) {
        let Self { picture, messages, key } = self;
        (key.clone(), if messages.is_empty() { picture.clone() } else { with_messages(messages, picture) })
    }
}

impl Served {
    /// Words for the page.
    fn words(text: String) -> Self {
        Self { text: Some(text), ..Self::default() }
    }
}

impl Desk<'_> {
    /// Does what a place asks for.
    pub(crate) fn serve(&self, order: &Order) -> Served {
        let served = match &order.place.what {
            What::Backslash => Ok(Served::words(String::new())),
            What::Wrong(told) => Err(order.told(told)),
            What::Link(to) => self.link(order, to).map(Served::words),
            What::Value { path, name } => self.value(order, path, name).map(Served::words),
            What::Scene { attributes, text } => self.figure(order, None, (attributes, text)),
            What::File { path, attributes } => self.figure(order, Some(path), (attributes, "")),
        };
        served.unwrap_or_else(|messages| Served { messages, ..Served::default() })
    }

    /// The target of a link: an address for what lies outside the book.
    fn link(&self, order: &Order, to: &str) -> Result<String, String> {
        let Some(code) = self.code else { return Ok(to.to_owned()) };
        let led = address(code, self.src, Path::new(order.name), to).map_err(|told| order.told(&told))?;
        Ok(led.unwrap_or_else(|| to.to_owned()))
    }

    /// The text of a value of a file's answer.
    fn value(&self, order: &Order, path: &str, name: &str) -> Result<String, String> {
        let file = open(&order.path(path)).map_err(|refused| order.refused(&refused, self.ink))?;
        let refuse = |problems| order.refused(&Refused { source: file.source.clone(), problems }, self.ink);
        let plan = plan(&file.scene).map_err(refuse)?;
        plan.say(&format!("{{={name}}}")).map_err(|problems| {
            let told = |problem: &tracefig::scene::Problem<tracefig::figure::Fault>| {
                let help = problem.fault.help().map(|help| format!("; {help}")).unwrap_or_default();
                order.told(&format!("{}{help}", problem.fault))
            };
            problems.iter().map(told).collect()
        })
    }

    /// A figure as Markdown: the scene's text where that is asked for, and the picture. `path` is the file
    /// of the scene; without one it stands in the page as `text`.
    fn figure(
        &self,
        order: &Order,
        path: Option<&String>,
        (attributes, text): (&str, &str),
    ) -> Result<Served, String> {
        let attributes = Attributes::read(attributes).map_err(|told| order.told(&told))?;
        let (mut file, input) = self.opened(order, path, text)?;
        if let Some(alt) = &attributes.alt {
            file.scene.alt = Some(Spanned { value: alt.clone(), span: 0..0 });
        }
        let own = self.own_theme(order, &attributes, &file, &input)?;
        if attributes.exercise {
            return self.exercise(order, &attributes, file, own.as_ref());
        }
        let drawn = self.drawn(order, &file, own.as_ref())?;
        let (picture, kept) = (&drawn.picture, vec![drawn.kept()]);
        let mut out = String::new();
        let is_live = attributes.live && self.takes == Takes::Element;
        if attributes.source {
            let shown = if path.is_some() { &file.source.text } else { text };
            push_fenced(&mut out, shown, &order.place.margin);
        }
        match self.takes {
            Takes::Element => {
                let element = self.element(order, &attributes, own.is_none(), picture);
                if is_live {
                    push_live(&mut out, &element, &self.request(order, &file, own.as_ref()));
                } else {
                    out.push_str(&element);
                }
            }
            Takes::Image => out.push_str(picture),
        }
        // A blank line ends the element for Markdown.
        let _ = write!(out, "\n{}", order.place.margin.trim_end());
        Ok(Served { text: Some(out), messages: drawn.messages, kept, is_live })
    }

    /// A scene as a picture, of the last build where nothing has changed. What is told is told by every
    /// build, of the place where the scene is now.
    pub(super) fn drawn(
        &self,
        order: &Order,
        file: &SceneFile,
        own: Option<&ChosenTheme>,
    ) -> Result<Drawn, String> {
        let key = self.key(order, file, own);
        if let Some(picture) = self.kept.get(&key) {
            return Ok(Drawn { picture: picture.to_owned(), messages: String::new(), key });
        }
        // Messages quote the scene, by the lines of its page.
        let told = format!("{} {:?} {}", file.source.name, self.ink, file.source.text);
        let of_told = fingerprint(&key, &told);
        if let Some((messages, picture)) = self.kept.get(&of_told).and_then(parted) {
            return Ok(Drawn { picture: picture.to_owned(), messages: messages.to_owned(), key: of_told });
        }
        let mut messages = String::new();
        let picture = self.picture(order, file, own, &mut messages)?;
        Ok(Drawn { picture, key: if messages.is_empty() { key } else { of_told }, messages })
    }

    /// A picture as an element of the page, with the style sheet if it is the first.
    pub(super) fn element(
        &self,
        order: &Order,
        attributes: &Attributes,
        follows: bool,
        picture: &str,
    ) -> String {
        let style = attributes.width.as_ref().map(|w| format!(" style=\"width:{w}\"")).unwrap_or_default();
        let class = Colors::class(follows);
        let sheet = order.with_sheet.then(|| format!("<style>{}</style>", self.colors.sheet));
        let sheet = sheet.unwrap_or_default();
        format!("<figure class=\"{class}\"{style}>{sheet}{picture}</figure>")
    }

    /// What a live figure is opened with, so that it draws the picture that stands in the page.
    fn request(&self, order: &Order, file: &SceneFile, own: Option<&ChosenTheme>) -> String {
        let (theme, colors) = match own {
            Some(own) => (own, Inline::OnItsOwn),
            None => (&self.colors.chosen, Inline::Following(&self.colors.shaded)),
        };
        request(file, &order.id, Some(theme), Some(colors))
    }

    /// What a picture depends on, in a hash.
    fn key(&self, order: &Order, file: &SceneFile, own: Option<&ChosenTheme>) -> String {
        let theme = own.map_or_else(|| self.colors.sheet.clone(), |own| format!("{:?}", own.theme));
        let alt = file.scene.alt.as_ref().map(|alt| &alt.value);
        let variant = file.scene.variant.word();
        fingerprint(&file.meaning, &format!("{:?} {} {variant} {alt:?} {theme}", self.takes, order.id))
    }

    /// Draws a scene, as an element or an image in Markdown; warnings go to `messages`.
    fn picture(
        &self,
        order: &Order,
        file: &SceneFile,
        own: Option<&ChosenTheme>,
        messages: &mut String,
    ) -> Result<String, String> {
        let theme = own.map_or(&self.colors.base, |own| &own.theme);
        let plan = plan_in(&file.scene, theme).map_err(|problems| {
            order.refused(&Refused { source: file.source.clone(), problems }, self.ink)
        })?;
        let mut figure = draw(&plan, theme, &order.id);
        for warning in &figure.warnings {
            messages.push_str(&message(&file.source, warning, warning.fault.severity(), self.ink));
        }
        if own.is_none() {
            self.colors.open_words(&mut figure.drawing);
        }
        let drawing = &figure.drawing;
        let cant = |error| order.told(&format!("the figure can't be written: {error}"));
        match self.takes {
            Takes::Element => inline(drawing).map_err(cant),
            Takes::Image => {
                Ok(format!("![{}]({})", escaped(&drawing.title), data_uri(drawing).map_err(cant)?))
            }
        }
    }

    /// The scene of an order, on the page of its project or of a book, and where it is from.
    fn opened(&self, order: &Order, path: Option<&String>, text: &str) -> Result<(SceneFile, Input), String> {
        let (path, opened) = match path {
            Some(path) => (order.path(path), open(&order.path(path))),
            // As many lines before it as in the page, so that messages count as the page's editor does.
            None => {
                (order.file.to_owned(), open_text(order.name, &("\n".repeat(order.line.unwrap_or(0)) + text)))
            }
        };
        let file = opened
            .and_then(|file| file.with_canvas(&page_of(&path)?))
            .map_err(|refused| order.refused(&refused, self.ink))?;
        Ok((file, Input::File(path)))
    }

    /// The theme that a figure keeps whatever its reader chose; `None` where it follows the book.
    fn own_theme(
        &self,
        order: &Order,
        attributes: &Attributes,
        file: &SceneFile,
        input: &Input,
    ) -> Result<Option<ChosenTheme>, String> {
        if let Some(word) = &attributes.theme {
            let folder = order.file.parent().unwrap_or(Path::new(""));
            let chosen = theme_in(folder, word).map_err(|e| order.told(&format!("theme {word}: {e}")))?;
            return Ok(Some(chosen));
        }
        let own = self
            .own_themes
            .of(file, input, self.ink)
            .map_err(|none| format!("{}  asked for at {}\n", none.message, order.place()))?;
        let named = || theme_in(Path::new(""), &file.scene.canvas.theme.as_ref()?.value).ok();
        let own = own.map(|own| ChosenTheme::clone(&own)).or_else(named);
        // Who has two sides follows the reader's system elsewhere, and the book here.
        Ok(own.filter(|own| own.theme.dark.is_none()))
    }
}

impl Order<'_> {
    /// A path of the page.
    fn path(&self, path: &str) -> PathBuf {
        let path = self.file.parent().unwrap_or(Path::new("")).join(path);
        let mut plain = PathBuf::new();
        for part in path.components() {
            // Of a folder that is a link the system would say otherwise; a page's reader would not.
            if part != Component::ParentDir || !plain.pop() {
                plain.push(part);
            }
        }
        let here = std::env::current_dir().unwrap_or_default();
        plain.strip_prefix(here).map(Path::to_owned).unwrap_or(plain)
    }

    /// Where the place is, as messages say it.
    fn place(&self) -> String {
        match self.line {
            Some(line) => format!("{}:{line}", visible(self.name)),
            None => format!("{} (a part that is included)", visible(self.name)),
        }
    }

    /// A message of ours about the place.
    pub(super) fn told(&self, told: &str) -> String {
        format!("error: {told}\n --> {}\n", self.place())
    }

    /// All that is wrong with a scene, and where it is asked for.
    pub(super) fn refused<F: Explain>(&self, refused: &Refused<F>, ink: Ink) -> String {
        format!("{}  asked for at {}\n", refused.render(ink), self.place())
    }
}

/// The page of scenes in the folder of a file that say none: that of their project file, else a book's.
fn page_of(file: &Path) -> Result<CanvasDefaults, Box<Refused>> {
    let folder = file.parent().unwrap_or(Path::new(""));
    match nearest(folder) {
        Ok(Some(project)) => Ok(project.said.canvas),
        Err(Unplanned::Refused(refused)) => Err(refused),
        Err(Unplanned::Unread(message)) => Err(Box::new(unread(message, folder))),
        // A project is read or refused.
        Ok(None) | Err(Unplanned::Usage(_) | Unplanned::Wrong(_)) => {
            Ok(project(&Source::new("", WIDTH)).map(|project| project.canvas).unwrap_or_default())
        }
    }
}

/// Messages and a picture as one text.
fn with_messages(messages: &str, picture: &str) -> String {
    format!("{}\n{messages}{picture}", messages.len())
}

/// The messages and the picture of such a text; `None` for any other.
fn parted(text: &str) -> Option<(&str, &str)> {
    let (length, rest) = text.split_once('\n')?;
    rest.split_at_checked(length.parse().ok()?)
}

/// Appends a figure that a reader may drag, with what its script needs of it, in one line.
fn push_live(out: &mut String, element: &str, request: &str) {
    // Neither markup nor what another preprocessor takes for a formula may be seen in a text of the scene.
    let request = request.replace('<', "\\u003c").replace('$', "\\u0024");
    let _ = write!(out, "<div class=\"tracefig-live\">{element}");
    let _ = write!(out, "<script type=\"application/json\">{request}</script></div>");
}

/// Appends a text as a fenced block of TOML or JSON, with the margin before each further line.
fn push_fenced(out: &mut String, text: &str, margin: &str) {
    let runs = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(runs.max(2) + 1);
    let language = if text.trim_start().starts_with('{') { "json" } else { "toml" };
    let _ = writeln!(out, "{fence}{language}");
    for line in text.trim_end().lines() {
        let _ = writeln!(out, "{}", format!("{margin}{line}").trim_end());
    }
    let _ = write!(out, "{margin}{fence}\n{}\n{margin}", margin.trim_end());
}

/// Words so that Markdown reads them as they are.
fn escaped(words: &str) -> String {
    let mut out = String::with_capacity(words.len());
    for c in words.chars() {
        if c.is_ascii_punctuation() {
            out.push('\\');
        }
        out.push(if c.is_control() { ' ' } else { c });
    }
    out
}
