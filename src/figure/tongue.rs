//! The language of the sentences of a figure, and the sign that its numbers have.

use crate::collision::scale_of;
use crate::geometry::Names;
use crate::scene::Scene;
use crate::trace::{Hand, Tongue, Voice};

use super::language::Language;
use super::text::{Decimal, Places};

/// The language of the sentences of ours about a scene: its own one where we have that, else English with
/// English numbers.
pub(crate) fn tongue(scene: &Scene) -> Tongue {
    match Language::of(scene).of_sentences() {
        0 => Tongue::ENGLISH,
        column => Tongue::new(column, Decimal::of(scene) == Decimal::Comma),
    }
}

/// The voice in which a reader of a figure is told what an algorithm did.
pub(super) fn voice<'n>(scene: &Scene, names: &'n Names, hand: Hand) -> Voice<'n> {
    let query = scene.query_of_bodies();
    // Of one body nothing is told that could be next to nothing.
    let size = query.b.map_or(0.0, |b| scale_of(query.a, b));
    Voice { names, tongue: tongue(scene), hand, size, unit: Places::of(scene).unit }
}
