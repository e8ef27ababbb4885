//! Counts what the panels of a figure ask for against [`limits`](super::limits).

use std::ops::Range;
use std::sync::Arc;

use crate::scene::Problem;
use crate::typeset::Line;

use super::limits::{INSIDE, MAX_ALL_LABELS, MAX_GLYPHS, MAX_LABELS, MAX_PAIRS, MAX_TEXT_BYTES, within};
use super::sketch::{Anchor, Sketched};

/// What the panels so far asked for.
#[derive(Default)]
pub(crate) struct Budget {
    /// Labels of all panels.
    labels: usize,
    /// Pairs of a label and an obstacle of its panel.
    pairs: usize,
    /// Letters and signs, set.
    glyphs: usize,
    /// Bytes of markup.
    bytes: usize,
}

impl Budget {
    /// Counts what a panel's layers asked for; `at` is the panel's place in the scene.
    ///
    /// # Errors
    /// The limit that it goes beyond.
    pub(crate) fn take(&mut self, sketched: &Sketched, at: &Range<usize>) -> Result<(), Problem> {
        let (labels, lines) = (sketched.requests.len(), sketched.obstacles.len());
        self.labels += labels;
        // A name looks for the remotest place from all areas.
        let areas = sketched.requests.iter().map(|r| &r.label.anchor).chain(&sketched.unnamed).map(points_of);
        let names = sketched.requests.iter().filter(|r| points_of(&r.label.anchor) > 0).count();
        self.pairs += labels * lines + INSIDE * names * areas.sum::<usize>();
        self.bytes += sketched.requests.iter().flat_map(|r| &r.label.lines).map(String::len).sum::<usize>();
        within("the texts of the figure", "bytes", self.bytes, MAX_TEXT_BYTES, at)?;
        within("the labels of the panel", "labels", labels, MAX_LABELS, at)?;
        within("the labels of the figure", "labels", self.labels, MAX_ALL_LABELS, at)?;
        within("the labels among the lines", "pairs", self.pairs, MAX_PAIRS, at)
    }

    /// Counts the letters of a text; `at` is its place in the scene.
    ///
    /// # Errors
    /// When they are too many.
    pub(crate) fn letters(&mut self, lines: &[Arc<Line>], at: &Range<usize>) -> Result<(), Problem> {
        self.glyphs += lines.iter().map(|line| line.glyphs.len()).sum::<usize>();
        within("the texts of the figure", "letters", self.glyphs, MAX_GLYPHS, at)
    }
}

/// The points of the area that a label may stand in or beside; 0 for a label of anything else.
fn points_of(anchor: &Anchor) -> usize {
    if let Anchor::Inside { area } | Anchor::Outline { area, .. } = anchor { area.len() } else { 0 }
}
