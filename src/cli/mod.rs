//! The command line: one command a file, each a row in [`COMMANDS`].
//!
//! Messages go to standard error, results to standard output. Exit status: 0 done, 1 the input is wrong or a
//! check failed, 2 usage, 3 a bug of ours, 74 something can't be read or written. A closed pipe costs a
//! command nothing but its readers: what it had to do is done and its exit status is the same, only a stream
//! of scenes is read no further.

mod answering;
mod apart;
mod asked;
mod atomic_file;
mod book;
mod check;
mod checked;
mod completions;
mod console;
mod declared;
mod describe;
mod differences;
mod encoded;
mod encoding;
mod failure;
mod files;
mod gallery;
mod handout;
mod in_motion;
mod in_steps;
mod in_time;
mod inputs;
mod jobs;
mod lines;
mod list;
mod live;
mod man;
mod manual;
mod mdbook;
mod moodle;
mod narrow;
mod orphans;
mod outputs;
mod own_themes;
mod parallel;
mod partition;
mod positive;
mod project;
mod qti;
mod questions;
mod regular;
mod render;
mod report;
mod reports;
mod schema;
mod settings;
mod solve;
mod step_files;
mod stream;
mod tally;
mod themes;
mod timings;
mod trace;
mod unasked;
mod unchecked;
mod unfit;
mod unplanned;
mod variants;
mod walk;
mod watch;
mod written;

use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::{ArgMatches, Args, FromArgMatches};

use tracefig::scene::{Explain, Refused};

use console::{Console, Manner};
use manual::Manual;

/// How a command ended, where it was not stopped.
///
/// Of several things that went wrong the last of these is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Status {
    /// All is done.
    Done,
    /// The input is wrong, or a check failed; messages have been written.
    Wrong,
    /// The options contradict each other; a message has been written.
    Usage,
    /// Something can't be read or written; a message has been written.
    Io,
    /// A bug of ours; a message has been written.
    Bug,
}

impl Status {
    /// How a command ends that was refused a scene: a file that can't be read is no wrong input.
    fn of<F: Explain>(refused: &Refused<F>) -> Self {
        if refused.problems.iter().all(|problem| problem.fault.has_place()) { Self::Wrong } else { Self::Io }
    }

    /// The number of the exit status. What can't be read or written is the 74 of BSD's `sysexits.h`.
    fn number(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Wrong => 1,
            Self::Usage => 2,
            Self::Bug => 3,
            Self::Io => 74,
        }
    }

    /// The exit status.
    fn code(self) -> ExitCode {
        ExitCode::from(self.number())
    }
}

/// A row of the table of commands: what the parser, the man page and the completions know of a command.
struct Command {
    /// The word for it on the command line, and the name of its file.
    name: &'static str,
    /// One line of help.
    about: &'static str,
    /// What its page says beyond that.
    manual: Manual,
    /// Adds its options to a parser.
    args: fn(clap::Command) -> clap::Command,
    /// Runs it with the options that were given.
    run: fn(&ArgMatches, &mut Console) -> io::Result<Status>,
}

/// A command: its options by `clap`, and what it does.
trait Runs: Args {
    /// What its help and its man page say beyond the options.
    const MANUAL: Manual;

    /// Runs the command. An `Err` is a failure of standard output itself.
    fn run(self, console: &mut Console) -> io::Result<Status>;
}

/// The row of a command.
const fn row<T: Runs>(name: &'static str, about: &'static str) -> Command {
    Command { name, about, manual: T::MANUAL, args: T::augment_args, run: run_as::<T> }
}

/// Runs a command with what the parser found.
fn run_as<T: Runs>(matches: &ArgMatches, console: &mut Console) -> io::Result<Status> {
    match T::from_arg_matches(matches) {
        Ok(command) => command.run(console),
        Err(error) => error.exit(),
    }
}

/// Every command.
static COMMANDS: &[Command] = &[
    row::<render::Render>("render", "Draw scenes, as SVG, PNG and other formats"),
    row::<watch::Watch>("watch", "Draw scenes, and again whenever they change"),
    row::<check::Check>("check", "Compare the figures on disk with what their scenes give"),
    row::<solve::Solve>("solve", "Answer scenes, as text or JSON"),
    row::<trace::Trace>("trace", "Tell every step of a scene's algorithm"),
    row::<describe::Describe>("describe", "Tell a figure in words: its alternative text, short and long"),
    row::<mdbook::Mdbook>("mdbook", "Draw the scenes in the pages of a book, as mdBook builds it"),
    row::<moodle::Moodle>("moodle", "Write exercises as questions for a Moodle course, in one file"),
    row::<qti::Qti>("qti", "Write exercises as items of QTI 2.1 for a learning platform, in one package"),
    row::<report::Report>("report", "Measure speed against error, as tables and plots"),
    row::<list::List>("list", "Print what a scene may say: kinds, algorithms, layers, fields, errors"),
    row::<completions::Completions>("completions", "Print completions for a shell"),
    row::<man::Man>("man", "Print the man page"),
];

/// The parser, built from the table.
fn app() -> clap::Command {
    // What comes with options of their own describes itself, and would be told in the place of the whole.
    let app = Manner::augment_args(clap::Command::new("tracefig"))
        .version(env!("CARGO_PKG_VERSION"))
        .about("Draw what a 2D collision algorithm did")
        .after_help(format!("`-` is standard input or output. {}", manual::endings_in_a_line()))
        .subcommand_required(true)
        .arg_required_else_help(true);
    COMMANDS.iter().fold(app, |app, command| {
        let parser = clap::Command::new(command.name).after_help(command.manual.below_help());
        app.subcommand((command.args)(parser).about(command.about).mut_args(signed))
    })
}

/// Lets an option take a number below 0: then it can say what it takes instead.
fn signed(arg: clap::Arg) -> clap::Arg {
    let takes = arg.get_long().is_some() && arg.get_action().takes_values();
    arg.allow_negative_numbers(takes)
}

/// Runs the command line of this process.
pub(crate) fn run() -> ExitCode {
    let matches = match app().try_get_matches() {
        Ok(matches) => matches,
        Err(answer) => return print(&answer),
    };
    let manner = Manner::from_arg_matches(&matches).unwrap_or_default();
    let mut console = Console::new(manner);
    tell_bugs_briefly();
    let Some((name, arguments)) = matches.subcommand() else { return ExitCode::from(2) };
    let Some(command) = COMMANDS.iter().find(|command| command.name == name) else {
        return ExitCode::from(2);
    };
    let ended = catch_unwind(AssertUnwindSafe(|| (command.run)(arguments, &mut console)));
    match console.finish().and(ended.unwrap_or(Ok(Status::Bug))) {
        Ok(status) => status.code(),
        Err(error) => cant_print(&error),
    }
}

/// Prints what the parser has to say instead of running a command: help and version on standard output, what
/// is wrong with the arguments on standard error.
fn print(answer: &clap::Error) -> ExitCode {
    let printed = answer.print().and_then(|()| io::stdout().flush());
    match printed {
        Err(error) if !answer.use_stderr() && error.kind() != io::ErrorKind::BrokenPipe => cant_print(&error),
        _ => ExitCode::from(u8::try_from(answer.exit_code()).unwrap_or(2)),
    }
}

/// Says that standard output failed.
fn cant_print(error: &io::Error) -> ExitCode {
    Console::new(Manner::default()).error(&format!("can't write to standard output: {error}"));
    Status::Io.code()
}

/// A panic is a bug of ours: one line that says so, and no backtrace unless `RUST_BACKTRACE` asks for it.
fn tell_bugs_briefly() {
    if std::env::var_os("RUST_BACKTRACE").is_some() {
        return;
    }
    std::panic::set_hook(Box::new(|info| {
        let place = info.location().map_or(String::new(), |at| format!(" at {}:{}", at.file(), at.line()));
        Console::new(Manner::default())
            .error(&format!("this is a bug of tracefig{place}; please report it with the scene"));
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_makes_a_parser_without_contradictions() {
        app().debug_assert();
    }
}
