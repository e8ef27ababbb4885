//! Streams of a PDF, compressed: repetitions by a table of where each four bytes stood last.
//!
//! Content says the same operators and numbers again and again, so the last place where four bytes stood is a good one to
//! copy from (L. P. Deutsch, *DEFLATE Compressed Data Format Specification*, RFC 1951, section 4, with chains of one).

use super::super::png::deflate::{FARTHEST, Tokens};

/// Bits of a place in the table.
const TABLE_BITS: u32 = 14;

/// Bytes that must repeat before a copy is looked for.
const FEWEST: usize = 4;

/// The bytes, of which there must be some, as a zlib stream.
pub(super) fn compress(bytes: &[u8]) -> Vec<u8> {
    let mut last = vec![usize::MAX; 1 << TABLE_BITS];
    let (mut tokens, mut at) = (Tokens::new(), 0);
    while let Some(&byte) = bytes.get(at) {
        let length = repeated(bytes, at, &mut last);
        if let Some((length, distance)) = length {
            tokens.copy(length, distance);
            // The places inside the copy can be copied from, too.
            for inside in at + 1..at + length {
                let _ = note(bytes, inside, &mut last);
            }
            at += length;
        } else {
            tokens.literal(byte);
            at += 1;
        }
    }
    let mut adler = simd_adler32::Adler32::new();
    adler.write(bytes);
    let mut out = Vec::new();
    tokens.zlib(adler.finish(), &mut out);
    out
}

/// Length and distance of what stands at a place and stood before, if that is worth a copy.
fn repeated(bytes: &[u8], at: usize, last: &mut [usize]) -> Option<(usize, usize)> {
    let before = note(bytes, at, last)?;
    if at - before > FARTHEST {
        return None;
    }
    let same = bytes[before..].iter().zip(&bytes[at..]).take_while(|(a, b)| a == b).count();
    (same >= FEWEST).then_some((same, at - before))
}

/// Where the four bytes at a place, or others with their hash, stood last; they stand here from now on.
fn note(bytes: &[u8], at: usize, last: &mut [usize]) -> Option<usize> {
    let four = bytes.get(at..at + FEWEST)?.try_into().ok()?;
    // Knuth's multiplicative hash: 2³² over the golden ratio.
    let place = (u32::from_le_bytes(four).wrapping_mul(0x9E37_79B1) >> (32 - TABLE_BITS)) as usize;
    let before = std::mem::replace(last.get_mut(place)?, at);
    (before < at).then_some(before)
}

#[cfg(test)]
mod tests {
    use super::compress;

    #[test]
    fn what_was_compressed_comes_back() {
        let lines: Vec<String> = (0..400).map(|i| format!("{}.5 {} l\n", i * i % 977, i)).collect();
        let lines = lines.concat();
        let long = "0 ".repeat(40_000);
        for text in ["a", "abcabcabcabc", &lines, &long] {
            let packed = compress(text.as_bytes());
            assert_eq!(fdeflate::decompress_to_vec(&packed).unwrap(), text.as_bytes());
        }
        assert!(compress(lines.as_bytes()).len() < lines.len() / 2);
        assert!(compress(long.as_bytes()).len() < 300);
    }
}
