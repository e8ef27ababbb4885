//! Steps to rows of pixels, a band at a time.

use super::blend::{self, Mixer};
use super::coverage::{self, Cells, Span};
use super::edges::{Band, Edge};
use super::steps::{Part, Recorder, Step};

/// A pixel: red, green, blue, 255.
pub(crate) type Pixel = [u8; 4];

/// An area whose coverage is kept, in one band.
struct Kept {
    step: usize,
    /// The coverage of each row from the band's top.
    rows: Vec<Vec<Span>>,
}

/// A band being painted.
struct Painter<'s> {
    steps: &'s [Step],
    width: usize,
    /// Its first row in the image.
    top: usize,
    /// Its rows, after the last row of the band above.
    pixels: Vec<Pixel>,
    cells: Cells,
    kept: Vec<Kept>,
    /// What was there before each see-through group that has begun.
    saved: Vec<Vec<Pixel>>,
    /// Memory that is used again.
    spans: Vec<Span>,
    cut: Vec<Span>,
}

/// Paints what was recorded over a background, and hands every row from the top to `each`, after the row above it; above
/// the first one is the background.
pub(super) fn rows(
    recorder: Recorder,
    (width, height): (usize, usize),
    background: Pixel,
    mut each: impl FnMut(&[Pixel], &[Pixel]),
) {
    let Recorder { steps, bands, .. } = recorder;
    let rows = bands.rows();
    let mut painter = Painter {
        steps: &steps,
        width,
        top: 0,
        pixels: vec![background; (rows + 1) * width],
        cells: Cells::new(width, rows),
        kept: Vec::new(),
        saved: Vec::new(),
        spans: Vec::new(),
        cut: Vec::new(),
    };
    for band in bands.into_bands() {
        painter.band(&band, background);
        let count = rows.min(height - painter.top);
        for y in 0..count {
            let (above, row) = painter.pixels[y * width..(y + 2) * width].split_at(width);
            each(above, row);
        }
        painter.pixels.copy_within(count * width.., 0);
        painter.top += count;
    }
}

impl Painter<'_> {
    fn band(&mut self, band: &Band, background: Pixel) {
        self.pixels[self.width..].fill(background);
        self.kept.clear();
        for (step, edges) in band.steps() {
            match &self.steps[step] {
                Step::Lay { ink, within } => {
                    let mut mixer = Mixer::new(*ink);
                    self.area(edges, *within, |row, spans, _| mixer.lay(row, spans));
                }
                Step::Keep { within } => {
                    let mut rows = vec![Vec::new(); self.pixels.len() / self.width - 1];
                    self.area(edges, *within, |_, spans, y| rows[y].extend_from_slice(spans));
                    self.kept.push(Kept { step, rows });
                }
                Step::Save(part) => {
                    let before = self.rows_of(part).flat_map(|range| &self.pixels[range]).copied().collect();
                    self.saved.push(before);
                }
                Step::Fade { part, opacity } => self.fade(part, *opacity),
            }
        }
    }

    /// Finds the coverage of an area row by row, and hands it to `each` with the row's pixels and its number in the band.
    fn area(
        &mut self,
        edges: &[Edge],
        within: Option<usize>,
        mut each: impl FnMut(&mut [Pixel], &[Span], usize),
    ) {
        let Self { width, top, pixels, cells, kept, spans, cut, .. } = self;
        // What keeps a coverage has no edges in a band that it covers nothing of.
        let kept = within.map(|step| kept.iter().find(|kept| kept.step == step));
        let reach = cells.add(edges, *top);
        for y in reach.rows.clone() {
            cells.take_row(y, &reach, spans);
            let visible = match kept {
                None => &*spans,
                Some(None) => continue,
                Some(Some(area)) => {
                    coverage::intersection(spans, &area.rows[y], cut);
                    &*cut
                }
            };
            each(&mut pixels[(y + 1) * *width..(y + 2) * *width], visible, y);
        }
    }

    fn fade(&mut self, part: &Part, opacity: f64) {
        let Some(before) = self.saved.pop() else { return };
        let ranges: Vec<_> = self.rows_of(part).collect();
        for (range, before) in ranges.into_iter().zip(before.chunks_exact(part.columns.len())) {
            blend::fade(&mut self.pixels[range], before, opacity);
        }
    }

    /// Where a part's rows lie in this band's pixels.
    fn rows_of(&self, part: &Part) -> impl Iterator<Item = std::ops::Range<usize>> + use<> {
        let (top, width) = (self.top, self.width);
        let end = top + self.pixels.len() / width - 1;
        let columns = part.columns.clone();
        (part.rows.start.max(top)..part.rows.end.min(end)).map(move |y| {
            let row = (y - top + 1) * width;
            row + columns.start..row + columns.end
        })
    }
}
