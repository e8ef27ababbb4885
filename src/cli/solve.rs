//! `tracefig solve`: the answer alone.

use std::io::{self, Read, Write};
use std::path::PathBuf;

use clap::Args;
use tracefig::scene::{SceneFile, Solution, refuse_jsonl_line, refuse_long_jsonl_line, solve_jsonl_line};

use super::console::Console;
use super::inputs::find;
use super::lines::{Line, Lines};
use super::unplanned::tell_unplanned;
use super::{Runs, Status};

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
    #[arg(long, conflicts_with_all = ["scenes", "json"])]
    jsonl: bool,
}

impl Runs for Solve {
    fn run(self, console: &mut Console) -> io::Result<Status> {
        if self.jsonl { stream(io::stdin().lock(), console) } else { self.each(console) }
    }
}

impl Solve {
    /// Answers scene by scene.
    fn each(&self, console: &mut Console) -> io::Result<Status> {
        let found = match find(&self.scenes) {
            Ok(found) => found,
            Err(unplanned) => return Ok(tell_unplanned(&unplanned, console)),
        };
        Console::message(&found.left_alone());
        let mut status = Status::Done;
        for input in found.scenes.iter().map(|scene| &scene.input) {
            match input.open() {
                Ok(file) if self.json => writeln!(console.out, "{}", json(&input.name(), &file))?,
                Ok(file) => console.out.write_all(text(&input.shown(), &file).as_bytes())?,
                Err(refused) => status = console.refuse(&refused)?,
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
    let query = &file.scene.query;
    let names = file.scene.names();
    let answer = Solution::of(&file.scene).text(&names);
    format!("{name}: {} of {} by {}\n{answer}", query.kind.word(), names.all(), query.algorithm.name)
}

/// Answers a stream line by line, in its order. Lines are answered as they come: whoever writes one and waits
/// gets its answer before writing the next. Where nobody reads the answers any more, no more lines are read.
fn stream(input: impl Read, console: &mut Console) -> io::Result<Status> {
    let mut lines = Lines::new(input);
    let mut status = Status::Done;
    while !console.out.is_closed() {
        let reply = match lines.next() {
            Ok(Some((number, Line::Text(text)))) => solve_jsonl_line(text, number),
            Ok(Some((number, Line::NotUtf8))) => refuse_jsonl_line(number),
            Ok(Some((number, Line::TooLong(bytes)))) => refuse_long_jsonl_line(number, bytes),
            Ok(None) => break,
            Err(error) => {
                console.out.flush()?;
                console.error(&format!("can't read standard input: {error}"));
                return Ok(Status::Wrong);
            }
        };
        if !reply.solved {
            status = Status::Wrong;
        }
        console.out.write_all(reply.line.as_bytes())?;
        console.out.write_all(b"\n")?;
        if !lines.has_next() {
            console.out.flush()?;
        }
    }
    Ok(status)
}
