//! What a file shows where it is not the finished figure alone: its steps, or its motion.

use tracefig::drawing::Drawing;
use tracefig::output::{FORMATS, Format};

use super::step_files::StepFiles;

/// How a figure is shown in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InTime {
    /// In the steps of its algorithm.
    Steps(StepFiles),
    /// The way to it, as it moves.
    Motion,
}

impl InTime {
    /// The group of the options that ask for it, which exclude each other.
    pub(crate) const GROUP: &'static str = "in_time";

    /// The part of a file's name that says so, and that of a file which holds one picture, before its number.
    pub(crate) const fn parts(self) -> [&'static str; 2] {
        match self {
            Self::Steps(_) => ["steps", "step"],
            Self::Motion => ["motion", "frame"],
        }
    }

    /// Whether a part of a file's name says that it shows a figure in time.
    pub(crate) fn is_part(part: &str) -> bool {
        [Self::Steps(StepFiles::One), Self::Motion].into_iter().any(|in_time| {
            let [whole, one] = in_time.parts();
            let number = part.strip_prefix(one).and_then(|after| after.strip_prefix('-'));
            let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
            part == whole || number.is_some_and(is_number)
        })
    }

    /// Whether each picture is a file of its own in a format.
    pub(crate) fn are_apart(self, format: &Format) -> bool {
        match self {
            Self::Steps(files) => files.are_apart(format),
            Self::Motion => !format.holds_motion(),
        }
    }

    /// The formats that are written where the command line does not say which; none for those of the project,
    /// or the usual ones.
    pub(crate) fn own_formats(self) -> Vec<&'static Format> {
        match self {
            Self::Steps(_) => Vec::new(),
            Self::Motion => FORMATS.iter().filter(|format| format.holds_motion()).collect(),
        }
    }

    /// All pictures of a drawing, in order.
    pub(crate) fn pictures(self, drawing: &Drawing) -> Vec<Drawing> {
        match self {
            Self::Steps(_) => (1..=drawing.steps.len()).map(|step| drawing.at_step(step)).collect(),
            Self::Motion => {
                let alone = |one: &Drawing| Drawing { motion: Vec::new(), ..one.clone() };
                drawing.pictures().into_iter().map(|(one, _)| alone(one)).collect()
            }
        }
    }
}
