//! `tracefig describe`: the figure in words, for readers who do not see it.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use tracefig::figure::{draw, plan, plan_in};
use tracefig::scene::{Refused, visible};

use super::console::Console;
use super::inputs::single;
use super::manual::Manual;
use super::own_themes::OwnThemes;
use super::{Runs, Status};

/// Options of `describe`.
#[derive(Args)]
pub(crate) struct Describe {
    /// The scene file; `-` is standard input
    scene: PathBuf,
}

impl Runs for Describe {
    const MANUAL: Manual = Manual {
        examples: &[("tracefig describe scene.toml", "Print the alternative text, short and long")],
        files: &[],
        wrong: Some("the scene is wrong"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        let input = single(&self.scene);
        let file = match input.open() {
            Ok(file) => file,
            Err(refused) => return console.refuse(&refused),
        };
        let refused = |problems| Refused { source: file.source.clone(), problems };
        let own = match OwnThemes::default().of(&file, &input, console.ink()) {
            Ok(own) => own,
            Err(none) => {
                Console::message(&none.message);
                return Ok(Status::Wrong);
            }
        };
        let planned = own.as_ref().map_or_else(|| plan(&file.scene), |own| plan_in(&file.scene, &own.theme));
        let plan = match planned {
            Ok(plan) => plan,
            Err(problems) => return console.refuse(&refused(problems)),
        };
        let drawing = draw(&plan, plan.theme, "figure").drawing;
        let line = |text: &str| visible(&text.replace('\n', " ")).into_owned();
        writeln!(console.out, "{}\n\n{}", line(&drawing.title), line(&drawing.desc))?;
        Ok(Status::Done)
    }
}
