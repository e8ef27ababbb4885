//! An image as what changes from row to row.
//!
//! Most pixels of a drawing equal the one above, so an image that comes row by row is kept as the spans that
//! differ: a twentieth of its pixels or less. Colours are looked for in these spans alone, and when the image
//! is written, its rows are made whole again one at a time.

use std::io::{self, Write};

use crate::output::raster::Pixel;

/// How many equal pixels end a span.
///
/// From 1 to 16 the article's eight figures take the same time within 3 %, and have the same bytes: few
/// pixels cost as much inside a span as the start of another.
const GAP: usize = 4;

/// How many pixels are compared at once where nothing is expected to differ.
const STRIDE: usize = 16;

/// Neighbouring pixels of a row that differ from those above.
#[derive(Clone, Copy)]
struct Span {
    /// Number of the row, from the top.
    row: u32,
    /// Number of the first pixel in the row.
    start: u32,
    /// Number of the pixel after the last.
    end: u32,
}

/// An image that says of each row where it differs from the one above.
pub(super) struct Changes {
    /// Pixels a row.
    pub(super) width: u32,
    /// Rows so far.
    pub(super) height: u32,
    /// The colour that all pixels above the first row have.
    pub(super) above: Pixel,
    /// Where rows differ, from the top, and from left to right.
    spans: Vec<Span>,
    /// The new pixels of all spans, one after the other.
    pub(super) pixels: Vec<Pixel>,
}

impl Changes {
    /// An image without rows.
    pub(super) fn new(width: u32, above: Pixel) -> Self {
        Self { width, height: 0, above, spans: Vec::new(), pixels: Vec::new() }
    }

    /// Adds a row, given the one above.
    #[expect(clippy::cast_possible_truncation, reason = "an image has at most 2^26 pixels")]
    pub(super) fn row(&mut self, above: &[Pixel], row: &[Pixel]) {
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

    /// Writes every row whole, from the top, given the bytes of the new pixels.
    ///
    /// `above` is the bytes of the colour above the first row; they say how many a pixel has.
    pub(super) fn write_rows(&self, above: &[u8], new: &[u8], out: &mut impl Write) -> io::Result<()> {
        let unit = above.len();
        let mut row = above.repeat(self.width as usize);
        let mut new = new;
        let mut spans = self.spans.iter().peekable();
        for y in 0..self.height {
            while let Some(span) = spans.next_if(|span| span.row == y) {
                let changed = &mut row[span.start as usize * unit..span.end as usize * unit];
                let (these, later) = new.split_at(changed.len());
                changed.copy_from_slice(these);
                new = later;
            }
            out.write_all(&row)?;
        }
        Ok(())
    }
}

/// The first pixel from one on that differs from the pixel above.
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
