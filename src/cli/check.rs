//! `tracefig check`: is every figure on disk what its scene gives today?

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use tracefig::drift::{Rendered, State, compare, triptych};

use super::console::Console;
use super::files::{Drawn, Files, tell_unplanned};
use super::in_order::in_order;
use super::jobs::{Job, Planned, Target};
use super::render::cant_write;
use super::whole_file::write_whole;
use super::{Runs, Status};

/// Options of `check`.
#[derive(Args)]
pub(crate) struct Check {
    #[command(flatten)]
    files: Files,
    /// Folder for the images expected · difference · actual of changed figures
    #[arg(short, long, value_name = "DIR", default_value = "target/tracefig-check")]
    output: PathBuf,
    /// Write what changed or is missing
    #[arg(long)]
    accept: bool,
}

impl Runs for Check {
    fn run(self, console: &mut Console) -> io::Result<Status> {
        let jobs = match self.files.jobs(None) {
            Ok(jobs) => jobs,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        let ink = console.ink();
        let mut total = Tally::default();
        in_order(
            &jobs,
            |job| self.compare_all(job, self.files.draw(job, ink)),
            |job, checked| -> io::Result<()> {
                let checked = checked.unwrap_or_else(|| Checked::bug(job));
                if !checked.messages.is_empty() {
                    console.out.flush()?;
                    Console::message(&checked.messages);
                }
                console.out.write_all(checked.lines.as_bytes())?;
                total.add(&checked.tally);
                Ok(())
            },
        )?;
        let Tally { identical, changed, missing, failed } = total;
        let accepted = if self.accept { ", accepted" } else { "" };
        writeln!(console.out, "{identical} identical, {changed} changed, {missing} missing{accepted}")?;
        let good = failed == 0 && (self.accept || changed + missing == 0);
        Ok(if good { Status::Done } else { Status::Wrong })
    }
}

/// How many files are what.
#[derive(Default)]
struct Tally {
    identical: usize,
    changed: usize,
    missing: usize,
    /// Scenes that can't be drawn, files that can't be read or written.
    failed: usize,
}

impl Tally {
    fn add(&mut self, other: &Self) {
        self.identical += other.identical;
        self.changed += other.changed;
        self.missing += other.missing;
        self.failed += other.failed;
    }
}

/// What `check` says of a scene.
#[derive(Default)]
struct Checked {
    lines: String,
    messages: String,
    tally: Tally,
}

impl Checked {
    fn bug(job: &Job) -> Self {
        let messages = format!("error: {} was not drawn because of a bug of tracefig\n", job.input.name());
        Self { messages, tally: Tally { failed: 1, ..Tally::default() }, ..Self::default() }
    }

    fn line(&mut self, line: &str) {
        self.lines.push_str(line);
        self.lines.push('\n');
    }

    fn fail(&mut self, message: &str) {
        self.messages.push_str(message);
        self.tally.failed += 1;
    }
}

impl Check {
    fn compare_all(&self, job: &Job, drawn: Drawn) -> Checked {
        let mut checked = Checked { messages: drawn.messages, ..Checked::default() };
        checked.tally.failed += usize::from(drawn.failed);
        for (file, bytes) in job.files.iter().zip(&drawn.bytes) {
            match &file.target {
                Target::File(path) => self.compare_one(path, file, bytes, &mut checked),
                Target::Stdout => checked.fail("error: a scene from standard input has no files to check\n"),
            }
        }
        checked
    }

    fn compare_one(&self, path: &Path, file: &Planned, bytes: &[u8], checked: &mut Checked) {
        let on_disk = match std::fs::read(path) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return checked.fail(&format!("error: can't read {}: {error}\n", path.display())),
        };
        let state = compare(on_disk.as_deref(), Rendered { extension: file.format.name, bytes });
        let name = path.display();
        match &state {
            State::Identical => {
                checked.tally.identical += 1;
                return;
            }
            State::Missing => {
                checked.tally.missing += 1;
                checked.line(&format!("missing   {name}"));
            }
            State::Changed(change) => {
                checked.tally.changed += 1;
                checked.line(&format!("changed   {name}: {change}"));
                if let Some(image) = on_disk.and_then(|old| triptych(&old, bytes)) {
                    self.picture(path, &image, checked);
                }
            }
        }
        if self.accept
            && let Err(error) = write_whole(path, bytes)
        {
            checked.fail(&cant_write(path, &error));
        }
    }

    /// Writes expected · difference · actual.
    fn picture(&self, of: &Path, image: &[u8], checked: &mut Checked) {
        let path = self.output.join(of.file_name().unwrap_or_default());
        let written = std::fs::create_dir_all(&self.output).and_then(|()| write_whole(&path, image));
        match written {
            Ok(()) => checked.line(&format!("          {}: expected · difference · actual", path.display())),
            Err(error) => checked.fail(&cant_write(&path, &error)),
        }
    }
}
