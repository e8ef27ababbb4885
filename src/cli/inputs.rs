//! Which scenes a command is about: files, folders of them, `-`, or all of `figures/`.

use std::io;
use std::path::{Path, PathBuf};

use tracefig::scene::{PROJECT_FILE, Refused, SceneFile, open, open_jsonl_line, open_reader, visible};

use super::Status;
use super::console::Console;
use super::project::{OpenProject, nearest};
use super::unplanned::Unplanned;
use super::walk::walk;

/// The folder whose scenes are meant when neither a command nor a project names any.
const DEFAULT_FOLDER: &str = "figures";

/// How many files are named that are no scenes.
const NAMED: usize = 4;

/// Where a scene comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    /// From standard input.
    Stdin,
    /// From a file of this name.
    File(PathBuf),
    /// From a line of a stream of scenes.
    Line {
        /// Number of the line, from 1.
        number: usize,
        /// The line.
        text: String,
        /// Stem of the names of its files.
        stem: String,
    },
}

impl Input {
    /// Its name.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::Stdin => "<stdin>".to_owned(),
            Self::File(path) => path.display().to_string(),
            Self::Line { number, .. } => format!("<stdin>:{number}"),
        }
    }

    /// Its name in a line for people.
    pub(crate) fn shown(&self) -> String {
        visible(&self.name()).into_owned()
    }

    /// Reads and checks the scene.
    pub(crate) fn open(&self) -> Result<SceneFile, Box<Refused>> {
        match self {
            Self::Stdin => open_reader("<stdin>", io::stdin().lock()),
            Self::File(path) => open(path),
            Self::Line { number, text, .. } => open_jsonl_line(text, *number),
        }
    }
}

/// A path as a message names it.
pub(crate) fn shown(path: &Path) -> String {
    visible(&path.display().to_string()).into_owned()
}

/// The input that one argument names.
pub(crate) fn single(argument: &Path) -> Input {
    if argument.as_os_str() == "-" { Input::Stdin } else { Input::File(argument.to_owned()) }
}

/// A scene, and where it was found.
#[derive(Clone, Debug)]
pub(crate) struct Located {
    /// The scene.
    pub(crate) input: Input,
    /// Its folder below the folder that was searched; empty where the scene itself was named.
    pub(crate) below: PathBuf,
}

/// What the arguments of a command name.
#[derive(Debug, Default)]
pub(crate) struct Found {
    /// The scenes, in the order of the arguments; a folder stands for its scenes by path.
    pub(crate) scenes: Vec<Located>,
    /// The files of the folders that end as a scene's do and are none.
    pub(crate) others: Vec<PathBuf>,
    /// The folders that were searched, each with those in it.
    pub(crate) folders: Vec<PathBuf>,
    /// Folders among them that can't be read, and why.
    pub(crate) unread: Vec<(PathBuf, io::Error)>,
}

impl Found {
    /// The files that were taken for no scenes, in a line; empty where there is none.
    pub(crate) fn left_alone(&self) -> String {
        let named: Vec<String> = self.others.iter().take(NAMED).map(|path| shown(path)).collect();
        let verb = if self.others.len() == 1 { "is no scene" } else { "are no scenes" };
        match self.others.len() - named.len() {
            _ if named.is_empty() => String::new(),
            0 => format!("note: {} {verb}\n", and(&named)),
            more => format!("note: {} and {more} more files {verb}\n", named.join(", ")),
        }
    }
}

/// Names in a row, the last one after an "and".
fn and(names: &[String]) -> String {
    match names {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => names.concat(),
    }
}

/// Tells of folders that were to be searched and can't be read: what is in them is not done.
pub(crate) fn tell_unread(unread: &[(PathBuf, io::Error)], console: &Console) -> Status {
    for (folder, error) in unread {
        console.error(&unread_folder(folder, error));
    }
    if unread.is_empty() { Status::Done } else { Status::Io }
}

/// The words for a folder that can't be read, and why.
pub(crate) fn unread_folder(folder: &Path, error: &io::Error) -> String {
    format!("can't read the folder {}: {error}", shown(folder))
}

/// The scenes of the working directory's project, where none is named: what its file says, else
/// [`DEFAULT_FOLDER`] beside it, or here without a project.
pub(crate) fn default_scenes(project: Option<&OpenProject>) -> Vec<PathBuf> {
    let named = project.map(OpenProject::scenes).unwrap_or_default();
    if !named.is_empty() {
        return named;
    }
    vec![project.map_or(Path::new(""), OpenProject::folder).join(DEFAULT_FOLDER)]
}

/// The scenes that the arguments name; without arguments, those of the working directory's project.
///
/// # Errors
/// As [`find`], and when the project file is none.
pub(crate) fn find_here(arguments: &[PathBuf]) -> Result<Found, Unplanned> {
    let project = if arguments.is_empty() { nearest(Path::new(""))? } else { None };
    find(arguments, project.as_ref())
}

/// The scenes that the arguments name; without arguments, those of a project.
///
/// # Errors
/// When a folder can't be read or has no scene, or when standard input is to be read twice.
pub(crate) fn find(arguments: &[PathBuf], project: Option<&OpenProject>) -> Result<Found, Unplanned> {
    if !arguments.is_empty() {
        return named(arguments).map_err(Unplanned::Wrong);
    }
    let told = |error| match project {
        Some(project) => format!("{error}, which {} names", shown(&project.file)),
        None => format!("no scene was given, and {error}"),
    };
    named(&default_scenes(project)).map_err(|error| Unplanned::Wrong(told(error)))
}

fn named(arguments: &[PathBuf]) -> Result<Found, String> {
    let mut found = Found::default();
    for argument in arguments {
        let input = single(argument);
        if input == Input::Stdin && found.scenes.iter().any(|known| known.input == Input::Stdin) {
            return Err("`-` is given twice, but standard input can be read only once".to_owned());
        }
        if argument.is_dir() {
            folder(argument, &mut found)?;
        } else if argument.file_name().is_some_and(|name| name == PROJECT_FILE) {
            return Err(format!("{} is a project file and no scene", shown(argument)));
        } else if is_missing_default(argument) {
            return Err(format!("can't read the folder {}: there is none", shown(argument)));
        } else {
            // A missing file is told when it is opened, so that the others are still read.
            found.scenes.push(Located { input, below: PathBuf::new() });
        }
    }
    Ok(found)
}

/// Whether it is the usual folder, and there is none.
fn is_missing_default(argument: &Path) -> bool {
    argument.ends_with(DEFAULT_FOLDER) && !argument.exists()
}

/// Adds the scenes of a folder.
fn folder(path: &Path, found: &mut Found) -> Result<(), String> {
    let walked = walk(path).map_err(|error| unread_folder(path, &error))?;
    if walked.scenes.is_empty() {
        return Err(format!("there is no scene (*.toml, *.json) in the folder {}", shown(path)));
    }
    found.others.extend(walked.others);
    found.folders.extend(walked.folders);
    found.unread.extend(walked.unread);
    found.scenes.extend(walked.scenes.into_iter().map(|scene| {
        let below = scene.parent().and_then(|folder| folder.strip_prefix(path).ok());
        let below = below.map(Path::to_owned).unwrap_or_default();
        Located { input: Input::File(scene), below }
    }));
    Ok(())
}
