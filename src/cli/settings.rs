//! How scenes are drawn: what the command line says, else their project file, else what is usual.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use tracefig::figure::theme;
use tracefig::output::{FORMATS, Format, format};
use tracefig::scene::limits::MAX_SCALE;
use tracefig::scene::{CanvasDefaults, Fault, Spanned, Variant};

use super::in_time::InTime;
use super::inputs::{Input, shown};
use super::project::{OpenProject, near, nearest_file, real};
use super::step_files::StepFiles;
use super::themes::{ChosenTheme, NoTheme, each_once, theme_in};
use super::unplanned::Unplanned;
use super::variants::Seeds;

/// Dots of an image for each page pixel, where nobody says: sharp on today's screens.
const USUAL_SCALE: f64 = 2.0;

/// What the command line says.
#[derive(Clone, Debug, Default)]
pub(crate) struct Flags<'c> {
    /// Where files go.
    pub(crate) output: Option<&'c Path>,
    /// Words for formats; none where it does not say.
    pub(crate) formats: &'c [String],
    /// Themes; none where it does not say.
    pub(crate) themes: Vec<ChosenTheme>,
    /// Dots of an image for each page pixel.
    pub(crate) scale: Option<f64>,
    /// Variants of exercises; none are the figures.
    pub(crate) variants: &'c [Variant],
    /// Numbers of variants of exercises; none are the scenes themselves.
    pub(crate) seeds: &'c [Seeds],
    /// How figures are shown in time; none where it does not ask for that.
    pub(crate) in_time: Option<InTime>,
    /// Whether figures are drawn finished, whatever a project says.
    pub(crate) is_still: bool,
    /// The project file of all scenes; `None` is the nearest of each.
    pub(crate) project: Option<&'c Path>,
}

/// Where files go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Destination {
    /// Beside each scene.
    Beside,
    /// To standard output.
    Stdout,
    /// To the one file of this name.
    File(PathBuf),
    /// Into a folder that the command line names, as the tree of the searched folder.
    Folder(PathBuf),
    /// Into the folder of a project, as the trees of its folders of scenes.
    Project(PathBuf),
}

/// How the scenes of one project are drawn, or those of none.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    /// Where files go.
    pub(crate) destination: Destination,
    /// What each scene is written as.
    pub(crate) formats: Vec<&'static Format>,
    /// Whether the command line says which formats.
    pub(crate) formats_asked: bool,
    /// The formats that the project file names, where the command line does not say; else none.
    pub(crate) formats_of_project: Vec<&'static Format>,
    /// Themes; none is each scene's own.
    pub(crate) themes: Vec<ChosenTheme>,
    /// Whether the project file names them, and the command line does not say.
    pub(crate) themes_of_project: bool,
    /// Dots of an image for each page pixel.
    pub(crate) scale: f64,
    /// What is drawn of each scene: variants of an exercise, or its figure.
    pub(crate) variants: Vec<Variant>,
    /// Which variants by number; `None` is the scene itself.
    pub(crate) seeds: Vec<Option<usize>>,
    /// How figures are shown in time; none draws the finished figure alone.
    pub(crate) in_time: Option<InTime>,
    /// Whether the project file asks for steps, and the command line does not say.
    pub(crate) steps_of_project: bool,
    /// The page of scenes that do not say otherwise.
    pub(crate) canvas: CanvasDefaults,
    /// The theme of that page, where it is a file.
    pub(crate) page_theme: Option<Arc<ChosenTheme>>,
    /// The project file, if there is one.
    pub(crate) project: Option<PathBuf>,
    /// The project's folders of scenes, by their real names.
    trees: Vec<PathBuf>,
}

/// What pictures and documents of other programs end in: nobody means a folder by such a name.
const OTHER_FORMATS: [&str; 14] =
    ["avif", "bmp", "eps", "heic", "htm", "ico", "jpeg", "jpg", "jxl", "ps", "tif", "tiff", "tikz", "webp"];

/// The formats that are written where nobody says which.
pub(crate) fn usual_formats() -> Vec<&'static Format> {
    FORMATS.iter().filter(|format| format.usual).collect()
}

impl Settings {
    /// What the command line says, else the project.
    ///
    /// # Errors
    /// When one of them contradicts itself, or the project names a format or theme that there is not.
    pub(crate) fn new(flags: &Flags<'_>, project: Option<&OpenProject>) -> Result<Self, Unplanned> {
        let known = project.map(FromProject::read).transpose()?.unwrap_or_default();
        let destination = destination(flags.output, known.output)?;
        let asked: Vec<_> = flags.formats.iter().filter_map(|name| format(name)).collect();
        let formats_asked = !asked.is_empty();
        let in_time = flags.in_time.or(known.steps.filter(|_| !flags.is_still).map(InTime::Steps));
        let formats_of_project = if formats_asked { Vec::new() } else { known.formats.clone() };
        let of_time = in_time.map(InTime::own_formats).unwrap_or_default();
        let mut formats = match (&destination, formats_asked) {
            (Destination::File(path), _) => vec![format_of(path, &asked)?],
            (_, true) => asked,
            (_, false) if !of_time.is_empty() => of_time,
            (_, false) if known.formats.is_empty() => usual_formats(),
            (_, false) => known.formats,
        };
        let mut seen = Vec::new();
        formats.retain(|format| {
            let new = !seen.contains(&format.name);
            seen.push(format.name);
            new
        });
        let themes = if flags.themes.is_empty() { &known.themes[..] } else { &flags.themes[..] };
        Ok(Self {
            destination,
            formats,
            formats_asked,
            formats_of_project,
            themes_of_project: flags.themes.is_empty() && !known.themes.is_empty(),
            themes: each_once(themes).map_err(Unplanned::Usage)?,
            scale: flags.scale.or(known.scale).unwrap_or(USUAL_SCALE),
            variants: if flags.variants.is_empty() { vec![Variant::Figure] } else { once(flags.variants) },
            seeds: Seeds::all(flags.seeds),
            in_time,
            steps_of_project: flags.in_time.is_none() && in_time.is_some(),
            page_theme: known.page_theme,
            canvas: project.map(|project| project.said.canvas.clone()).unwrap_or_default(),
            project: project.map(|project| project.file.clone()),
            trees: project.iter().flat_map(|project| project.scenes()).map(|path| real(&path)).collect(),
        })
    }

    /// The theme of that name, where it was asked for.
    pub(crate) fn theme(&self, name: Option<&str>) -> Option<&ChosenTheme> {
        self.themes.iter().find(|chosen| Some(chosen.name.as_str()) == name)
    }

    /// Whether each picture of a figure in time becomes a file of its own in a format.
    pub(crate) fn are_apart(&self, format: &Format) -> bool {
        self.in_time.is_some_and(|in_time| in_time.are_apart(format))
    }

    /// The folder of a scene's files within the output folder; `below` is where the scene was found below
    /// the folder that was searched. In a project it is where the scene lies below a folder of its scenes,
    /// however it was found, so that one scene has one place.
    pub(crate) fn within(&self, input: &Input, below: &Path) -> PathBuf {
        if let (Destination::Project(_), Input::File(path)) = (&self.destination, input) {
            let folder = real(path.parent().unwrap_or(Path::new("")));
            let trees = self.trees.iter().filter_map(|tree| folder.strip_prefix(tree).ok());
            // The innermost of its folders.
            if let Some(within) = trees.min_by_key(|within| within.components().count()) {
                return within.to_owned();
            }
        }
        below.to_owned()
    }
}

impl Settings {
    /// The folders that the scenes of a folder of figures may lie in: itself, and where the project's output
    /// folder mirrors its folders of scenes, those.
    pub(crate) fn folders_of_scenes(&self, figures: &Path) -> Vec<PathBuf> {
        let mut all = vec![figures.to_owned()];
        if let Destination::Project(output) = &self.destination
            && let Ok(within) = figures.strip_prefix(output)
        {
            all.extend(self.trees.iter().map(|tree| near(tree).join(within)));
        }
        all
    }
}

/// Each variant once, in the order in which they were asked for.
fn once(variants: &[Variant]) -> Vec<Variant> {
    let mut all = Vec::new();
    for &variant in variants {
        if !all.contains(&variant) {
            all.push(variant);
        }
    }
    all
}

/// Where files go, by the option of the command line, else by the project's.
///
/// # Errors
/// When the option's name ends as those of pictures do that are not written here.
fn destination(flag: Option<&Path>, project: Option<PathBuf>) -> Result<Destination, Unplanned> {
    let Some(path) = flag else { return Ok(project.map_or(Destination::Beside, Destination::Project)) };
    if path.as_os_str() == "-" {
        return Ok(Destination::Stdout);
    }
    let folder = Destination::Folder(path.to_owned());
    if path.is_dir() {
        return Ok(folder);
    }
    if named_format(path).is_some() {
        return Ok(Destination::File(path.to_owned()));
    }
    let ending = ending(path).filter(|ending| OTHER_FORMATS.contains(&ending.as_str()));
    ending.map_or(Ok(folder), |ending| {
        let ours: Vec<_> = FORMATS.iter().map(|format| format!(".{}", format.name)).collect();
        let (ours, shown) = (ours.join(", "), shown(path));
        Err(Unplanned::Usage(format!("{shown}: no figure is written as .{ending}, but as {ours}")))
    })
}

/// What the name of a file ends in, after its last point, in small letters.
fn ending(path: &Path) -> Option<String> {
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

/// The format whose files end as this one, in small letters or capitals.
fn named_format(path: &Path) -> Option<&'static Format> {
    format(&ending(path)?)
}

/// The format of the one file that is written, where those asked for do not contradict its name.
fn format_of(path: &Path, asked: &[&'static Format]) -> Result<&'static Format, Unplanned> {
    let named = named_format(path);
    let other = asked.iter().find(|format| Some(format.name) != named.map(|named| named.name));
    match (named, other) {
        (Some(named), None) => Ok(named),
        (_, other) => {
            let name = other.map_or("", |format| format.name);
            Err(Unplanned::Usage(format!("{} is no file of the format `{name}`", shown(path))))
        }
    }
}

/// The settings of each scene of a run, by the project that it belongs to.
pub(crate) struct Projects<'f> {
    /// What the command line says, which beats them all.
    flags: &'f Flags<'f>,
    /// The project file of each folder that was asked about.
    files: BTreeMap<PathBuf, Option<PathBuf>>,
    /// Settings by project file; those of none under `None`.
    settings: BTreeMap<Option<PathBuf>, Arc<Settings>>,
}

impl<'f> Projects<'f> {
    /// No project was read yet.
    pub(crate) fn new(flags: &'f Flags<'f>) -> Self {
        Self { flags, files: BTreeMap::new(), settings: BTreeMap::new() }
    }

    /// How scenes of a folder are drawn.
    ///
    /// # Errors
    /// When the project file is none, or the command line contradicts itself.
    pub(crate) fn settings(&mut self, folder: &Path) -> Result<Arc<Settings>, Unplanned> {
        let named = self.flags.project.map(Path::to_owned);
        let file = self
            .files
            .entry(folder.to_owned())
            .or_insert_with(|| named.clone().or_else(|| nearest_file(folder)))
            .clone();
        if let Some(known) = self.settings.get(&file) {
            return Ok(Arc::clone(known));
        }
        let open = file.clone().map(OpenProject::read).transpose()?;
        let settings = Arc::new(Settings::new(self.flags, open.as_ref())?);
        self.settings.insert(file, Arc::clone(&settings));
        Ok(settings)
    }
}

/// What a project file says of formats, themes and places, its words looked up.
#[derive(Default)]
struct FromProject {
    /// The folder that files go to.
    output: Option<PathBuf>,
    /// What each scene is written as; none where it does not say.
    formats: Vec<&'static Format>,
    /// Themes; none where it does not say.
    themes: Vec<ChosenTheme>,
    /// Dots of an image for each page pixel.
    scale: Option<f64>,
    /// What the steps of a figure become; none where it does not ask for them.
    steps: Option<StepFiles>,
    /// The theme of its page, where it is a file.
    page_theme: Option<Arc<ChosenTheme>>,
}

impl FromProject {
    fn read(project: &OpenProject) -> Result<Self, Unplanned> {
        let said = &project.said;
        let formats = said.formats.iter().map(|word| known_format(project, word));
        let themes = said.themes.iter().map(|word| known_theme(project, word));
        let page_theme = said.canvas.theme().map(|word| known_theme(project, &word)).transpose()?;
        if let Some(scale) = said.scale.as_ref().filter(|scale| scale.value <= 0.0) {
            let (key, got) = ("scale".to_owned(), scale.value.to_string());
            let expected = format!("a number above 0 and up to {MAX_SCALE}");
            return project.wrong(Fault::OutOfRange { key, expected, got }, &scale.span);
        }
        Ok(Self {
            output: said.output.as_ref().map(|output| project.folder().join(&output.value)),
            formats: formats.collect::<Result<_, _>>()?,
            themes: themes.collect::<Result<_, _>>()?,
            scale: said.scale.as_ref().map(|scale| scale.value),
            steps: said.steps.as_deref().and_then(StepFiles::of_word),
            page_theme: page_theme.filter(|theme| theme.file.is_some()).map(Arc::new),
        })
    }
}

/// The format that a project file names.
fn known_format(project: &OpenProject, word: &Spanned<String>) -> Result<&'static Format, Unplanned> {
    if let Some(format) = format(&word.value) {
        return Ok(format);
    }
    let known = FORMATS.iter().map(|format| format.name.to_owned()).collect();
    project.wrong(Fault::UnknownWord { what: "format", got: word.value.clone(), known }, &word.span)
}

/// The theme that a project file names.
pub(crate) fn known_theme(project: &OpenProject, word: &Spanned<String>) -> Result<ChosenTheme, Unplanned> {
    theme_in(project.folder(), &word.value).or_else(|none| {
        let fault = match none {
            NoTheme::File(refused) => return Err(Unplanned::Refused(refused)),
            NoTheme::Said(said) if theme::is_file(&word.value) => {
                let help = "`tracefig list themes` has those that are built in".to_owned();
                Fault::Conflict { message: format!("the theme `{}`: {said}", word.value), help }
            }
            NoTheme::Said(_) => {
                let known = theme::THEMES.iter().map(|theme| theme.name.to_owned()).collect();
                Fault::UnknownWord { what: "theme", got: word.value.clone(), known }
            }
        };
        project.wrong(fault, &word.span)
    })
}
