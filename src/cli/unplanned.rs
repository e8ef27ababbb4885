//! Why a run does nothing: its options, its inputs or its project file are wrong.

use std::path::Path;

use tracefig::scene::{Fault, Problem, Refused, Source};

use super::Status;
use super::console::Console;

/// Why there is no plan.
#[derive(Debug)]
pub(crate) enum Unplanned {
    /// The options contradict each other.
    Usage(String),
    /// The inputs are wrong: no scene, or two that would become one file.
    Wrong(String),
    /// A file can't be read.
    Unread(String),
    /// A project file is wrong.
    Refused(Box<Refused>),
}

/// What is said of a project file that can't be read, as of one that is wrong.
pub(crate) fn unread(message: String, folder: &Path) -> Refused {
    let help = "look at who may read it".to_owned();
    let problems = vec![Problem::new(Fault::Conflict { message, help }, 0..0)];
    Refused { source: Source::new(&folder.display().to_string(), ""), problems }
}

/// Says why nothing is done.
pub(crate) fn tell_unplanned(why: &Unplanned, console: &Console) -> Status {
    match why {
        Unplanned::Usage(message) => {
            console.error(message);
            Status::Usage
        }
        Unplanned::Wrong(message) => {
            console.error(message);
            Status::Wrong
        }
        Unplanned::Unread(message) => {
            console.error(message);
            Status::Io
        }
        Unplanned::Refused(refused) => {
            Console::message(&refused.render(console.ink()));
            Status::Wrong
        }
    }
}
