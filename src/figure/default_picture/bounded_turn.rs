//! The arc of the farthest point of a body that turns in its place, and its measures.

use crate::collision::Answer;
use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-turn",
    about: "the motion bound of a body that turns in its place",
    fits: |case| {
        let turns_in_place = |event: &Event| match *event {
            Event::MotionBounded { theta, linear, .. } => theta > 0.0 && linear == 0.0,
            _ => false,
        };
        let one = case.scene.query.of.len() == 1;
        one && matches!(case.run.answer, Answer::MotionBound(_)) && case.count(turns_in_place) == 1
    },
    panels: r#"
[[panels]]
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, { layer = "arc", sector = true }]
"#,
};
