//! How much a figure may show, so that no scene, however it was made, takes seconds or gigabytes to draw.
//!
//! Each limit is far above what a reader can tell apart on a page, and its doc says which cost it holds down. A scene
//! within [`crate::scene::limits`] can still ask for 200 layers of 4,096 corners in each of 32 panels: what it asks for
//! is known only once its layers have drawn.

use std::ops::Range;
use std::sync::Arc;

use crate::scene::{Fault, Problem};
use crate::typeset::Line;

use super::label::Anchor;
use super::plan::PanelPlan;
use super::sketch::{Request, Sketched};

/// Points of all lines of a figure; each takes some 300 bytes and 2 µs on its way into the files.
pub(super) const MAX_POINTS: usize = 250_000;
/// Labels of a panel: placing n of them compares their places some n³ times.
const MAX_LABELS: usize = 150;
/// Labels of a figure: one is held against those of the panels before.
const MAX_ALL_LABELS: usize = 600;
/// Pairs of a label and a piece of a line in its panel: each is measured at some fifty places.
const MAX_PAIRS: usize = 2_000_000;
/// Letters and signs of a figure; a formula of four takes 80 µs.
const MAX_GLYPHS: usize = 20_000;
/// Million page pixels of all areas: at twice the size, as images are, painting one takes 2 ms.
const MAX_MEGAPIXELS: f64 = 600.0;
/// An area with a pattern takes as long as so many without.
pub(super) const PATTERNED: f64 = 15.0;
/// Dashes count as points: the length of a dash and its gap, page pixels.
pub(super) const DASH: f64 = 5.0;
/// Bytes of all texts as the layers write them, which are counted before they are set.
const MAX_TEXT_BYTES: usize = 60_000;
/// The points of an area that a label may stand in are looked at ten times as often as those of other lines.
const INSIDE: usize = 10;

/// What a figure shows so far.
#[derive(Default)]
pub(super) struct Budget {
    labels: usize,
    pairs: usize,
    glyphs: usize,
    bytes: usize,
}

impl Budget {
    /// Counts what a panel's layers asked for.
    ///
    /// # Errors
    /// The limit that it goes beyond.
    pub(super) fn take(&mut self, panel: &PanelPlan, sketched: &Sketched) -> Result<(), Problem> {
        let (labels, lines) = (sketched.requests.len(), sketched.obstacles.len());
        self.labels += labels;
        self.pairs += labels * lines + INSIDE * sketched.requests.iter().map(points_of).sum::<usize>();
        let at = &panel.source.span;
        self.bytes += sketched.requests.iter().flat_map(|r| &r.label.lines).map(String::len).sum::<usize>();
        within("the texts of the figure", "bytes", self.bytes, MAX_TEXT_BYTES, at)?;
        within("the labels of the panel", "labels", labels, MAX_LABELS, at)?;
        within("the labels of the figure", "labels", self.labels, MAX_ALL_LABELS, at)?;
        within("the labels among the lines", "pairs", self.pairs, MAX_PAIRS, at)
    }

    /// Counts the letters of a text.
    ///
    /// # Errors
    /// When they are too many.
    pub(super) fn letters(&mut self, lines: &[Arc<Line>], at: &Range<usize>) -> Result<(), Problem> {
        self.glyphs += lines.iter().map(|line| line.glyphs.len()).sum::<usize>();
        within("the texts of the figure", "letters", self.glyphs, MAX_GLYPHS, at)
    }
}

/// # Errors
/// When all areas together, in million page pixels, are more than can be painted.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "saturates; only for the message"
)]
pub(super) fn areas_within(painted: f64, at: &Range<usize>) -> Result<(), Problem> {
    if painted <= MAX_MEGAPIXELS {
        return Ok(());
    }
    within("the areas of the figure", "megapixels", painted.ceil() as usize, MAX_MEGAPIXELS as usize, at)
}

/// The points of the area that a label may stand in.
fn points_of(request: &Request) -> usize {
    match &request.label.anchor {
        Anchor::Inside { area, avoid } => area.len() + avoid.iter().map(Vec::len).sum::<usize>(),
        _ => 0,
    }
}

/// # Errors
/// When there are more than the limit.
pub(super) fn within(
    what: &str,
    unit: &'static str,
    got: usize,
    limit: usize,
    at: &Range<usize>,
) -> Result<(), Problem> {
    if got <= limit {
        return Ok(());
    }
    Err(Problem::new(Fault::OverLimit { what: what.to_owned(), limit, unit, got }, at.clone()))
}
