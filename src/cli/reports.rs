//! Where a check writes: pictures of differences and a page of them, `JUnit` XML, a summary.
//!
//! Nothing of it may take the place of a scene or of an expected figure, so all places are known, and
//! refused, before anything is compared.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

use clap::Args;
use tracefig::drift::report::{Finding, html, is_page, junit, markdown};
use tracefig::drift::{TRIPTYCH_FORMAT, is_triptych};
use tracefig::figure::theme;
use tracefig::output::MOST_BYTES;

use super::atomic_file::{Wait, write_whole};
use super::inputs::shown;
use super::jobs::{Job, Target, folders_of};
use super::outputs::{Kept, one_name, write_report};
use super::regular::read_regular;
use super::unplanned::Unplanned;
use super::written::cant_write;

/// Options of `check` that say where findings go.
#[derive(Args)]
pub(crate) struct Places {
    /// Folder for the images on disk · difference · now of changed figures, and a page that shows all
    #[arg(short, long, value_name = "DIR", default_value = "target/tracefig-check")]
    output: PathBuf,
    /// Write the findings as `JUnit` XML; `-` is standard output, a device or a pipe is written into
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Append the findings as Markdown, as to $`GITHUB_STEP_SUMMARY`; `-` is standard output
    #[arg(long, value_name = "FILE")]
    summary: Option<PathBuf>,
}

/// The page of all findings, in the folder of the pictures.
const PAGE: &str = "index.html";

/// Bytes of the page's beginning by which it is known as ours.
const HEAD: usize = 4_096;

/// The words of standard output as a place; the second is a link that leads to whatever that is.
const STDOUT: [&str; 2] = ["-", "/dev/stdout"];

/// Whether a report goes to standard output.
fn is_stdout(place: Option<&PathBuf>) -> bool {
    place.is_some_and(|path| STDOUT.iter().any(|word| path.as_os_str() == *word))
}

impl Places {
    /// Whether a report goes to standard output, and nothing else may.
    pub(crate) fn take_stdout(&self) -> bool {
        is_stdout(self.junit.as_ref()) || is_stdout(self.summary.as_ref())
    }

    /// The folder of the pictures.
    pub(crate) fn folder(&self) -> &Path {
        &self.output
    }

    /// The page of all findings.
    pub(crate) fn page(&self) -> PathBuf {
        self.output.join(PAGE)
    }

    /// Takes away what an earlier check left: its page, and its pictures of differences.
    pub(crate) fn clear(&self) {
        for path in self.output.read_dir().into_iter().flatten().flatten().map(|entry| entry.path()) {
            let is_ours = match path.file_name() {
                Some(name) if name == PAGE => read_regular(&path, HEAD).is_ok_and(|head| is_page(&head)),
                _ if path.extension().is_some_and(|e| e == TRIPTYCH_FORMAT.name) => {
                    read_regular(&path, MOST_BYTES).is_ok_and(|bytes| is_triptych(&bytes))
                }
                _ => false,
            };
            // What can't be deleted is written over, or stays.
            if is_ours && !path.is_symlink() {
                let _ = std::fs::remove_file(&path);
            }
        }
    }

    /// Where the picture of a figure goes that was not planned: it has the names of the figure's folders, as
    /// others may be called the same.
    pub(crate) fn picture_of(&self, figure: &Path) -> PathBuf {
        let normal = figure.components().filter_map(|part| match part {
            Component::Normal(part) => Some(part),
            _ => None,
        });
        let mut name = normal.collect::<Vec<_>>().join(OsStr::new("-"));
        name.push(".");
        name.push(TRIPTYCH_FORMAT.name);
        self.output.join(name)
    }

    /// Where the picture of each figure goes; `kept` are the files that the run reads, and `json` is whether
    /// the findings go to standard output as JSON.
    ///
    /// # Errors
    /// When a report would take the place of a scene, of a figure or of another report.
    pub(crate) fn planned(
        &self,
        jobs: &[Job],
        mut kept: Kept,
        json: bool,
    ) -> Result<BTreeMap<PathBuf, PathBuf>, Unplanned> {
        let usage = |message: String| Err(Unplanned::Usage(message));
        let on_stdout = [json, is_stdout(self.junit.as_ref()), is_stdout(self.summary.as_ref())];
        if on_stdout.into_iter().filter(|&is| is).count() > 1 {
            return usage("standard output takes one of `--json`, `--junit -` and `--summary -`".to_owned());
        }
        if self.output.is_symlink() {
            let folder = shown(&self.output);
            return usage(format!("{folder} is a link: end it in `/` to write into the folder it leads to"));
        }
        let folder = one_name(&self.output);
        if folders_of(jobs).into_iter().any(|of| one_name(&of.join(PAGE)) == folder.join(PAGE)) {
            return usage(format!(
                "the figures lie in {}: give another folder with `-o` for what differs",
                shown(&self.output)
            ));
        }
        for file in jobs.iter().flat_map(|job| &job.files) {
            if let Target::File(path) = &file.target {
                kept.keep(path, "a figure of this run");
            }
        }
        for place in [&self.junit, &self.summary].into_iter().flatten() {
            if let Some(what) = kept.what(place) {
                return usage(format!("{} is {what}, and a report can't take its place", shown(place)));
            }
            // Which theme a scene names is known when it is read.
            if theme::is_file(&place.to_string_lossy()) && place.is_file() {
                let place = shown(place);
                return usage(format!(
                    "{place} may be a scene or a theme, and a report can't take its place"
                ));
            }
            kept.keep(place, "another report of this run");
        }
        Ok(pictures(jobs, &self.output))
    }

    /// Writes the page, `JUnit` XML and the summary, those that are wanted.
    pub(crate) fn write(&self, findings: &[Finding], out: &mut impl Write) -> Reported {
        let (mut failed, mut has_page) = (String::new(), false);
        let mut tell = |path: &Path, written: io::Result<()>| {
            failed.extend(written.err().map(|error| cant_write(path, &error)));
        };
        if findings.iter().any(Finding::is_bad) {
            let page = self.page();
            let made = std::fs::create_dir_all(&self.output).map_err(|error| (&self.output, error));
            let written = made.and_then(|()| write_page(&page, &html(findings)).map_err(|e| (&page, e)));
            has_page = written.is_ok();
            if let Err((path, error)) = written {
                tell(path, Err(error));
            }
        }
        if let Some(path) = &self.junit {
            let text = junit(findings);
            let to_stdout = is_stdout(Some(path));
            tell(
                path,
                if to_stdout { out.write_all(text.as_bytes()) } else { write_report(path, text.as_bytes()) },
            );
        }
        if let Some(path) = &self.summary {
            let text = markdown(findings);
            let append = || {
                // What it leads to was not named.
                if path.is_symlink() && path.is_file() {
                    return Err(io::Error::other("it is a link"));
                }
                OpenOptions::new().create(true).append(true).open(path)?.write_all(text.as_bytes())
            };
            tell(path, if is_stdout(Some(path)) { out.write_all(text.as_bytes()) } else { append() });
        }
        Reported { failed, has_page }
    }
}

/// What became of the reports.
pub(crate) struct Reported {
    /// What could not be written, each in a line.
    pub(crate) failed: String,
    /// Whether there is a page of what differs.
    pub(crate) has_page: bool,
}

/// Writes the page of findings, unless somebody else's page is there.
fn write_page(path: &Path, text: &str) -> io::Result<()> {
    match read_regular(path, HEAD) {
        Ok(bytes) if !is_page(&bytes) => {
            Err(io::Error::new(io::ErrorKind::AlreadyExists, "there is a page that no check wrote"))
        }
        _ => write_whole(path, text.as_bytes(), Wait::No),
    }
}

/// Where the picture of each figure goes: under the figure's own name where picture and figure have one
/// format, else with the picture's extension after it; of figures of one name, under the name and a number.
fn pictures(jobs: &[Job], folder: &Path) -> BTreeMap<PathBuf, PathBuf> {
    let extension = TRIPTYCH_FORMAT.name;
    let (mut taken, mut all) = (BTreeSet::new(), BTreeMap::new());
    // How many figures of a name there were, from which on the search for a free one begins.
    let mut counts: BTreeMap<OsString, usize> = BTreeMap::new();
    for file in jobs.iter().flat_map(|job| &job.files) {
        let Target::File(path) = &file.target else { continue };
        let is_image = path.extension().is_none_or(|e| e == extension);
        let stem = if is_image { path.file_stem() } else { path.file_name() }.unwrap_or_default();
        let first = counts.entry(stem.to_owned()).or_insert(0);
        let name = (*first + 1..).find_map(|count| {
            *first = count;
            let mut name = stem.to_owned();
            if count > 1 {
                name.push(format!("-{count}"));
            }
            name.push(".");
            name.push(extension);
            taken.insert(name.clone()).then_some(name)
        });
        all.insert(path.clone(), folder.join(name.unwrap_or_default()));
    }
    all
}
