//! What became of a stream of scenes, counted so that the counts of its shards add up to those of the whole.
//!
//! ```text
//! checksum = Σ h(line) mod 2⁴⁰        h: FNV-1a of 64 bits of a reply, its upper 40
//! ```
//!
//! A sum takes the replies in any order, and one below 2⁴⁰ stays exact in the numbers of JSON: those of 8,192
//! shards can be added before the remainder is taken. The number of a refused line is left out of its reply,
//! as it counts from the beginning of whatever shard the line is in.
//!
//! Source: Fowler, Noll and Vo, *The FNV Non-Cryptographic Hash Algorithm*, RFC 9923, 2025.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use tracefig::scene::Reply;

/// Bits of the checksum.
const BITS: u32 = 40;

/// Counts of replies, and their checksum.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Tally {
    /// Scenes answered, by the kind of their query and its outcome.
    answers: BTreeMap<String, u64>,
    /// Lines refused, by the code of their first error.
    errors: BTreeMap<String, u64>,
    /// The sum of the hashes, modulo 2⁶⁴.
    sum: u64,
}

impl Tally {
    /// Counts a reply.
    pub(crate) fn count(&mut self, reply: &Reply) {
        let counts = if reply.solved { &mut self.answers } else { &mut self.errors };
        match counts.get_mut(&reply.outcome) {
            Some(count) => *count += 1,
            None => {
                counts.insert(reply.outcome.clone(), 1);
            }
        }
        self.sum = self.sum.wrapping_add(hash(&reply.numberless()) >> (u64::BITS - BITS));
    }

    /// Counts what another tally counted.
    pub(crate) fn add(&mut self, other: Self) {
        for (counts, more) in [(&mut self.answers, other.answers), (&mut self.errors, other.errors)] {
            for (outcome, count) in more {
                *counts.entry(outcome).or_default() += count;
            }
        }
        self.sum = self.sum.wrapping_add(other.sum);
    }

    /// Whether a line was refused.
    pub(crate) fn has_errors(&self) -> bool {
        !self.errors.is_empty()
    }

    /// The tally as JSON, in the order of the words.
    pub(crate) fn json(&self) -> Value {
        let total = |counts: &BTreeMap<String, u64>| counts.values().sum::<u64>();
        let (answered, refused) = (total(&self.answers), total(&self.errors));
        json!({
            "tracefig_summary": 1,
            "lines": answered + refused,
            "answered": answered,
            "refused": refused,
            "answers": self.answers,
            "errors": self.errors,
            "checksum": self.sum & ((1 << BITS) - 1),
        })
    }
}

/// FNV-1a of 64 bits.
fn hash(text: &str) -> u64 {
    const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    text.bytes().fold(BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_the_source() {
        // RFC 9923, appendix C: of nothing, of "a" and of "foobar".
        assert_eq!(hash(""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(hash("a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(hash("foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn shards_add_up_in_any_order() {
        let replies: Vec<Reply> = (1..50)
            .map(|k| {
                let text = match k % 3 {
                    0 => "no json".to_owned(),
                    radius => json!({
                        "id": k,
                        "shapes": { "a": { "kind": "circle", "radius": radius } },
                        "query": { "kind": "bounds", "of": ["a"] },
                    })
                    .to_string(),
                };
                tracefig::scene::solve_jsonl_line(&text, k)
            })
            .collect();
        let tally = |replies: &mut dyn Iterator<Item = &Reply>| {
            let mut tally = Tally::default();
            replies.for_each(|reply| tally.count(reply));
            tally
        };
        let whole = tally(&mut replies.iter());
        let mut sum = tally(&mut replies.iter().rev().step_by(2));
        sum.add(tally(&mut replies.iter().rev().skip(1).step_by(2)));
        assert_eq!(sum, whole);
        assert_eq!(whole.json()["answers"], json!({ "bounds": 33 }));
        assert_eq!(whole.json()["errors"], json!({ "syntax": 16 }));
        let other = tally(&mut replies[1..].iter());
        assert_ne!(other.json()["checksum"], whole.json()["checksum"]);
    }
}
