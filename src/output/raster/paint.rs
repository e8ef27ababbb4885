//! Steps to rows of pixels, a band of rows at a time.

use std::ops::Range;

use super::blend::{self, Mixer};
use super::coverage::{self, Filler, Part, Span};
use super::steps::Step;

/// A pixel: red, green, blue, 255.
pub(crate) type Pixel = [u8; 4];

/// Pixels of a band, about: a megabyte of colours and at most a quarter of it for a mask, which a
/// second-level cache holds. Measured on the article's figures; with a quarter as many, high areas are filled
/// in more pieces and rendering takes 3 % longer, with four times as many the cache is left and it takes 7 %
/// longer.
const BAND: usize = 1 << 18;

/// A band being painted.
struct Painter {
    /// Pixels a row.
    width: usize,
    /// Its rows in the image.
    rows: Range<usize>,
    /// Its rows, after the last row of the band above.
    pixels: Vec<Pixel>,
    /// What was there before each see-through group that has begun.
    saved: Vec<Vec<Pixel>>,
    /// Finds the coverage of areas.
    filler: Filler,
    /// Memory for the spans of one row.
    spans: Vec<Span>,
    /// Memory for the spans that a clip leaves of a row.
    inside: Vec<Span>,
}

/// Paints steps over a background, and hands every row from the top to `each`, after the row above it; above
/// the first one is the background.
pub(super) fn rows(
    steps: &[Step],
    (width, height): (usize, usize),
    background: Pixel,
    mut each: impl FnMut(&[Pixel], &[Pixel]),
) {
    let count = (BAND / width).clamp(1, height);
    let mut painter = Painter {
        width,
        rows: 0..count,
        pixels: vec![background; (count + 1) * width],
        saved: Vec::new(),
        filler: Filler::default(),
        spans: Vec::new(),
        inside: Vec::new(),
    };
    while !painter.rows.is_empty() {
        painter.pixels[width..].fill(background);
        for step in steps {
            painter.step(step);
        }
        for y in painter.rows.clone() {
            let at = painter.row(y) - width;
            let (above, row) = painter.pixels[at..at + 2 * width].split_at(width);
            each(above, row);
        }
        let last = painter.row(painter.rows.end - 1);
        painter.pixels.copy_within(last..last + width, 0);
        painter.rows = painter.rows.end..height.min(painter.rows.end + count);
    }
}

impl Painter {
    /// Where a row of the image begins in the pixels.
    fn row(&self, y: usize) -> usize {
        (y + 1 - self.rows.start) * self.width
    }

    /// What of a part lies in this band.
    fn seen(&self, part: &Part) -> Part {
        let rows = part.rows.start.max(self.rows.start)..part.rows.end.min(self.rows.end);
        Part { columns: part.columns.clone(), rows }
    }

    fn step(&mut self, step: &Step) {
        let part = self.seen(step.part());
        if part.is_empty() {
            return;
        }
        match step {
            Step::Lay { ink, area, clip, .. } => {
                let mut mixer = Mixer::new(*ink);
                let Self { width, rows, pixels, filler, spans, inside, .. } = self;
                area.rows(&part, filler, spans, |y, spans| {
                    let start = (y + 1 - rows.start) * *width;
                    let row = &mut pixels[start..start + *width];
                    let Some(clip) = clip else { return mixer.lay(row, spans) };
                    coverage::cut(spans, y, *clip, inside);
                    mixer.lay(row, inside);
                });
            }
            Step::Save(_) => {
                let before =
                    part.rows.clone().flat_map(|y| &self.pixels[self.range(y, &part)]).copied().collect();
                self.saved.push(before);
            }
            Step::Fade { opacity, .. } => {
                let Some(before) = self.saved.pop() else { return };
                for (y, before) in part.rows.clone().zip(before.chunks_exact(part.columns.len())) {
                    let range = self.range(y, &part);
                    blend::fade(&mut self.pixels[range], before, *opacity);
                }
            }
        }
    }

    /// Where a part's pixels of one row are.
    fn range(&self, y: usize, part: &Part) -> Range<usize> {
        let row = self.row(y);
        row + part.columns.start..row + part.columns.end
    }
}
