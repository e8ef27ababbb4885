//! A body that goes straight, where it begins and where it ends: every point of it goes as far.

use crate::collision::Answer;
use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-translation",
    about: "the motion bound of a body that does not turn",
    fits: |case| {
        let turns = |event: &Event| matches!(*event, Event::MotionBounded { theta, .. } if theta > 0.0);
        let is_bound = matches!(case.run.answer, Answer::MotionBound(_));
        is_bound && case.scene.query.of.len() == 1 && case.count(turns) == 0
    },
    panels: r#"
[[panels]]
time = "start"
layers = [
  "shapes",
  { layer = "ghosts", at = "end" },
  { layer = "velocity", values = true, length = true },
]
"#,
};
