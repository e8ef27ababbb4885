//! Bodies that turn and meet, and the paths of the two points that touch.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-hit",
    about: "the hit of bodies that turn",
    fits: |case| case.hits() && case.turns(),
    panels: r#"
[[panels]]
time = "start"
inset = "small"
layers = ["shapes", { layer = "ghosts", at = "hit" }, "tracks", "velocity", "spin", "contact"]
"#,
};
