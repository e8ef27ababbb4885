//! Figures that no scene gives: files of ours in a folder of figures, whose scene is gone or was renamed, or
//! which the project file asks for no more.
//!
//! An orphan may be deleted, so nothing is called one in doubt: not where a scene or a folder of this run
//! could not be read, not where a file of the figure's name lies in the place of its scene, whatever is
//! wrong with it, and not where a scene of its name lies as a figure of another run's folder would have it.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use tracefig::drift::{Stamp, is_triptych};
use tracefig::output::{MOST_BYTES, format};
use tracefig::scene::PROJECT_FILE;

use super::files::Plan;
use super::inputs::Input;
use super::jobs::{Job, Target, each_settings};
use super::regular::read_regular;
use super::settings::Destination;
use super::unasked::{told, unasked};
use super::walk::folders;

/// A file of ours that no scene gives.
pub(crate) struct Orphan {
    /// The file.
    pub(crate) path: PathBuf,
    /// What the project file says of it; `None` where it has no scene at all.
    pub(crate) unasked: Option<String>,
}

impl Orphan {
    /// What it is, and what to do about it.
    pub(crate) fn told(&self) -> String {
        match &self.unasked {
            None => "it has no scene: bring its scene back, or delete it by `--prune`".to_owned(),
            Some(why) => format!("{why}: mend that, or delete it by `--prune`"),
        }
    }

    /// What it was, now that it is deleted.
    pub(crate) fn deleted(&self) -> String {
        match &self.unasked {
            None => "it had no scene, and was deleted".to_owned(),
            Some(why) => format!("{why}: it was deleted"),
        }
    }
}

/// What was found of figures that no scene of the run gives.
#[derive(Default)]
pub(crate) struct Unclaimed {
    /// The orphans, by name.
    pub(crate) orphans: Vec<Orphan>,
    /// Files that may be the scene of figures and were not taken for one, each with those figures.
    pub(crate) doubtful: BTreeMap<PathBuf, Vec<PathBuf>>,
}

/// The figures in the folders that were checked as a whole that no scene gives.
pub(crate) fn unclaimed(plan: &Plan) -> Unclaimed {
    let scenes = names_of_files(&plan.jobs);
    let mut figures: Vec<PathBuf> =
        folders_of_figures(plan).iter().flat_map(|folder| files_of_ours(folder)).collect();
    figures.sort();
    let mut found = Unclaimed::default();
    let (mut places, mut called) = (None, None);
    for path in figures {
        let (scene, parts) = scene_of(&path, &scenes);
        let unasked = match scene {
            None => None,
            Some(job) => match unasked_of(job, &parts, &path) {
                Some(why) => Some(why),
                None => continue,
            },
        };
        let called = called.get_or_insert_with(|| by_name(&scenes));
        let is_elsewhere = unasked.is_none() && is_gathered(&path, called);
        if is_elsewhere || places.get_or_insert_with(|| real_places(&plan.jobs)).contains(&real(&path)) {
            continue;
        }
        match possible_scene(plan, &path).filter(|_| unasked.is_none()) {
            Some(scene) => found.doubtful.entry(scene).or_default().push(path),
            None => found.orphans.push(Orphan { path, unasked }),
        }
    }
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

/// The scene of a figure's name, with or without more parts after it, as the name of a theme, which may have
/// dots in it; and those parts.
fn scene_of<'j>(path: &Path, scenes: &BTreeMap<PathBuf, &'j Job>) -> (Option<&'j Job>, Vec<String>) {
    let (mut stem, mut parts) = (path.with_extension(""), Vec::new());
    loop {
        if let Some(job) = scenes.get(&stem) {
            parts.reverse();
            return (Some(job), parts);
        }
        let Some(part) = stem.extension() else { return (None, parts) };
        parts.push(part.to_string_lossy().into_owned());
        stem.set_extension("");
    }
}

/// The scenes by what their files are called.
fn by_name<'s>(scenes: &'s BTreeMap<PathBuf, &Job>) -> BTreeMap<OsString, Vec<&'s Path>> {
    let mut all: BTreeMap<OsString, Vec<&Path>> = BTreeMap::new();
    for scene in scenes.keys() {
        all.entry(scene.file_name().unwrap_or_default().to_owned()).or_default().push(scene);
    }
    all
}

/// Whether a scene of a figure's name lies where a folder that gathers figures would have that.
fn is_gathered(figure: &Path, called: &BTreeMap<OsString, Vec<&Path>>) -> bool {
    let name = figure.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let stems = name.match_indices('.').filter_map(|(end, _)| called.get(OsStr::new(&name[..end])));
    stems.flatten().any(|scene| gathers(figure, scene))
}

/// Whether a figure lies as in a folder that gathers the figures of a tree: below the scene's folder, or
/// below one that both are in, with the way from there to the scene at its end. `docs/img/a/x.svg` is that of
/// `docs/a/x`, and `a/x.svg` not that of `b/x`.
fn gathers(figure: &Path, scene: &Path) -> bool {
    let both = figure.components().zip(scene.components()).take_while(|(f, s)| f == s).count();
    let (figure, scene): (PathBuf, PathBuf) =
        (figure.components().skip(both).collect(), scene.components().skip(both).collect());
    let (Some(folder), Some(beside)) = (figure.parent(), scene.parent()) else { return false };
    folder != beside && folder.ends_with(beside)
}

/// Why the project of a scene does not ask for a figure of it, in words.
fn unasked_of(job: &Job, parts: &[String], path: &Path) -> Option<String> {
    let extension = path.extension()?.to_str()?;
    Some(told(job.settings.project.as_deref()?, &unasked(&job.settings, parts, extension)?))
}

/// The figures of ours in a folder.
fn files_of_ours(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = folder.read_dir() else { return Vec::new() };
    let paths = entries.filter_map(|entry| entry.ok().map(|e| e.path()));
    paths.filter(|path| is_ours(path)).collect()
}

/// Whether a file says of itself that it is a figure of ours, of a scene's file: the name of a document of
/// several is anybody's choice, and a line of a stream has no file.
fn is_ours(path: &Path) -> bool {
    let Some(format) = path.extension().and_then(|e| format(&e.to_string_lossy())) else { return false };
    read_regular(path, MOST_BYTES).is_ok_and(|bytes| {
        Stamp::read(format, &bytes).is_some_and(|stamp| stamp.is_of_a_file()) && !is_triptych(&bytes)
    })
}

/// The files that the scenes give and that are there, by their one name: a disk that takes `A.svg` and
/// `a.svg` for one, or a link, may have them under another.
fn real_places(jobs: &[Job]) -> BTreeSet<PathBuf> {
    let files = jobs.iter().flat_map(|job| &job.files);
    let places = files.filter_map(|file| match &file.target {
        Target::File(path) => path.canonicalize().ok(),
        Target::Stdout => None,
    });
    places.collect()
}

/// A file by its one name.
fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

/// The file that lies where the scene of a figure would: of its name, which may end otherwise in capitals, in
/// a folder that may not be searched.
fn possible_scene(plan: &Plan, figure: &Path) -> Option<PathBuf> {
    let folder = figure.parent().unwrap_or(Path::new(""));
    let mut places: BTreeSet<PathBuf> = BTreeSet::from([folder.to_owned()]);
    for settings in each_settings(&plan.jobs) {
        places.extend(settings.folders_of_scenes(folder));
    }
    let name = figure.file_stem()?.to_string_lossy().into_owned();
    let is_of_figure = |path: &PathBuf| {
        let ends_so = |e: &std::ffi::OsStr| e.eq_ignore_ascii_case("toml") || e.eq_ignore_ascii_case("json");
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let after = name.strip_prefix(&stem).filter(|after| after.is_empty() || after.starts_with('.'));
        path.extension().is_some_and(ends_so)
            && path.file_name().is_none_or(|name| name != PROJECT_FILE)
            && after.is_some()
    };
    let files = places.iter().flat_map(|place| {
        let place = if place.as_os_str().is_empty() { Path::new(".") } else { place };
        place.read_dir().into_iter().flatten().flatten().map(|entry| entry.path())
    });
    // Of several the one that has most of the name.
    files.filter(is_of_figure).max_by_key(|path| path.file_stem().map(std::ffi::OsStr::len))
}

/// What the files of the scenes are called, without theme and extension: beside the scene and where they go.
fn names_of_files(jobs: &[Job]) -> BTreeMap<PathBuf, &Job> {
    let mut names = BTreeMap::new();
    for job in jobs {
        let Input::File(scene) = &job.input else { continue };
        names.insert(scene.with_extension(""), job);
        let folders = job.files.iter().filter_map(|file| match &file.target {
            Target::File(path) => path.parent(),
            Target::Stdout => None,
        });
        let stem = Path::new(scene.file_stem().unwrap_or_default());
        names.extend(folders.map(|folder| (folder.join(stem), job)));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_gathers_the_figures_of_a_tree_below_its_scenes() {
        for (figure, scene, gathered) in [
            ("docs/img/x.svg", "docs/x", true),
            ("docs/img/a/x.dark.svg", "docs/a/x", true),
            ("img/a/x.svg", "a/x", true),
            ("a/x.svg", "b/x", false),
            ("docs/x.svg", "docs/x", false),
            ("x.svg", "a/x", false),
        ] {
            assert_eq!(gathers(Path::new(figure), Path::new(scene)), gathered, "{figure} of {scene}");
        }
        let called = BTreeMap::from([("x".into(), vec![Path::new("docs/x")])]);
        let gathered = |figure: &str| is_gathered(Path::new(figure), &called);
        assert!(
            gathered("docs/img/x.svg") && gathered("docs/img/x.dark.svg") && !gathered("docs/img/xy.svg")
        );
    }
}
