//! Prefix codes of least total length, no code longer than a limit.
//!
//! The tree is Huffman's (*A method for the construction of minimum-redundancy codes*, 1952), built from two queues as
//! the weights are sorted. Codes beyond the limit are cut to it, and the sum of 2^(−length) is brought back to 1 by
//! lengthening the longest codes below the limit; this is not optimal, but the limit is hardly ever met.

/// Length of the code of each symbol; 0 for a symbol that does not occur. A single symbol gets a code of one bit.
pub(super) fn lengths(weights: &[u32], limit: usize) -> Vec<u8> {
    let mut symbols: Vec<usize> = (0..weights.len()).filter(|&s| weights[s] > 0).collect();
    // The symbol breaks ties, so that the order does not depend on the sort.
    symbols.sort_unstable_by_key(|&s| (weights[s], s));
    let mut lengths = vec![0; weights.len()];
    if let [only] = symbols[..] {
        lengths[only] = 1;
    }
    if symbols.len() < 2 {
        return lengths;
    }
    let sorted: Vec<u64> = symbols.iter().map(|&s| u64::from(weights[s])).collect();
    let counts = limited(&counts(&depths(&sorted)), limit);
    // The rarest symbol has the longest code.
    let longest_first = (1..=limit).rev().flat_map(|length| std::iter::repeat_n(length, counts[length]));
    for (&symbol, length) in symbols.iter().zip(longest_first) {
        lengths[symbol] = u8::try_from(length).unwrap_or(u8::MAX);
    }
    lengths
}

/// Depth of each leaf of Huffman's tree over sorted weights.
fn depths(sorted: &[u64]) -> Vec<usize> {
    let n = sorted.len();
    let mut weight = sorted.to_vec();
    let mut parent = vec![0; 2 * n - 1];
    let (mut leaf, mut node) = (0, n);
    for next in n..2 * n - 1 {
        let mut take = || {
            let first = if leaf < n && (node >= next || weight[leaf] <= weight[node]) {
                &mut leaf
            } else {
                &mut node
            };
            let taken = *first;
            *first += 1;
            parent[taken] = next;
            weight[taken]
        };
        let sum = take() + take();
        weight.push(sum);
    }
    let mut depth = vec![0; 2 * n - 1];
    for i in (0..2 * n - 2).rev() {
        depth[i] = depth[parent[i]] + 1;
    }
    depth.truncate(n);
    depth
}

/// How many leaves have each depth.
fn counts(depths: &[usize]) -> Vec<usize> {
    let mut counts = vec![0; depths.iter().max().map_or(0, |d| d + 1)];
    for &depth in depths {
        counts[depth] += 1;
    }
    counts
}

/// The counts with nothing beyond the limit and 2^(−length) summing to 1.
fn limited(counts: &[usize], limit: usize) -> Vec<usize> {
    let mut limited: Vec<usize> = (0..=limit).map(|i| counts.get(i).copied().unwrap_or(0)).collect();
    limited[limit] += counts.iter().skip(limit + 1).sum::<usize>();
    let mut total: usize = (1..=limit).map(|i| limited[i] << (limit - i)).sum();
    while total > 1 << limit {
        // One code moves up from the limit to pair with the longest shorter one.
        limited[limit] -= 1;
        if let Some(i) = (1..limit).rev().find(|&i| limited[i] > 0) {
            limited[i] -= 1;
            limited[i + 1] += 2;
        }
        total -= 1;
    }
    limited
}

/// The code of each symbol for the lengths, its bits in the order in which deflate writes them (RFC 1951, 3.2.2).
pub(super) fn codes(lengths: &[u8]) -> Vec<u16> {
    let mut counts = [0_u32; 16];
    for &length in lengths.iter().filter(|&&length| length > 0) {
        counts[usize::from(length)] += 1;
    }
    let (mut first, mut code) = ([0_u32; 16], 0);
    for length in 1..16 {
        code = (code + counts[length - 1]) << 1;
        first[length] = code;
    }
    let mut assign = |&length: &u8| {
        if length == 0 {
            return 0;
        }
        let code = first[usize::from(length)];
        first[usize::from(length)] += 1;
        u16::try_from(code.reverse_bits() >> (32 - u32::from(length))).unwrap_or(0)
    };
    lengths.iter().map(&mut assign).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the sum of 2^(−length) is 1.
    fn complete(lengths: &[u8]) -> bool {
        lengths.iter().filter(|&&l| l > 0).map(|&l| 1_u32 << (16 - l)).sum::<u32>() == 1 << 16
    }

    #[test]
    fn frequent_symbols_have_short_codes_and_the_code_is_complete() {
        let lengths = lengths(&[45, 13, 12, 16, 9, 5, 0], 15);
        assert_eq!(lengths, [1, 3, 3, 3, 4, 4, 0]);
        assert!(complete(&lengths));
    }

    #[test]
    fn no_code_is_longer_than_the_limit() {
        // Fibonacci weights make the deepest tree.
        let mut weights = vec![1_u32, 1];
        while weights.len() < 30 {
            weights.push(weights[weights.len() - 1] + weights[weights.len() - 2]);
        }
        let lengths = lengths(&weights, 7);
        assert_eq!(lengths.iter().max(), Some(&7));
        assert!(complete(&lengths));
    }

    #[test]
    fn codes_are_those_of_the_standard_with_their_bits_reversed() {
        // The example of RFC 1951, 3.2.2: lengths 3, 3, 3, 3, 3, 2, 4, 4.
        let codes = codes(&[3, 3, 3, 3, 3, 2, 4, 4]);
        assert_eq!(codes, [0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111]);
    }
}
