//! All texts of ours that a figure may say, for pages in other languages than English.

use super::{describe, exercise, handle, language};

/// Every phrase and every row of words, in an order that stays.
pub(crate) fn all_texts() -> impl Iterator<Item = &'static [&'static str]> {
    let phrases = describe::all_phrases().chain(exercise::all_phrases()).map(|row| &row[..]);
    phrases.chain(language::WORDS.iter().chain(handle::NAMES).map(|row| &row[..]))
}
