//! A sweep without turning: the band in the world, and the ray that enters B ⊖ A at the same time.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "sweep-hit",
    about: "the hit of bodies that do not turn",
    fits: |case| case.hits(),
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = [
  "shapes",
  { layer = "ghosts", at = "hit" },
  "sweep",
  { layer = "velocity", accent = "hit" },
  "contact",
]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
layers = ["axes", "difference", "ray", "origin"]
"#,
};
