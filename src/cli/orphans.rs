//! Figures without a scene: files of ours in a folder of scenes, whose scene is gone or was renamed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use tracefig::drift::Stamp;
use tracefig::drift::report::Finding;
use tracefig::figure::theme::THEMES;
use tracefig::output::{MOST_BYTES, format};

use super::inputs::Input;
use super::jobs::Job;
use super::regular::read_regular;

/// The orphans in the folders that were checked as a whole, by name.
pub(crate) fn orphans(jobs: &[Job], folders: &[PathBuf]) -> Vec<Finding> {
    let scenes = names_of_files(jobs);
    let mut found: Vec<PathBuf> = folders.iter().flat_map(|folder| files_of_ours(folder)).collect();
    found.retain(|path| !scenes.contains(&path.with_extension("")));
    found.sort();
    let finding = |path: PathBuf| Finding {
        file: path.display().to_string(),
        state: "orphan",
        details: vec!["it has no scene: delete it, or bring its scene back".to_owned()],
        picture: None,
    };
    found.into_iter().map(finding).collect()
}

/// The figures of ours in a folder.
fn files_of_ours(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = folder.read_dir() else { return Vec::new() };
    let paths = entries.filter_map(|entry| entry.ok().map(|e| e.path()));
    paths.filter(|path| is_ours(path)).collect()
}

/// Whether a file says of itself that it is a figure of ours.
fn is_ours(path: &Path) -> bool {
    let Some(format) = path.extension().and_then(|e| format(&e.to_string_lossy())) else { return false };
    read_regular(path, MOST_BYTES).is_ok_and(|bytes| Stamp::read(format, &bytes).is_some())
}

/// What the files of the scenes may be called, without the format's extension: STEM, and STEM.THEME for each
/// theme of the house and each that was asked for.
fn names_of_files(jobs: &[Job]) -> BTreeSet<PathBuf> {
    let asked = jobs.iter().flat_map(|job| &job.files).filter_map(|file| file.theme.as_deref());
    let themes: BTreeSet<&str> = THEMES.iter().map(|theme| theme.name).chain(asked).collect();
    let mut names = BTreeSet::new();
    for job in jobs {
        let Input::File(path) = &job.input else { continue };
        let stem = path.with_extension("");
        for theme in &themes {
            let mut name = stem.clone().into_os_string();
            name.push(".");
            name.push(theme);
            names.insert(name.into());
        }
        names.insert(stem);
    }
    names
}
