//! `[[handout]]` of a project file: documents of several figures, which a run of the whole project writes and
//! compares as well.

use std::io;
use std::path::{Path, PathBuf};

use tracefig::output::{FORMATS, Format, PAPERS, format};
use tracefig::scene::{DeclaredHandout, Fault, Spanned};

use super::Status;
use super::console::Console;
use super::encoded::Encoded;
use super::files::Files;
use super::handout::{Sheets, Told};
use super::inputs::{default_scenes, find, shown};
use super::jobs::{Job, Target, bound_jobs};
use super::outputs::one_name;
use super::project::OpenProject;
use super::settings::{Flags, Projects, known_theme};
use super::unplanned::Unplanned;
use super::variants::Seeds;
use super::written::makes_folders;

/// A document that a project declares, and its figures.
pub(crate) struct Declared {
    /// The document.
    pub(crate) path: PathBuf,
    /// How the figures are put onto its sheets.
    sheets: Sheets,
    /// The figures.
    pub(crate) jobs: Vec<Job>,
}

impl Declared {
    /// The documents of a run: those of its project where it draws all of it; `figures` are the files that it
    /// draws besides.
    ///
    /// # Errors
    /// When the project file is wrong, or a document would take the place of another file of the run.
    pub(crate) fn all(files: &Files, figures: &[Job]) -> Result<Vec<Self>, Unplanned> {
        let Some(project) = files.whole_project()? else { return Ok(Vec::new()) };
        let mut taken: Vec<PathBuf> = figures.iter().flat_map(|job| &job.files).filter_map(place).collect();
        let mut all = Vec::new();
        for handout in &project.said.handouts {
            let one = Self::read(&project, handout)?;
            let name = one_name(&one.path);
            if taken.contains(&name) {
                let message = format!("{} is another file of this project already", shown(&one.path));
                let help = "give it another name".to_owned();
                return project.wrong(Fault::Conflict { message, help }, &handout.file.span);
            }
            taken.push(name);
            all.push(one);
        }
        Ok(all)
    }

    /// A document as its project says.
    fn read(project: &OpenProject, said: &DeclaredHandout) -> Result<Self, Unplanned> {
        let path = project.folder().join(&said.file.value);
        let format = document_format(project, &said.file)?;
        let sheets = sheets(project, said, format)?;
        let theme = said.theme.as_ref().or(project.said.themes.first());
        let seeds = said.seeds.iter().map(|seeds| read_seeds(project, seeds));
        let flags = Flags {
            output: Some(&path),
            themes: theme.map(|word| known_theme(project, word)).transpose()?.into_iter().collect(),
            variants: &said.variants,
            seeds: &seeds.collect::<Result<Vec<_>, _>>()?,
            is_still: true,
            project: Some(&project.file),
            ..Flags::default()
        };
        let named: Vec<_> = said.scenes.iter().map(|scene| project.folder().join(&scene.value)).collect();
        let scenes = if named.is_empty() { default_scenes(Some(project)) } else { named };
        let jobs = bound_jobs(find(&scenes, Some(project))?.scenes, &mut Projects::new(&flags))?;
        Ok(Self { path, sheets, jobs })
    }

    /// Writes it; of its scenes something may be told already.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn write(&self, files: &Files, told: &Told, console: &mut Console) -> io::Result<Status> {
        if !makes_folders(self.path.parent(), console) {
            return Ok(Status::Io);
        }
        Ok(self.sheets.write_besides(files, &self.jobs, told, console)?.unwrap_or(Status::Done))
    }

    /// Whether it is there and shows its scenes as they are.
    pub(crate) fn is_current(&self, files: &Files) -> bool {
        self.sheets.is_current(files, &self.jobs)
    }

    /// The document as it would be written; what became of a figure that can't be drawn is said.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn encoded(
        &self,
        files: &Files,
        told: &Told,
        console: &mut Console,
    ) -> io::Result<Result<Option<Encoded>, Status>> {
        self.sheets.encoded(files, (&self.jobs, told), console)
    }
}

/// The place of a file, where it has one.
fn place(file: &super::jobs::Planned) -> Option<PathBuf> {
    match &file.target {
        Target::File(path) => Some(one_name(path)),
        Target::Stdout => None,
    }
}

/// The format of a document by the end of its name.
fn document_format(project: &OpenProject, file: &Spanned<String>) -> Result<&'static Format, Unplanned> {
    let holds = |format: &&Format| format.has_sheets() || format.has_slides();
    let named = Path::new(&file.value).extension().and_then(|end| format(end.to_str()?)).filter(holds);
    let ends: Vec<_> = FORMATS.iter().filter(holds).map(|format| format!(".{}", format.name)).collect();
    let expected = format!("a name that ends in {}", ends.join(" or "));
    let fault = Fault::WrongType { key: "file".to_owned(), expected, got: format!("`{}`", file.value) };
    named.map_or_else(|| project.wrong(fault, &file.span), Ok)
}

/// How the figures are put onto sheets, where the format has them.
fn sheets(
    project: &OpenProject,
    said: &DeclaredHandout,
    format: &'static Format,
) -> Result<Sheets, Unplanned> {
    let keys = [
        ("per_page", said.per_page.as_ref().map(|value| &value.span)),
        ("paper", said.paper.as_ref().map(|value| &value.span)),
        ("numbers", said.numbers.as_ref().map(|value| &value.span)),
        ("heading", said.heading.as_ref().map(|value| &value.span)),
        ("name_line", said.name_line.as_ref().map(|value| &value.span)),
    ];
    if !format.has_sheets()
        && let Some((key, span)) = keys.into_iter().find_map(|(key, span)| Some((key, span?)))
    {
        let message = format!("`{key}` is of sheets, and {} has none", format.name);
        let help = format!("leave `{key}` out");
        return project.wrong(Fault::Conflict { message, help }, span);
    }
    if let Some(paper) = said.paper.as_ref().filter(|paper| PAPERS.iter().all(|p| p.name != paper.value)) {
        let known = PAPERS.map(|paper| paper.name.to_owned()).to_vec();
        return project
            .wrong(Fault::UnknownWord { what: "paper", got: paper.value.clone(), known }, &paper.span);
    }
    Ok(Sheets::of_a_project(said))
}

/// Numbers of variants as a project file writes them.
fn read_seeds(project: &OpenProject, seeds: &Spanned<String>) -> Result<Seeds, Unplanned> {
    seeds.value.parse().or_else(|expected: String| {
        let expected = expected.trim_start_matches("expected ").to_owned();
        let fault = Fault::WrongType { key: "seeds".to_owned(), expected, got: format!("`{}`", seeds.value) };
        project.wrong(fault, &seeds.span)
    })
}
