//! All texts of ours that a figure may say, for pages in other languages than English.

use super::layer::LAYERS;
use super::{asked, describe, handle, language};

/// Every phrase and every row of words, in an order that stays.
pub(crate) fn all_texts() -> impl Iterator<Item = &'static [&'static str]> {
    // A page asks no exercise.
    let phrases = describe::all_phrases().chain(asked::ALL.iter().copied()).map(|row| &row[..]);
    let layers = LAYERS.iter().map(|layer| &layer.in_words[..]);
    phrases.chain(layers).chain(language::WORDS.iter().chain(handle::NAMES).map(|row| &row[..]))
}
