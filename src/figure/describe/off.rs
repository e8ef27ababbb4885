//! How far off what someone else answered is, in a sentence.

use crate::figure::runs::Run;
use crate::figure::tongue::voice;
use crate::geometry::Names;
use crate::scene::{Scene, Solution};
use crate::trace::{Hand, sentence_in};

/// How far off what the scene expects is; empty where it expects nothing.
pub(super) fn compared(scene: &Scene, run: &Run, names: &Names) -> String {
    let off = scene.query.expected.and_then(|_| Solution::told(scene, run.answer.clone()).off);
    off.map_or_else(String::new, |off| sentence_in(&off.event(), voice(scene, names, Hand::Words)))
}
