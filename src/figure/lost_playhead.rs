//! A live figure that asks for a playhead and can have none.

use crate::scene::Scene;

use super::fault::{Fault, Problem};
use super::playhead::playhead;

/// A note on a scene that asks for a playhead where nothing moves, or every panel shows a moment of the
/// answer; none where it has one, or asks for none.
///
/// ```
/// use tracefig::{figure::no_playhead, scene::{Source, read}};
/// let text = |panel: &str| format!(
///     "shapes.A = {{ kind = 'circle', radius = 1, velocity = [4, 0] }}
///     shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
///     query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}\nlive = {{ time = true }}\n{panel}"
/// );
/// let note = |panel: &str| no_playhead(&read(&Source::new("s.toml", &text(panel))).unwrap());
/// assert!(note("").is_some_and(|note| note.fault.to_string().contains("no panel can follow")));
/// assert!(note("panels = [{ layers = ['shapes'] }]").is_none());
/// ```
#[must_use]
pub fn no_playhead(scene: &Scene) -> Option<Problem> {
    let why = "no panel can follow the playhead that `[live]` asks for";
    let is_lost = scene.live.time == Some(true) && playhead(scene).is_none();
    is_lost.then(|| Problem::new(Fault::NothingPlays { why }, scene.query.span.clone()))
}
