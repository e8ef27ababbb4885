//! `tracefig render`: scenes to files.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::atomic_file::clear_leftovers;
use super::console::Console;
use super::declared::Declared;
use super::files::{Files, Plan};
use super::gallery::finish;
use super::handout::{Sheets, Told};
use super::inputs::tell_unread;
use super::jobs::{Job, bound_jobs, folders_of, sheet_jobs};
use super::live::Live;
use super::manual::{FIGURES, Manual, PROJECT_FILE};
use super::parallel::in_order;
use super::partition::Partition;
use super::settings::Destination;
use super::stream::{Drawable, LinesToDraw};
use super::timings::Timings;
use super::unfit::Unfits;
use super::unplanned::{Unplanned, tell_unplanned};
use super::written::{Written, makes_folders, write_files};
use super::{Runs, Status};

/// Options of `render`.
#[derive(Args)]
pub(crate) struct Render {
    /// Which scenes, and how they are drawn.
    #[command(flatten)]
    files: Files,
    /// Folder for the files, made if it is not there, or the one file to write, as x.svg; `-` is standard
    /// output; default: the folder of the project file, else beside each scene
    #[arg(short, long, value_name = "DIR|FILE")]
    output: Option<PathBuf>,
    /// Read a scene (as JSON) a line from standard input, as `solve` does; each becomes files named by its
    /// `id`, changed where no file can be called so or an earlier one differs in case alone, or `line-N`
    /// without one; a second line of one `id` is refused
    #[arg(long, conflicts_with_all = ["scenes", "skip_unchanged", "partition",
        "per_page", "paper", "no_numbers", "heading", "name_line"])]
    jsonl: bool,
    /// Leave scenes alone whose files say that this version drew them from the same scene and options
    #[arg(long, conflicts_with_all = ["per_page", "paper", "no_numbers", "heading", "name_line"])]
    skip_unchanged: bool,
    /// Draw only the Kth of N equal shares of the scenes, so that N machines share the work
    #[arg(long, value_name = "K/N")]
    partition: Option<Partition>,
    /// Pages whose figures a reader drags, steps through and asks by numbers; each has all that it needs, or
    /// with `shared` takes it from one file beside them. Needs a format that has such pages; in a folder, a
    /// page lists them
    #[arg(long, value_name = "shared", num_args = 0..=1, require_equals = true,
        default_missing_value = "alone", value_parser = Live::of_word,
        conflicts_with_all = ["jsonl", "skip_unchanged", "in_time", "per_page", "paper", "no_numbers",
            "heading", "name_line"])]
    live: Option<Live>,
    /// How figures are put onto sheets.
    #[command(flatten)]
    sheets: Sheets,
    /// Tell on standard error where the time went, added over all scenes
    #[arg(long)]
    timings: bool,
}

impl Runs for Render {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig render", "Draw the scenes of the project, or of figures/"),
            (
                "tracefig render docs -o docs/img --theme auto",
                "Draw every scene in docs and the folders in it, as the same tree below docs/img",
            ),
            (
                "tracefig render --jsonl -o out < pairs.jsonl",
                "Draw a scene a line, each into files named by its id",
            ),
        ],
        files: &[PROJECT_FILE, FIGURES],
        wrong: Some("a scene or a theme file is wrong"),
    };

    fn run(mut self, console: &mut Console) -> io::Result<Status> {
        if self.jsonl {
            return self.stream(console);
        }
        if let Some(live) = self.live {
            self.files.live = Some(live);
            // What is wrong with the settings is told with the plan.
            if let Ok(settings) = self.files.settings_here(self.output.as_deref()) {
                Live::add_pictures(&settings.destination, &mut self.files.asked.format);
            }
        }
        let planner = if self.sheets.are_asked() { sheet_jobs } else { bound_jobs };
        let Plan { jobs, left_alone, unread, .. } = match self.files.plan_by(self.output.as_deref(), planner)
        {
            Ok(plan) => plan,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let declared = match self.declared(&jobs) {
            Ok(declared) => declared,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        console.note(&left_alone);
        let searched = tell_unread(&unread, console);
        if self.live.is_some() && !jobs.iter().flat_map(|job| &job.files).any(|f| f.format.live.is_some()) {
            console.error(&format!("`--live` needs `--format {}`", Live::formats()));
            return Ok(Status::Usage);
        }
        if !makes_folders(folders_of(&jobs), console) {
            return Ok(Status::Io);
        }
        // Twins are looked for among all scenes, whichever share is drawn.
        let jobs = match self.partition {
            Some(partition) => partition.of_all(jobs),
            None => jobs,
        };
        folders_of(&jobs).into_iter().for_each(clear_leftovers);
        if self.skip_unchanged && self.sheets.is_current(&self.files, &jobs) {
            return Ok(searched);
        }
        if let Some(status) = self.sheets.write(&self.files, &jobs, console)? {
            return Ok(status.max(searched));
        }
        let (drawn, told) = self.draw_all(&jobs, console)?;
        let mut status = drawn.max(searched);
        for document in declared {
            if self.skip_unchanged && document.is_current(&self.files) {
                continue;
            }
            status = status.max(document.write(&self.files, &told, console)?);
        }
        Ok(status)
    }
}

impl Render {
    /// The documents that the project declares, where all of it is drawn.
    fn declared(&self, figures: &[Job]) -> Result<Vec<Declared>, Unplanned> {
        let is_elsewhere = self.output.is_some() || self.partition.is_some() || self.sheets.are_asked();
        if is_elsewhere { Ok(Vec::new()) } else { Declared::all(&self.files, figures) }
    }

    /// Draws scenes and writes their files; what was said of each is the second.
    fn draw_all(&self, jobs: &[Job], console: &mut Console) -> io::Result<(Status, Told)> {
        let bar = progress(jobs.len(), console);
        let alone = bar.is_hidden();
        let ink = console.ink();
        let (mut status, mut timings) = (Status::Done, Timings::start());
        let (mut names, mut unfits, mut told) = (BTreeSet::new(), Unfits::default(), Told::new());
        let work = |job: &Job| {
            if self.skip_unchanged && self.files.is_current(job) {
                Written::nothing()
            } else {
                write_files(self.files.draw(job, ink), self.files.wait())
            }
        };
        in_order(jobs, self.files.threads(), work, |job, written| -> io::Result<()> {
            let mut written = written.unwrap_or_else(|| Written::bug(&job.input.shown()));
            status = status.max(written.status);
            timings.add(&written.timings);
            names.extend(written.names.iter().cloned());
            let own = Unfits::of(std::mem::take(&mut written.unfit));
            told.insert(job.input.shown(), written.messages.clone() + &own.messages());
            unfits.join(own);
            bar.suspend(|| -> io::Result<()> {
                written.tell(console)?;
                // While the bar is away, lest the two write over each other.
                if alone { Ok(()) } else { console.out.flush() }
            })?;
            bar.inc(1);
            Ok(())
        })?;
        bar.finish_and_clear();
        unfits.tell(console)?;
        if let Some(live) = self.live {
            status = status.max(finish(live, jobs, &names, console)?);
        }
        if self.timings {
            Console::message(&timings.to_string());
        }
        Ok((status, told))
    }

    /// Draws a stream of scenes.
    fn stream(&self, console: &mut Console) -> io::Result<Status> {
        let settings = match self.files.settings_here(self.output.as_deref()) {
            Ok(settings) => settings,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let folder = match &settings.destination {
            Destination::Stdout | Destination::File(_) => {
                console.error("a stream becomes many files: `-o` takes a folder");
                return Ok(Status::Usage);
            }
            Destination::Beside => Path::new(""),
            Destination::Folder(folder) | Destination::Project(folder) => folder,
        };
        if !makes_folders([folder], console) {
            return Ok(Status::Io);
        }
        clear_leftovers(folder);
        let ink = console.ink();
        let (mut status, mut timings) = (Status::Done, Timings::start());
        let mut unfits = Unfits::default();
        let mut stream = LinesToDraw::new(io::stdin().lock(), ink);
        loop {
            let batch = match stream.next_batch(&settings, self.files.threads()) {
                Ok(batch) if batch.is_empty() => break,
                Ok(batch) => batch,
                Err(error) => {
                    console.out.flush()?;
                    console.error(&format!("can't read standard input: {error}"));
                    status = Status::Io;
                    break;
                }
            };
            let work = |line: &Drawable| match line {
                Drawable::Job(job) => write_files(self.files.draw(job, ink), self.files.wait()),
                Drawable::Refused(messages) => Written::refused(messages.clone()),
            };
            in_order(&batch, self.files.threads(), work, |line, written| -> io::Result<()> {
                let mut written = written.unwrap_or_else(|| Written::bug(&line.shown()));
                unfits.extend(std::mem::take(&mut written.unfit));
                status = status.max(written.status);
                timings.add(&written.timings);
                written.tell(console)
            })?;
            console.out.flush()?;
        }
        unfits.tell(console)?;
        if self.timings {
            Console::message(&timings.to_string());
        }
        Ok(status)
    }
}

/// A bar where someone watches and there is something to wait for.
fn progress(scenes: usize, console: &Console) -> ProgressBar {
    if !console.is_watched() || scenes < 2 {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} scenes, {eta} left");
    let bar = ProgressBar::with_draw_target(Some(scenes as u64), ProgressDrawTarget::stderr());
    style.map_or(bar.clone(), |style| bar.with_style(style))
}
