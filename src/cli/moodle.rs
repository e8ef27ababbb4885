//! `tracefig moodle`: exercises as questions with a number for an answer, in one file for a question bank.

use std::io::{self, Write};

use clap::Args;
use tracefig::output::{Numerical, OutputError, Quiz};

use super::console::Console;
use super::manual::Manual;
use super::questions::{Bank, Exercises};
use super::{Runs, Status};

/// Options of `moodle`.
#[derive(Args)]
pub(crate) struct Moodle {
    /// Which exercises; each scene becomes a category.
    #[command(flatten)]
    exercises: Exercises,
}

impl Bank for Quiz {
    fn category(&mut self, name: &str) {
        Quiz::category(self, name);
    }

    fn add(&mut self, question: &Numerical<'_>) -> Result<(), OutputError> {
        Quiz::add(self, question)
    }
}

impl Runs for Moodle {
    const MANUAL: Manual = Manual {
        examples: &[
            (
                "tracefig moodle scene.toml --seed 1..30 > scene.moodle.xml",
                "Write thirty variants of an exercise as numerical questions, to be imported as Moodle XML",
            ),
            ("tracefig moodle a.toml b.toml > all.xml", "Write two exercises, a category each"),
        ],
        files: &[],
        wrong: Some("a scene is wrong, or is no exercise"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        let mut quiz = Quiz::new();
        let filled = self.exercises.fill(&mut quiz, console);
        if filled.is_whole {
            console.out.write_all(quiz.finish().as_bytes())?;
        }
        Ok(filled.status)
    }
}
