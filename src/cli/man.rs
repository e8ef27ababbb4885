//! `tracefig man`: the man page, of the whole or of one command.

use std::io::{self, Write};

use clap::Args;

use super::console::Console;
use super::{COMMANDS, Runs, Status, app};

/// Options of `man`.
#[derive(Args)]
pub(crate) struct Man {
    /// The command; none: the page of tracefig itself
    #[arg(value_parser = clap::builder::PossibleValuesParser::new(COMMANDS.iter().map(|c| c.name)))]
    command: Option<String>,
}

impl Runs for Man {
    fn run(self, console: &mut Console) -> io::Result<Status> {
        let mut app = app();
        app.build();
        let page = match &self.command {
            None => app,
            Some(name) => match app.find_subcommand(name) {
                Some(command) => command.clone(),
                None => return Ok(Status::Usage),
            },
        };
        let mut roff = Vec::new();
        clap_mangen::Man::new(page).render(&mut roff)?;
        console.out.write_all(&roff)?;
        Ok(Status::Done)
    }
}
