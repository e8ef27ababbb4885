//! How much a figure may show, so that no scene, however it was made, takes seconds or gigabytes to draw.
//!
//! Each limit is far above what a reader can tell apart on a page, and its doc says which cost it holds down.
//! A scene within [`crate::scene::limits`] can still ask for 200 layers of 4,096 vertices in each of 32
//! panels: what it asks for is known only once its layers have drawn.

use std::ops::Range;

use crate::scene::{Fault, Problem};

/// Points of all lines of a figure; each takes some 300 bytes and 2 µs on its way into the files.
pub(crate) const MAX_POINTS: usize = 250_000;
/// Labels of a panel: placing n of them compares their places some n³ times.
pub(crate) const MAX_LABELS: usize = 150;
/// Labels of a figure: one is held against those of the panels before.
pub(crate) const MAX_ALL_LABELS: usize = 600;
/// Pairs of a label and a piece of a line in its panel: each is measured at some fifty places.
pub(crate) const MAX_PAIRS: usize = 2_000_000;
/// Letters and signs of a figure; a formula of four takes 80 µs.
pub(crate) const MAX_GLYPHS: usize = 20_000;
/// Bytes of all texts as the layers write them, which are counted before they are set.
pub(crate) const MAX_TEXT_BYTES: usize = 60_000;
/// Pairs of vertices that all runs look at, at most, where the slowest algorithm looks at every pair: ten
/// runs of the largest shapes.
pub(crate) const MAX_RUNS: usize = 170_000_000;
/// Million page pixels of all areas: at twice the size, as images are, painting one takes 2 ms.
const MAX_MEGAPIXELS: f64 = 600.0;
/// How many plain areas one with a pattern counts as: painting a million page pixels of hatching takes 40 ms.
pub(crate) const PATTERNED: f64 = 20.0;
/// Length of line, in page pixels, that counts as one point where it is dashed: a dash and its gap.
pub(crate) const DASH: f64 = 5.0;
/// How many obstacles a point of an area counts as that a label may stand in: it is looked at ten times as
/// often.
pub(crate) const INSIDE: usize = 10;

/// Holds `got` of a countable thing to its limit.
///
/// # Errors
/// When there are more than the limit; `what` and `unit` name the thing in the message, `at` is its place in
/// the scene.
pub(crate) fn within(
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

/// Holds all areas of a figure, in million page pixels, to what can be painted.
///
/// # Errors
/// When they are more.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "saturates; only for the message"
)]
pub(crate) fn areas_within(painted: f64, at: &Range<usize>) -> Result<(), Problem> {
    if painted <= MAX_MEGAPIXELS {
        return Ok(());
    }
    within("the areas of the figure", "megapixels", painted.ceil() as usize, MAX_MEGAPIXELS as usize, at)
}

/// The whole part of a number, for counts.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and NaN is 0")]
pub(crate) fn whole(x: f64) -> usize {
    x as usize
}
