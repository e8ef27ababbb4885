//! The short text: one sentence.

use crate::figure::runs::Run;
use crate::figure::text::plain;
use crate::scene::Scene;

use super::result::{result, sentence};

/// One sentence for `alt`: the title, and the result of `run` with its number.
pub(crate) fn short(scene: &Scene, run: &Run) -> String {
    match &scene.title {
        Some(title) => format!("{}: {}", plain(&title.value), result(scene, run)),
        None => sentence(scene, run),
    }
}
