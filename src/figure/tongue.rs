//! The language of the sentences of a figure, and the sign that its numbers have.

use crate::scene::Scene;
use crate::trace::Tongue;

use super::language::Language;
use super::text::Decimal;

/// The language of the sentences of ours about a scene: its own one where we have that, else English with
/// English numbers.
pub(crate) fn tongue(scene: &Scene) -> Tongue {
    match Language::of(scene).of_sentences() {
        0 => Tongue::ENGLISH,
        column => Tongue::new(column, Decimal::of(scene) == Decimal::Comma),
    }
}
