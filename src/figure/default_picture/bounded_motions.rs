//! Two bodies that both turn and do not pass each other, each with its velocity and the arc of its farthest
//! point: all parts of the bound. The angles say how they turn.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-motions",
    about: "the motion bound of two bodies that both turn",
    fits: |case| case.bounded(|theta, _| theta > 0.0) == Some(2),
    panels: r#"
[[panels]]
time = "start"
layers = [
  "shapes",
  { layer = "velocity", values = true },
  { layer = "arc", of = "A", sector = true },
  { layer = "arc", of = "B", sector = true },
]
"#,
};
