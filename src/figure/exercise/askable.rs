//! What may be asked for, found by its name and told in words.

use crate::collision::QueryKind;

use super::of_contacts;
use super::quantities::{self, Askable};

/// Every row, in the order in which they are listed.
pub(super) fn all() -> impl Iterator<Item = &'static Askable> {
    quantities::ASKABLE.iter().chain(of_contacts::ASKABLE)
}

/// Every value that `[exercise]` may ask for, with what it is.
///
/// ```
/// let depth = tracefig::figure::exercise::askables().find(|(name, _)| *name == "depth").unwrap();
/// assert_eq!(depth.1, "the depth by which A and B overlap");
/// ```
pub fn askables() -> impl Iterator<Item = (&'static str, String)> {
    all().map(|row| (row.name, in_words(row.what[0], ["A and B", "A", "B"])))
}

/// What is to be found, of bodies that are called so: both, the first, the second.
pub(super) fn in_words(what: &str, [all, a, b]: [&str; 3]) -> String {
    what.replace("{}", all).replace("{a}", a).replace("{b}", b)
}

/// The value of a name that can be asked for in a kind of question.
pub(crate) fn askable(name: &str, kind: QueryKind) -> Option<&'static Askable> {
    all().find(|row| row.name == name && (row.of)(kind))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::values;

    #[test]
    fn every_row_is_a_value_of_texts() {
        for row in all() {
            assert!(values().any(|(name, _)| name == row.name), "{}", row.name);
        }
    }
}
