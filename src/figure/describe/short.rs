//! The short text: one sentence.

use crate::figure::runs::Run;
use crate::scene::Scene;

use super::result::{result, sentence};

/// One sentence for `alt`: the title in plain words, and the result of `run` with its number.
pub(crate) fn short(scene: &Scene, title: Option<&str>, run: &Run) -> String {
    match title {
        Some(title) => format!("{title}: {}", result(scene, run)),
        None => sentence(scene, run),
    }
}
