//! `tracefig check`: is every figure on disk what its scene gives today?

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use tracefig::drawing::Rect;
use tracefig::drift::report::{Finding, json, tally};
use tracefig::drift::{
    Change, Measured, PixelDrift, Rendered, State, compare_and_show, elements_in, what_moved,
};
use tracefig::output::{Format, MOST_BYTES};
use tracefig::scene::visible;

use super::atomic_file::{Wait, clear_leftovers, write_whole};
use super::console::Console;
use super::encoded::Encoded;
use super::files::{Drawn, Files, Plan};
use super::inputs::shown;
use super::jobs::{Job, Target, folders_of, inputs_of};
use super::manual::{FIGURES, Manual, PROJECT_FILE};
use super::orphans::orphans;
use super::parallel::in_order;
use super::regular::{read_regular, replaceable};
use super::reports::Places;
use super::unfit::{Unfit, Unfits};
use super::unplanned::{Unplanned, tell_unplanned};
use super::written::cant_write;
use super::{Runs, Status};

/// Options of `check`.
#[derive(Args)]
pub(crate) struct Check {
    /// Which scenes, and how they are drawn.
    #[command(flatten)]
    files: Files,
    /// Where the findings go.
    #[command(flatten)]
    places: Places,
    /// Write what changed, is stale or is missing
    #[arg(long)]
    accept: bool,
    /// Delete orphans: figures of ours whose scene is gone
    #[arg(long)]
    prune: bool,
    /// Channel levels (of 255) by which a pixel may differ; SVGs are drawn to be compared
    #[arg(long, value_name = "LEVELS", default_value_t = 0)]
    tolerance: u8,
    /// Print the findings as JSON
    #[arg(long)]
    json: bool,
}

/// The state of a file that can't be drawn, read or written.
const ERROR: &str = "error";

/// The state of a figure without a scene.
const ORPHAN: &str = "orphan";

/// Where the picture of each figure's differences goes.
type Pictures = BTreeMap<PathBuf, PathBuf>;

/// What `check` says of a scene.
struct Checked {
    /// A finding for each file, in the order of the job.
    findings: Vec<Finding>,
    /// What is said on standard error.
    messages: String,
    /// What the scene has against its themes, to be said once for all scenes.
    unfit: Vec<Unfit>,
    /// Why something could not be checked, the worst of it.
    status: Status,
}

impl Checked {
    /// Nothing is said yet.
    fn new() -> Self {
        let (findings, messages, unfit) = (Vec::new(), String::new(), Vec::new());
        Self { findings, messages, unfit, status: Status::Done }
    }

    /// Adds a file that could not be checked, and why, which is said.
    fn fail(&mut self, file: &str, status: Status, message: &str) {
        self.messages.push_str(message);
        self.miss(file, status, message);
    }

    /// Adds a file that could not be checked, and why.
    fn miss(&mut self, file: &str, status: Status, message: &str) {
        self.status = self.status.max(status);
        let details = message.lines().take(1).map(str::to_owned).collect();
        self.findings.push(Finding { details, ..Finding::new(file, ERROR) });
    }
}

impl Runs for Check {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig check", "Compare the figures of the project, or of figures/"),
            (
                "tracefig check docs --junit check.xml --tolerance 2",
                "Let pixels differ by two levels, and write the findings for a CI",
            ),
            (
                "tracefig check docs --accept --prune",
                "Write what changed, and delete figures whose scene is gone",
            ),
        ],
        files: &[
            PROJECT_FILE,
            FIGURES,
            ("target/tracefig-check/", "a page and pictures of what differs, unless -o names another folder"),
        ],
        wrong: Some("a figure is not what its scene gives, or a scene is wrong"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        if self.files.read_stdin() {
            let message = "`check` compares files, and a scene from standard input has none: name its file";
            return Ok(tell_unplanned(&Unplanned::Usage(message.to_owned()), console));
        }
        let plan = match self.files.plan(None) {
            Ok(plan) => plan,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let jobs = &plan.jobs;
        let pictures = match self.places.planned(jobs, inputs_of(jobs), self.json) {
            Ok(pictures) => pictures,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let ink = console.ink();
        clear_leftovers(self.places.folder());
        self.places.clear();
        if self.accept {
            folders_of(jobs).into_iter().for_each(clear_leftovers);
        }
        let (mut findings, mut unfits, mut status) = (Vec::new(), Unfits::default(), Status::Done);
        in_order(
            jobs,
            self.files.threads(),
            |job| self.compare_all(job, self.files.draw(job, ink), &pictures),
            |job, checked| -> io::Result<()> {
                let mut checked = checked.unwrap_or_else(|| {
                    let mut bug = Checked::new();
                    let name = job.input.shown();
                    bug.fail(
                        &job.input.name(),
                        Status::Bug,
                        &format!("error: {name} was not drawn because of a bug of tracefig\n"),
                    );
                    bug
                });
                unfits.extend(std::mem::take(&mut checked.unfit));
                status = status.max(checked.status);
                self.tell(&checked.findings, &checked.messages, console)?;
                findings.extend(checked.findings);
                Ok(())
            },
        )?;
        unfits.tell(console)?;
        let orphans = self.orphans(&plan);
        self.tell(&orphans.findings, &orphans.messages, console)?;
        findings.extend(orphans.findings);
        status = status.max(orphans.status);
        let failed = self.places.write(&findings, &mut console.out);
        Console::message(&failed);
        self.conclude(&findings, console)?;
        let settled = |f: &Finding| match f.state {
            ERROR => false,
            ORPHAN => self.prune,
            _ => !f.is_bad() || self.accept,
        };
        Ok(match findings.iter().all(settled) {
            _ if !failed.is_empty() => status.max(Status::Io),
            true => status,
            false => status.max(Status::Wrong),
        })
    }
}

impl Check {
    /// The figures without a scene, deleted where that is wanted.
    fn orphans(&self, plan: &Plan) -> Checked {
        let mut checked = Checked::new();
        for path in orphans(plan) {
            let name = path.display().to_string();
            let told = if self.prune {
                // A link stays, as what it leads to was not asked about.
                match replaceable(&path).and_then(|()| std::fs::remove_file(&path)) {
                    Ok(()) => "it had no scene, and was deleted",
                    Err(error) => {
                        checked.fail(
                            &name,
                            Status::Io,
                            &format!("error: can't delete {}: {error}\n", shown(&path)),
                        );
                        continue;
                    }
                }
            } else {
                "it has no scene: bring its scene back, or delete it by `--prune`"
            };
            checked.findings.push(Finding { details: vec![told.to_owned()], ..Finding::new(&name, ORPHAN) });
        }
        checked
    }

    /// Says what was found, unless standard output is for a report.
    fn tell(&self, findings: &[Finding], messages: &str, console: &mut Console) -> io::Result<()> {
        if !messages.is_empty() {
            console.out.flush()?;
            Console::message(messages);
        }
        if self.json || self.places.take_stdout() {
            return Ok(());
        }
        for finding in findings.iter().filter(|f| f.is_bad() && f.state != ERROR) {
            writeln!(console.out, "{:<9} {}", finding.state, visible(&finding.file))?;
            for line in &finding.details {
                writeln!(console.out, "          {}", visible(line))?;
            }
            if let Some((path, _)) = &finding.picture {
                writeln!(console.out, "          {}: expected · difference · actual", visible(path))?;
            }
        }
        Ok(())
    }

    /// Says how many files have each state.
    fn conclude(&self, findings: &[Finding], console: &mut Console) -> io::Result<()> {
        if self.json {
            return console.out.write_all(json(findings).as_bytes());
        }
        let is_well = !findings.iter().any(Finding::is_bad);
        if self.places.take_stdout() || (console.is_quiet() && is_well) {
            return Ok(());
        }
        if !is_well {
            writeln!(console.out, "all of it: {}", shown(&self.places.page()))?;
        }
        let always = ["identical", "changed", "missing"];
        let counts: Vec<_> = tally(findings)
            .into_iter()
            .filter(|(state, count)| *count > 0 || always.contains(state))
            .map(|(state, count)| format!("{count} {state}"))
            .collect();
        let accepted = if self.accept { ", accepted" } else { "" };
        writeln!(console.out, "{}{accepted}", counts.join(", "))
    }

    /// Compares all files of a scene.
    fn compare_all(&self, job: &Job, drawn: Drawn, pictures: &Pictures) -> Checked {
        let mut checked = Checked::new();
        checked.messages = drawn.messages;
        if drawn.status != Status::Done {
            let mut messages = checked.messages.clone();
            messages.extend(drawn.unfit.iter().map(Unfit::message));
            checked.miss(&job.input.name(), drawn.status, &messages);
        }
        checked.unfit = drawn.unfit;
        for encoded in &drawn.files {
            match &encoded.target {
                Target::File(path) => {
                    // How many steps there are is known when they are drawn.
                    let of_a_step = || self.places.picture_of(path);
                    let picture = pictures.get(path).cloned().unwrap_or_else(of_a_step);
                    self.compare_one((path, &picture), encoded, &mut checked);
                }
                Target::Stdout => {
                    checked.fail(
                        "<stdin>",
                        Status::Usage,
                        "error: a scene from standard input has no files to check\n",
                    );
                }
            }
        }
        checked
    }

    /// Compares a file with what lies in its place, and writes it where that is accepted; where they differ,
    /// there is then a picture of it.
    fn compare_one(&self, (path, picture): (&Path, &Path), encoded: &Encoded, checked: &mut Checked) {
        let name = path.display().to_string();
        let on_disk = match read_regular(path, MOST_BYTES) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => {
                return checked.fail(
                    &name,
                    Status::Io,
                    &format!("error: can't read {}: {error}\n", shown(path)),
                );
            }
        };
        let (format, scale) = (encoded.format, encoded.options.scale);
        let rendered = Rendered { format, bytes: &encoded.bytes, scale };
        let (state, image) = match on_disk.as_deref() {
            Some(old) if Files::differs_in_stamp(old, encoded) => (State::Identical, None),
            old => compare_and_show(old, rendered),
        };
        let mut finding = Finding::new(&name, state.word());
        match &state {
            State::Identical => {}
            State::Missing => finding.details.push("there is no such file yet".to_owned()),
            State::Changed(change) if change.is_within(self.tolerance) => {
                finding.state = "identical";
            }
            State::Changed(change) | State::Stale(change) => {
                let old = on_disk.unwrap_or_default();
                let measured = measured(change, &old, encoded);
                finding.details = details(change, (&old, format), encoded, &measured);
                finding.measured = Some(measured);
                if let Some(image) = image {
                    let written = std::fs::create_dir_all(self.places.folder())
                        .and_then(|()| write_whole(picture, &image, Wait::No));
                    if let Err(error) = written {
                        checked.fail(&name, Status::Io, &cant_write(picture, &error));
                    }
                    finding.picture = Some((picture.display().to_string(), image));
                }
            }
        }
        let differs = state != State::Identical;
        checked.findings.push(finding);
        if differs
            && self.accept
            && let Err(error) = write_whole(path, &encoded.bytes, self.files.wait())
        {
            checked.fail(&name, Status::Io, &cant_write(path, &error));
        }
    }
}

/// How a file differs, in numbers.
fn measured(change: &Change, old: &[u8], encoded: &Encoded) -> Measured {
    let pixels = change.pixels().cloned();
    let elements = pixels.as_ref().and_then(|drift| drift.area).map_or_else(Vec::new, |area| {
        let [x0, y0, x1, y1] = area.map(|dots| f64::from(dots) / encoded.options.scale);
        elements_in(&encoded.drawing, Rect { x0, y0, x1, y1 })
    });
    Measured { bytes: [old.len(), encoded.bytes.len()], pixels, elements }
}

/// How a file differs, in lines.
fn details(
    change: &Change,
    (old, format): (&[u8], &Format),
    encoded: &Encoded,
    measured: &Measured,
) -> Vec<String> {
    let mut lines = what_moved(format, old, &encoded.bytes);
    lines.push(change.to_string());
    lines.extend(measured.pixels.as_ref().map(PixelDrift::under_tolerances));
    let names: Vec<&str> = measured.elements.iter().map(|element| element.name.as_str()).collect();
    if !names.is_empty() {
        lines.push(format!("in the changed area: {}", names.join(", ")));
    }
    lines
}
