//! `tracefig completions`: what a shell completes.

use std::io::{self, Write};

use clap::Args;
use clap_complete::{Shell, generate};

use super::console::Console;
use super::manual::Manual;
use super::{Runs, Status, app};

/// Options of `completions`.
#[derive(Args)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl Runs for Completions {
    const MANUAL: Manual = Manual {
        examples: &[
            (
                "tracefig completions bash > ~/.local/share/bash-completion/completions/tracefig",
                "Bash: found by the next shell",
            ),
            (
                "tracefig completions zsh > ~/.zfunc/_tracefig",
                "Zsh: where ~/.zfunc is in fpath before compinit",
            ),
            ("tracefig completions fish > ~/.config/fish/completions/tracefig.fish", "Fish: found at once"),
            ("tracefig completions powershell >> $PROFILE", "PowerShell: found by the next shell"),
            ("tracefig completions elvish >> ~/.config/elvish/rc.elv", "Elvish: found by the next shell"),
        ],
        files: &[],
        wrong: None,
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        // `generate` panics where it can't write, so it writes to memory.
        let mut script = Vec::new();
        generate(self.shell, &mut app(), "tracefig", &mut script);
        console.out.write_all(&script)?;
        Ok(Status::Done)
    }
}
