//! The short text: one sentence.

use crate::figure::runs::Run;
use crate::figure::text::plain;
use crate::scene::Scene;

use super::result::{capitalized, result};

/// One sentence for `alt`: the title, and the result of `run` with its number.
pub(crate) fn short(scene: &Scene, run: &Run) -> String {
    let result = result(scene, run);
    match &scene.title {
        Some(title) => format!("{}: {result}", plain(&title.value)),
        None => capitalized(&result),
    }
}
