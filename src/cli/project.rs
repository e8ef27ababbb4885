//! Project files: the nearest `tracefig.toml` upward from a scene's folder, and what it says.

use std::path::{Path, PathBuf};

use tracefig::scene::limits::MAX_FILE_BYTES;
use tracefig::scene::{Fault, PROJECT_FILE, Problem, Project, Refused, Source, project, visible};

use super::regular::read_regular;
use super::unplanned::Unplanned;

/// A project file and what it says.
#[derive(Debug)]
pub(crate) struct OpenProject {
    /// The file, relative to the working directory where it lies below it.
    pub(crate) file: PathBuf,
    /// Its text, for messages.
    pub(crate) source: Source,
    /// What it says.
    pub(crate) said: Project,
}

impl OpenProject {
    /// Reads a project file.
    ///
    /// # Errors
    /// When it can't be read, or is none.
    pub(crate) fn read(file: PathBuf) -> Result<Self, Unplanned> {
        let name = file.display().to_string();
        let refused = |source, problems| Unplanned::Refused(Box::new(Refused { source, problems }));
        let unreadable = |reason: String| {
            Unplanned::Unread(format!("can't read the project file `{}`: {reason}", visible(&name)))
        };
        let bytes = read_regular(&file, MAX_FILE_BYTES).map_err(|e| unreadable(e.to_string()))?;
        if bytes.len() > MAX_FILE_BYTES {
            return Err(unreadable(format!("expected at most {MAX_FILE_BYTES} bytes")));
        }
        let text = String::from_utf8(bytes).map_err(|e| unreadable(e.to_string()))?;
        let source = Source::new(&name, text.strip_prefix('\u{feff}').unwrap_or(&text));
        match project(&source) {
            Ok(said) => Ok(Self { file, source, said }),
            Err(problems) if is_scene(&source) => {
                let message = format!("`{}` is a scene, and no project file", visible(&name));
                let help =
                    "a project file has the tables `[canvas]`, `[render]` and `[[handout]]`".to_owned();
                let span = problems.first().map_or(0..0, |problem| problem.span.clone());
                let fault = Fault::Conflict { message, help };
                Err(refused(source, vec![Problem::new(fault, span)]))
            }
            Err(problems) => Err(refused(source, problems)),
        }
    }

    /// The folder that its paths are relative to.
    pub(crate) fn folder(&self) -> &Path {
        self.file.parent().unwrap_or(Path::new(""))
    }

    /// The scenes that it names, files and folders; none where it does not say.
    pub(crate) fn scenes(&self) -> Vec<PathBuf> {
        self.said.scenes.iter().map(|scene| self.folder().join(&scene.value)).collect()
    }

    /// The error of a place in it.
    pub(crate) fn wrong<T>(&self, fault: Fault, span: &std::ops::Range<usize>) -> Result<T, Unplanned> {
        let problems = vec![Problem::new(fault, span.clone())];
        Err(Unplanned::Refused(Box::new(Refused { source: self.source.clone(), problems })))
    }
}

/// Whether a text is that of a scene.
fn is_scene(source: &Source) -> bool {
    tracefig::scene::read(source).is_ok()
}

/// The project file that is nearest upward from a folder.
///
/// # Errors
/// When it can't be read, or is none.
pub(crate) fn nearest(folder: &Path) -> Result<Option<OpenProject>, Unplanned> {
    nearest_file(folder).map(OpenProject::read).transpose()
}

/// Where the project file is that is nearest upward from a folder.
pub(crate) fn nearest_file(folder: &Path) -> Option<PathBuf> {
    let folder = real(folder);
    let found = folder.ancestors().map(|above| above.join(PROJECT_FILE)).find(|file| file.is_file())?;
    Some(near(&found))
}

/// A path by its name from the working directory, where it lies below that.
pub(crate) fn near(path: &Path) -> PathBuf {
    path.strip_prefix(real(Path::new(""))).map_or_else(|_| path.to_owned(), Path::to_owned)
}

/// A folder by the one name that it has, links resolved.
pub(crate) fn real(folder: &Path) -> PathBuf {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let absolute = || std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
    folder.canonicalize().unwrap_or_else(|_| absolute())
}
