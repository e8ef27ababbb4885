//! Figures without a scene: files of ours in a folder of scenes, whose scene is gone or was renamed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use tracefig::drift::{Stamp, is_triptych};
use tracefig::output::{MOST_BYTES, format};

use super::files::Plan;
use super::inputs::Input;
use super::jobs::{Job, Target, each_settings};
use super::regular::read_regular;
use super::settings::Destination;
use super::walk::folders;

/// The orphans in the folders that were checked as a whole, by name.
pub(crate) fn orphans(plan: &Plan) -> Vec<PathBuf> {
    let scenes = names_of_files(&plan.jobs);
    let mut found: Vec<PathBuf> = folders_of_figures(plan).iter().flat_map(|at| files_of_ours(at)).collect();
    found.retain(|path| !has_scene(path, &scenes));
    found.sort();
    found
}

/// The folders whose figures must all have a scene: those that were searched, and the output folder of a
/// project all of whose scenes are known.
fn folders_of_figures(plan: &Plan) -> BTreeSet<PathBuf> {
    let mut all: BTreeSet<PathBuf> = plan.folders.iter().cloned().collect();
    for settings in each_settings(&plan.jobs).into_iter().filter(|_| plan.is_whole) {
        if let Destination::Project(folder) = &settings.destination {
            all.extend(folders(folder).unwrap_or_default());
        }
    }
    all
}

/// Whether a figure has a scene of its name, with or without the name of a theme after it, which may have
/// dots in it: which themes are asked for differs from run to run.
fn has_scene(path: &Path, scenes: &BTreeSet<PathBuf>) -> bool {
    let mut stem = path.with_extension("");
    while !scenes.contains(&stem) {
        if stem.extension().is_none() {
            return false;
        }
        stem.set_extension("");
    }
    true
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
    read_regular(path, MOST_BYTES)
        .is_ok_and(|bytes| Stamp::read(format, &bytes).is_some() && !is_triptych(&bytes))
}

/// What the files of the scenes are called, without theme and extension: beside the scene and where they go.
fn names_of_files(jobs: &[Job]) -> BTreeSet<PathBuf> {
    let mut names = BTreeSet::new();
    for job in jobs {
        let Input::File(scene) = &job.input else { continue };
        names.insert(scene.with_extension(""));
        let folders = job.files.iter().filter_map(|file| match &file.target {
            Target::File(path) => path.parent(),
            Target::Stdout => None,
        });
        let stem = Path::new(scene.file_stem().unwrap_or_default());
        names.extend(folders.map(|folder| folder.join(stem)));
    }
    names
}
