//! The report as files, and what it ran on.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::drawing::Role;
use crate::figure::theme;
use crate::output::{FORMATS, Options, Writer};

use super::{Report, json, markdown, plots};

/// Writes `report.md`, `report.json` and every plot in every format of one drawing to a folder, which is made
/// where there is none. Returns the files.
///
/// # Errors
///
/// What the file system says, or that a plot can't be drawn.
///
/// ```
/// use tracefig::report::{Report, write};
/// let folder = tempfile::tempdir()?;
/// let report = Report { machine: vec![], rows: vec![], partial: true };
/// let files = write(&report, folder.path())?;
/// assert_eq!(files, ["report.md", "report.json"].map(|name| folder.path().join(name)));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(report: &Report, folder: &Path) -> io::Result<Vec<PathBuf>> {
    fs::create_dir_all(folder)?;
    let mut paths = Vec::new();
    for (name, bytes) in files(report)? {
        let path = folder.join(name);
        fs::write(&path, bytes)?;
        paths.push(path);
    }
    Ok(paths)
}

/// The files of a report, each with its name: `report.md`, `report.json` and every plot.
///
/// # Errors
///
/// When a plot can't be drawn.
///
/// ```
/// use tracefig::report::{Report, files};
/// let files = files(&Report { machine: vec![], rows: vec![], partial: true })?;
/// assert_eq!(files[0].0, "report.md");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn files(report: &Report) -> io::Result<Vec<(String, Vec<u8>)>> {
    let mut files = vec![
        ("report.md".to_owned(), markdown(report).into_bytes()),
        ("report.json".to_owned(), format!("{:#}\n", json(report)).into_bytes()),
    ];
    let look = &theme::THEMES[0];
    let color = |role: Role| look.color(role);
    for plot in plots(report, &color).map_err(io::Error::other)? {
        for format in FORMATS.iter().filter(|format| format.usual) {
            if let Writer::One(bytes) = format.write {
                let bytes = bytes(&plot.drawing, &Options::default()).map_err(io::Error::other)?;
                files.push((format!("{}.{}", plot.stem, format.name), bytes));
            }
        }
    }
    Ok(files)
}

/// What this program runs on: processor, system, version, and the commit where it runs in a checkout of
/// itself. Each with the word for it.
///
/// ```
/// let facts = tracefig::report::machine();
/// assert!(facts.iter().any(|(what, _)| what == "processor"));
/// ```
#[must_use]
pub fn machine() -> Vec<(String, String)> {
    let mut facts = vec![
        ("processor".to_owned(), processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned())),
        ("system".to_owned(), format!("{} {}", std::env::consts::OS, std::env::consts::ARCH)),
        ("tracefig".to_owned(), env!("CARGO_PKG_VERSION").to_owned()),
    ];
    if let Some(commit) = commit() {
        facts.push(("commit".to_owned(), commit));
    }
    facts
}

/// The name of the processor, where the system tells it.
fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// The commit of the checkout that this runs in, where it is one of tracefig.
fn commit() -> Option<String> {
    let manifest = fs::read_to_string("Cargo.toml").or_else(|_| fs::read_to_string("../Cargo.toml")).ok()?;
    manifest.contains("name = \"tracefig").then_some(())?;
    let output =
        Command::new("git").args(["describe", "--always", "--dirty", "--abbrev=12"]).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
