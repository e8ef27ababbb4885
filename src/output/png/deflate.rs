//! Deflate (RFC 1951) of tokens that the caller has found, with codes made for them.
//!
//! A general compressor spends its time on looking for repetitions; who knows an image knows where they are.
//! So this one takes literals and copies, counts them, and writes them in one block with codes of their own.

use super::huffman;

/// Longest copy.
pub(super) const LONGEST: usize = 258;

/// Farthest distance of a copy.
pub(in crate::output) const FARTHEST: usize = 32_768;

/// Marks a token as a copy: then bits 15 – 23 are its length and bits 0 – 14 its distance less 1.
const COPY: u32 = 1 << 31;

/// Symbol of the end of a block.
const END: usize = 256;

/// Least length of each length symbol from 257 on, and the count of its extra bits.
const LENGTHS: [(u16, u8); 29] = [
    (3, 0),
    (4, 0),
    (5, 0),
    (6, 0),
    (7, 0),
    (8, 0),
    (9, 0),
    (10, 0),
    (11, 1),
    (13, 1),
    (15, 1),
    (17, 1),
    (19, 2),
    (23, 2),
    (27, 2),
    (31, 2),
    (35, 3),
    (43, 3),
    (51, 3),
    (59, 3),
    (67, 4),
    (83, 4),
    (99, 4),
    (115, 4),
    (131, 5),
    (163, 5),
    (195, 5),
    (227, 5),
    (258, 0),
];

/// Order in which the lengths of the codes for code lengths are written.
const ORDER: [usize; 19] = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

/// Literals and copies, counted.
pub(in crate::output) struct Tokens {
    list: Vec<u32>,
    literals: [u32; 286],
    distances: [u32; 30],
    /// Length symbol less 257 of each length from 3 on.
    length_symbol: [u8; LONGEST + 1],
}

impl Tokens {
    pub(in crate::output) fn new() -> Self {
        let mut length_symbol = [0; LONGEST + 1];
        for (symbol, &(least, _)) in (0_u8..).zip(&LENGTHS) {
            length_symbol[usize::from(least)..].fill(symbol);
        }
        Self { list: Vec::with_capacity(1 << 15), literals: [0; 286], distances: [0; 30], length_symbol }
    }

    /// A byte as it is.
    #[inline]
    pub(in crate::output) fn literal(&mut self, byte: u8) {
        self.list.push(u32::from(byte));
        self.literals[usize::from(byte)] += 1;
    }

    /// A copy of `length` bytes from `distance` bytes before; split where it is longer than a copy may be.
    ///
    /// A remainder of one or two bytes can't be a copy, so the one before it is cut short.
    #[inline]
    pub(in crate::output) fn copy(&mut self, mut length: usize, distance: usize) {
        while length > 0 {
            let piece = match length {
                0..=LONGEST => length,
                _ if length < LONGEST + 3 => length - 3,
                _ => LONGEST,
            };
            self.one_copy(piece, distance);
            length -= piece;
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "lengths to 258 and distances to 32768")]
    fn one_copy(&mut self, length: usize, distance: usize) {
        self.list.push(COPY | (length as u32) << 15 | (distance - 1) as u32);
        self.literals[END + 1 + usize::from(self.length_symbol[length])] += 1;
        self.distances[distance_symbol(distance).0] += 1;
    }

    /// Appends a zlib stream (RFC 1950) whose bytes have the checksum `adler`.
    pub(in crate::output) fn zlib(mut self, adler: u32, out: &mut Vec<u8>) {
        // Deflate with a window of 32 KiB, fastest effort; the second byte makes the pair divisible by 31.
        out.extend_from_slice(&[0x78, 0x01]);
        self.literals[END] = 1;
        // A block without copies still has one code for distances.
        self.distances[0] = self.distances[0].max(1);
        let literal_lengths = huffman::lengths(&self.literals, 15);
        let distance_lengths = huffman::lengths(&self.distances, 15);
        let mut bits = Bits { out, held: 0, count: 0 };
        bits.push(0b101, 3); // the last block, with its own codes
        header(&mut bits, &literal_lengths, &distance_lengths);
        self.body(&mut bits, &literal_lengths, &distance_lengths);
        bits.finish();
        out.extend_from_slice(&adler.to_be_bytes());
    }

    fn body(&self, bits: &mut Bits, literal_lengths: &[u8], distance_lengths: &[u8]) {
        let literals: Vec<(u16, u8)> = table(literal_lengths);
        let distances: Vec<(u16, u8)> = table(distance_lengths);
        let push = |bits: &mut Bits, (code, length): (u16, u8)| bits.push(u32::from(code), u32::from(length));
        for &token in &self.list {
            if token & COPY == 0 {
                push(bits, literals[token as usize]);
                continue;
            }
            let (length, distance) = ((token >> 15 & 0x1FF) as usize, (token & 0x7FFF) as usize + 1);
            let symbol = usize::from(self.length_symbol[length]);
            push(bits, literals[END + 1 + symbol]);
            let (least, extra) = LENGTHS[symbol];
            bits.push((token >> 15 & 0x1FF) - u32::from(least), u32::from(extra));
            let (symbol, extra, rest) = distance_symbol(distance);
            push(bits, distances[symbol]);
            bits.push(rest, extra);
        }
        push(bits, literals[END]);
    }
}

fn table(lengths: &[u8]) -> Vec<(u16, u8)> {
    huffman::codes(lengths).into_iter().zip(lengths.iter().copied()).collect()
}

/// Symbol of a distance, the count of its extra bits, and these.
#[expect(clippy::cast_possible_truncation, reason = "distances to 32768")]
fn distance_symbol(distance: usize) -> (usize, u32, u32) {
    let d = distance as u32 - 1;
    if d < 4 {
        return (d as usize, 0, 0);
    }
    let extra = d.ilog2() - 1;
    let symbol = 2 * (extra + 1) + (d >> extra & 1);
    (symbol as usize, extra, d & ((1 << extra) - 1))
}

/// The lengths of both codes, themselves run-length and Huffman coded (RFC 1951, 3.2.7).
fn header(bits: &mut Bits, literal_lengths: &[u8], distance_lengths: &[u8]) {
    let used =
        |lengths: &[u8], least: usize| lengths.iter().rposition(|&l| l > 0).map_or(0, |i| i + 1).max(least);
    let (literals, distances) = (used(literal_lengths, 257), used(distance_lengths, 1));
    let all: Vec<u8> = [&literal_lengths[..literals], &distance_lengths[..distances]].concat();
    let runs = runs(&all);
    let mut weights = [0; 19];
    for &(symbol, _, _) in &runs {
        weights[usize::from(symbol)] += 1;
    }
    let lengths = huffman::lengths(&weights, 7);
    let table = table(&lengths);
    let count = ORDER.iter().rposition(|&s| lengths[s] > 0).map_or(4, |i| (i + 1).max(4));
    let size = |n: usize, less: usize| u32::try_from(n - less).unwrap_or(0);
    bits.push(size(literals, 257), 5);
    bits.push(size(distances, 1), 5);
    bits.push(size(count, 4), 4);
    for &symbol in &ORDER[..count] {
        bits.push(u32::from(lengths[symbol]), 3);
    }
    for (symbol, rest, extra) in runs {
        let (code, length) = table[usize::from(symbol)];
        bits.push(u32::from(code), u32::from(length));
        bits.push(rest, extra);
    }
}

/// Symbols of code lengths with their extra bits: a length, 16 for the last one again, 17 and 18 for zeros.
fn runs(lengths: &[u8]) -> Vec<(u8, u32, u32)> {
    let mut out = Vec::new();
    for run in lengths.chunk_by(|a, b| a == b) {
        let (length, mut left) = (run[0], u32::try_from(run.len()).unwrap_or(0));
        if length > 0 {
            out.push((length, 0, 0));
            left -= 1;
        }
        while left > 0 {
            let (symbol, least, most, extra) = match (length, left) {
                (_, 0..=2) => (length, 1, 1, 0),
                (0, 3..=10) => (17, 3, 10, 3),
                (0, _) => (18, 11, 138, 7),
                (_, _) => (16, 3, 6, 2),
            };
            let taken = left.min(most);
            out.push((symbol, taken - least, extra));
            left -= taken;
        }
    }
    out
}

/// Bits to bytes, the lowest first.
struct Bits<'o> {
    out: &'o mut Vec<u8>,
    held: u64,
    count: u32,
}

impl Bits<'_> {
    /// At most 16 bits.
    #[inline]
    fn push(&mut self, bits: u32, count: u32) {
        self.held |= u64::from(bits) << self.count;
        self.count += count;
        if self.count >= 32 {
            #[expect(clippy::cast_possible_truncation, reason = "the low half is meant")]
            self.out.extend_from_slice(&(self.held as u32).to_le_bytes());
            self.held >>= 32;
            self.count -= 32;
        }
    }

    fn finish(self) {
        let bytes = self.held.to_le_bytes();
        self.out.extend_from_slice(&bytes[..self.count.div_ceil(8) as usize]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What an independent decoder makes of the tokens.
    fn decoded(tokens: Tokens, expected: &[u8]) -> Vec<u8> {
        let mut out = Vec::new();
        tokens.zlib(simd_adler32::adler32(&expected), &mut out);
        fdeflate::decompress_to_vec(&out).unwrap()
    }

    #[test]
    fn literals_and_copies_of_every_length_come_back() {
        let mut tokens = Tokens::new();
        let mut expected: Vec<u8> = (0..=255).collect();
        for &byte in &expected {
            tokens.literal(byte);
        }
        for length in 3..700 {
            for distance in [1, 2, 3, 4, 5, 17, 250] {
                tokens.copy(length, distance);
                for _ in 0..length {
                    expected.push(expected[expected.len() - distance]);
                }
            }
        }
        for distance in [1000, 5761, 20_000, FARTHEST] {
            tokens.copy(LONGEST, distance);
            for _ in 0..LONGEST {
                expected.push(expected[expected.len() - distance]);
            }
        }
        assert!(decoded(tokens, &expected) == expected);
    }

    #[test]
    fn a_stream_without_copies_is_one_that_decoders_take() {
        let mut tokens = Tokens::new();
        for &byte in b"abc" {
            tokens.literal(byte);
        }
        assert_eq!(decoded(tokens, b"abc"), b"abc");
    }
}
