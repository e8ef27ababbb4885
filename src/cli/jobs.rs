//! Which files a scene becomes: `STEM[.THEME].EXT`, beside it or in a folder.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use tracefig::output::Format;

use super::inputs::{Input, shown};
use super::outputs::{Kept, one_name};

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
}

/// What is asked of every scene.
pub(crate) struct Wanted<'w> {
    /// Where files go; `None` is beside the scene, `-` is standard output.
    pub(crate) folder: Option<&'w Path>,
    /// Names of themes; none is the scene's own.
    pub(crate) themes: &'w [String],
    /// What each theme is written as.
    pub(crate) formats: &'w [&'static Format],
}

/// Why there is no plan.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Unplanned {
    /// The options contradict each other.
    Usage(String),
    /// The inputs are wrong: no scene, or two that would become one file.
    Wrong(String),
}

/// The files of all scenes, or why they can't all be written; nothing has been written then.
pub(crate) fn jobs(inputs: Vec<Input>, wanted: &Wanted<'_>) -> Result<Vec<Job>, Unplanned> {
    let jobs: Vec<Job> = inputs.into_iter().map(|input| job(input, wanted)).collect();
    let to_stdout = jobs.iter().flat_map(|j| &j.files).filter(|f| f.target == Target::Stdout).count();
    if to_stdout > 1 {
        let message =
            "standard output takes one file: give one scene, one `--format` and at most one `--theme`";
        return Err(Unplanned::Usage(message.to_owned()));
    }
    twins(&jobs)?;
    inputs_stay(&jobs)?;
    Ok(jobs)
}

/// A scene and its files, whatever other scenes there are.
pub(crate) fn job(input: Input, wanted: &Wanted<'_>) -> Job {
    let files = files(&input, wanted);
    Job { input, files }
}

/// The files of one scene.
fn files(input: &Input, wanted: &Wanted<'_>) -> Vec<Planned> {
    let themes: Vec<Option<&String>> =
        if wanted.themes.is_empty() { vec![None] } else { wanted.themes.iter().map(Some).collect() };
    let mut files = Vec::new();
    for theme in themes {
        for &format in wanted.formats {
            let named = theme.filter(|_| wanted.themes.len() > 1);
            let target = target(input, wanted.folder, named.map(String::as_str), format.name);
            files.push(Planned { theme: theme.cloned(), format, target });
        }
    }
    files
}

/// Where a file of a scene goes.
fn target(input: &Input, folder: Option<&Path>, theme: Option<&str>, extension: &str) -> Target {
    if folder.is_some_and(|f| f.as_os_str() == "-") {
        return Target::Stdout;
    }
    let (beside, stem) = match input {
        // Beside standard input is standard output.
        Input::Stdin if folder.is_none() => return Target::Stdout,
        Input::Stdin => (Path::new("."), "stdin".into()),
        Input::Line { stem, .. } => (Path::new(""), stem.into()),
        Input::File(path) => {
            (path.parent().unwrap_or(Path::new("")), path.file_stem().unwrap_or_default().to_owned())
        }
    };
    let mut name: OsString = stem;
    for part in theme.into_iter().chain([extension]) {
        name.push(".");
        name.push(part);
    }
    Target::File(folder.unwrap_or(beside).join(name))
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

/// Refuses two inputs that would become one file.
fn twins(jobs: &[Job]) -> Result<(), Unplanned> {
    let mut first: BTreeMap<PathBuf, &Input> = BTreeMap::new();
    for job in jobs {
        for file in &job.files {
            let Target::File(path) = &file.target else { continue };
            if let Some(other) = first.insert(one_name(path), &job.input) {
                let (a, b, path) = (other.shown(), job.input.shown(), shown(path));
                return Err(Unplanned::Wrong(format!(
                    "{a} and {b} would both become {path}; nothing was written"
                )));
            }
        }
    }
    Ok(())
}

/// The files that a run reads, which it must not write.
pub(crate) fn inputs_of(jobs: &[Job]) -> Kept {
    let mut kept = Kept::default();
    for job in jobs {
        if let Input::File(path) = &job.input {
            kept.keep(path, "a scene of this run");
        }
    }
    kept
}

/// Refuses a file that would replace a scene of the same run.
fn inputs_stay(jobs: &[Job]) -> Result<(), Unplanned> {
    let kept = inputs_of(jobs);
    for file in jobs.iter().flat_map(|job| &job.files) {
        if let Target::File(path) = &file.target
            && let Some(what) = kept.what(path)
        {
            return Err(Unplanned::Wrong(format!(
                "{} is {what}, and a figure would take its place; nothing was written",
                shown(path)
            )));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tracefig::output::format;

    fn targets(scenes: &[&str], folder: Option<&str>, themes: &[&str]) -> Result<Vec<String>, Unplanned> {
        let inputs = scenes.iter().map(|s| super::super::inputs::single(s.as_ref())).collect();
        let themes: Vec<String> = themes.iter().map(|&t| t.to_owned()).collect();
        let formats: Vec<_> = ["svg", "png"].into_iter().filter_map(format).collect();
        let wanted = Wanted { folder: folder.map(Path::new), themes: &themes, formats: &formats };
        let jobs = jobs(inputs, &wanted)?;
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
        assert_eq!(got, Unplanned::Wrong(message.to_owned()));
        assert!(targets(&["src/x.toml", "src/../src/x.json"], None, &[]).is_err());
    }

    #[test]
    fn standard_output_takes_one_file() {
        assert!(matches!(targets(&["x.toml"], Some("-"), &[]), Err(Unplanned::Usage(_))));
        assert!(matches!(targets(&["-"], None, &[]), Err(Unplanned::Usage(_))));
    }
}
