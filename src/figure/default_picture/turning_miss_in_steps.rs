//! Bodies that turn and never meet: how near they come, and their separation over time, down to which no step
//! of the advancement goes. The places of two bodies that both move are left out: they would hide each other.

use crate::collision::Outcome;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "turning-miss-in-steps",
    about: "a miss of bodies that turn, by an advancement in several steps",
    fits: |case| case.turns() && case.steps() > 1 && matches!(case.outcome(), Some(Outcome::Miss)),
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = ["shapes", { layer = "ghosts", at = "steps", numbered = true }, "approach", "velocity", "spin"]

[[panels]]
title = "Separation over time"
time = "start"
layers = [{ layer = "graph", values = true }]
"#,
};
