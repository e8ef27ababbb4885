//! Bodies that turn and meet, and B ⊖ A at every step of the advancement: it changes until it reaches the
//! origin.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-steps",
    about: "the hit of bodies that turn, by an advancement",
    fits: |case| case.hits() && case.turns() && case.steps() > 0,
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = ["shapes", { layer = "ghosts", at = "hit" }, "tracks", "contact"]

[[panels]]
title = "Configuration space, step by step"
space = "configuration"
time = "start"
layers = ["axes", { layer = "difference", at = "steps", numbers = true }, "origin"]
"#,
};
