//! Where a body begins and ends, its velocity, its spin, and the arc of its farthest point.

use crate::collision::Answer;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-motion",
    about: "the motion bound of bodies that move",
    fits: |case| matches!(case.run.answer, Answer::MotionBound(_)),
    panels: r#"
[[panels]]
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, "velocity", "spin", "arc"]
"#,
};
