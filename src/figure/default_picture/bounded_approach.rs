//! Two bodies that pass each other, each with its velocity and, where it turns, the arc of its farthest
//! point; and the velocity of one as seen from the other: all parts of the bound.

use crate::collision::Answer;
use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-approach",
    about: "the motion bound of two bodies that pass each other",
    fits: |case| {
        let passes = |event: &Event| matches!(*event, Event::MotionBounded { linear, .. } if linear > 0.0);
        let is_bound = matches!(case.run.answer, Answer::MotionBound(_));
        is_bound && case.scene.query.of.len() == 2 && case.count(passes) > 0
    },
    panels: r#"
[[panels]]
title = "World"
time = "start"
layers = [
  "shapes",
  { layer = "velocity", values = true },
  { layer = "arc", of = "A", sector = true },
  { layer = "arc", of = "B", sector = true },
]

[[panels]]
title = "Relative velocity"
space = "configuration"
time = "start"
layers = ["axes", "origin", { layer = "velocity", values = true, length = true }]
"#,
};
