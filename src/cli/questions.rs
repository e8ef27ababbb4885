//! Exercises as questions with a number for an answer: which scenes and variants, and what each says.

use std::path::{Path, PathBuf};

use clap::Args;
use tracefig::figure::exercise::{answer_in_words, asked, task_of, to_enter, way};
use tracefig::figure::{Fault, Plan, draw, plain, plan, plan_in};
use tracefig::output::{Numerical, OutputError};
use tracefig::scene::{Ink, Problem, Refused, Scene, SceneFile, Variant, visible};

use super::Status;
use super::console::Console;
use super::encoding::warn;
use super::failure::Failure;
use super::inputs::{Input, single};
use super::own_themes::OwnThemes;
use super::themes::ChosenTheme;
use super::variants::{Seeds, Unvaried, scene_of, varied};

/// Which exercises become questions.
#[derive(Args)]
pub(crate) struct Exercises {
    /// Scene files that are exercises; `-` is standard input
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Variants of the exercises by number, as 7 or 1..30: other bodies near the scene's own, whose answer
    /// has three digits at most; default: the bodies of the scene
    #[arg(long, value_delimiter = ',', value_name = "N|FROM..TO")]
    seed: Vec<Seeds>,
}

/// What questions go into.
pub(crate) trait Bank {
    /// Begins the questions of a scene.
    fn category(&mut self, name: &str);

    /// Adds a question.
    fn add(&mut self, question: &Numerical<'_>) -> Result<(), OutputError>;
}

impl Exercises {
    /// The scene files.
    pub(crate) fn scenes(&self) -> &[PathBuf] {
        &self.scenes
    }

    /// Fills a bank with the questions of all scenes, and tells what is wrong with any of them. A bank that
    /// lacks a scene would be taken for the whole, so it is not to be written unless all is done; but for a
    /// scene that has no variants, which nobody can mend and all others need not wait for.
    pub(crate) fn fill(&self, bank: &mut dyn Bank, console: &Console) -> Filled {
        let mut filled = Filled { is_whole: true, status: Status::Done };
        let mut messages = String::new();
        let mut unvaried = 0;
        for path in &self.scenes {
            let mut sheet = Sheet { bank: &mut *bank, ink: console.ink(), messages: &mut messages };
            let Err(failure) = sheet.scene(path, &self.seed) else { continue };
            filled.status = filled.status.max(failure.failure.status);
            messages.push_str(&failure.failure.message);
            unvaried += usize::from(failure.is_unvaried);
            filled.is_whole &= failure.is_unvaried;
        }
        filled.is_whole &= unvaried < self.scenes.len();
        if !messages.is_empty() {
            Console::message(&messages);
        }
        filled
    }
}

/// What came of filling a bank.
pub(crate) struct Filled {
    /// Whether it is to be written: it has the questions of every scene that can have some.
    pub(crate) is_whole: bool,
    /// How the command ends.
    pub(crate) status: Status,
}

/// Why a scene has no questions.
struct Unasked {
    /// What is to be told.
    failure: Failure,
    /// Whether it only has too few variants.
    is_unvaried: bool,
}

impl From<Failure> for Unasked {
    fn from(failure: Failure) -> Self {
        Self { failure, is_unvaried: false }
    }
}

/// The bank that is being filled, and what is to be said of it.
struct Sheet<'s> {
    /// The bank.
    bank: &'s mut dyn Bank,
    /// How messages look.
    ink: Ink,
    /// Warnings, ready to be shown.
    messages: &'s mut String,
}

impl Sheet<'_> {
    /// Adds the questions of a scene, or says what is wrong.
    fn scene(&mut self, path: &Path, seeds: &[Seeds]) -> Result<(), Unasked> {
        let (input, ink) = (single(path), self.ink);
        let file = input.open().map_err(|refused| Failure::of(&refused, ink))?;
        let refuse = |problems| Refused { source: file.source.clone(), problems }.render(ink);
        let told = |unvaried: Unvaried| Unasked {
            is_unvaried: matches!(unvaried, Unvaried::TooFew { .. }),
            failure: Failure::from(match unvaried {
                Unvaried::Wrong(problems) => refuse(problems),
                unvaried => unvaried.message(&visible(&file.source.name)),
            }),
        };
        let own = OwnThemes::default().of(&file, &input, ink).map_err(|none| Failure::from(none.message))?;
        let seeds = Seeds::all(seeds);
        let found = varied(&file, seeds.iter().flatten().copied().max()).map_err(told)?;
        for (i, seed) in seeds.into_iter().enumerate() {
            let other = seed.and_then(|seed| found.get(seed.checked_sub(1)?));
            let exercise = other.map_or(&file, |found| &found.file);
            let question = scene_of(exercise, Variant::Question).map_err(told)?.into_owned();
            let title = title(&question, &input);
            if i == 0 {
                self.bank.category(&title);
            }
            let name = seed.map_or(title.clone(), |seed| format!("{title} {seed:02}"));
            self.questions(&name, exercise, question, own.as_deref())?;
        }
        Ok(())
    }

    /// Adds a question for each value that an exercise asks for.
    fn questions(
        &mut self,
        name: &str,
        exercise: &SceneFile,
        mut question: Scene,
        theme: Option<&ChosenTheme>,
    ) -> Result<(), Failure> {
        let ink = self.ink;
        let refuse = |problems| Refused { source: exercise.source.clone(), problems }.render(ink);
        // What is asked stands above the figure; the figure itself has no blanks.
        question.exercise = None;
        let (asking, key) =
            (planned(&question, theme).map_err(refuse)?, planned(&exercise.scene, theme).map_err(refuse)?);
        let [figure, solved] = [&asking, &key].map(|plan| draw(plan, plan.theme, "figure"));
        warn(exercise, &figure.warnings, ink, self.messages);
        for number in &asked(&key) {
            let numerical = Numerical {
                name: format!("{name}: {}", number.name),
                asks: vec![task_of(&key, number), to_enter(&key, number)],
                figure: &figure.drawing,
                answer: number.value(),
                tolerance: number.tolerance(),
                told: vec![answer_in_words(&key, number)],
                way: way(&key),
                solved: &solved.drawing,
            };
            self.bank.add(&numerical).map_err(|error| cant_write(exercise, &error))?;
        }
        Ok(())
    }
}

/// What is drawn of a scene.
fn planned<'s>(scene: &'s Scene, theme: Option<&'s ChosenTheme>) -> Result<Plan<'s>, Vec<Problem<Fault>>> {
    theme.map_or_else(|| plan(scene), |own| plan_in(scene, &own.theme))
}

/// What a question is called, without any trace of its answer.
fn title(question: &Scene, input: &Input) -> String {
    let stem = || match input {
        Input::File(path) => path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        other => other.shown(),
    };
    question.title.as_ref().map_or_else(stem, |title| plain(&title.value))
}

/// The message of a figure that can't be written.
fn cant_write(file: &SceneFile, error: &OutputError) -> String {
    format!("error: can't write the figures of {}: {error}\n", visible(&file.source.name))
}
