//! Bodies that overlap before they move: how deep, and which way each is about to go.

use crate::collision::Outcome;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "overlap-at-start",
    about: "a question for the first contact of bodies that overlap from the start",
    fits: |case| matches!(case.outcome(), Some(Outcome::Overlapping { .. })),
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = ["shapes", { layer = "separation", points = true }, "velocity", "spin"]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
inset = "small"
layers = ["axes", "difference", "origin", "closest"]
"#,
};
