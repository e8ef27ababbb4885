//! `tracefig solve`: the answer alone.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use tracefig::scene::{SceneFile, Solution};

use super::answering::{End, answer_all};
use super::console::Console;
use super::inputs::{find_here, shown, tell_unread};
use super::manual::Manual;
use super::outputs::write_report;
use super::parallel::threads;
use super::partition::Partition;
use super::unplanned::tell_unplanned;
use super::{Runs, Status};

/// What a stream is not asked with. Its options say so too: what requires an option is not asked for where
/// something conflicts with that.
const ALONE: [&str; 2] = ["scenes", "json"];

/// Options of `solve`.
#[derive(Args)]
pub(crate) struct Solve {
    /// Scene files, or folders, which are searched in depth; `-` is standard input; none: the scenes of the
    /// project file `tracefig.toml`, else all of figures/
    #[arg(value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// A line of JSON for each scene
    #[arg(long)]
    json: bool,
    /// Read a scene (as JSON) a line from standard input, write a line of JSON for each
    #[arg(long, conflicts_with_all = ALONE)]
    jsonl: bool,
    /// What a refused line of --jsonl does to the exit status; its error line is written in any case
    #[arg(long, value_name = "WHAT", value_enum, default_value = "status", requires = "jsonl",
        conflicts_with_all = ALONE)]
    errors: Errors,
    /// Answer only the Kth of N equal shares of the lines of --jsonl: every Nth, from the Kth on
    #[arg(long, value_name = "K/N", requires = "jsonl", conflicts_with_all = ALONE)]
    partition: Option<Partition>,
    /// Write what became of the lines of --jsonl as JSON: counts and a checksum, to which those of shards add
    /// up
    #[arg(long, value_name = "FILE", requires = "jsonl", conflicts_with_all = ALONE)]
    summary: Option<PathBuf>,
    /// Lines of --jsonl answered at once, at most; the output is the same for any number; default: as many as
    /// there are processors
    #[arg(long, value_name = "N", requires = "jsonl", conflicts_with_all = ALONE)]
    threads: Option<NonZeroUsize>,
}

impl Runs for Solve {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig solve scene.toml --json", "Answer a scene, with bounds that enclose the exact answer"),
            (
                "tracefig solve --jsonl --errors lines < pairs.jsonl > answers.jsonl",
                "Answer a scene a line; lines that are refused do not count for the exit status",
            ),
        ],
        files: &[],
        wrong: Some("a scene, or a line, is wrong"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        if self.jsonl { self.stream(console) } else { self.each(console) }
    }
}

impl Solve {
    /// Answers scene by scene.
    fn each(&self, console: &mut Console) -> io::Result<Status> {
        let found = match find_here(&self.scenes) {
            Ok(found) => found,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        console.note(&found.left_alone());
        let mut status = tell_unread(&found.unread, console);
        for input in found.scenes.iter().map(|scene| &scene.input) {
            match input.open() {
                Ok(file) if self.json => writeln!(console.out, "{}", json(&input.name(), &file))?,
                Ok(file) => console.out.write_all(text(&input.shown(), &file).as_bytes())?,
                Err(refused) => status = status.max(console.refuse(&refused)?),
            }
        }
        Ok(status)
    }
}

/// The answer to a scene as a line of JSON.
fn json(name: &str, file: &SceneFile) -> serde_json::Value {
    serde_json::json!({ "scene": name, "result": Solution::of(&file.scene).json() })
}

/// The answer to a scene for people.
fn text(name: &str, file: &SceneFile) -> String {
    let query = file.scene.query();
    let names = file.scene.names();
    let answer = Solution::of(&file.scene).text(&names);
    format!("{name}: {} of {} by {}\n{answer}", query.kind.word(), names.all(), query.algorithm.name)
}

/// What a refused line of a stream does to the exit status.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Errors {
    /// Exit 1 at the end
    Status,
    /// Nothing: its error line is the answer
    Lines,
}

impl Solve {
    /// Answers a stream line by line, in its order.
    fn stream(&self, console: &mut Console) -> io::Result<Status> {
        if self.summary.as_deref() == Some(Path::new("-")) {
            console.error("standard output takes the answers: give `--summary` a file");
            return Ok(Status::Usage);
        }
        let part = self.partition.unwrap_or(Partition::WHOLE);
        let (tally, end) = answer_all(io::stdin(), part, threads(self.threads), &mut console.out);
        console.out.flush()?;
        let refused = tally.has_errors() && self.errors != Errors::Lines;
        let mut status = if refused { Status::Wrong } else { Status::Done };
        match end {
            End::Done => {}
            End::CantRead(error) => {
                console.error(&format!("can't read standard input: {error}"));
                status = Status::Io;
            }
            End::Lost => status = Status::Bug,
        }
        if let Some(path) = &self.summary
            && let Err(error) = write_report(path, format!("{:#}\n", tally.json()).as_bytes())
        {
            console.error(&format!("can't write {}: {error}", shown(path)));
            status = Status::Io;
        }
        Ok(status)
    }
}
