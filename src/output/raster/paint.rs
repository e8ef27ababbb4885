//! Steps to rows of pixels, a band of rows at a time.

use std::ops::Range;

use super::blend::{self, Mixer};
use super::coverage::{self, Filler, Part, Span};
use super::steps::Step;

/// A pixel: red, green, blue, opacity, the colour not multiplied by it; black where nothing is.
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

/// The rows of an image, painted a band at a time.
pub(crate) struct Rows {
    /// What is painted.
    steps: Vec<Step>,
    /// What is below it.
    background: Pixel,
    /// Width and height of the image.
    size: (u32, u32),
    /// Rows of a band.
    count: usize,
    /// The band that the last row is in.
    painter: Painter,
    /// Number of the next row, from the top.
    next: usize,
}

impl Rows {
    /// Steps over a background; nothing is painted yet.
    pub(super) fn new(steps: Vec<Step>, size: (u32, u32), background: Pixel) -> Self {
        let (width, height) = (size.0 as usize, size.1 as usize);
        let count = (BAND / width).clamp(1, height);
        let painter = Painter {
            width,
            rows: 0..0,
            pixels: vec![background; (count + 1) * width],
            saved: Vec::new(),
            filler: Filler::default(),
            spans: Vec::new(),
            inside: Vec::new(),
        };
        Self { steps, background, size, count, painter, next: 0 }
    }

    /// Width and height of the image in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        self.size
    }

    /// What painting takes: pixels of all areas, and pieces of their outlines, each as often as it is looked
    /// at: once for each band that its area reaches into.
    pub(crate) fn work(&self) -> (usize, usize) {
        let (mut pixels, mut pieces) = (0_usize, 0_usize);
        for step in &self.steps {
            let part = step.part();
            let bands = part.rows.len().div_ceil(self.count) + 1;
            pixels = pixels.saturating_add(step.weight() * part.columns.len() * part.rows.len());
            pieces = pieces.saturating_add(bands.saturating_mul(step.pieces()));
        }
        (pixels, pieces)
    }

    /// The row above the next one, and the next one, from the top; above the first one is the background.
    pub(crate) fn next(&mut self) -> Option<(&[Pixel], &[Pixel])> {
        if self.next == self.size.1 as usize {
            return None;
        }
        if self.next == self.painter.rows.end {
            self.paint();
        }
        let (width, at) = (self.painter.width, self.painter.row(self.next) - self.painter.width);
        self.next += 1;
        Some(self.painter.pixels[at..at + 2 * width].split_at(width))
    }

    /// Paints the band that begins with the next row.
    fn paint(&mut self) {
        let Self { painter, steps, next, .. } = self;
        let width = painter.width;
        if !painter.rows.is_empty() {
            let last = painter.row(painter.rows.end - 1);
            painter.pixels.copy_within(last..last + width, 0);
        }
        painter.rows = *next..(*next + self.count).min(self.size.1 as usize);
        painter.pixels[width..].fill(self.background);
        for step in steps {
            painter.step(step);
        }
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
