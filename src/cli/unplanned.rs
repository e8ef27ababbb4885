//! Why a run does nothing: its options, its inputs or its project file are wrong.

use tracefig::scene::Refused;

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
