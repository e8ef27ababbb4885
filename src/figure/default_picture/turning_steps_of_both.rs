//! Bodies that both move and of which one turns: where they meet, on which paths, and their separation at
//! each step of an advancement. The places of two bodies at all steps would hide each other.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-steps-of-both",
    about: "the hit of bodies that both move, and turn, by an advancement",
    fits: |case| case.hits() && case.turns() && case.steps() > 0,
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = ["shapes", { layer = "ghosts", at = "hit" }, "tracks", "velocity", "spin", "contact"]

[[panels]]
title = "Separation over time"
time = "start"
layers = [{ layer = "graph", values = true }]
"#,
};
