//! All texts of ours that a figure may say, for pages in other languages than English.

use super::layer::LAYERS;
use super::{describe, exercise, handle, language};

/// Every phrase and every row of words, in an order that stays.
pub(crate) fn all_texts() -> impl Iterator<Item = &'static [&'static str]> {
    let phrases = describe::all_phrases().chain(exercise::all_phrases()).map(|row| &row[..]);
    let layers = LAYERS.iter().map(|layer| &layer.in_words[..]);
    phrases.chain(layers).chain(language::WORDS.iter().chain(handle::NAMES).map(|row| &row[..]))
}
