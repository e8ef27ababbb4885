//! A body that goes straight, where it begins and where it ends: every point of it goes as far.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "bounded-translation",
    about: "the motion bound of a body that does not turn",
    fits: |case| case.scene.query.of.len() == 1 && case.bounded(|theta, _| theta > 0.0) == Some(0),
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
