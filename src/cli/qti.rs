//! `tracefig qti`: exercises as items with a number for an answer, in one package for a learning platform.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use tracefig::output::{ItemPackage, Numerical, OutputError};

use super::console::Console;
use super::inputs::shown;
use super::manual::Manual;
use super::outputs::{Kept, write_report};
use super::questions::{Bank, Exercises, Filled};
use super::written::cant_write;
use super::{Runs, Status};

/// Options of `qti`.
#[derive(Args)]
pub(crate) struct Qti {
    /// Which exercises.
    #[command(flatten)]
    exercises: Exercises,
    /// The package to write, as course.zip; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

impl Bank for ItemPackage {
    /// Begins nothing: a package has no categories, and items are named after their scene.
    fn category(&mut self, _name: &str) {}

    fn add(&mut self, question: &Numerical<'_>) -> Result<(), OutputError> {
        ItemPackage::add(self, question)
    }
}

impl Runs for Qti {
    const MANUAL: Manual = Manual {
        examples: &[(
            "tracefig qti scene.toml --seed 1..30 -o course.zip",
            "Write thirty variants of an exercise as a content package of QTI 2.1",
        )],
        files: &[],
        wrong: Some("a scene is wrong, or is no exercise"),
    };

    fn run(self, console: &mut Console) -> io::Result<Status> {
        let mut kept = Kept::default();
        let files = self.exercises.scenes().iter().filter(|scene| scene.as_path() != Path::new("-"));
        files.for_each(|scene| kept.keep(scene, "a scene of this run"));
        if let Some(what) = kept.what(&self.output) {
            console
                .error(&format!("{} is {what}, and the package would take its place", shown(&self.output)));
            return Ok(Status::Wrong);
        }
        let mut package = ItemPackage::default();
        let Filled { is_whole, status } = self.exercises.fill(&mut package, console);
        if !is_whole {
            return Ok(status);
        }
        let bytes = match package.finish() {
            Ok(bytes) => bytes,
            Err(error) => {
                console.error(&format!("can't write {}: {error}", shown(&self.output)));
                return Ok(Status::Wrong);
            }
        };
        if self.output == Path::new("-") {
            console.out.write_all(&bytes)?;
            return Ok(status);
        }
        if let Err(error) = write_report(&self.output, &bytes) {
            Console::message(&cant_write(&self.output, &error));
            return Ok(Status::Io);
        }
        writeln!(console.out, "{}", shown(&self.output))?;
        Ok(status)
    }
}
