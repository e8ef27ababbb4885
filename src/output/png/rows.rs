//! Rows of a drawing, filtered and cut into tokens.
//!
//! Most pixels of a drawing equal the one above. So each row is stored as its difference from the row above (the filter
//! *Up* of PNG), which is zero nearly everywhere, and zeros are one copy from the byte before. What differs lies in a few
//! spans a row; only these are looked at byte by byte, for a repetition of the pixel before (edges that are nearly level)
//! and for a piece that occurred in the last 32 KiB (slanted edges, that move but keep their pattern).

use simd_adler32::Adler32;

use super::deflate::{FARTHEST, LONGEST, Tokens};
use super::palette::Palette;

/// Bytes of the filter *Up* at the start of each row.
const UP: u8 = 2;

/// Equal pixels that end a span: fewer cost less inside it than as a gap.
const GAP: usize = 4;

/// Pixels compared at once where nothing is expected to differ.
const STRIDE: usize = 16;

/// Entries of the table of places by hash, a power of two.
const PLACES: usize = 1 << 13;

/// Pixels of a row that differ from those above.
#[derive(Clone, Copy)]
pub(super) struct Span {
    row: u32,
    start: u32,
    end: u32,
}

impl Span {
    /// Its pixels.
    pub(super) fn of(self, pixels: &[[u8; 4]], width: usize) -> &[[u8; 4]] {
        let row = self.row as usize * width;
        &pixels[row + self.start as usize..row + self.end as usize]
    }
}

/// All spans of an image from the top, whose rows have `width` pixels; above the first row is `above_all`.
#[expect(clippy::cast_possible_truncation, reason = "an image has at most 2^26 pixels")]
pub(super) fn spans(pixels: &[[u8; 4]], width: usize, above_all: [u8; 4]) -> Vec<Span> {
    let first = vec![above_all; width];
    let mut spans = Vec::new();
    let mut above = first.as_slice();
    for (y, row) in pixels.chunks_exact(width).enumerate() {
        let mut x = 0;
        while let Some(start) = next_difference(row, above, x) {
            let mut end = start + 1;
            // The span goes on while the next difference is near.
            loop {
                let near = (end + GAP).min(width);
                match (end..near).rev().find(|&i| row[i] != above[i]) {
                    Some(i) => end = i + 1,
                    None => break,
                }
            }
            spans.push(Span { row: y as u32, start: start as u32, end: end as u32 });
            x = end;
        }
        above = row;
    }
    spans
}

/// Makes the whole first row a span: above it, RGB has zeros.
pub(super) fn first_row_differs(spans: &mut Vec<Span>, width: u32) {
    let count = spans.iter().take_while(|span| span.row == 0).count();
    spans.splice(..count, [Span { row: 0, start: 0, end: width }]);
}

fn next_difference(row: &[[u8; 4]], above: &[[u8; 4]], from: usize) -> Option<usize> {
    let mut x = from;
    while x + STRIDE <= row.len() && row[x..x + STRIDE] == above[x..x + STRIDE] {
        x += STRIDE;
    }
    (x..row.len()).find(|&i| row[i] != above[i])
}

/// How a pixel becomes bytes.
pub(super) enum Depth<'p> {
    /// Red, green, blue.
    Rgb,
    /// A number in the palette.
    Indexed(&'p Palette),
}

impl Depth<'_> {
    fn bytes(&self) -> usize {
        match self {
            Self::Rgb => 3,
            Self::Indexed(_) => 1,
        }
    }
}

/// Tokens of the whole image and the checksum of the bytes that they stand for.
pub(super) fn tokens(pixels: &[[u8; 4]], width: usize, spans: &[Span], depth: &Depth) -> (Tokens, u32) {
    let unit = depth.bytes();
    let mut writer = Writer::new(unit, 1 + width * unit);
    let above_all = vec![[0; 4]; width];
    let mut above = above_all.as_slice();
    let mut spans = spans;
    for (y, row) in pixels.chunks_exact(width).enumerate() {
        let count = spans.iter().take_while(|span| span.row as usize == y).count();
        let (these, rest) = spans.split_at(count);
        spans = rest;
        writer.begin_row();
        for span in these {
            let range = span.start as usize..span.end as usize;
            let at = 1 + span.start as usize * unit;
            difference(&row[range.clone()], &above[range], depth, writer.row_from(at));
        }
        writer.row(these);
        above = row;
    }
    (writer.tokens, writer.adler.finish())
}

/// Writes what differs between pixels and those above, byte by byte.
fn difference(row: &[[u8; 4]], above: &[[u8; 4]], depth: &Depth, out: &mut [u8]) {
    match depth {
        Depth::Rgb => {
            for ((p, q), out) in row.iter().zip(above).zip(out.chunks_exact_mut(3)) {
                for channel in 0..3 {
                    out[channel] = p[channel].wrapping_sub(q[channel]);
                }
            }
        }
        Depth::Indexed(palette) => {
            for ((&p, &q), out) in row.iter().zip(above).zip(out) {
                *out = palette.index(p).wrapping_sub(palette.index(q));
            }
        }
    }
}

/// Cuts filtered rows into tokens.
struct Writer {
    /// Bytes a pixel.
    unit: usize,
    /// Bytes a row.
    stride: usize,
    /// The latest bytes: the row being cut, and [`FARTHEST`] before it at least.
    bytes: Vec<u8>,
    /// Bytes that were before those.
    dropped: usize,
    /// Where a hash last occurred, counted from the image's first byte, plus 1; 0 for nowhere.
    places: Vec<u32>,
    tokens: Tokens,
    adler: Adler32,
}

impl Writer {
    fn new(unit: usize, stride: usize) -> Self {
        let bytes = Vec::with_capacity(2 * FARTHEST + 2 * stride);
        let (tokens, adler) = (Tokens::new(), Adler32::new());
        Self { unit, stride, bytes, dropped: 0, places: vec![0; PLACES], tokens, adler }
    }

    /// Adds a row without differences.
    fn begin_row(&mut self) {
        if self.bytes.len() + self.stride > 2 * FARTHEST + 2 * self.stride {
            let old = self.bytes.len() - FARTHEST;
            self.bytes.copy_within(old.., 0);
            self.bytes.truncate(FARTHEST);
            self.dropped += old;
        }
        self.bytes.push(UP);
        self.bytes.resize(self.bytes.len() + self.stride - 1, 0);
    }

    /// The row's bytes from that one on.
    fn row_from(&mut self, at: usize) -> &mut [u8] {
        let start = self.bytes.len() - self.stride + at;
        &mut self.bytes[start..]
    }

    /// Cuts the row, that is zero outside the spans.
    fn row(&mut self, spans: &[Span]) {
        let start = self.bytes.len() - self.stride;
        self.adler.write(&self.bytes[start..]);
        self.tokens.literal(UP);
        let mut at = start + 1;
        for span in spans {
            let begin = start + 1 + span.start as usize * self.unit;
            self.zeros(at, begin);
            at = start + 1 + span.end as usize * self.unit;
            self.span(begin, at);
        }
        self.zeros(at, self.bytes.len());
    }

    fn zeros(&mut self, start: usize, end: usize) {
        let mut at = start;
        while at < end && (end - at < 3 || self.bytes[at - 1] != 0) {
            self.tokens.literal(0);
            at += 1;
        }
        if end > at {
            self.tokens.copy(end - at, 1);
        }
    }

    /// Cuts the bytes from `at` to `end`, whole pixels.
    fn span(&mut self, mut at: usize, end: usize) {
        let unit = self.unit;
        while at < end {
            let longest = end - at;
            let (length, distance) = self.copy_at(at, longest);
            if length > 0 {
                self.tokens.copy(length, distance);
                at += length;
                continue;
            }
            for i in at..at + unit {
                self.tokens.literal(self.bytes[i]);
            }
            at += unit;
        }
    }

    /// Length and distance of the best copy that begins at `at`; length 0 for none that is worth it.
    fn copy_at(&mut self, at: usize, longest: usize) -> (usize, usize) {
        let unit = self.unit;
        // Shorter copies cost as much as the literals.
        let shortest = if unit == 1 { 4 } else { 2 * unit };
        if longest < shortest {
            return (0, 0);
        }
        let again = if at >= unit { self.common(at, at - unit, longest) } else { 0 };
        let place = &mut self.places[hash(&self.bytes[at..at + shortest])];
        let absolute = self.dropped + at;
        let before = *place as usize;
        *place = u32::try_from(absolute + 1).unwrap_or(0);
        if again >= shortest {
            return (again, unit);
        }
        let distance = absolute + 1 - before.max(1);
        if before == 0 || distance > FARTHEST || distance > at {
            return (0, 0);
        }
        match self.common(at, at - distance, longest) {
            length if length >= shortest => (length, distance),
            _ => (0, 0),
        }
    }

    /// How many whole pixels' bytes agree at two places.
    fn common(&self, at: usize, before: usize, longest: usize) -> usize {
        let longest = longest.min(LONGEST - LONGEST % self.unit);
        let (new, old) = (&self.bytes[at..at + longest], &self.bytes[before..before + longest]);
        let length = new.iter().zip(old).take_while(|(a, b)| a == b).count();
        length - length % self.unit
    }
}

/// A place in the table for some bytes: Fibonacci hashing (Knuth, *The Art of Computer Programming* 3, 6.4).
fn hash(bytes: &[u8]) -> usize {
    let mut key = 0_u64;
    for &byte in bytes {
        key = key << 8 | u64::from(byte);
    }
    let mixed = key.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    #[expect(clippy::cast_possible_truncation, reason = "13 bits")]
    {
        (mixed >> (64 - PLACES.ilog2())) as usize
    }
}
