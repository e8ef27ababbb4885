//! `tracefig check`: is every figure on disk what its scene gives today?

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use tracefig::drift::report::{Finding, advice, json, tally};
use tracefig::drift::{Rendered, State, compare_and_show};
use tracefig::output::MOST_BYTES;
use tracefig::scene::{Ink, visible};

use super::atomic_file::{Wait, clear_leftovers, write_whole};
use super::checked::{Checked, ERROR, ORPHAN};
use super::console::Console;
use super::declared::Declared;
use super::differences::{details, measured, told_before};
use super::encoded::Encoded;
use super::files::{Drawn, Files, Plan};
use super::handout::{Sheets, Told};
use super::inputs::shown;
use super::jobs::{Job, Target, Twins, bound_jobs, compared_jobs, folders_of, inputs_of, sheet_jobs, twins};
use super::manual::{FIGURES, Manual, PROJECT_FILE};
use super::orphans::unclaimed;
use super::parallel::in_order;
use super::regular::{read_regular, replaceable};
use super::reports::{Places, Reported};
use super::unchecked::{of_doubtful, of_folders, of_twins};
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
    /// One document of all these figures, a PDF or a presentation, as `render -o FILE` writes it, instead of
    /// their own files
    #[arg(long, value_name = "FILE")]
    handout: Option<PathBuf>,
    /// How figures are put onto its sheets.
    #[command(flatten)]
    sheets: Sheets,
    /// Where the findings go.
    #[command(flatten)]
    places: Places,
    /// Write what changed, is stale or is missing
    #[arg(long)]
    accept: bool,
    /// Delete orphans: figures of ours that no scene or project file asks for any more
    #[arg(long)]
    prune: bool,
    /// Channel levels (of 255) by which a pixel may differ; SVGs are drawn to be compared
    #[arg(long, value_name = "LEVELS", default_value_t = 0)]
    tolerance: u8,
    /// Print the findings as JSON
    #[arg(long)]
    json: bool,
}

/// Where the picture of each figure's differences goes.
type Pictures = BTreeMap<PathBuf, PathBuf>;

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
        if self.files.asked.read_stdin() {
            let message = "`check` compares files, and a scene from standard input has none: name its file";
            return Ok(tell_unplanned(&Unplanned::Usage(message.to_owned()), console));
        }
        let planner = match &self.handout {
            None => compared_jobs,
            Some(_) if self.sheets.are_asked() => sheet_jobs,
            Some(_) => bound_jobs,
        };
        let plan = match self.files.plan_by(self.handout.as_deref(), planner) {
            Ok(plan) => plan,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let declared = match &self.handout {
            None => Declared::all(&self.files, &plan.jobs),
            Some(_) => Ok(Vec::new()),
        };
        let declared = match declared {
            Ok(declared) => declared,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let mut kept = inputs_of(&plan.jobs);
        for document in &declared {
            kept.keep(&document.path, "a handout of this project");
        }
        let pictures = match self.places.planned(&plan.jobs, kept, self.json) {
            Ok(pictures) => pictures,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        clear_leftovers(self.places.folder());
        self.places.clear();
        if self.accept {
            folders_of(&plan.jobs).into_iter().for_each(clear_leftovers);
        }
        let mut all = match self.sheets.encoded(&self.files, (&plan.jobs, &Told::new()), console)? {
            Ok(None) => self.check_all(&plan, &pictures, console)?,
            Err(Status::Usage) => return Ok(Status::Usage),
            document => {
                let path = self.handout.as_deref().unwrap_or(Path::new(""));
                self.check_document(path, document, console)?
            }
        };
        if self.handout.is_some() {
            let unread = of_folders(&plan);
            self.tell(&unread, console)?;
            all.add(unread);
        }
        for document in declared {
            let encoded = document.encoded(&self.files, &all.told, console)?;
            all.add(self.check_document(&document.path, encoded, console)?);
        }
        let written = self.places.write(&all.findings, &mut console.out);
        Console::message(&written.failed);
        self.conclude(&all, &written, console)?;
        Ok(match all.findings.iter().all(|finding| self.is_settled(finding)) {
            _ if !written.failed.is_empty() => all.status.max(Status::Io),
            true => all.status,
            false => all.status.max(Status::Wrong),
        })
    }
}

impl Check {
    /// Compares the figures of all scenes, and looks for those of none; says what it finds on the way.
    fn check_all(&self, plan: &Plan, pictures: &Pictures, console: &mut Console) -> io::Result<Checked> {
        let (ink, twins) = (console.ink(), twins(&plan.jobs));
        let (mut all, mut unfits) = (Checked::new(), Unfits::default());
        let apart: Vec<&Job> = plan.jobs.iter().filter(|job| !are_among(&twins, job)).collect();
        in_order(
            &apart,
            self.files.threads(),
            |job| self.compare_all(job, self.files.draw(job, ink), pictures),
            |job, checked| -> io::Result<()> {
                let bug = || Checked::bug((&job.input.name(), &job.input.shown()));
                let mut checked = checked.unwrap_or_else(bug);
                unfits.extend(std::mem::take(&mut checked.unfit));
                self.tell(&checked, console)?;
                all.add(checked);
                Ok(())
            },
        )?;
        unfits.tell(console)?;
        if self.handout.is_some() {
            return Ok(all);
        }
        for more in [of_twins(&twins), of_folders(plan)] {
            self.tell(&more, console)?;
            all.add(more);
        }
        let unclaimed = self.unclaimed(plan, all.is_unread, ink);
        self.tell(&unclaimed, console)?;
        all.add(unclaimed);
        Ok(all)
    }

    /// Compares the one document of all figures, where it could be made, and says what it finds.
    fn check_document(
        &self,
        path: &Path,
        document: Result<Option<Encoded>, Status>,
        console: &mut Console,
    ) -> io::Result<Checked> {
        let mut checked = Checked::new();
        match document {
            Ok(document) => document.iter().for_each(|document| {
                self.compare_one((path, &self.places.picture_of(path)), document, &mut checked);
            }),
            Err(status) => {
                checked.miss(&path.display().to_string(), status, "not all of its figures can be drawn");
            }
        }
        self.tell(&checked, console)?;
        Ok(checked)
    }

    /// The figures that no scene gives: orphans, deleted where that is wanted, and those of files that may be
    /// their scenes. Where not every scene could be read, nothing is called an orphan.
    fn unclaimed(&self, plan: &Plan, is_unread: bool, ink: Ink) -> Checked {
        let (mut checked, found) = (Checked::new(), unclaimed(plan));
        for (scene, figures) in &found.doubtful {
            checked.add(of_doubtful(scene, figures, ink));
        }
        if is_unread && !found.orphans.is_empty() {
            let count = found.orphans.len();
            let (figures, stay) = if count == 1 { ("figure", "stays") } else { ("figures", "stay") };
            checked.say(&format!(
                "note: {count} {figures} without a scene {stay}: not every scene or folder could be read\n"
            ));
            return checked;
        }
        for orphan in found.orphans {
            let (name, path) = (orphan.path.display().to_string(), &orphan.path);
            let told = if self.prune {
                // A link stays, as what it leads to was not asked about.
                match replaceable(path).and_then(|()| std::fs::remove_file(path)) {
                    Ok(()) => orphan.deleted(),
                    Err(error) => {
                        let message = format!("error: can't delete {}: {error}\n", shown(path));
                        checked.fail(&name, Status::Io, &message);
                        continue;
                    }
                }
            } else {
                orphan.told()
            };
            checked.findings.push(Finding { details: vec![told], ..Finding::new(&name, ORPHAN) });
        }
        checked
    }

    /// Says what was found, unless standard output is for a report.
    fn tell(&self, checked: &Checked, console: &mut Console) -> io::Result<()> {
        if !checked.messages.is_empty() {
            console.out.flush()?;
            Console::message(&checked.messages);
        }
        if self.json || self.places.take_stdout() {
            return Ok(());
        }
        let bad: Vec<&Finding> = checked.findings.iter().filter(|f| f.is_bad() && f.state != ERROR).collect();
        for (k, finding) in bad.iter().enumerate() {
            writeln!(console.out, "{:<9} {}", finding.state, visible(&finding.file))?;
            let (alike, other) = told_before(finding, &bad[..k]);
            if let Some(other) = other {
                writeln!(console.out, "          as {} ({alike} lines)", visible(&other.file))?;
            }
            for line in &finding.details[alike..] {
                writeln!(console.out, "          {}", visible(line))?;
            }
            if let Some((path, _)) = &finding.picture {
                writeln!(console.out, "          {}: on disk · difference · now", visible(path))?;
            }
        }
        Ok(())
    }

    /// Says how many files have each state, and what to do about them.
    fn conclude(&self, all: &Checked, written: &Reported, console: &mut Console) -> io::Result<()> {
        let findings = &all.findings;
        if self.json {
            return console.out.write_all(json(findings).as_bytes());
        }
        let is_well = !findings.iter().any(Finding::is_bad);
        if self.places.take_stdout() || (console.is_quiet() && is_well) {
            return Ok(());
        }
        if written.has_page {
            writeln!(console.out, "all of it: {}", shown(&self.places.page()))?;
        }
        let always = ["identical", "changed", "missing"];
        let counts: Vec<_> = tally(findings)
            .into_iter()
            .filter(|(state, count)| *count > 0 || always.contains(state))
            .map(|(state, count)| format!("{count} {state}"))
            .collect();
        writeln!(console.out, "{}{}", counts.join(", "), self.accepted(all))?;
        let open = findings.iter().filter(|finding| !self.is_settled(finding));
        let advice = advice(&open.map(|f| Finding::new(&f.file, f.state)).collect::<Vec<_>>());
        advice.map_or(Ok(()), |advice| writeln!(console.out, "{advice}"))
    }

    /// Whether a finding is well, or made so by this run.
    fn is_settled(&self, finding: &Finding) -> bool {
        match finding.state {
            ERROR => false,
            ORPHAN => self.prune,
            _ => !finding.is_bad() || self.accept,
        }
    }

    /// How many of the files that differ were written, in words.
    fn accepted(&self, all: &Checked) -> String {
        let differ =
            all.findings.iter().filter(|f| f.is_bad() && ![ERROR, ORPHAN].contains(&f.state)).count();
        match all.accepted {
            _ if !self.accept || differ == 0 => String::new(),
            count if count == differ => ", accepted".to_owned(),
            count => format!(", {count} of {differ} accepted"),
        }
    }

    /// Compares all files of a scene.
    fn compare_all(&self, job: &Job, drawn: Drawn, pictures: &Pictures) -> Checked {
        let mut checked = Checked::new();
        checked.messages = drawn.messages;
        if drawn.status != Status::Done {
            let mut messages = checked.messages.clone();
            messages.extend(drawn.unfit.iter().map(Unfit::message));
            checked.miss(&job.input.name(), drawn.status, &messages);
            checked.is_unread = drawn.status == Status::Io;
        }
        checked.unfit = drawn.unfit;
        checked.keep_told(job.input.shown());
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
                    match written {
                        Ok(()) => finding.picture = Some((picture.display().to_string(), image)),
                        Err(error) => checked.cant(&mut finding, &cant_write(picture, &error)),
                    }
                }
            }
        }
        if state != State::Identical && self.accept {
            match write_whole(path, &encoded.bytes, self.files.wait()) {
                Ok(()) => checked.accepted += usize::from(finding.is_bad()),
                Err(error) => checked.cant(&mut finding, &cant_write(path, &error)),
            }
        }
        checked.findings.push(finding);
    }
}

/// Whether a scene is one of two that would become one file.
fn are_among(twins: &[Twins<'_>], job: &Job) -> bool {
    twins.iter().any(|twins| twins.inputs.contains(&&job.input))
}
