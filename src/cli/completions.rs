//! `tracefig completions`: what a shell completes.

use std::io::{self, Write};

use clap::Args;
use clap_complete::{Shell, generate};

use super::console::Console;
use super::{Runs, Status, app};

/// Options of `completions`.
#[derive(Args)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl Runs for Completions {
    fn run(self, console: &mut Console) -> io::Result<Status> {
        // `generate` panics where it can't write, so it writes to memory.
        let mut script = Vec::new();
        generate(self.shell, &mut app(), "tracefig", &mut script);
        console.out.write_all(&script)?;
        Ok(Status::Done)
    }
}
