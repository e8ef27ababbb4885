//! `render --live`: pages whose figures a reader drags, and how they find each other.

use std::path::Path;

use serde_json::{Value, json};
use tracefig::drawing::{Drawing, Role};
use tracefig::figure::plain;
use tracefig::live::{self, Frame, foreign_texts, more_glyphs};
use tracefig::output::{FORMATS, INLINE, LivePage, Module, OutputError, WriteLive};
use tracefig::scene::{SceneFile, Source, Variant};

use super::inputs::Input;
use super::jobs::{Job, Planned, Target};
use super::settings::Destination;
use super::themes::ChosenTheme;

/// What draws a figure in a browser: the library as a module of WebAssembly, packed by gzip.
pub(crate) const MODULE: &[u8] = include_bytes!("../../live/tracefig-live.wasm.gz");
/// The file that pages share.
pub(crate) const RUNTIME: &str = "tracefig-live.js";
/// The stem of the page that lists the others.
const INDEX: &str = "index";

/// How pages are live.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Live {
    /// Each page holds all that it needs.
    Alone,
    /// One file beside the pages holds what they share.
    Shared,
}

impl Live {
    /// Every word with what it asks for.
    const WORDS: [(&'static str, Self); 2] = [("alone", Self::Alone), ("shared", Self::Shared)];

    /// What a word of the command line asks for.
    ///
    /// # Errors
    /// Where it is none of those known.
    pub(crate) fn of_word(word: &str) -> Result<Self, String> {
        let found = Self::WORDS.iter().find(|(known, _)| *known == word);
        found
            .map(|&(_, live)| live)
            .ok_or_else(|| format!("expected {}", Self::WORDS.map(|w| w.0).join(" or ")))
    }

    /// The words of the formats that have live pages.
    pub(crate) fn formats() -> String {
        let live = FORMATS.iter().filter(|format| format.live.is_some());
        live.map(|format| format.name).collect::<Vec<_>>().join(" or ")
    }

    /// Adds the pictures of pages to the formats asked for: in a folder the page that lists them shows those.
    pub(crate) fn add_pictures(destination: &Destination, formats: &mut Vec<String>) {
        let is_folder = matches!(destination, Destination::Folder(_) | Destination::Project(_));
        if is_folder && !formats.is_empty() {
            formats.push(INLINE.name.to_owned());
        }
    }
}

/// A file that is a live page.
#[derive(Clone, Copy)]
pub(crate) struct LiveFile {
    /// How pages are live.
    live: Live,
    /// How it is written.
    write: WriteLive,
}

/// The live page that a file is; none for any other, as for a variant, which is not what the scene says.
pub(crate) fn live_of(live: Option<Live>, planned: &Planned) -> Option<LiveFile> {
    let write = planned.format.live.filter(|_| planned.variant == Variant::Figure)?;
    live.map(|live| LiveFile { live, write })
}

impl LiveFile {
    /// The page. Its picture has the stamp of an SVG file.
    pub(crate) fn page(
        self,
        drawing: &Drawing,
        (job, file): (&Job, &SceneFile),
        target: &Target,
        theme: Option<&ChosenTheme>,
    ) -> Result<Vec<u8>, OutputError> {
        let up = up(job, target);
        let (beside, index) = (format!("{up}{RUNTIME}"), index_of(job, target));
        let module = if self.live == Live::Shared { Module::Beside(&beside) } else { Module::Inside(MODULE) };
        let request = with_info(request(file, &drawing.id, theme, None));
        let (heading, index) = (heading(file, job), index.map(|name| format!("{up}{name}")));
        (self.write)(
            drawing,
            &LivePage { request: &request, heading: &heading, module, index: index.as_deref() },
        )
    }
}

/// A request with what its figure says at rest, so that the page has its handles before it has the module.
fn with_info(request: String) -> String {
    match live::Live::open(&request).and_then(|mut live| live.draw()) {
        Ok(Frame { panel, .. }) => format!("{{\"info\":{panel},{}", &request[1..]),
        // The page then says why.
        Err(_) => request,
    }
}

/// Whose colours a picture has that stands inside a page.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Inline<'r> {
    /// Colours of the page's style sheet, which gives words of these roles another one than lines.
    Following(&'r [Role]),
    /// Colours of its own.
    OnItsOwn,
}

/// What the module is opened with: the scene, the id and the theme, and how the picture stands inside a page.
pub(crate) fn request(
    file: &SceneFile,
    id: &str,
    theme: Option<&ChosenTheme>,
    inline: Option<Inline<'_>>,
) -> String {
    let mut rest = json!({ "id": id });
    if let Some(theme) = theme {
        let own = |key: &String| {
            let file = Source::new("", key).json().and_then(|text| serde_json::from_str(&text).ok());
            json!({ "key": key, "file": file.unwrap_or(Value::Null) })
        };
        rest["theme"] = if theme.file.is_some() { own(&theme.key) } else { json!(theme.key) };
    }
    if let Some(inline) = inline {
        let names = |roles: &[Role]| roles.iter().map(|role| role.name()).collect::<Vec<_>>();
        rest["inline"] = match inline {
            Inline::Following(roles) => json!({ "words": names(roles) }),
            Inline::OnItsOwn => json!({}),
        };
    }
    if let Some(faces) = more_glyphs(file) {
        rest["faces"] = faces;
    }
    if let Some(texts) = foreign_texts(file) {
        rest["texts"] = texts;
    }
    // A page sorts what is called as a number.
    let names = || file.scene.shapes().iter().map(|(name, _)| name.value.as_str());
    if names().any(|name| name.bytes().all(|byte| byte.is_ascii_digit())) {
        rest["bodyNames"] = json!(names().collect::<Vec<_>>());
    }
    // The order of a scene's keys stays: the scene is written as it is.
    let (mut scene, rest) = (file.json(), rest.to_string());
    if let Some(alt) = file.scene.alt.as_ref()
        && let Ok(mut said) = serde_json::from_str::<Value>(&scene)
    {
        // A book may say another one.
        said["alt"] = json!(alt.value);
        scene = said.to_string();
    }
    format!("{{\"scene\":{scene},{}", rest.trim_start_matches('{'))
}

/// What a page is called.
pub(crate) fn heading(file: &SceneFile, job: &Job) -> String {
    let stem = || match &job.input {
        Input::File(path) => path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        other => other.shown(),
    };
    file.scene.title.as_ref().map_or_else(stem, |title| plain(&title.value))
}

/// The folder that all files of a run go to, where there is one.
pub(crate) fn root(job: &Job) -> Option<&Path> {
    match &job.settings.destination {
        Destination::Folder(folder) | Destination::Project(folder) => Some(folder),
        Destination::Beside | Destination::Stdout | Destination::File(_) => None,
    }
}

/// The folder of a file below that folder; none where there is no such folder.
pub(crate) fn below<'t>(job: &Job, target: &'t Target) -> Option<&'t Path> {
    let Target::File(path) = target else { return None };
    path.parent()?.strip_prefix(root(job)?).ok()
}

/// The way from a page to the folder of what is shared, as an address.
fn up(job: &Job, target: &Target) -> String {
    below(job, target).map(|below| "../".repeat(below.components().count())).unwrap_or_default()
}

/// The name of the page that lists this one; none where no folder gathers the pages.
pub(crate) fn index_of(job: &Job, target: &Target) -> Option<String> {
    below(job, target)?;
    let Target::File(path) = target else { return None };
    Some(format!("{INDEX}.{}", path.extension()?.to_string_lossy()))
}
