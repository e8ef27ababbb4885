//! Which files the steps of a figure become.

use tracefig::output::Format;
use tracefig::scene::STEP_FILES;

/// How many files the steps of a figure become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepFiles {
    /// One with all of them, where the format holds them.
    One,
    /// Each a file.
    Each,
}

impl StepFiles {
    /// The word for it, in a project file and on the command line.
    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::One => STEP_FILES[0],
            Self::Each => STEP_FILES[1],
        }
    }

    /// What a word says.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        [Self::One, Self::Each].into_iter().find(|files| files.word() == word)
    }

    /// Whether each step is a file of its own in a format.
    pub(crate) fn are_apart(self, format: &Format) -> bool {
        self == Self::Each || !format.holds_steps()
    }
}
