//! `render -o FILE` of several scenes: their figures on the sheets of one document, or its slides; and what
//! `check --handout FILE` compares such a file with.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::drawing::Drawing;
use tracefig::drift::{text_chunk, text_chunk_of_several};
use tracefig::output::{FORMATS, Format, Handout, Heading, MOST_A_SHEET, OutputError, PAPERS};

use tracefig::scene::DeclaredHandout;

use super::Status;
use super::atomic_file::write_whole;
use super::console::Console;
use super::encoded::Encoded;
use super::files::{Files, says};
use super::inputs::shown;
use super::jobs::{Job, Target, bound_file};
use super::parallel::in_order;
use super::unfit::Unfits;
use super::written::{Written, cant_write};

/// What was said of each scene when it was drawn last; nothing where it is well.
pub(crate) type Told = BTreeMap<String, String>;

/// Smaller letters, in points, are hard to read on paper: footnotes of books have 7 to 8.
const SMALLEST: f64 = 7.0;

/// How the figures of several scenes are put onto sheets.
#[derive(Args, Clone, Debug)]
pub(crate) struct Sheets {
    /// Figures on a sheet, where one PDF holds several scenes; default: 2
    #[arg(long, value_name = "N", value_parser = per_page, conflicts_with = "steps")]
    per_page: Option<usize>,
    /// Paper of these sheets; default: a4
    #[arg(long, conflicts_with = "steps",
        value_parser = PossibleValuesParser::new(PAPERS.map(|paper| paper.name)))]
    paper: Option<String>,
    /// Leave out the line "Figure N" below each figure of these sheets
    #[arg(long, conflicts_with = "steps")]
    no_numbers: bool,
    /// Words above the figures of the first of these sheets, as "Sheet 3: distances"
    #[arg(long, value_name = "TEXT", conflicts_with = "steps")]
    heading: Option<String>,
    /// A line for a name at the right of the first of these sheets
    #[arg(long, conflicts_with = "steps")]
    name_line: bool,
    /// Whether one figure is a document as well.
    #[arg(skip)]
    is_document: bool,
}

/// A number of figures as written on the command line.
fn per_page(text: &str) -> Result<usize, String> {
    let known = text.parse().ok().filter(|n| (1..=MOST_A_SHEET).contains(n));
    known.ok_or_else(|| format!("expected a whole number from 1 to {MOST_A_SHEET}"))
}

/// A document of several figures that is to be written.
struct Document {
    /// Its file.
    path: PathBuf,
    /// The format of the file.
    format: &'static Format,
    /// How the figures are put onto sheets; `None` for slides.
    handout: Option<Handout>,
}

impl Sheets {
    /// The sheets of a document that a project declares, even of one figure.
    pub(crate) fn of_a_project(said: &DeclaredHandout) -> Self {
        Self {
            per_page: said.per_page.as_ref().map(|count| count.value),
            paper: said.paper.as_ref().map(|paper| paper.value.clone()),
            no_numbers: said.numbers.as_ref().is_some_and(|numbers| !numbers.value),
            heading: said.heading.as_ref().map(|heading| heading.value.clone()),
            name_line: said.name_line.as_ref().is_some_and(|line| line.value),
            is_document: true,
        }
    }

    /// Whether anything is said of sheets.
    pub(crate) fn are_asked(&self) -> bool {
        let words = self.no_numbers || self.heading.is_some() || self.name_line;
        self.per_page.is_some() || self.paper.is_some() || words
    }

    /// Writes the document of a run; `None` where the run writes other files.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn write(
        &self,
        files: &Files,
        jobs: &[Job],
        console: &mut Console,
    ) -> io::Result<Option<Status>> {
        self.write_besides(files, jobs, &Told::new(), console)
    }

    /// Writes the document of a run, of whose scenes something may be told already, which then is not told
    /// again; `None` where the run writes other files.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn write_besides(
        &self,
        files: &Files,
        jobs: &[Job],
        told: &Told,
        console: &mut Console,
    ) -> io::Result<Option<Status>> {
        match self.document(jobs) {
            Ok(None) => Ok(None),
            Ok(Some(document)) => document.write(files, (jobs, told), console).map(Some),
            Err(message) => {
                console.error(&message);
                Ok(Some(Status::Usage))
            }
        }
    }

    /// The document of a run, as it would be written; `None` where the run writes other files. What became
    /// of a figure that can't be drawn, or why they are no document, is said.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn encoded(
        &self,
        files: &Files,
        (jobs, told): (&[Job], &Told),
        console: &mut Console,
    ) -> io::Result<Result<Option<Encoded>, Status>> {
        let document = match self.document(jobs) {
            Ok(Some(document)) => document,
            Ok(None) => return Ok(Ok(None)),
            Err(message) => {
                console.error(&message);
                return Ok(Err(Status::Usage));
            }
        };
        let figures = match figures(files, (jobs, told), console)? {
            Ok(figures) => figures,
            Err(status) => return Ok(Err(status)),
        };
        Ok(document.bound(&figures).map(Some).map_err(|message| {
            Console::message(&message);
            Status::Wrong
        }))
    }

    /// Whether the document of a run is there and says that it was made of these scenes as they are.
    pub(crate) fn is_current(&self, files: &Files, jobs: &[Job]) -> bool {
        let Ok(Some(document)) = self.document(jobs) else { return false };
        let hashes: Option<Vec<Vec<String>>> = jobs.iter().map(|job| files.hashes(job)).collect();
        let carried =
            |hashes: Vec<Vec<String>>| hashes.concat().iter().map(|hash| text_chunk(hash)).collect();
        let Some(all): Option<Vec<String>> = hashes.map(carried) else { return false };
        let all: Vec<&str> = all.iter().map(String::as_str).collect();
        let chunk = document.hash(&all);
        let hash = chunk.split_once(' ').map_or(chunk.as_str(), |(hash, _)| hash);
        says(&document.path, document.format, hash)
    }

    /// The document that a run writes, where it writes one.
    ///
    /// # Errors
    /// Where sheets are asked for and the run writes files of other kinds.
    fn document(&self, jobs: &[Job]) -> Result<Option<Document>, String> {
        let is_asked = self.are_asked();
        let files = jobs.iter().map(|job| job.files.len()).sum::<usize>();
        let bound = bound_file(jobs);
        if is_asked && !bound.is_some_and(|(_, format)| format.has_sheets()) {
            let with_sheets = FORMATS.iter().filter(|format| format.has_sheets());
            let names: Vec<String> = with_sheets.map(|format| format!("-o FILE.{}", format.name)).collect();
            return Err(format!(
                "options of sheets, as `--per-page`, need one file for all figures: {}",
                names.join(" or ")
            ));
        }
        let document = |(path, format): (&Path, &'static Format)| Document {
            path: path.to_owned(),
            format,
            handout: format.has_sheets().then(|| self.handout()),
        };
        Ok(bound.filter(|_| is_asked || self.is_document || files > 1).map(document))
    }

    /// How figures are put onto sheets: as asked, else as usual.
    fn handout(&self) -> Handout {
        let usual = Handout::default();
        let paper = PAPERS.into_iter().find(|paper| self.paper.as_deref() == Some(paper.name));
        Handout {
            paper: paper.unwrap_or(usual.paper),
            per_page: self.per_page.unwrap_or(usual.per_page),
            numbers: !self.no_numbers,
            heading: Heading { title: self.heading.clone().unwrap_or_default(), name: self.name_line },
        }
    }
}

impl Document {
    /// Draws the scenes and writes their figures as one file, or none where one of them fails.
    ///
    /// # Errors
    /// When standard output fails.
    fn write(
        &self,
        files: &Files,
        (jobs, told): (&[Job], &Told),
        console: &mut Console,
    ) -> io::Result<Status> {
        let figures = match figures(files, (jobs, told), console)? {
            Ok(figures) => figures,
            Err(status) => {
                console.error(&format!("{} is not written without all its figures", shown(&self.path)));
                return Ok(status);
            }
        };
        let mut written = Written::nothing();
        match self.bound(&figures) {
            Ok(Encoded { bytes, .. }) => match write_whole(&self.path, &bytes, files.wait()) {
                Ok(()) => written.names.push(shown(&self.path)),
                Err(error) => {
                    written.messages = cant_write(&self.path, &error);
                    written.status = Status::Io;
                }
            },
            Err(message) => {
                written.messages = message;
                written.status = Status::Wrong;
            }
        }
        written.messages.push_str(&self.small_letters(&figures));
        written.tell(console)?;
        Ok(written.status)
    }

    /// What the file carries, of what its figures carry.
    fn hash(&self, all: &[&str]) -> String {
        text_chunk_of_several(all, &format!("{:?}", self.handout))
    }

    /// The figures as one file, which says by a hash what it was made of; or why they are none, in a
    /// message.
    fn bound(&self, figures: &[(String, Encoded)]) -> Result<Encoded, String> {
        let wrong = |error: OutputError| format!("error: {}: {error}\n", shown(&self.path));
        let Some((_, first)) = figures.first() else { return Err(wrong(OutputError::NoSheets)) };
        let all: Vec<&str> = figures.iter().map(|(_, file)| file.drawing.hash.as_str()).collect();
        let hash = self.hash(&all);
        let of_one =
            |(_, file): &(String, Encoded)| Drawing { hash: hash.clone(), ..(*file.drawing).clone() };
        let drawings: Vec<Drawing> = figures.iter().map(of_one).collect();
        let drawings: Vec<&Drawing> = drawings.iter().collect();
        let bytes = match &self.handout {
            None => self.format.slides(&drawings, &first.options),
            Some(handout) => handout.write(&drawings, self.format),
        };
        Ok(Encoded {
            bytes: bytes.map_err(wrong)?,
            drawing: Arc::clone(&first.drawing),
            options: first.options,
            format: self.format,
            target: Target::File(self.path.clone()),
        })
    }

    /// A warning of letters that are hard to read on these sheets; empty where all are large enough.
    fn small_letters(&self, figures: &[(String, Encoded)]) -> String {
        let Some(handout) = &self.handout else { return String::new() };
        let drawings: Vec<&Drawing> = figures.iter().map(|(_, file)| &*file.drawing).collect();
        let letters = handout.letters(&drawings);
        let small = figures.iter().zip(letters).filter_map(|((name, _), size)| Some((name, size?)));
        let small: Vec<_> = small.filter(|(_, size)| *size < SMALLEST).collect();
        let Some((name, size)) = small.iter().min_by(|(_, a), (_, b)| a.total_cmp(b)) else {
            return String::new();
        };
        // Variants of a scene are figures of their own, and have its name.
        let scenes: BTreeSet<&String> = small.iter().map(|(name, _)| *name).collect();
        let others = match scenes.len() - 1 {
            0 => String::new(),
            1 => " and small ones in another scene".to_owned(),
            more => format!(" and small ones in {more} more scenes"),
        };
        format!(
            "warning: letters of {size:.1} points in {name}{others}: under {SMALLEST} they are hard to read; \
             fewer figures on a sheet are larger\n"
        )
    }
}

/// Draws the scenes: their figures with the names of their scenes, or what became of one of them.
///
/// # Errors
/// When standard output fails.
fn figures(
    files: &Files,
    (jobs, told): (&[Job], &Told),
    console: &mut Console,
) -> io::Result<Result<Vec<(String, Encoded)>, Status>> {
    let ink = console.ink();
    let (mut status, mut figures) = (Status::Done, Vec::new());
    let mut unfits = Unfits::default();
    in_order(
        jobs,
        files.threads(),
        |job| files.draw(job, ink),
        |job, drawn| -> io::Result<()> {
            let name = job.input.shown();
            let Some(drawn) = drawn else {
                status = status.max(Status::Bug);
                return Written::bug(&name).tell(console);
            };
            status = status.max(drawn.status);
            let own = Unfits::of(drawn.unfit);
            if told.get(&name) != Some(&(drawn.messages.clone() + &own.messages())) {
                Console::message(&drawn.messages);
                unfits.join(own);
            }
            figures.extend(drawn.files.into_iter().map(|file| (name.clone(), file)));
            Ok(())
        },
    )?;
    unfits.tell(console)?;
    Ok(if status == Status::Done { Ok(figures) } else { Err(status) })
}

#[cfg(test)]
mod tests {
    use tracefig::scene::limits::MAX_A_SHEET;

    use super::*;

    #[test]
    fn a_project_file_takes_as_many_figures_a_sheet_as_the_command_line() {
        assert_eq!(MAX_A_SHEET, MOST_A_SHEET);
        assert!(per_page("36").is_ok() && per_page("37").is_err());
    }
}
