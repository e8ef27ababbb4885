//! `tracefig watch`: scenes to files, and again whenever something that they are drawn from changes.
//!
//! An editor writes a file in several steps, and a checkout many files, so a change is taken up once it has
//! been quiet for a moment. What has to be drawn again is asked of the files on disk, as `--skip-unchanged`
//! does: a figure that says that it was drawn from this scene with these options stays.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use clap::Args;
use notify::{Event, RecommendedWatcher, RecursiveMode, Watcher, recommended_watcher};
use tracefig::figure::theme;
use tracefig::output::format;

use super::atomic_file::clear_leftovers;
use super::console::Console;
use super::declared::Declared;
use super::files::{Files, Plan};
use super::handout::Told;
use super::inputs::{Input, shown};
use super::jobs::{Job, each_settings, folders_of};
use super::manual::{FIGURES, Manual, PROJECT_FILE};
use super::parallel::in_order;
use super::unfit::Unfits;
use super::unplanned::{Unplanned, tell_unplanned};
use super::written::{Written, makes_folders, write_files};
use super::{Runs, Status};

/// How long nothing may change before a change is taken up: editors rename what they wrote within
/// milliseconds, and a reader who looks from the editor to the picture takes longer.
const QUIET: Duration = Duration::from_millis(80);

/// Options of `watch`.
#[derive(Args)]
pub(crate) struct Watch {
    /// Which scenes, and how they are drawn.
    #[command(flatten)]
    files: Files,
    /// Folder for the files, made if it is not there, or the one file to write, as x.svg; default: the folder
    /// of the project file, else beside each scene
    #[arg(short, long, value_name = "DIR|FILE")]
    output: Option<PathBuf>,
}

/// What is remembered from one round to the next.
#[derive(Default)]
struct Before {
    /// What was told of each scene.
    told: Told,
    /// Scenes among them that gave no figures: what is told of one that did is true until it is drawn again.
    refused: BTreeSet<String>,
    /// The files of all scenes.
    scenes: BTreeSet<PathBuf>,
}

impl Before {
    /// Tells of files that were scenes in the round before and are taken for none by now, as what is left of
    /// one that is being written.
    fn tell_of_others(&mut self, jobs: &[Job], console: &Console) {
        let file = |job: &Job| match &job.input {
            Input::File(path) => Some(path.clone()),
            Input::Stdin | Input::Line { .. } => None,
        };
        let now: BTreeSet<PathBuf> = jobs.iter().filter_map(file).collect();
        for path in self.scenes.difference(&now).filter(|path| path.is_file()) {
            let name = shown(path);
            let message = format!("note: {name} is no scene any more, and its figures stay as they were\n");
            console.note(&message);
            self.told.insert(name.clone(), message);
            self.refused.insert(name);
        }
        self.scenes = now;
    }
}

/// What ends a wait.
enum Wake {
    /// Something changed.
    Changed,
    /// Ctrl-C.
    Stop,
}

impl Runs for Watch {
    const MANUAL: Manual = Manual {
        examples: &[(
            "tracefig watch docs",
            "Draw the scenes of docs, and each again when it changes, until Ctrl-C",
        )],
        files: &[PROJECT_FILE, FIGURES],
        wrong: None,
    };

    fn run(mut self, console: &mut Console) -> io::Result<Status> {
        if self.files.asked.read_stdin() || self.output.as_deref().is_some_and(|to| to.as_os_str() == "-") {
            console.error("`watch` is of files: name scenes or folders, and a folder for the figures");
            return Ok(Status::Usage);
        }
        let (wake, woken) = channel();
        let mut watched = match Watched::new(&wake) {
            Ok(watched) => watched,
            Err(error) => {
                console.error(&format!("can't watch files: {error}"));
                return Ok(Status::Io);
            }
        };
        let (mut before, mut is_planned) = (Before::default(), true);
        for round in 0.. {
            match self.files.plan(self.output.as_deref()) {
                Ok(plan) => {
                    watched.look_at(&self.places(&plan.jobs, &plan.folders), console);
                    before.tell_of_others(&plan.jobs, console);
                    let figures = self.draw(&plan, &mut before, console)?;
                    let documents = self.documents(&plan, (&mut before.told, &mut watched), console)?;
                    let drawn = figures + documents.unwrap_or_default();
                    if !is_planned && drawn == 0 && documents.is_some() {
                        console.note("well again\n");
                    }
                    if round == 0 {
                        console.out.flush()?;
                        console.note(&begun(&plan, drawn));
                    }
                    // The project may have changed since it was read for the figures.
                    is_planned = documents.is_some();
                }
                // Options don't mend themselves; a project file or a folder may.
                Err(usage @ Unplanned::Usage(_)) => return Ok(tell_unplanned(&usage, console)),
                Err(unplanned) => {
                    tell_unplanned(&unplanned, console);
                    watched.look_at(&self.files.asked.named_folders(), console);
                    is_planned = false;
                }
            }
            console.out.flush()?;
            if console.out.is_closed() || !changed(&woken) {
                return Ok(Status::Done);
            }
            if let Err(error) = self.files.read_themes_again() {
                console.error(&error);
            }
        }
        Ok(Status::Done)
    }
}

/// What is looked at from now on, and what ends that, in lines.
fn begun(plan: &Plan, drawn: usize) -> String {
    let count = plan.jobs.len();
    let scenes = if count == 1 { "1 scene".to_owned() } else { format!("{count} scenes") };
    let current = if drawn == 0 { ", up to date" } else { "" };
    // The first of those that were searched is above them.
    let mut above: Vec<&PathBuf> = Vec::new();
    for folder in &plan.folders {
        if !above.iter().any(|known| folder.starts_with(known)) {
            above.push(folder);
        }
    }
    let folders: Vec<String> = above.into_iter().map(|folder| shown(folder)).collect();
    let of = if folders.is_empty() { String::new() } else { format!(" in {}", folders.join(", ")) };
    format!("watching {scenes}{of}{current}; Ctrl-C ends it\n")
}

impl Watch {
    /// The folders in which something lies that the scenes are drawn from.
    fn places(&self, jobs: &[Job], folders: &[PathBuf]) -> BTreeSet<PathBuf> {
        let mut all: BTreeSet<PathBuf> = folders.iter().cloned().collect();
        all.extend(self.files.asked.named_folders());
        all.extend(folders_of(jobs).into_iter().map(Path::to_owned));
        let folder = |path: &Path| path.parent().map(Path::to_owned).unwrap_or_default();
        for job in jobs {
            if let Input::File(path) = &job.input {
                all.insert(folder(path));
                // A theme that the scene itself asks for.
                let file = job.input.open().ok();
                let asked = file.as_ref().and_then(|file| file.scene.canvas.theme.as_ref());
                let theme = asked.filter(|theme| theme::is_file(&theme.value));
                all.extend(theme.map(|theme| folder(&folder(path).join(&theme.value))));
            }
        }
        for settings in each_settings(jobs) {
            let themes = settings.themes.iter().chain(settings.page_theme.as_deref());
            all.extend(themes.filter_map(|theme| theme.file.as_deref()).map(folder));
            all.extend(settings.project.as_deref().map(folder));
        }
        all
    }

    /// Draws what is not what it should be, a line for each scene; what was `told` of a scene and has not
    /// changed is not told again. How many scenes were not up to date.
    fn draw(&self, plan: &Plan, before: &mut Before, console: &mut Console) -> io::Result<usize> {
        let mut count = 0;
        if !makes_folders(folders_of(&plan.jobs), console) {
            return Ok(plan.jobs.len());
        }
        folders_of(&plan.jobs).into_iter().for_each(clear_leftovers);
        let ink = console.ink();
        let work = |job: &Job| {
            let is_current = self.files.is_current(job);
            (!is_current).then(|| write_files(self.files.draw(job, ink), self.files.wait()))
        };
        in_order(&plan.jobs, self.files.threads(), work, |job, written| -> io::Result<()> {
            let name = job.input.shown();
            let Some(written) = written.unwrap_or_else(|| Some(Written::bug(&name))) else {
                if before.refused.remove(&name) {
                    before.told.remove(&name);
                    console.note(&format!("{name}: well again\n"));
                }
                return Ok(());
            };
            count += 1;
            let mut unfits = Unfits::default();
            unfits.extend(written.unfit);
            let messages = written.messages + &unfits.messages();
            if !messages.is_empty() && before.told.get(&name) != Some(&messages) {
                console.out.flush()?;
                Console::message(&messages);
            }
            if !written.names.is_empty() && !console.is_quiet() {
                writeln!(console.out, "{name}: {}", written.names.join(", "))?;
            }
            if written.names.is_empty() {
                before.refused.insert(name.clone());
            } else {
                before.refused.remove(&name);
            }
            before.told.insert(name, messages);
            Ok(())
        })?;
        Ok(count)
    }
}

impl Watch {
    /// Writes the documents of the project that are not what they should be, where all of it is watched. One
    /// whose figures can't be drawn is tried again when one of its scenes reads otherwise. How many were not
    /// up to date; `None` where the project is wrong by now.
    fn documents(
        &self,
        plan: &Plan,
        (told, watched): (&mut Told, &mut Watched),
        console: &mut Console,
    ) -> io::Result<Option<usize>> {
        let declared =
            if self.output.is_none() { Declared::all(&self.files, &plan.jobs) } else { Ok(Vec::new()) };
        let declared = match declared {
            Ok(declared) => declared,
            Err(unplanned) => {
                tell_unplanned(&unplanned, console);
                return Ok(None);
            }
        };
        let mut count = 0;
        for document in declared {
            watched.look_at(&self.places(&document.jobs, &[]), console);
            let name = shown(&document.path);
            if document.is_current(&self.files) {
                told.remove(&name);
                continue;
            }
            count += 1;
            let texts = read_texts(&document.jobs);
            if told.get(&name) != Some(&texts) {
                console.out.flush()?;
                match document.write(&self.files, told, console)? {
                    Status::Done => told.remove(&name),
                    _ => told.insert(name, texts),
                };
            }
        }
        Ok(Some(count))
    }
}

/// What the scenes of a document say, as one text; of one that can't be read, nothing.
fn read_texts(jobs: &[Job]) -> String {
    let text = |job: &Job| match &job.input {
        Input::File(path) => fs::read_to_string(path).unwrap_or_default(),
        Input::Stdin | Input::Line { .. } => String::new(),
    };
    jobs.iter().map(text).collect::<Vec<_>>().join("\0")
}

/// Waits until something has changed and all is quiet again; whether that was before Ctrl-C.
fn changed(woken: &Receiver<Wake>) -> bool {
    if !matches!(woken.recv(), Ok(Wake::Changed)) {
        return false;
    }
    loop {
        match woken.recv_timeout(QUIET) {
            Ok(Wake::Changed) => {}
            Ok(Wake::Stop) | Err(RecvTimeoutError::Disconnected) => return false,
            Err(RecvTimeoutError::Timeout) => return true,
        }
    }
}

/// Folders that are looked at.
struct Watched {
    /// Who hears of changes.
    watcher: RecommendedWatcher,
    /// The folders so far.
    folders: BTreeSet<PathBuf>,
}

impl Watched {
    /// Nothing is looked at yet; changes, and Ctrl-C, wake whoever waits.
    fn new(wake: &Sender<Wake>) -> Result<Self, String> {
        let (change, stop) = (wake.clone(), wake.clone());
        let heard = move |event: notify::Result<Event>| {
            if event.is_ok_and(|event| concerns(&event)) {
                let _ = change.send(Wake::Changed);
            }
        };
        let watcher = recommended_watcher(heard).map_err(|error| error.to_string())?;
        ctrlc::set_handler(move || {
            let _ = stop.send(Wake::Stop);
        })
        .map_err(|error| error.to_string())?;
        Ok(Self { watcher, folders: BTreeSet::new() })
    }

    /// Looks at these folders, too, though not at those in them.
    fn look_at(&mut self, folders: &BTreeSet<PathBuf>, console: &Console) {
        for folder in folders {
            let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
            // Again, as a folder may be gone and come back.
            match self.watcher.watch(here, RecursiveMode::NonRecursive) {
                Ok(()) => drop(self.folders.insert(folder.clone())),
                Err(error) if !self.folders.contains(folder) => {
                    console.note(&format!("note: can't watch {}: {error}\n", here.display()));
                }
                Err(_) => drop(self.folders.remove(folder)),
            }
        }
    }
}

/// Whether an event may be of a scene, a theme, a project file or a folder, or of a figure that is gone:
/// figures that were just written are none of these, and to be read changes nothing.
fn concerns(event: &Event) -> bool {
    let ends_so = |path: &PathBuf| path.extension().is_none_or(|e| e == "toml" || e == "json");
    let is_figure = |path: &PathBuf| path.extension().is_some_and(|e| format(&e.to_string_lossy()).is_some());
    let is_gone = event.kind.is_remove() && event.paths.iter().any(is_figure);
    !event.kind.is_access() && (is_gone || event.paths.iter().any(ends_so))
}
