//! What live pages share: the file with the module, and the page that lists them.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tracefig::figure::{draw, plain, plan};
use tracefig::output::{Gallery, INLINE, gallery, live_runtime};
use tracefig::scene::Scene;

use super::Status;
use super::atomic_file::{Wait, write_whole};
use super::console::Console;
use super::inputs::shown;
use super::jobs::{Job, Target};
use super::live::{Live, MODULE, RUNTIME, below, heading, index_of, live_of, root};
use super::written::cant_write;

/// How a value begins that a text takes from the answer.
const VALUE: &str = "{=";

/// Writes what the pages of a run share: the runtime, and the page that lists them. Pages that `written` does
/// not name were not written.
///
/// # Errors
/// When standard output fails.
pub(crate) fn finish(
    live: Live,
    jobs: &[Job],
    written: &BTreeSet<String>,
    console: &mut Console,
) -> io::Result<Status> {
    let mut status = Status::Done;
    let pages: Vec<(&Job, &Target)> = jobs
        .iter()
        .flat_map(|job| {
            job.files.iter().filter(|f| live_of(Some(live), f).is_some()).map(move |f| (job, &f.target))
        })
        .filter(|(_, target)| matches!(target, Target::File(path) if written.contains(&shown(path))))
        .collect();
    let mut files: Vec<(PathBuf, String)> = Vec::new();
    if live == Live::Shared {
        let folder = |&(job, target): &(&Job, &Target)| match (root(job), target) {
            (Some(root), _) => root.to_owned(),
            (None, Target::File(path)) => path.parent().unwrap_or(Path::new("")).to_owned(),
            (None, Target::Stdout) => PathBuf::new(),
        };
        let folders: BTreeSet<PathBuf> = pages.iter().map(folder).collect();
        files.extend(folders.into_iter().map(|folder| (folder.join(RUNTIME), live_runtime(MODULE))));
    }
    // Each folder that gathers pages has a list of its own.
    let mut gathered: BTreeMap<&Path, Vec<(&Job, &Target)>> = BTreeMap::new();
    for &(job, target) in &pages {
        gathered.entry(root(job).unwrap_or(Path::new(""))).or_default().push((job, target));
    }
    files.extend(gathered.values().filter_map(|pages| index(pages, written)));
    for (path, text) in files {
        match write_whole(&path, text.as_bytes(), Wait::No) {
            Ok(()) if console.is_quiet() => {}
            Ok(()) => writeln!(console.out, "{}", shown(&path))?,
            Err(error) => {
                console.error(cant_write(&path, &error).trim_start_matches("error: ").trim_end());
                status = Status::Io;
            }
        }
    }
    Ok(status)
}

/// The page that lists the others, where a folder gathers several; first those whose scenes say what moves.
fn index(pages: &[(&Job, &Target)], written: &BTreeSet<String>) -> Option<(PathBuf, String)> {
    let &(first, target) = pages.first()?;
    let path = root(first)?.join(index_of(first, target)?);
    let taken = pages.iter().any(|(_, target)| **target == Target::File(path.clone()));
    if pages.len() < 2 || taken {
        return None;
    }
    let entries = pages.iter().filter_map(|&(job, target)| entry(job, target, written));
    let (told, others): (Vec<_>, Vec<_>) = entries.partition(|(is_told, _)| *is_told);
    let ordered: Vec<Gallery> = told.into_iter().chain(others).map(|(_, entry)| entry).collect();
    Some((path, gallery(&ordered)))
}

/// What a page claims: its headline, or the short text of its picture where the headline has values in it.
fn claim(scene: &Scene) -> String {
    let Some(headline) = &scene.headline else { return String::new() };
    if !headline.value.contains(VALUE) {
        return plain(&headline.value);
    }
    plan(scene).map(|plan| draw(&plan, plan.theme, "").drawing.title).unwrap_or_default()
}

/// A page's entry in the list, with its picture where that was `written`, and whether its scene says what can
/// be moved.
fn entry(job: &Job, target: &Target, written: &BTreeSet<String>) -> Option<(bool, Gallery)> {
    let Target::File(path) = target else { return None };
    let has_picture = written.contains(&shown(&path.with_extension(INLINE.name)));
    let file = job.input.open().ok()?;
    let name = below(job, target)?.join(path.file_name()?);
    let address = |path: &Path| path.to_string_lossy().replace('\\', "/");
    let picture = if has_picture { address(&name.with_extension(INLINE.name)) } else { String::new() };
    let lang = file.scene.lang.as_ref().map(|lang| lang.value.clone());
    let words = claim(&file.scene);
    let entry = Gallery { page: address(&name), picture, title: heading(&file, job), words, lang };
    Some((file.scene.live.drag.is_some(), entry))
}
