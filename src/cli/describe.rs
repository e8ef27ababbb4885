//! `tracefig describe`: the figure in words, for readers who do not see it.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use tracefig::figure::{draw, plan};
use tracefig::scene::{Refused, visible};

use super::console::Console;
use super::inputs::single;
use super::{Runs, Status};

/// Options of `describe`.
#[derive(Args)]
pub(crate) struct Describe {
    /// The scene file; `-` is standard input
    scene: PathBuf,
}

impl Runs for Describe {
    fn run(self, console: &mut Console) -> io::Result<Status> {
        let file = match single(&self.scene).open() {
            Ok(file) => file,
            Err(refused) => return console.refuse(&refused),
        };
        let plan = match plan(&file.scene) {
            Ok(plan) => plan,
            Err(problems) => return console.refuse(&Refused { source: file.source.clone(), problems }),
        };
        let drawing = draw(&plan, plan.theme, "figure").drawing;
        let line = |text: &str| visible(&text.replace('\n', " ")).into_owned();
        writeln!(console.out, "{}\n\n{}", line(&drawing.title), line(&drawing.desc))?;
        Ok(Status::Done)
    }
}
