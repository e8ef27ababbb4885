//! How much of each pixel an area covers: what tiny-skia fills, read as spans.
//!
//! An area is filled into a mask, a byte a pixel, that is as large as the part of the image that is asked
//! for, and whose memory serves the next area again. A byte counts how many of the pixel's 4 × 4 samples are
//! inside by the non-zero rule. From left to right, pixels of one coverage are a [`Span`]: a row of a figure
//! has a few of them where it has a thousand pixels, and colours are laid on span by span.

use std::ops::Range;

use tiny_skia::{FillRule, IntSize, Mask, Path, Transform};

use crate::drawing::Clip;

/// Levels of coverage: as many as a pixel has samples, so that none is lost, and so few that an image has few
/// colours.
pub(super) const LEVELS: u32 = 16;

/// Neighbouring pixels of one row with one coverage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    /// The first pixel's column in the image.
    pub(super) start: u32,
    /// The column after the last pixel's.
    pub(super) end: u32,
    /// How much is covered, from 1 to [`LEVELS`].
    pub(super) level: u32,
}

/// A rectangle of whole pixels of the image.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Part {
    /// Pixels from the image's left edge.
    pub(super) columns: Range<usize>,
    /// Pixels from the image's top.
    pub(super) rows: Range<usize>,
}

impl Part {
    /// Whether it has no pixels.
    pub(super) fn is_empty(&self) -> bool {
        self.columns.is_empty() || self.rows.is_empty()
    }

    /// The smallest part that holds both; an empty one holds nothing.
    pub(super) fn union(self, other: &Self) -> Self {
        if self.is_empty() {
            return other.clone();
        }
        let both = |a: Range<usize>, b: &Range<usize>| a.start.min(b.start)..a.end.max(b.end);
        Self { columns: both(self.columns, &other.columns), rows: both(self.rows, &other.rows) }
    }
}

/// Fills areas, one after the other in the same memory.
#[derive(Default)]
pub(super) struct Filler {
    /// The bytes of the last mask.
    bytes: Vec<u8>,
    /// The spans of the last row.
    spans: Vec<Span>,
}

impl Filler {
    /// Fills several paths over each other, cuts them by the area of `within`, and hands the spans of each
    /// row that lies in `part` to `each`, with the row's place in the image.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        reason = "an image is narrower than 2^26"
    )]
    pub(super) fn fill(
        &mut self,
        paths: &[&Path],
        within: Option<&Path>,
        part: &Part,
        mut each: impl FnMut(usize, &[Span]),
    ) {
        let (width, height) = (part.columns.len(), part.rows.len());
        self.bytes.clear();
        self.bytes.resize(width * height, 0);
        let size = IntSize::from_wh(width as u32, height as u32);
        let mask = size.and_then(|size| Mask::from_vec(std::mem::take(&mut self.bytes), size));
        let Some(mut mask) = mask else { return };
        let to_mask = Transform::from_translate(-(part.columns.start as f32), -(part.rows.start as f32));
        for path in paths {
            mask.fill_path(path, FillRule::Winding, true, to_mask);
        }
        if let Some(within) = within {
            mask.intersect_path(within, FillRule::Winding, true, to_mask);
        }
        for (row, y) in mask.data().chunks_exact(width).zip(part.rows.clone()) {
            read(row, part.columns.start, &mut self.spans);
            each(y, &self.spans);
        }
        self.bytes = mask.take();
    }
}

/// Bytes of a mask that are compared at once.
const STRIDE: usize = 16;

/// The spans of a row of a mask whose first pixel has the column `left`.
#[expect(clippy::cast_possible_truncation, reason = "an image is narrower than 2^26")]
fn read(row: &[u8], left: usize, spans: &mut Vec<Span>) {
    spans.clear();
    let mut x = 0;
    while let Some(&byte) = row.get(x) {
        let start = x;
        x += 1;
        while row.get(x..x + STRIDE).is_some_and(|stride| stride == [byte; STRIDE]) {
            x += STRIDE;
        }
        while row.get(x) == Some(&byte) {
            x += 1;
        }
        push(spans, (left + start) as u32, (left + x) as u32, (u32::from(byte) * LEVELS + 127) / 255);
    }
}

#[inline]
fn push(spans: &mut Vec<Span>, start: u32, end: u32, level: u32) {
    if level == 0 || start >= end {
        return;
    }
    if let Some(last) = spans.last_mut()
        && (last.end, last.level) == (start, level)
    {
        last.end = end;
        return;
    }
    spans.push(Span { start, end, level });
}

/// Cuts the spans of row `y` by a clip, in image pixels, that may end inside a pixel: the product of both
/// coverages.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "columns and levels of an image")]
pub(super) fn cut(spans: &[Span], y: usize, clip: Clip, inside: &mut Vec<Span>) {
    inside.clear();
    let row = ClippedRow::of(y, clip);
    for span in spans {
        row.columns(|start, end| {
            let level = f64::from(span.level) * row.covered(start);
            let column = |x: f64| (x.max(0.0) as u32).clamp(span.start, span.end);
            push(inside, column(start), column(end), level.round() as u32);
        });
    }
}

/// Parts into which a row is cut where a corner is round: its coverage is then off by a hundredth or so.
const PARTS: u8 = 8;

/// What a clip leaves of a row of pixels.
struct ClippedRow {
    /// Where its parts begin and end, each with its share of the row's height.
    parts: [(f64, f64, f64); PARTS as usize],
    /// Its first column, the one after those that a left corner reaches, the first that a right one reaches,
    /// and the one after the last.
    columns: [f64; 4],
}

impl ClippedRow {
    #[expect(clippy::cast_precision_loss, reason = "an image is smaller than 2^26")]
    fn of(y: usize, clip: Clip) -> Self {
        let Clip { rect, radius } = clip;
        let top = y as f64;
        let is_round = top < rect.y0 + radius || top + 1.0 > rect.y1 - radius;
        let mut parts = [(0.0, rect.x0, rect.x1); PARTS as usize];
        if is_round {
            let height = 1.0 / f64::from(PARTS);
            for (part, i) in parts.iter_mut().zip(0..PARTS) {
                let from = top + f64::from(i) * height;
                let middle = from + 0.5 * height;
                let taken = clip.taken((middle - rect.y0).min(rect.y1 - middle).max(0.0));
                let share = (rect.y1.min(from + height) - rect.y0.max(from)).max(0.0);
                *part = (share, rect.x0 + taken, rect.x1 - taken);
            }
        } else {
            parts[0].0 = covered(top, rect.y0, rect.y1);
        }
        // A column that the clip ends in is covered in part; the first and the last may be one.
        let reach = if is_round { radius.ceil() } else { 0.0 };
        let (first, end) = (rect.x0.floor(), rect.x1.ceil());
        let left = (first + 1.0 + reach).min(end);
        Self { parts, columns: [first, left, (end - 1.0 - reach).max(left), end] }
    }

    /// Calls `lay` with the first column of each run that is covered alike, and the one after it.
    fn columns(&self, mut lay: impl FnMut(f64, f64)) {
        let [first, left, right, end] = self.columns;
        let mut next = first;
        while next < end {
            let after = if (left..right).contains(&next) { right } else { next + 1.0 };
            lay(next, after);
            next = after;
        }
    }

    /// How much of the pixel in the column that begins at `start` the clip leaves.
    fn covered(&self, start: f64) -> f64 {
        self.parts.iter().map(|&(share, low, high)| share * covered(start, low, high)).sum()
    }
}

/// How much of the pixel that begins at `start` lies between two places.
fn covered(start: f64, low: f64, high: f64) -> f64 {
    (high.min(start + 1.0) - low.max(start)).clamp(0.0, 1.0)
}
