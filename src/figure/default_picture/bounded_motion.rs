//! A body with its velocity, its spin, and the arc of its farthest point: the two parts of the bound. The
//! body at the end would have made both at once, so that no end of the arc lay on it.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-motion",
    about: "the motion bound of bodies that move",
    fits: |case| case.bounded(|_, _| true).is_some(),
    panels: r#"
[[panels]]
time = "start"
layers = [
  "shapes",
  { layer = "velocity", values = true, length = true },
  "spin",
  { layer = "arc", sector = true },
]
"#,
};
