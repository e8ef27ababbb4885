//! A figure that is drawn again and again while its scene is edited, as in a browser.
//!
//! A [`Live`] holds a scene as JSON. [`Live::set`] changes numbers in it and reads it again by the rules of
//! every scene, so that an edit which would make no scene is refused with the reason and changes nothing;
//! [`Live::draw`] gives the bytes that `tracefig render` writes for that scene, with the result in words.

mod edit;
mod faces;
mod panel;
mod refusal;
mod request;
#[cfg(test)]
mod tests;
mod texts;

use serde_json::Value;

use crate::drawing::Drawing;
use crate::drift::{facts, fingerprint, metadata, text_chunk};
use crate::figure::{Figure, Language, Plan, draw_unjudged, off_page, plan, plan_in};
use crate::output::{OutputError, found_words, inline_with, svg_key, svg_with};
use crate::scene::{SceneFile, open_text};

#[cfg(not(tracefig_page))]
pub use faces::more_glyphs;
pub use refusal::Refusal;
use request::{Inline, Look, Request};
#[cfg(not(tracefig_page))]
pub use texts::foreign_texts;

/// A scene with the text that it was read from.
#[derive(Clone, Debug)]
struct State {
    /// What it says, as JSON.
    json: Value,
    /// The scene itself.
    file: SceneFile,
}

impl State {
    /// Reads a scene that is JSON, or a text that holds one.
    fn of(scene: Value) -> Result<Self, Refusal> {
        let read = |text: &str| open_text("scene", text).map_err(|refused| Refusal::of_scene(*refused));
        match scene {
            Value::String(text) => {
                let file = read(&text)?;
                Self::of(file.json_value())
            }
            json => Ok(Self { file: read(&serde_json::to_string(&json).unwrap_or_default())?, json }),
        }
    }
}

/// A figure, drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The picture as SVG: what `tracefig render` writes for the scene as it is now.
    pub svg: String,
    /// What it says, as JSON: `sentence`, the result in words; `answer`, as `tracefig solve --jsonl` has it;
    /// `notes`, what this answer lacks of what the scene asks to show (the module of pages has none);
    /// `handles`, what can be dragged ([`handles_json`](crate::figure::handles_json)); `steps`, each with its
    /// `title` and `sentences`; `panels`, each with its `rect` on the page, left, top, right, bottom, and
    /// where its space lies there: its `zero`, and what a unit of `x` and of `y` is.
    pub panel: String,
}

/// A scene that is edited and drawn.
#[derive(Clone, Debug)]
pub struct Live {
    /// What every id of the SVG begins with.
    id: String,
    /// The theme.
    look: Look,
    /// How the picture stands inside a page; `None` where it is a file.
    inline: Option<Inline>,
    /// The scene as it is now.
    now: State,
    /// The scene as it was last drawn, where it has been edited since.
    drawn: Option<State>,
    /// Whether `now` has been drawn.
    is_drawn: bool,
    /// The step that is shown, from 1; `None` is the finished figure.
    step: Option<usize>,
    /// The picture before, where labels stay as they stood; without what it drew.
    before: Option<Box<Figure>>,
    /// The words that are found in the picture before, where they stay too.
    words: Option<String>,
}

/// What is drawn of a scene.
struct Drawn {
    /// What a page gets.
    frame: Frame,
    /// The figure, without what it drew.
    figure: Box<Figure>,
    /// The words that are found in its picture.
    words: String,
}

impl Live {
    /// Reads a figure from JSON: `{"scene": {…}, "id": "fig", "theme": "light"}`.
    ///
    /// The scene is one in JSON, or the text of a scene file. `id` is what every id of the SVG begins with,
    /// and is `fig` where it is left out. The theme is one of the house by its name, or
    /// `{"key": TEXT, "file": {…}}`: a theme file as JSON, with the text that stands for it in the figure's
    /// hash; without one it is the scene's own. With `"inline": {}` the picture is an element for the
    /// middle of a page (`output::inline`); with `"inline": {"words": ["a"]}` that page's style sheet sets
    /// its colours, those of words of these roles apart from those of lines, and says when it is dark. The
    /// module of live pages has few glyphs and English texts, and takes from `"faces"` the glyphs that the
    /// scene needs besides ([`more_glyphs`]) and from `"texts"` those of its language ([`foreign_texts`]).
    /// The library itself has them all.
    /// An `"info"` and `"bodyNames"`, which the page reads itself, are passed over.
    ///
    /// # Errors
    /// Where the text is no such JSON, or the scene is none.
    ///
    /// ```
    /// use serde_json::json;
    /// use tracefig::live::Live;
    /// let scene = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let mut live = Live::open(&json!({ "scene": scene, "theme": "dark" }).to_string())?;
    /// let frame = live.draw()?;
    /// assert!(frame.svg.starts_with("<svg"));
    /// assert!(frame.panel.contains("reaches from (−2, −2) to (2, 2)"), "{}", frame.panel);
    /// assert!(Live::open(r#"{"scene": {}}"#).unwrap_err().to_string().contains("lacks `shapes`"));
    /// # Ok::<(), tracefig::live::Refusal>(())
    /// ```
    pub fn open(text: &str) -> Result<Self, Refusal> {
        let Request { scene, id, look, inline } = Request::read(text)?;
        let now = State::of(scene)?;
        let (drawn, step, before, words) = (None, None, None, None);
        Ok(Self { id, look, inline, now, drawn, is_drawn: false, step, before, words })
    }

    /// Changes the scene: JSON `[[PATH, VALUE], …]`, where a path is a list of keys and numbers, as
    /// `["shapes", 0, "position"]`. A number counts elements of a list, or entries of a table in their order.
    /// `null` takes a key away. All edits are made or none.
    ///
    /// # Errors
    /// Where a path leads nowhere, or the scene would be none: it stays as it was.
    ///
    /// ```
    /// use serde_json::json;
    /// use tracefig::live::Live;
    /// let scene = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let mut live = Live::open(&json!({ "scene": scene }).to_string())?;
    /// live.set(r#"[[["shapes", "A", "position"], [10, 0]], [["shapes", 0, "radius"], 1]]"#)?;
    /// assert!(live.draw()?.panel.contains("from (9, −1) to (11, 1)"));
    /// let refused = live.set(r#"[[["shapes", 0, "radius"], -1]]"#).unwrap_err();
    /// assert_eq!(refused.to_string(), "A can't be so: it would be too small");
    /// # Ok::<(), tracefig::live::Refusal>(())
    /// ```
    pub fn set(&mut self, edits: &str) -> Result<(), Refusal> {
        let language = Language::of(&self.now.file.scene);
        self.edit(edits).map_err(|refusal| refusal.in_language(language))
    }

    /// Changes the scene, or says in English why not.
    fn edit(&mut self, edits: &str) -> Result<(), Refusal> {
        let mut json = self.now.json.clone();
        edit::apply(&mut json, edits)?;
        let before = std::mem::replace(&mut self.now, State::of(json)?);
        if std::mem::take(&mut self.is_drawn) {
            self.drawn = Some(before);
        }
        Ok(())
    }

    /// Shows the figure up to a step, counted from 1, from the next picture on; `None` shows it finished, as
    /// does a step beyond the last.
    ///
    /// ```
    /// use serde_json::json;
    /// use tracefig::live::Live;
    /// let scene = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let mut live = Live::open(&json!({ "scene": scene }).to_string())?;
    /// let finished = live.draw()?;
    /// assert!(finished.panel.contains(r#""steps":[{"title":"The question""#));
    /// live.show(Some(1));
    /// assert!(live.draw()?.svg.len() < finished.svg.len());
    /// live.show(None);
    /// assert_eq!(live.draw()?, finished);
    /// # Ok::<(), tracefig::live::Refusal>(())
    /// ```
    pub fn show(&mut self, step: Option<usize>) {
        self.step = step;
        self.words = None;
    }

    /// Places labels afresh in the next picture, and the words that are found: it is that of the scene alone,
    /// as a file has it.
    ///
    /// ```
    /// use serde_json::json;
    /// use tracefig::live::Live;
    /// let scene = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let mut live = Live::open(&json!({ "scene": scene }).to_string())?;
    /// let at_rest = live.draw()?.svg;
    /// live.set(r#"[[["shapes", "A", "radius"], 0.5]]"#)?;
    /// live.draw()?;
    /// live.set(r#"[[["shapes", "A", "radius"], 2]]"#)?;
    /// live.rest();
    /// assert_eq!(live.draw()?.svg, at_rest);
    /// # Ok::<(), tracefig::live::Refusal>(())
    /// ```
    pub fn rest(&mut self) {
        self.before = None;
        self.words = None;
    }

    /// Draws the scene as it is now; labels rest where they stood in the picture before, and words that are
    /// found and not seen say what they said there.
    ///
    /// # Errors
    /// Where the scene can't be drawn: it then is again as it was when it was drawn last, if it was.
    ///
    /// ```
    /// use serde_json::json;
    /// use tracefig::live::Live;
    /// let scene = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let mut live = Live::open(&json!({ "scene": scene }).to_string())?;
    /// let before = live.draw()?;
    /// live.set(r#"[[["panels"], [{"layers": ["difference"]}]]]"#)?;
    /// assert!(live.draw().unwrap_err().to_string().starts_with("the figure can't be so: "));
    /// assert_eq!(live.draw()?, before);
    /// # Ok::<(), tracefig::live::Refusal>(())
    /// ```
    pub fn draw(&mut self) -> Result<Frame, Refusal> {
        match self.frame() {
            Ok(Drawn { frame, figure, words }) => {
                (self.drawn, self.is_drawn) = (None, true);
                (self.before, self.words) = (Some(figure), Some(words));
                Ok(frame)
            }
            Err(refusal) => {
                let refusal = refusal.in_language(Language::of(&self.now.file.scene));
                if let Some(drawn) = self.drawn.take() {
                    (self.now, self.is_drawn) = (drawn, true);
                }
                Err(refusal)
            }
        }
    }

    /// The scene as it is now, as JSON.
    ///
    /// ```
    /// use serde_json::json;
    /// use tracefig::live::Live;
    /// let scene = "shapes.A = { kind = 'circle', radius = 2 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let mut live = Live::open(&json!({ "scene": scene }).to_string())?;
    /// live.set(r#"[[["shapes", "A", "radius"], 0.5]]"#)?;
    /// assert!(live.scene().contains(r#""A":{"kind":"circle","radius":0.5}"#));
    /// # Ok::<(), tracefig::live::Refusal>(())
    /// ```
    #[must_use]
    pub fn scene(&self) -> String {
        self.now.json.to_string()
    }

    /// The plan of the scene as it is now.
    fn plan(&self) -> Result<Plan<'_>, Refusal> {
        let scene = &self.now.file.scene;
        let plan = match &self.look {
            Look::Own => plan(scene),
            Look::Given { theme, .. } => plan_in(scene, theme),
        };
        plan.map_err(|problems| Refusal::of_figure(&self.now.file.source, &problems))
    }

    /// What the scene looks like as it is now.
    fn frame(&self) -> Result<Drawn, Refusal> {
        let plan = self.plan()?;
        let mut figure = Box::new(draw_unjudged(&plan, plan.theme, &self.id, self.before.as_deref()));
        let panel = panel::panel(&plan, &figure);
        // What is kept for the next picture is where labels stand.
        let items = std::mem::take(&mut figure.drawing.items);
        let whole = Drawing { items, ..figure.drawing.clone() };
        let mut drawing = match self.step {
            Some(step) if step < whole.steps.len() => whole.at_step(step.max(1)),
            _ => whole.finished(),
        };
        let words = self.words.clone().unwrap_or_else(|| found_words(&drawing, None));
        let written = if let Some(Inline { words: colored }) = &self.inline {
            if let Some(roles) = colored {
                drawing.words = roles.iter().map(|&role| (role, plan.theme.word_color(role))).collect();
                drawing.dark = None;
            }
            inline_with(&drawing, &words)
        } else {
            let key = match &self.look {
                Look::Own => plan.theme.name,
                Look::Given { key, .. } => key,
            };
            // A page is no file that anyone compares: each frame would tell its trace to nobody.
            if !cfg!(tracefig_page) {
                let hash = fingerprint(&self.now.file.meaning, &svg_key(key));
                drawing.hash = text_chunk(&hash);
                drawing.metadata = metadata(&hash, &facts(&plan));
            }
            svg_with(&drawing, &words)
        };
        let svg = written.map_err(|error| match error {
            OutputError::NotFinite { outer, group } => {
                let problem = off_page(plan.scene, &outer, &group);
                Refusal::of_figure(&self.now.file.source, &[problem])
            }
            other => Refusal::Output(other),
        })?;
        Ok(Drawn { frame: Frame { svg, panel }, figure, words })
    }
}
