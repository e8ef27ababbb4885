//! A sweep that hits in the first part of its way: the rest of it would leave no room for the bodies.

use crate::collision::Outcome;

use super::Picture;

/// Until when a hit is early: the whole way is then five times as long as what is shown of it.
const EARLY: f64 = 0.2;

pub(super) const PICTURE: Picture = Picture {
    name: "early-hit",
    about: "a hit in the first fifth of the motion, of bodies that do not turn",
    fits: |case| matches!(case.outcome(), Some(Outcome::Hit { time, .. }) if time.hi < EARLY),
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = ["shapes", { layer = "ghosts", at = "hit" }, "sweep", { layer = "velocity", cut = "hit" }, "contact"]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
layers = ["difference", { layer = "ray", cut = "hit" }, "origin"]
"#,
};
