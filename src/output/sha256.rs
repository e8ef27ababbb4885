//! SHA-256 of a text (FIPS 180-4, sections 4.1.2, 5 and 6.2): by it a page's policy names the one script that
//! it runs.

/// Fractional bits of the cube roots of the first 64 primes.
const K: [u32; 64] = fractions(3);
/// Fractional bits of the square roots of the first 8 primes.
const H: [u32; 8] = fractions(2);

/// The first 32 fractional bits of the roots of the first primes.
const fn fractions<const N: usize>(root: u32) -> [u32; N] {
    let mut found = [0; N];
    let (mut count, mut prime) = (0, 2u128);
    while count < N {
        let mut divisor = 2;
        while divisor * divisor <= prime && !prime.is_multiple_of(divisor) {
            divisor += 1;
        }
        if divisor * divisor > prime {
            found[count] = fraction(prime, root);
            count += 1;
        }
        prime += 1;
    }
    found
}

/// The first 32 fractional bits of a root: of the whole root of the number times a power of 2³².
#[expect(clippy::cast_possible_truncation, reason = "the lower half is what is wanted")]
const fn fraction(number: u128, root: u32) -> u32 {
    let shifted = number << (32 * root);
    // A whole root of 38 bits, found bit by bit.
    let (mut found, mut bit) = (0u128, 1u128 << 37);
    while bit > 0 {
        let tried = found | bit;
        if tried.pow(root) <= shifted {
            found = tried;
        }
        bit >>= 1;
    }
    found as u32
}

/// The hash of bytes.
pub(super) fn sha256(bytes: &[u8]) -> [u8; 32] {
    let mut padded = bytes.to_vec();
    padded.push(0x80);
    padded.resize((padded.len() + 8).next_multiple_of(64) - 8, 0);
    padded.extend((bytes.len() as u64 * 8).to_be_bytes());
    let state = padded.chunks_exact(64).fold(H, compressed);
    let mut hash = [0; 32];
    for (four, word) in hash.chunks_exact_mut(4).zip(state) {
        four.copy_from_slice(&word.to_be_bytes());
    }
    hash
}

/// The state after a block.
fn compressed(state: [u32; 8], block: &[u8]) -> [u32; 8] {
    let mut w = [0u32; 64];
    for (word, four) in w.iter_mut().zip(block.chunks_exact(4)) {
        *word = four.iter().fold(0, |word, &byte| word << 8 | u32::from(byte));
    }
    for t in 16..64 {
        let (x, y) = (w[t - 15], w[t - 2]);
        let s0 = x.rotate_right(7) ^ x.rotate_right(18) ^ x >> 3;
        let s1 = y.rotate_right(17) ^ y.rotate_right(19) ^ y >> 10;
        w[t] = s1.wrapping_add(w[t - 7]).wrapping_add(s0).wrapping_add(w[t - 16]);
    }
    let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h] = state;
    for (k, w) in K.into_iter().zip(w) {
        let s1 = e.rotate_right(6) ^ e.rotate_right(11) ^ e.rotate_right(25);
        let t1 = h.wrapping_add(s1).wrapping_add(e & f ^ !e & g).wrapping_add(k).wrapping_add(w);
        let s0 = a.rotate_right(2) ^ a.rotate_right(13) ^ a.rotate_right(22);
        let t2 = s0.wrapping_add(a & b ^ a & c ^ b & c);
        (a, b, c, d, e, f, g, h) = (t1.wrapping_add(t2), a, b, c, d.wrapping_add(t1), e, f, g);
    }
    let worked = [a, b, c, d, e, f, g, h];
    std::array::from_fn(|i| state[i].wrapping_add(worked[i]))
}

#[cfg(test)]
mod tests {
    use super::sha256;

    fn hex(bytes: &[u8]) -> String {
        sha256(bytes)
            .iter()
            .flat_map(|byte| [byte >> 4, byte & 15])
            .map(|d| char::from(b"0123456789abcdef"[usize::from(d)]))
            .collect()
    }

    #[test]
    fn the_examples_of_the_standard_come_out() {
        assert_eq!(hex(b""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        assert_eq!(hex(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        let two_blocks = b"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
        assert_eq!(hex(two_blocks), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
        // A length that leaves no room for itself in its block.
        assert_eq!(hex(&[b'a'; 64]), "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
    }
}
