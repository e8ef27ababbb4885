//! Which scenes a command is about: files, folders of them, `-`, or all of `figures/`.

use std::io;
use std::path::{Path, PathBuf};

use tracefig::scene::{Refused, SceneFile, open, open_jsonl_line, open_reader, visible};

/// The folder whose scenes are meant when none is named.
const DEFAULT_FOLDER: &str = "figures";

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

/// The inputs that the arguments name, in their order; a folder stands for its scenes by name.
pub(crate) fn inputs(arguments: &[PathBuf]) -> Result<Vec<Input>, String> {
    if arguments.is_empty() {
        let scenes =
            folder(Path::new(DEFAULT_FOLDER)).map_err(|error| format!("no scene was given, and {error}"))?;
        return Ok(scenes);
    }
    let mut found = Vec::new();
    for argument in arguments {
        if argument.as_os_str() == "-" {
            if found.contains(&Input::Stdin) {
                return Err("`-` is given twice, but standard input can be read only once".to_owned());
            }
            found.push(Input::Stdin);
        } else if argument.is_dir() {
            found.extend(folder(argument)?);
        } else {
            // A missing file is told when it is opened, so that the others are still read.
            found.push(Input::File(argument.clone()));
        }
    }
    Ok(found)
}

/// The folders among the arguments; the usual one when there is no argument.
pub(crate) fn whole_folders(arguments: &[PathBuf]) -> Vec<PathBuf> {
    if arguments.is_empty() {
        return vec![PathBuf::from(DEFAULT_FOLDER)];
    }
    arguments.iter().filter(|a| a.is_dir()).cloned().collect()
}

/// The scenes of a folder, by name. What is neither a file nor a link is no scene, whatever its name: a pipe
/// would keep the others waiting. A link that leads nowhere is told when it is opened.
fn folder(path: &Path) -> Result<Vec<Input>, String> {
    let entries = path.read_dir().map_err(|e| format!("can't read the folder {}: {e}", shown(path)))?;
    let mut paths: Vec<PathBuf> = entries
        .filter_map(|entry| entry.ok().map(|e| e.path()))
        .filter(|p| p.extension().is_some_and(|e| e == "toml" || e == "json"))
        .filter(|p| p.metadata().is_ok_and(|place| place.is_file()) || p.is_symlink() && !p.exists())
        .collect();
    paths.sort();
    if paths.is_empty() {
        return Err(format!("there is no scene (*.toml, *.json) in the folder {}", shown(path)));
    }
    Ok(paths.into_iter().map(Input::File).collect())
}
