//! What help and man pages say of a command beyond its options: examples, files and exit statuses.

use super::{COMMANDS, Status};

/// What a command's page says.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Manual {
    /// Lines to be typed, each with what it does.
    pub(crate) examples: &'static [(&'static str, &'static str)],
    /// Files and folders that it reads or writes without being told their names, each with what for.
    pub(crate) files: &'static [(&'static str, &'static str)],
    /// What went wrong where it ends with [`Status::Wrong`]; none where it never does.
    pub(crate) wrong: Option<&'static str>,
}

/// The project file, of commands that draw.
pub(crate) const PROJECT_FILE: (&str, &str) =
    ("tracefig.toml", "the project file, the nearest upward from each scene: what holds of all scenes");

/// The folder that is drawn where nothing says which.
pub(crate) const FIGURES: (&str, &str) =
    ("figures/", "the scenes that are taken where neither arguments nor a project file name any");

/// Variables of the environment that every command heeds, each with what it does.
pub(crate) const ENVIRONMENT: &[(&str, &str)] = &[
    ("NO_COLOR", "where it is set and not empty, messages have no colour; the option --color beats it"),
    ("TERM", "the value dumb does as NO_COLOR"),
    ("RUST_BACKTRACE", "where it is set, a bug of tracefig is told with its backtrace"),
];

/// How commands end, by the number; what a status says of all of them.
const ENDINGS: [(Status, &str); 5] = [
    (Status::Done, "done"),
    (Status::Wrong, "wrong input or failed check"),
    (Status::Usage, "wrong options or arguments"),
    (Status::Bug, "a bug of tracefig"),
    (Status::Io, "something can't be read or written"),
];

impl Manual {
    /// How the command ends: each exit status, with what it says.
    pub(crate) fn endings(&self) -> Vec<(u8, &'static str)> {
        let meant = |(status, says): (Status, &'static str)| match status {
            Status::Wrong => self.wrong.map(|wrong| (status.number(), wrong)),
            _ => Some((status.number(), says)),
        };
        ENDINGS.into_iter().filter_map(meant).collect()
    }

    /// The examples as they stand below the options in help.
    pub(crate) fn below_help(&self) -> String {
        let shown = self.examples.iter().map(|(line, does)| format!("  {line}\n      {does}"));
        std::iter::once("Examples:".to_owned()).chain(shown).collect::<Vec<_>>().join("\n")
    }
}

/// The examples on the page of tracefig itself: the first of each command.
pub(crate) fn first_examples() -> Vec<(&'static str, &'static str)> {
    COMMANDS.iter().filter_map(|command| command.manual.examples.first().copied()).collect()
}

/// All exit statuses, each with what it says.
pub(crate) fn all_endings() -> Vec<(u8, &'static str)> {
    ENDINGS.iter().map(|(status, says)| (status.number(), *says)).collect()
}

/// How commands end, as a sentence of the help.
pub(crate) fn endings_in_a_line() -> String {
    let all = all_endings().into_iter().map(|(number, says)| format!("{number} {says}"));
    format!("Exit status: {}.", all.collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::super::app;
    use super::*;

    #[test]
    fn every_example_is_a_line_that_the_parser_takes_for_its_command() {
        for command in COMMANDS {
            assert!(!command.manual.examples.is_empty(), "{}", command.name);
            for (line, _) in command.manual.examples {
                let ours = line.rsplit("| ").find(|part| part.starts_with("tracefig ")).unwrap();
                let ours = ours.split(['<', '>']).next().unwrap();
                let matches = app().try_get_matches_from(ours.split_whitespace());
                let matches = matches.unwrap_or_else(|error| panic!("{line}: {error}"));
                assert_eq!(matches.subcommand_name(), Some(command.name), "{line}");
            }
        }
    }

    #[test]
    fn endings_are_in_the_order_of_their_numbers() {
        assert!(ENDINGS.is_sorted_by_key(|(status, _)| status.number()));
        let all = |manual: &Manual| manual.endings().iter().map(|(number, _)| *number).collect::<Vec<_>>();
        for command in COMMANDS {
            let wrong: &[u8] = if command.manual.wrong.is_some() { &[1] } else { &[] };
            assert_eq!(all(&command.manual), [&[0], wrong, &[2, 3, 74]].concat(), "{}", command.name);
        }
    }
}
