//! An image as what changes from row to row.
//!
//! Most pixels of a drawing equal the one above, so an image that comes row by row is kept as the spans that differ: a
//! twentieth of its pixels or less. That is all that the palette, the filter and the search for repetitions look at.

use crate::output::raster::Pixel;

/// Equal pixels that end a span: fewer cost less inside it than as a gap.
const GAP: usize = 4;

/// Pixels compared at once where nothing is expected to differ.
const STRIDE: usize = 16;

/// Pixels of a row that differ from those above.
#[derive(Clone, Copy)]
pub(super) struct Span {
    pub(super) row: u32,
    pub(super) start: u32,
    pub(super) end: u32,
}

impl Span {
    /// How many pixels it has.
    pub(super) fn len(self) -> usize {
        (self.end - self.start) as usize
    }
}

/// An image: above its first row all pixels have one colour, and each row says where it differs from the one above.
#[derive(Clone)]
pub(in crate::output) struct Changes {
    pub(super) width: u32,
    /// Rows so far.
    pub(super) height: u32,
    /// The colour above the first row.
    pub(super) above: Pixel,
    /// From the top, and from left to right.
    pub(super) spans: Vec<Span>,
    /// The new pixels of all spans, one after the other.
    pub(super) pixels: Vec<Pixel>,
}

impl Changes {
    /// No rows yet.
    pub(in crate::output) fn new(width: u32, above: Pixel) -> Self {
        Self { width, height: 0, above, spans: Vec::new(), pixels: Vec::new() }
    }

    /// Adds a row, given the one above.
    #[expect(clippy::cast_possible_truncation, reason = "an image has at most 2^26 pixels")]
    pub(in crate::output) fn row(&mut self, above: &[Pixel], row: &[Pixel]) {
        let mut x = 0;
        while let Some(start) = next_difference(row, above, x) {
            let mut end = start + 1;
            // The span goes on while the next difference is near.
            loop {
                let near = (end + GAP).min(row.len());
                match (end..near).rev().find(|&i| row[i] != above[i]) {
                    Some(i) => end = i + 1,
                    None => break,
                }
            }
            self.spans.push(Span { row: self.height, start: start as u32, end: end as u32 });
            self.pixels.extend_from_slice(&row[start..end]);
            x = end;
        }
        self.height += 1;
    }

    /// The same image with its first row as one span: where above it is not the background but nothing.
    pub(super) fn with_whole_first_row(mut self) -> Self {
        let count = self.spans.iter().take_while(|span| span.row == 0).count();
        let mut first = vec![self.above; self.width as usize];
        let mut at = 0;
        for span in self.spans.drain(..count) {
            let pixels = &self.pixels[at..at + span.len()];
            first[span.start as usize..span.end as usize].copy_from_slice(pixels);
            at += span.len();
        }
        self.pixels.splice(..at, first);
        self.spans.insert(0, Span { row: 0, start: 0, end: self.width });
        self
    }

    /// Every row whole, given the bytes of the changed pixels, `unit` a pixel; above the first row are zeros.
    pub(super) fn whole_rows(&self, bytes: &[u8], unit: usize) -> Vec<u8> {
        let stride = self.width as usize * unit;
        let (mut row, mut all) = (vec![0; stride], Vec::with_capacity(stride * self.height as usize));
        let (mut spans, mut bytes) = (self.spans.as_slice(), bytes);
        for y in 0..self.height {
            while let Some((span, rest)) = spans.split_first().filter(|(span, _)| span.row == y) {
                let (new, later) = bytes.split_at(span.len() * unit);
                row[span.start as usize * unit..span.end as usize * unit].copy_from_slice(new);
                (spans, bytes) = (rest, later);
            }
            all.extend_from_slice(&row);
        }
        all
    }
}

fn next_difference(row: &[Pixel], above: &[Pixel], from: usize) -> Option<usize> {
    let (rest, rest_above) = (&row[from..], &above[from..]);
    let (strides, _) = rest.as_chunks::<STRIDE>();
    let (strides_above, _) = rest_above.as_chunks::<STRIDE>();
    let mut same = 0;
    while same < strides.len() && equal(&strides[same], &strides_above[same]) {
        same += 1;
    }
    (from + same * STRIDE..row.len()).find(|&i| row[i] != above[i])
}

/// Whether two strides are equal, without a branch for each pixel.
#[inline]
fn equal(a: &[Pixel; STRIDE], b: &[Pixel; STRIDE]) -> bool {
    let (mut different, mut i) = (0, 0);
    while i < STRIDE {
        different |= u32::from_ne_bytes(a[i]) ^ u32::from_ne_bytes(b[i]);
        i += 1;
    }
    different == 0
}
