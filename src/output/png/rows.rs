//! Rows of a drawing, filtered and cut into tokens.
//!
//! Most pixels of a drawing equal the one above. So each row is stored as its difference from the row above (the filter
//! *Up* of PNG), which is zero nearly everywhere, and zeros are one copy from the byte before. What differs lies in a few
//! spans a row ([`super::changes`]); only these are looked at byte by byte, for a repetition of the pixel before (edges that are nearly level)
//! and for a piece that occurred in the last 32 KiB (slanted edges, that move but keep their pattern).

use simd_adler32::Adler32;

use super::changes::{Changes, Span};
use super::deflate::{FARTHEST, LONGEST, Tokens};

/// Bytes of the filter *Up* at the start of each row.
const UP: u8 = 2;

/// Entries of the table of places by hash, a power of two.
const PLACES: usize = 1 << 13;

/// Tokens of the whole image, given the bytes of its changed pixels, `unit` a pixel, and the checksum of the bytes that the
/// tokens stand for. Above the first row are zeros.
pub(super) fn tokens(changes: &Changes, bytes: &[u8], unit: usize) -> (Tokens, u32) {
    let width = changes.width as usize;
    let mut writer = Writer::new(unit, 1 + width * unit);
    let mut above = vec![0; width * unit];
    let (mut spans, mut bytes) = (changes.spans.as_slice(), bytes);
    for y in 0..changes.height {
        let count = spans.iter().take_while(|span| span.row == y).count();
        let (these, rest) = spans.split_at(count);
        spans = rest;
        writer.begin_row();
        for span in these {
            let (new, later) = bytes.split_at(span.len() * unit);
            bytes = later;
            let start = span.start as usize * unit;
            let old = &mut above[start..start + new.len()];
            for ((out, new), old) in writer.row_from(1 + start).iter_mut().zip(new).zip(&*old) {
                *out = new.wrapping_sub(*old);
            }
            old.copy_from_slice(new);
        }
        writer.row(these);
    }
    (writer.tokens, writer.adler.finish())
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
