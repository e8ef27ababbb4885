//! How long an animation shows each step: as long as it takes to read what the step says, and to find it.

use crate::drawing::{Drawing, Step};

/// Seconds to find what is new in a picture.
const FIND: f64 = 1.2;
/// Seconds to read a word. Adults read some 240 words of plain text a minute (Brysbaert, *How many words do
/// we read per minute?*, 2019); numbers and names of edges take longer.
const WORD: f64 = 0.3;
/// The least and the most seconds of a step: below, it flashes by; above, a reader thinks that it is over.
const BOUNDS: [f64; 2] = [1.5, 15.0];

/// How the steps of a figure are written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InSteps {
    /// Whether the parts of an SVG are fragments of reveal.js.
    pub fragments: bool,
    /// Whether the drawing has the words of each step below it, as
    /// [`Plan::with_words_below`](crate::figure::Plan::with_words_below) writes them: that a file is another
    /// one by.
    pub words: bool,
    /// Seconds that an animation shows each step; none goes by the length of what a step says.
    pub hold: Option<f64>,
}

impl InSteps {
    /// What tells it apart in the key of a file.
    pub(super) fn key(self) -> String {
        let hold = self.hold.map_or_else(|| "read".to_owned(), |seconds| seconds.to_string());
        let words = if self.words { " words" } else { "" };
        format!(" steps fragments={} hold={hold}{words}", self.fragments)
    }
}

/// Milliseconds that each step is shown.
pub(super) fn holds(drawing: &Drawing, in_steps: InSteps) -> Vec<u32> {
    let seconds = |step: &Step| in_steps.hold.unwrap_or_else(|| reading(step));
    drawing.steps.iter().map(|step| milliseconds(seconds(step))).collect()
}

/// Seconds to see and read a step.
fn reading(step: &Step) -> f64 {
    let words = step.sentences.iter().flat_map(|sentence| sentence.split_whitespace()).count();
    let words = u32::try_from(words).map_or(f64::INFINITY, f64::from);
    (FIND + WORD * words).clamp(BOUNDS[0], BOUNDS[1])
}

/// Seconds in whole milliseconds.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and NaN is 0")]
fn milliseconds(seconds: f64) -> u32 {
    (1000.0 * seconds).round() as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::everything;

    #[test]
    fn a_long_sentence_is_shown_longer_and_none_for_ever() {
        let step = |words: usize| Step { title: String::new(), sentences: vec!["so ".repeat(words)] };
        let drawing = Drawing { steps: [0, 4, 10, 1000].map(step).to_vec(), ..everything() };
        assert_eq!(holds(&drawing, InSteps::default()), [1500, 2400, 4200, 15_000]);
        let fixed = InSteps { hold: Some(0.25), ..InSteps::default() };
        assert_eq!(holds(&drawing, fixed), [250; 4]);
    }
}
