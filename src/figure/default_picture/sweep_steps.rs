//! The first two steps of an advancement along the ray, beside the bodies.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "sweep-steps",
    about: "the hit of bodies that do not turn, by an advancement",
    fits: |case| case.hits() && case.steps() > 1,
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = [
  "shapes",
  { layer = "ghosts", at = "hit" },
  "sweep",
  "velocity",
  "contact",
]

[[panels]]
title = "Step 1"
space = "configuration"
step = 1
inset = "small"
layers = [{ layer = "difference", at = "start" }, "velocity", "origin", "advancement"]

[[panels]]
title = "Step 2"
space = "configuration"
step = 2
inset = "small"
layers = [{ layer = "difference", at = "start" }, "velocity", "origin", "advancement"]
"#,
};
