//! A sweep without turning that ends before it touches, or passes by: where the bodies are closest, in the
//! world and on the ray.

use crate::collision::Outcome;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "sweep-miss",
    about: "a miss of bodies that do not turn",
    fits: |case| matches!(case.outcome(), Some(Outcome::Miss)),
    panels: r#"
[[panels]]
title = "World"
time = "start"
inset = "small"
layers = ["shapes", "approach", "velocity"]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
inset = "small"
layers = ["axes", "difference", "ray", "origin", "approach"]
"#,
};
