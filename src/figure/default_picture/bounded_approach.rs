//! Two bodies that pass each other, each with its velocity and, where it turns, the arc of its farthest
//! point; and the velocity of one as seen from the other: all parts of the bound.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-approach",
    about: "the motion bound of two bodies that pass each other",
    fits: |case| case.bounded(|_, way| way > 0.0) == Some(2),
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
