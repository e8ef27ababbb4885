//! What `render` and `check` share: their options, and a scene's files as bytes.

use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::drift::{Stamp, facts, fingerprint, hash_of_line, is_whole, restamped};
use tracefig::figure::theme;
use tracefig::figure::{Figure, no_playhead, not_held};
use tracefig::output::{Format, INLINE, MOST_BYTES, Options, PngEffort};
use tracefig::scene::{Ink, Refused, Scene, SceneFile, Variant, visible};

use super::Status;
use super::asked::Asked;
use super::atomic_file::Wait;
use super::encoded::{Encoded, encode_all};
use super::encoding::{cant_encode, figure_id, warn};
use super::failure::Failure;
use super::in_motion::{MotionOptions, planned as planned_for};
use super::in_steps::StepOptions;
use super::in_time::InTime;
use super::inputs::{Found, Input, find};
use super::jobs::{Job, Planned, Planner, Target, jobs};
use super::live::{Live, live_of};
use super::narrow::narrow;
use super::own_themes::{NoOwnTheme, OwnThemes};
use super::parallel::threads;
use super::project::OpenProject;
use super::regular::read_regular;
use super::settings::{Projects, Settings};
use super::themes::ChosenTheme;
use super::timings::Timings;
use super::unfit::Unfit;
use super::unplanned::Unplanned;
use super::variants::{Unvaried, scene_of, varied};

/// Which scenes, and how they are drawn.
#[derive(Args)]
pub(crate) struct Files {
    /// Which scenes, and as what.
    #[command(flatten)]
    pub(crate) asked: Asked,
    /// How a PNG is packed: fast, or small (slower, the same pixels)
    #[arg(long, default_value = PngEffort::default().word(),
        value_parser = PossibleValuesParser::new(PngEffort::ALL.map(PngEffort::word)))]
    png: String,
    /// Whether figures are drawn in steps.
    #[command(flatten)]
    steps: StepOptions,
    /// Whether figures play.
    #[command(flatten)]
    motion: MotionOptions,
    /// Colours of a theme file that readers can't tell apart are warnings, not errors
    #[arg(long)]
    allow_similar: bool,
    /// A label that finds no free place, and a layer or moment that the answer lacks, are errors
    #[arg(long)]
    strict: bool,
    /// Scenes drawn at once, at most; the files are the same for any number; default: as many as there are
    /// processors
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Wait until the disk has the files, so that they survive a loss of power
    #[arg(long)]
    sync: bool,
    /// Whether pages are live, and how.
    #[arg(skip)]
    pub(crate) live: Option<Live>,
    /// The theme files that scenes name, as far as they were read.
    #[arg(skip)]
    own_themes: OwnThemes,
}

/// A scene's files, or what is wrong.
pub(crate) struct Drawn {
    /// In the order of the job's files; empty where there is an error.
    pub(crate) files: Vec<Encoded>,
    /// Messages, ready to be shown.
    pub(crate) messages: String,
    /// What it has against its themes.
    pub(crate) unfit: Vec<Unfit>,
    /// What the errors among them are.
    pub(crate) status: Status,
    /// Where the time went.
    pub(crate) timings: Timings,
}

/// What is drawn: a scene of a job, or a variant of it.
struct Subject<'f> {
    /// The job.
    job: &'f Job,
    /// The file of the scene.
    file: &'f SceneFile,
    /// What is drawn of it.
    scene: &'f Scene,
    /// The theme of the file that the scene names.
    own: Option<&'f ChosenTheme>,
    /// How messages look.
    ink: Ink,
}

/// What a run is to draw.
pub(crate) struct Plan {
    /// The scenes with their files.
    pub(crate) jobs: Vec<Job>,
    /// The folders that were searched for scenes.
    pub(crate) folders: Vec<PathBuf>,
    /// Folders among them that can't be read, and why.
    pub(crate) unread: Vec<(PathBuf, io::Error)>,
    /// Whether the scenes are all that the project has.
    pub(crate) is_whole: bool,
    /// What was left alone, in a line; empty where nothing was.
    pub(crate) left_alone: String,
}

/// Whether a file is there and says that this tracefig made it of what has that hash.
pub(crate) fn says(path: &Path, format: &Format, hash: &str) -> bool {
    let bytes = read_regular(path, MOST_BYTES).ok();
    let stamp = |bytes: Vec<u8>| Stamp::read(format, &bytes).filter(|_| is_whole(format, &bytes));
    bytes.and_then(stamp).is_some_and(|stamp| stamp.is_of(hash))
}

impl Files {
    /// What is to be drawn; `output` is where the command line wants the files.
    pub(crate) fn plan(&self, output: Option<&Path>) -> Result<Plan, Unplanned> {
        self.plan_by(output, jobs)
    }

    /// What is to be drawn, its files named by a planner.
    pub(crate) fn plan_by(&self, output: Option<&Path>, planner: Planner) -> Result<Plan, Unplanned> {
        let project = if self.asked.scenes.is_empty() { self.asked.project()? } else { None };
        let found = find(&self.asked.scenes, project.as_ref())?;
        let left_alone = found.left_alone();
        let Found { scenes, folders, unread, .. } = found;
        let jobs = planner(scenes, &mut Projects::new(&self.asked.flags(output, self.in_time())?))?;
        Ok(Plan { jobs, folders, unread, is_whole: self.asked.scenes.is_empty(), left_alone })
    }

    /// How scenes of the working directory are drawn.
    pub(crate) fn settings_here(&self, output: Option<&Path>) -> Result<Arc<Settings>, Unplanned> {
        Projects::new(&self.asked.flags(output, self.in_time())?).settings(Path::new(""))
    }

    /// How figures are shown in time; none where the command line does not ask for that.
    fn in_time(&self) -> Option<InTime> {
        let steps = self.steps.files().map(InTime::Steps);
        if self.motion.is_asked() { Some(InTime::Motion) } else { steps }
    }

    /// The project of a run that draws all of its scenes as it says; none where an argument or an option
    /// asks for something else.
    ///
    /// # Errors
    /// When the project file can't be read, or is none.
    pub(crate) fn whole_project(&self) -> Result<Option<OpenProject>, Unplanned> {
        let is_whole = self.asked.is_nothing() && self.in_time().is_none() && self.live.is_none();
        if is_whole { self.asked.project() } else { Ok(None) }
    }

    /// Whether files are waited for until the disk has them.
    pub(crate) fn wait(&self) -> Wait {
        Wait::asked(self.sync)
    }

    /// Reads the theme files anew.
    ///
    /// # Errors
    /// Where one is none; the themes are then as they were.
    pub(crate) fn read_themes_again(&mut self) -> Result<(), String> {
        self.own_themes = OwnThemes::default();
        self.asked.read_themes_again()
    }

    /// How many scenes are drawn at once.
    pub(crate) fn threads(&self) -> NonZeroUsize {
        threads(self.threads)
    }

    /// Reads, answers and draws one scene.
    pub(crate) fn draw(&self, job: &Job, ink: Ink) -> Drawn {
        let mut timings = Timings::start();
        let (mut messages, mut unfit) = (String::new(), Vec::new());
        let made = self.encoded(job, ink, (&mut messages, &mut unfit), &mut timings);
        let (files, status) = made.unwrap_or_else(|Failure { status, message }| {
            timings.lap("failed");
            messages.push_str(&message);
            (Vec::new(), status)
        });
        Drawn { files, messages, unfit, status, timings }
    }

    /// Whether every file of a scene is there and says that this tracefig drew it from this scene and these
    /// options.
    pub(crate) fn is_current(&self, job: &Job) -> bool {
        let Some(hashes) = self.hashes(job) else { return false };
        job.files.iter().zip(hashes).all(|(planned, hash)| {
            let Target::File(path) = &planned.target else { return false };
            !job.settings.are_apart(planned.format) && says(path, planned.format, &hash)
        })
    }

    /// The hashes that the files of a scene carry, in their order, without drawing it; `None` where the scene
    /// or its theme can't be read.
    pub(crate) fn hashes(&self, job: &Job) -> Option<Vec<String>> {
        let file = opened(job).ok()?;
        let word = file.scene.canvas.theme.as_ref().map_or(theme::THEMES[0].name, |t| t.value.as_str());
        let own = self.own_theme(&file, job, Ink::Plain).ok()?;
        let own = own.as_ref().map_or(word, |own| &own.key);
        let hash = |planned: &Planned| {
            let theme = job.settings.theme(planned.theme.as_deref()).map_or(own, |chosen| &chosen.key);
            self.hash((job, planned), &file, theme, &self.options(job, planned))
        };
        Some(job.files.iter().map(hash).collect())
    }

    /// The theme of the file that a scene names, or its project for it, where it is drawn in its own.
    fn own_theme(
        &self,
        file: &SceneFile,
        job: &Job,
        ink: Ink,
    ) -> Result<Option<Arc<ChosenTheme>>, NoOwnTheme> {
        let is_drawn = job.files.iter().any(|planned| planned.theme.is_none());
        match &job.settings.page_theme {
            _ if !is_drawn => Ok(None),
            // What a project says has no place in the scene.
            Some(theme) if file.scene.canvas.theme.as_ref().is_some_and(|t| t.span.is_empty()) => {
                Ok(Some(Arc::clone(theme)))
            }
            _ => self.own_themes.of(file, &job.input, ink),
        }
    }

    /// Whether a file shows what it should and only says of itself that it was drawn from another text, or by
    /// another version.
    pub(crate) fn differs_in_stamp(old: &[u8], now: &Encoded) -> bool {
        let format = now.format;
        let Some(stamp) = Stamp::read(format, old).filter(|_| old != now.bytes) else { return false };
        format.encode(&restamped(&now.drawing, &stamp), &now.options).is_ok_and(|bytes| bytes == old)
    }

    /// The files of a scene, or what is wrong.
    fn encoded(
        &self,
        job: &Job,
        ink: Ink,
        (messages, unfit): (&mut String, &mut Vec<Unfit>),
        timings: &mut Timings,
    ) -> Result<(Vec<Encoded>, Status), Failure> {
        let file = opened(job).map_err(|refused| Failure::of(&refused, ink))?;
        timings.lap("read");
        let refuse = |problems| Refused { source: file.source.clone(), problems }.render(ink);
        let own = self.own_theme(&file, job, ink).map_err(|none| {
            unfit.push(Unfit::file(&file, none));
            Failure::told()
        })?;
        let told = |unvaried: Unvaried| match unvaried {
            Unvaried::Wrong(problems) => refuse(problems),
            unvaried => unvaried.message(&visible(&file.source.name)),
        };
        let most = job.files.iter().filter_map(|planned| planned.seed).max();
        let varied = varied(&file, most).map_err(told)?;
        let mut files: Vec<Encoded> = Vec::new();
        for same_variant in job.files.chunk_by(|a, b| (a.seed, a.variant) == (b.seed, b.variant)) {
            let Some(first) = same_variant.first() else { continue };
            let other = first.seed.and_then(|seed| varied.get(seed.checked_sub(1)?));
            let scene = scene_of(other.map_or(&file, |found| &found.file), first.variant).map_err(told)?;
            let subject = Subject { job, file: &file, scene: &scene, own: own.as_deref(), ink };
            files.extend(self.encoded_variant(&subject, same_variant, (messages, unfit), timings)?);
        }
        Ok((files, Status::Done))
    }

    /// The files of a variant of a scene, or what is wrong.
    fn encoded_variant(
        &self,
        &Subject { job, file, scene, own, ink }: &Subject<'_>,
        all: &[Planned],
        (messages, unfit): (&mut String, &mut Vec<Unfit>),
        timings: &mut Timings,
    ) -> Result<Vec<Encoded>, Failure> {
        let refuse = |problems| Refused { source: file.source.clone(), problems }.render(ink);
        let (in_time, theme) = (job.settings.in_time, own.or(job.settings.themes.first()));
        let plan = planned_for(scene, theme.map(|chosen| &chosen.theme), in_time).map_err(refuse)?;
        timings.lap("plan");
        let mut files: Vec<Encoded> = Vec::new();
        // The formats of a theme follow one another and share a drawing.
        for same_theme in all.chunk_by(|a, b| a.theme == b.theme) {
            let Some(first) = same_theme.first() else { continue };
            let chosen = job.settings.theme(first.theme.as_deref()).or(own);
            let theme = chosen.map_or(plan.theme, |chosen| &chosen.theme);
            // Texts are set and views fitted for the sizes of one theme; those of the house have the same.
            let other = (theme.text, theme.strokes) != (plan.theme.text, plan.theme.strokes);
            let planned_anew =
                if other { Some(planned_for(scene, Some(theme), in_time).map_err(refuse)?) } else { None };
            let plan = planned_anew.as_ref().unwrap_or(&plan);
            let id = figure_id(job, first);
            let drawn = self.motion.drawn(in_time, (plan, theme, &id)).map_err(refuse)?;
            let lacking = self.live.map(|_| not_held(scene, &drawn).into_iter().chain(no_playhead(scene)));
            let lacking: Vec<_> = lacking.into_iter().flatten().collect();
            let Figure { mut drawing, mut warnings, .. } = drawn;
            warnings.extend(lacking);
            drawing.narrow = narrow((scene, theme), (&drawing, in_time), same_theme);
            if self.steps.words {
                drawing = plan.with_words_below(drawing, theme);
            }
            timings.lap("draw");
            if self.strict && !warnings.is_empty() {
                return Err(refuse(warnings).into());
            }
            if files.is_empty() {
                // Labels stand at the same places in every theme.
                warn(file, &warnings, ink, messages);
            }
            if let Some(chosen) = chosen {
                let formats = same_theme.iter().map(|planned| planned.format);
                let found = Unfit::colors(&file.source.name, (chosen, &drawing), formats, self.allow_similar);
                let is_refused = !found.is_empty() && !self.allow_similar;
                unfit.extend(found);
                if is_refused {
                    return Err(Failure::told());
                }
            }
            // Drawing a plan says which events are shown.
            let facts = facts(plan);
            let key = chosen.map_or(theme.name, |chosen| &chosen.key);
            let asked = |planned: &Planned| {
                let options = self.options(job, planned);
                (options, self.hash((job, planned), file, key, &options))
            };
            let encode = |drawing: &_, planned: &Planned, options: &_| match live_of(self.live, planned) {
                Some(live) => live.page(drawing, (job, file), &planned.target, chosen),
                None => planned.format.encode(drawing, options),
            };
            let same_theme = (same_theme, in_time);
            let made = encode_all(drawing, same_theme, &facts, (asked, encode), timings);
            let made = made.map_err(|(planned, error)| cant_encode(file, planned, &error, ink))?;
            files.extend(made);
        }
        Ok(files)
    }

    /// The hash of a file's scene and of all that its bytes depend on besides.
    fn hash(
        &self,
        (job, planned): (&Job, &Planned),
        file: &SceneFile,
        theme: &str,
        options: &Options,
    ) -> String {
        let format = live_of(self.live, planned).map_or(planned.format, |_| &INLINE);
        let mut key = format.key(theme, options);
        if planned.variant != Variant::Figure {
            key.push_str(" variant=");
            key.push_str(planned.variant.word());
        }
        if let Some(seed) = planned.seed {
            key.push_str(" seed=");
            key.push_str(&seed.to_string());
        }
        let own = fingerprint(&file.meaning, &key);
        if let Input::Line { .. } = job.input { hash_of_line(&own) } else { own }
    }

    /// What is asked of the format of a file.
    fn options(&self, job: &Job, planned: &Planned) -> Options {
        let (in_time, format) = (job.settings.in_time, planned.format);
        let steps = self.steps.in_one(in_time, format);
        let motion = self.motion.in_one(in_time, format, self.steps.hold);
        Options { scale: job.settings.scale, png: self.effort(), steps, motion }
    }

    /// How a PNG is packed.
    fn effort(&self) -> PngEffort {
        PngEffort::ALL.into_iter().find(|effort| effort.word() == self.png).unwrap_or_default()
    }
}

/// The scene of a job, on the page that its project gives it.
fn opened(job: &Job) -> Result<SceneFile, Box<Refused>> {
    job.input.open()?.with_canvas(&job.settings.canvas)
}
