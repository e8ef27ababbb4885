//! Which files a scene becomes: `STEM[.SEED][.VARIANT][.THEME].EXT`, beside it or in a folder.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use tracefig::output::Format;
use tracefig::scene::{Variant, visible};

use super::in_time::InTime;
use super::inputs::{Input, Located, shown};
use super::outputs::{Kept, one_name};
use super::settings::{Destination, Projects, Settings};
use super::unplanned::Unplanned;

/// What a scene is that is read.
const SCENE: &str = "a scene of this run";

/// Where a file goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// To standard output.
    Stdout,
    /// To a file of this name.
    File(PathBuf),
}

/// One file of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Planned {
    /// The number of the variant with other bodies; `None` is the scene itself.
    pub(crate) seed: Option<usize>,
    /// What is drawn of the scene.
    pub(crate) variant: Variant,
    /// Name of the theme; `None` is the scene's own.
    pub(crate) theme: Option<String>,
    /// What it is written as.
    pub(crate) format: &'static Format,
    /// Where it goes.
    pub(crate) target: Target,
}

/// A scene and the files that it becomes.
#[derive(Clone, Debug)]
pub(crate) struct Job {
    /// The scene.
    pub(crate) input: Input,
    /// What it becomes, theme by theme.
    pub(crate) files: Vec<Planned>,
    /// How it is drawn.
    pub(crate) settings: Arc<Settings>,
}

/// Plans the files of scenes.
pub(crate) type Planner = fn(Vec<Located>, &mut Projects<'_>) -> Result<Vec<Job>, Unplanned>;

/// The files of all scenes, or why they can't all be written; nothing has been written then.
pub(crate) fn jobs(scenes: Vec<Located>, projects: &mut Projects<'_>) -> Result<Vec<Job>, Unplanned> {
    let jobs = planned(scenes, projects)?;
    apart(&jobs)?;
    inputs_stay(&jobs).map_err(nothing_written)?;
    Ok(jobs)
}

/// The files of all scenes, to be compared with those on disk: scenes that would become one file, which
/// [`twins`] tells, are a finding of that file alone.
pub(crate) fn compared_jobs(
    scenes: Vec<Located>,
    projects: &mut Projects<'_>,
) -> Result<Vec<Job>, Unplanned> {
    let jobs = planned(scenes, projects)?;
    inputs_stay(&jobs).map_err(Unplanned::Wrong)?;
    Ok(jobs)
}

/// Why a run that was to write files did not.
fn nothing_written(why: String) -> Unplanned {
    Unplanned::Wrong(why + "; nothing was written")
}

/// The files of all scenes, as [`jobs`] gives them, or all of them one file where that has
/// room for them.
pub(crate) fn bound_jobs(scenes: Vec<Located>, projects: &mut Projects<'_>) -> Result<Vec<Job>, Unplanned> {
    let mut jobs = planned(scenes, projects)?;
    if jobs.iter().map(|job| job.files.len()).sum::<usize>() > 1 {
        finish(&mut jobs);
    }
    bound(jobs)
}

/// [`bound_jobs`] where sheets are asked for, of one figure as well.
pub(crate) fn sheet_jobs(scenes: Vec<Located>, projects: &mut Projects<'_>) -> Result<Vec<Job>, Unplanned> {
    let mut jobs = planned(scenes, projects)?;
    finish(&mut jobs);
    bound(jobs)
}

/// Draws figures finished where it is their project that asks for steps and the one file that they go to
/// has none: sheets show figures as a reader of paper wants them.
fn finish(jobs: &mut [Job]) {
    for settings in jobs.iter_mut().map(|job| &mut job.settings) {
        let on_sheets = |format: &Format| format.has_sheets() && !format.has_slides();
        let one_file = matches!(settings.destination, Destination::File(_));
        if one_file && settings.steps_of_project && settings.formats.iter().all(|format| on_sheets(format)) {
            Arc::make_mut(settings).in_time = None;
        }
    }
}

/// The files of scenes that may go to one.
fn bound(jobs: Vec<Job>) -> Result<Vec<Job>, Unplanned> {
    if bound_file(&jobs).is_none() {
        apart(&jobs)?;
    }
    inputs_stay(&jobs).map_err(nothing_written)?;
    Ok(jobs)
}

/// The one file that all figures go to, where it is named and its format has sheets, or slides, of which
/// steps may have one each.
pub(crate) fn bound_file(jobs: &[Job]) -> Option<(&Path, &'static Format)> {
    let Planned { target: Target::File(path), format, .. } = jobs.iter().flat_map(|job| &job.files).next()?
    else {
        return None;
    };
    let bound = |Settings { destination, in_time, .. }: &Settings| {
        let holds = match in_time {
            None => format.has_sheets() || format.has_slides(),
            Some(InTime::Steps(files)) => format.has_slides() && !files.are_apart(format),
            Some(InTime::Motion) => false,
        };
        holds && matches!(destination, Destination::File(_))
    };
    jobs.iter().all(|job| bound(&job.settings)).then_some((path, *format))
}

/// The scenes with their files.
fn planned(scenes: Vec<Located>, projects: &mut Projects<'_>) -> Result<Vec<Job>, Unplanned> {
    let planned = |scene: Located| {
        let folder = match &scene.input {
            Input::File(path) => path.parent().unwrap_or(Path::new("")),
            Input::Stdin | Input::Line { .. } => Path::new(""),
        };
        let settings = projects.settings(folder)?;
        Ok(job(scene, &settings))
    };
    scenes.into_iter().map(planned).collect()
}

/// Refuses files of which one would take the place of another.
fn apart(jobs: &[Job]) -> Result<(), Unplanned> {
    let count = |is: fn(&Destination) -> bool| {
        jobs.iter().filter(|job| is(&job.settings.destination)).map(|job| job.files.len()).sum::<usize>()
    };
    let to_stdout = jobs.iter().flat_map(|j| &j.files).filter(|f| f.target == Target::Stdout).count();
    let apart = jobs.iter().any(|job| {
        let to_stdout = |file: &&Planned| file.target == Target::Stdout;
        job.files.iter().filter(to_stdout).any(|file| job.settings.are_apart(file.format))
    });
    let several = several_themes(jobs).unwrap_or_default();
    if to_stdout > 1 || apart {
        return Err(Unplanned::Usage(format!(
            "standard output takes one file: give one scene, one `--format` and at most one `--theme`, \
             `--variant` and `--seed`{several}"
        )));
    }
    if count(|destination| matches!(destination, Destination::File(_))) > 1 {
        return Err(Unplanned::Usage(format!(
            "`-o` names one file: give one scene and at most one `--theme`, `--variant` and `--seed`, or a \
             folder{several}"
        )));
    }
    match twins(jobs).first() {
        Some(twins) => Err(nothing_written(twins.to_string())),
        None => Ok(()),
    }
}

/// Where nobody asked for several themes but a project file, what it names, and what chooses one of them.
fn several_themes(jobs: &[Job]) -> Option<String> {
    let settings =
        each_settings(jobs).into_iter().find(|all| all.themes_of_project && all.themes.len() > 1)?;
    let themes = &settings.themes;
    let names: Vec<String> = themes.iter().map(|theme| format!("`{}`", visible(&theme.name))).collect();
    let project = shown(settings.project.as_deref()?);
    Some(format!("; {project} names {} themes, {}: choose one by `--theme`", names.len(), names.join(", ")))
}

/// A scene and its files, whatever other scenes there are.
pub(crate) fn job(scene: Located, settings: &Arc<Settings>) -> Job {
    let files = files(&scene, settings);
    Job { input: scene.input, files, settings: Arc::clone(settings) }
}

/// The files of one scene.
fn files(scene: &Located, settings: &Settings) -> Vec<Planned> {
    let themes: Vec<Option<&str>> = if settings.themes.is_empty() {
        vec![None]
    } else {
        settings.themes.iter().map(|theme| Some(theme.name.as_str())).collect()
    };
    let themes = &themes;
    let themed = |(seed, variant)| themes.iter().map(move |&theme| (seed, variant, theme));
    let variants = |&seed: &Option<usize>| settings.variants.iter().map(move |&variant| (seed, variant));
    let mut files = Vec::new();
    for (seed, variant, theme) in settings.seeds.iter().flat_map(variants).flat_map(themed) {
        for &format in &settings.formats {
            let word = Some(variant.word()).filter(|_| variant != Variant::Figure);
            let named = theme.filter(|_| settings.themes.len() > 1);
            let number = seed.map(|seed| format!("{seed:02}"));
            let target = target(scene, settings, [number.as_deref(), word, named], format.name);
            let to_stdout = target == Target::Stdout;
            files.push(Planned { seed, variant, theme: theme.map(str::to_owned), format, target });
            // Of the formats that nobody asked for it takes the first.
            if to_stdout && !settings.formats_asked {
                break;
            }
        }
    }
    files
}

/// Where a file of a scene goes; `parts` of its name stand between stem and extension.
fn target(scene: &Located, settings: &Settings, parts: [Option<&str>; 3], extension: &str) -> Target {
    let Located { input, below } = scene;
    let (beside, stem): (&Path, OsString) = match input {
        Input::Stdin => (Path::new(""), "stdin".into()),
        Input::Line { stem, .. } => (Path::new(""), stem.into()),
        Input::File(path) => {
            (path.parent().unwrap_or(Path::new("")), path.file_stem().unwrap_or_default().to_owned())
        }
    };
    let folder = match &settings.destination {
        Destination::Stdout => return Target::Stdout,
        Destination::File(path) => return Target::File(path.clone()),
        // Beside standard input is standard output, whatever a project says.
        Destination::Beside | Destination::Project(_) if *input == Input::Stdin => return Target::Stdout,
        Destination::Beside => beside.to_owned(),
        Destination::Folder(folder) | Destination::Project(folder) => {
            folder.join(settings.within(input, below))
        }
    };
    let mut name = stem;
    let in_time = settings.in_time.map(|in_time| in_time.parts()[0]);
    for part in parts.into_iter().flatten().chain(in_time).chain([extension]) {
        name.push(".");
        name.push(part);
    }
    Target::File(folder.join(name))
}

/// The folders that files go to.
pub(crate) fn folders_of(jobs: &[Job]) -> BTreeSet<&Path> {
    let files = jobs.iter().flat_map(|job| &job.files);
    files
        .filter_map(|file| match &file.target {
            Target::File(path) => path.parent(),
            Target::Stdout => None,
        })
        .collect()
}

/// Two inputs that would become one file.
pub(crate) struct Twins<'j> {
    /// Both, in the order of the run.
    pub(crate) inputs: [&'j Input; 2],
    /// The file.
    pub(crate) path: &'j Path,
}

impl std::fmt::Display for Twins<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [a, b] = self.inputs.map(Input::shown);
        write!(f, "{a} and {b} would both become {}", shown(self.path))
    }
}

/// All inputs that would become one file, two by two.
pub(crate) fn twins(jobs: &[Job]) -> Vec<Twins<'_>> {
    let (mut first, mut all): (BTreeMap<PathBuf, &Input>, Vec<Twins<'_>>) = (BTreeMap::new(), Vec::new());
    for job in jobs {
        for file in &job.files {
            let Target::File(path) = &file.target else { continue };
            if let Some(other) = first.insert(one_name(path), &job.input) {
                all.push(Twins { inputs: [other, &job.input], path });
            }
        }
    }
    all
}

/// The settings of the scenes, each once.
pub(crate) fn each_settings(jobs: &[Job]) -> Vec<&Arc<Settings>> {
    let mut each: Vec<&Arc<Settings>> = Vec::new();
    for job in jobs {
        // Scenes of one project follow one another, mostly.
        if !each.iter().rev().any(|known| Arc::ptr_eq(known, &job.settings)) {
            each.push(&job.settings);
        }
    }
    each
}

/// The files that a run reads, which it must not write.
pub(crate) fn inputs_of(jobs: &[Job]) -> Kept {
    let mut kept = Kept::default();
    let settings = each_settings(jobs);
    let themes = |settings: &Arc<Settings>| {
        settings.themes.iter().chain(settings.page_theme.as_deref()).cloned().collect::<Vec<_>>()
    };
    for theme in settings.iter().flat_map(|settings| themes(settings)) {
        theme.file.iter().for_each(|path| kept.keep(path, "a theme of this run"));
    }
    for project in settings.iter().filter_map(|settings| settings.project.as_ref()) {
        kept.keep(project, "the project file of this run");
    }
    for job in jobs {
        if let Input::File(path) = &job.input {
            kept.keep(path, SCENE);
        }
    }
    kept
}

/// Refuses a file that would replace a scene of the same run.
fn inputs_stay(jobs: &[Job]) -> Result<(), String> {
    let kept = inputs_of(jobs);
    for file in jobs.iter().flat_map(|job| &job.files) {
        if let Target::File(path) = &file.target
            && let Some(what) = kept.what(path)
        {
            let mend = if what == SCENE { ": the name of a scene ends in .toml or .json" } else { "" };
            return Err(format!("{} is {what}, and a figure would take its place{mend}", shown(path)));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::inputs::single;
    use super::super::settings::Flags;
    use super::super::themes::theme_in;
    use super::*;

    fn targets(scenes: &[&str], folder: Option<&str>, themes: &[&str]) -> Result<Vec<String>, Unplanned> {
        let located = |s: &&str| Located { input: single(s.as_ref()), below: PathBuf::new() };
        let themes: Vec<_> = themes.iter().filter_map(|t| theme_in(Path::new(""), t).ok()).collect();
        let formats = ["svg", "png"].map(str::to_owned);
        let flags = Flags {
            output: folder.map(Path::new),
            formats: &formats,
            themes,
            scale: None,
            variants: &[],
            seeds: &[],
            in_time: None,
            is_still: false,
            project: None,
        };
        let jobs = jobs(scenes.iter().map(located).collect(), &mut Projects::new(&flags))?;
        Ok(jobs.iter().flat_map(|j| &j.files).map(|f| format!("{:?}", f.target)).collect())
    }

    #[test]
    fn files_lie_beside_their_scene_or_in_the_folder() {
        assert_eq!(targets(&["a/x.toml"], None, &[]).unwrap(), [r#"File("a/x.svg")"#, r#"File("a/x.png")"#]);
        assert_eq!(
            targets(&["a/x.toml"], Some("b"), &["dark"]).unwrap(),
            [r#"File("b/x.svg")"#, r#"File("b/x.png")"#]
        );
    }

    #[test]
    fn the_theme_is_in_the_name_when_several_are_asked_for() {
        let got = targets(&["x.toml"], None, &["light", "dark"]).unwrap();
        assert_eq!(
            got,
            ["light.svg", "light.png", "dark.svg", "dark.png"].map(|end| format!("File(\"x.{end}\")"))
        );
    }

    #[test]
    fn two_scenes_of_one_name_are_refused() {
        assert!(targets(&["a/x.toml", "b/x.toml"], None, &[]).is_ok());
        let got = targets(&["a/x.toml", "b/x.json"], Some("out"), &[]).unwrap_err();
        let message = "a/x.toml and b/x.json would both become out/x.svg; nothing was written";
        assert!(matches!(got, Unplanned::Wrong(said) if said == message));
        assert!(targets(&["src/x.toml", "src/../src/x.json"], None, &[]).is_err());
    }

    #[test]
    fn standard_output_takes_one_file() {
        assert!(matches!(targets(&["x.toml"], Some("-"), &[]), Err(Unplanned::Usage(_))));
        assert!(matches!(targets(&["-"], None, &[]), Err(Unplanned::Usage(_))));
    }
}
