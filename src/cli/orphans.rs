//! Figures without a scene: files of ours in a folder of scenes, whose scene is gone or was renamed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use tracefig::drift::Stamp;
use tracefig::drift::report::Finding;
use tracefig::figure::theme::THEMES;
use tracefig::output::format;

use super::inputs::Input;
use super::jobs::Job;

/// The orphans in the folders that were checked as a whole, by name.
pub(crate) fn orphans(jobs: &[Job], folders: &[PathBuf]) -> Vec<Finding> {
    let stems: BTreeSet<PathBuf> = jobs
        .iter()
        .filter_map(|job| match &job.input {
            Input::File(path) => Some(path.with_extension("")),
            Input::Stdin => None,
        })
        .collect();
    let mut found: Vec<PathBuf> = folders.iter().flat_map(|folder| files_of_ours(folder)).collect();
    found.retain(|path| !has_scene(path, &stems));
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
    std::fs::read(path).is_ok_and(|bytes| Stamp::read(format, &bytes).is_some())
}

/// Whether `STEM.EXT` or `STEM.THEME.EXT` belongs to a scene.
fn has_scene(path: &Path, stems: &BTreeSet<PathBuf>) -> bool {
    let stem = path.with_extension("");
    let themed = stem.extension().is_some_and(|e| THEMES.iter().any(|t| e == t.name));
    stems.contains(&stem) || (themed && stems.contains(&stem.with_extension("")))
}
