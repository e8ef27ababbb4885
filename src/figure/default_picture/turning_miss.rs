//! Bodies that turn and do not meet, or not for certain, where they begin and end.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-miss",
    about: "no proved hit of bodies that turn",
    fits: |case| case.outcome().is_some() && case.turns(),
    panels: r#"
[[panels]]
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, "velocity", "spin"]
"#,
};
