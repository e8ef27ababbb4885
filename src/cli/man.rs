//! `tracefig man`: the man page, of the whole or of one command.

use std::io::{self, Write};

use clap::Args;
use clap_mangen::roff::{Roff, bold, roman};

use super::console::Console;
use super::manual::{ENVIRONMENT, Manual, all_endings, first_examples};
use super::{COMMANDS, Runs, Status, app};

/// Options of `man`.
#[derive(Args)]
pub(crate) struct Man {
    /// The command; none: the page of tracefig itself
    #[arg(value_parser = clap::builder::PossibleValuesParser::new(COMMANDS.iter().map(|c| c.name)))]
    command: Option<String>,
}

impl Runs for Man {
    const MANUAL: Manual = Manual {
        examples: &[
            ("tracefig man check | man -l -", "Read the page of a command"),
            ("tracefig man > ~/.local/share/man/man1/tracefig.1", "Keep the page for `man tracefig`"),
        ],
        files: &[],
        wrong: None,
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        let mut app = app();
        app.build();
        let Some(name) = &self.command else {
            console.out.write_all(&page(app, &first_examples(), &[], &all_endings())?)?;
            return Ok(Status::Done);
        };
        let row = COMMANDS.iter().find(|row| row.name == name);
        let (Some(command), Some(row)) = (app.find_subcommand(name), row) else { return Ok(Status::Usage) };
        let Manual { examples, files, .. } = row.manual;
        console.out.write_all(&page(command.clone(), examples, files, &row.manual.endings())?)?;
        Ok(Status::Done)
    }
}

/// A page in roff: what the parser knows, then what the manual says.
fn page(
    command: clap::Command,
    examples: &[(&str, &str)],
    files: &[(&str, &str)],
    endings: &[(u8, &str)],
) -> io::Result<Vec<u8>> {
    let version = concat!("tracefig ", env!("CARGO_PKG_VERSION"));
    let has_commands = command.has_subcommands();
    let name = command.get_display_name().unwrap_or_else(|| command.get_name()).to_owned();
    let parsed = clap_mangen::Man::new(command).title(name).source(version).manual("tracefig");
    let mut text = Vec::new();
    parsed.render_title(&mut text)?;
    parsed.render_name_section(&mut text)?;
    parsed.render_synopsis_section(&mut text)?;
    parsed.render_description_section(&mut text)?;
    parsed.render_options_section(&mut text)?;
    if has_commands {
        parsed.render_subcommands_section(&mut text)?;
    }
    let endings: Vec<(String, &str)> = endings.iter().map(|(n, says)| (n.to_string(), *says)).collect();
    let endings: Vec<(&str, &str)> = endings.iter().map(|(n, says)| (n.as_str(), *says)).collect();
    let mut roff = Roff::new();
    for (title, rows) in [
        ("EXAMPLES", examples),
        ("EXIT STATUS", &endings[..]),
        ("ENVIRONMENT", ENVIRONMENT),
        ("FILES", files),
    ] {
        section(&mut roff, title, rows);
    }
    roff.to_writer(&mut text)?;
    Ok(text)
}

/// A section of terms, each with what it is; none where there is no term.
fn section(roff: &mut Roff, title: &str, rows: &[(&str, &str)]) {
    if !rows.is_empty() {
        roff.control("SH", [title]);
    }
    for (term, is) in rows {
        roff.control("TP", []).text([bold(*term)]).text([roman(*is)]);
    }
}
