//! A share of many scenes, so that several machines or jobs of an array share the work.

use std::str::FromStr;

/// A share of some items: every Nth of them, so that neighbours, which tend to be alike, are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Partition {
    /// Number of the share, from 1.
    share: usize,
    /// How many shares there are.
    of: usize,
}

impl FromStr for Partition {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parsed = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
        match parsed {
            Some((share, of)) if 1 <= share && share <= of => Ok(Self { share, of }),
            _ => Err("expected K/N with 1 ≤ K ≤ N, as 2/8".to_owned()),
        }
    }
}

impl Partition {
    /// The one share of all.
    pub(crate) const WHOLE: Self = Self { share: 1, of: 1 };

    /// Whether an item, counted from 1, is in the share.
    pub(crate) fn holds(self, number: usize) -> bool {
        number % self.of == self.share % self.of
    }

    /// The items of the share.
    pub(crate) fn of_all<T>(self, items: Vec<T>) -> Vec<T> {
        items.into_iter().skip(self.share - 1).step_by(self.of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_in_one_share_whichever_way_it_is_counted() {
        let items: Vec<usize> = (1..=20).collect();
        for of in 1..6 {
            let shares: Vec<Partition> = (1..=of).map(|k| format!("{k}/{of}").parse().unwrap()).collect();
            let mut all: Vec<usize> = shares.iter().flat_map(|s| s.of_all(items.clone())).collect();
            all.sort_unstable();
            assert_eq!(all, items);
            for share in shares {
                let held: Vec<usize> = items.iter().copied().filter(|&n| share.holds(n)).collect();
                assert_eq!(held, share.of_all(items.clone()));
            }
        }
        for wrong in ["0/4", "5/4", "1/0", "1", "a/b", "-1/3"] {
            assert!(wrong.parse::<Partition>().is_err(), "{wrong}");
        }
    }
}
