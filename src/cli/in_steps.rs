//! `--steps`: a figure in the steps of its algorithm, in one file or in a file a step.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::drawing::Drawing;
use tracefig::output::{Format, InSteps};
use tracefig::scene::STEP_FILES;

use super::jobs::{Planned, Target};
use super::step_files::{PART, StepFiles};

/// The most seconds that a step is shown: a GIF counts hundredths in 16 bits.
const MOST_SECONDS: f64 = 600.0;
/// Digits of the number of a step, at least, so that names sort.
const DIGITS: usize = 2;

/// Options of a figure in steps.
#[derive(Args)]
pub(crate) struct StepOptions {
    /// Draw each figure in the steps of its algorithm: STEM.steps.EXT, one file with all of them, or with
    /// `--steps=files` and for formats of one picture a file a step, STEM.step-01.EXT
    #[arg(long, value_name = "FILES", num_args = 0..=1, require_equals = true,
        default_missing_value = StepFiles::One.word(),
        value_parser = PossibleValuesParser::new(STEP_FILES))]
    steps: Option<String>,
    /// The steps of an SVG are fragments of reveal.js
    #[arg(long, requires = "steps")]
    fragments: bool,
    /// Seconds that an animation shows each step; default: as long as its sentence takes to read
    #[arg(long, requires = "steps", value_name = "SECONDS", value_parser = seconds)]
    hold: Option<f64>,
}

/// Seconds as written on the command line.
fn seconds(text: &str) -> Result<f64, String> {
    let expected = || format!("expected a number above 0 and up to {MOST_SECONDS}");
    let seconds: f64 = text.parse().map_err(|_| expected())?;
    if seconds > 0.0 && seconds <= MOST_SECONDS { Ok(seconds) } else { Err(expected()) }
}

impl StepOptions {
    /// What the command line says of the files; none where it does not ask for steps.
    pub(crate) fn files(&self) -> Option<StepFiles> {
        self.steps.as_deref().and_then(StepFiles::of_word)
    }

    /// How a file of a format is written of a figure whose steps become these files; none for a file that
    /// shows one picture.
    pub(crate) fn in_one(&self, files: Option<StepFiles>, format: &Format) -> Option<InSteps> {
        let all = InSteps { fragments: self.fragments, hold: self.hold };
        files.filter(|files| !files.are_apart(format)).map(|_| all)
    }
}

/// One step of a figure, for a file of its own.
pub(crate) struct OneStep {
    /// What it shows.
    pub(crate) drawing: Drawing,
    /// Where it goes.
    pub(crate) target: Target,
    /// What tells it apart in a hash.
    pub(crate) key: String,
}

/// The steps of a drawing that become files of their own; none where the file of the plan holds what there is
/// to show.
pub(crate) fn apart(drawing: &Drawing, planned: &Planned, files: Option<StepFiles>) -> Option<Vec<OneStep>> {
    files.filter(|files| files.are_apart(planned.format))?;
    let last = drawing.steps.len();
    let digits = last.to_string().len().max(DIGITS);
    let one = |step: usize| OneStep {
        drawing: drawing.at_step(step),
        target: match &planned.target {
            Target::Stdout => Target::Stdout,
            Target::File(path) => Target::File(numbered(path, step, digits)),
        },
        key: format!(" step={step}"),
    };
    Some((1..=last).map(one).collect())
}

/// The name of the file of a step: `x.step-03.png` of `x.steps.png`.
fn numbered(path: &Path, step: usize, digits: usize) -> PathBuf {
    let extension = path.extension().unwrap_or_default().to_owned();
    let mut stem = path.with_extension("");
    if stem.extension().is_some_and(|part| part == PART) {
        stem.set_extension("");
    }
    let mut name = stem.into_os_string();
    name.push(format!(".step-{step:0digits$}."));
    name.push(extension);
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_in_the_place_of_the_word_and_sort() {
        let name = |path: &str, step, digits| numbered(Path::new(path), step, digits).display().to_string();
        assert_eq!(name("a/x.steps.png", 3, 2), "a/x.step-03.png");
        assert_eq!(name("a.b/x.dark.steps.svg", 12, 3), "a.b/x.dark.step-012.svg");
        assert_eq!(name("x.svg", 1, 2), "x.step-01.svg");
    }
}
