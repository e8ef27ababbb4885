//! `tracefig trace`: every event of the algorithm, as a story or as JSON lines.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use tracefig::scene::Solution;
use tracefig::trace::{Trace as Events, Tracer, json_lines, story};

use super::console::Console;
use super::inputs::single;
use super::manual::Manual;
use super::{Runs, Status};

/// Options of `trace`.
#[derive(Args)]
pub(crate) struct Trace {
    /// The scene file; `-` is standard input
    scene: PathBuf,
    /// A line of JSON for each event, after a header line
    #[arg(long)]
    jsonl: bool,
}

impl Runs for Trace {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig trace scene.toml", "Tell the algorithm step by step"),
            ("tracefig trace --jsonl scene.toml > events.jsonl", "Write an event a line, for a program"),
        ],
        files: &[],
        wrong: Some("the scene is wrong"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        let file = match single(&self.scene).open() {
            Ok(file) => file,
            Err(refused) => return console.refuse(&refused),
        };
        let mut events = Events::default();
        (file.scene.query().algorithm.traced)(&file.scene.query_of_bodies(), &mut events);
        if let Some(off) = Solution::of(&file.scene).off {
            events.record(|| off.event());
        }
        let text = if self.jsonl { json_lines(&events)? } else { story(&events, &file.scene.names()) };
        console.out.write_all(text.as_bytes())?;
        if events.left_out > 0 {
            console.out.flush()?;
            let warning = format!("warning: {} more events are left out, the end too", events.left_out);
            Console::message(&format!("{warning}\n  = help: `tracefig solve` says the answer\n"));
        }
        Ok(Status::Done)
    }
}
