//! `--steps`: a figure in the steps of its algorithm, in one file or in a file a step.

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::output::{Format, InSteps};
use tracefig::scene::STEP_FILES;

use super::in_time::InTime;
use super::positive::up_to;
use super::step_files::StepFiles;

/// The most seconds that a step is shown: a GIF counts hundredths in 16 bits.
const MOST_SECONDS: f64 = 600.0;

/// Options of a figure in steps.
#[derive(Args)]
pub(crate) struct StepOptions {
    /// Draw each figure in the steps of its algorithm: STEM.steps.EXT, one file with all of them, or with
    /// `--steps=files` and for formats of one picture a file a step, STEM.step-01.EXT
    #[arg(long, value_name = "FILES", num_args = 0..=1, require_equals = true, group = InTime::GROUP,
        default_missing_value = StepFiles::One.word(),
        value_parser = PossibleValuesParser::new(STEP_FILES))]
    steps: Option<String>,
    /// The steps of an SVG are fragments of reveal.js
    #[arg(long, requires = "steps", conflicts_with = "motion")]
    fragments: bool,
    /// Write what each step says below its picture, where no page tells it
    #[arg(long, requires = "steps", conflicts_with = "motion")]
    pub(crate) words: bool,
    /// Seconds that an animation shows each step, or the end of a motion; default: as long as the step's
    /// sentence takes to read, 2 for a motion
    #[arg(long, requires = InTime::GROUP, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) hold: Option<f64>,
}

/// Seconds as written on the command line.
fn seconds(text: &str) -> Result<f64, String> {
    up_to(MOST_SECONDS, text)
}

impl StepOptions {
    /// What the command line says of the files; none where it does not ask for steps.
    pub(crate) fn files(&self) -> Option<StepFiles> {
        self.steps.as_deref().and_then(StepFiles::of_word)
    }

    /// How a file of a format is written of a figure in steps; none for a file that shows one picture.
    pub(crate) fn in_one(&self, in_time: Option<InTime>, format: &Format) -> Option<InSteps> {
        let all = InSteps { fragments: self.fragments, words: self.words, hold: self.hold };
        let is_one = |files: StepFiles| !files.are_apart(format);
        matches!(in_time, Some(InTime::Steps(files)) if is_one(files)).then_some(all)
    }
}
