//! A sweep without turning that ends before it touches, or passes by: the ray does not enter B ⊖ A.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "sweep-miss",
    about: "no proved hit of bodies that do not turn",
    fits: |case| case.outcome().is_some(),
    panels: r#"
[[panels]]
title = "World"
time = "start"
layers = ["shapes", { layer = "ghosts", at = "end" }, "velocity"]

[[panels]]
title = "Configuration space"
space = "configuration"
time = "start"
layers = ["axes", "difference", "ray", "origin"]
"#,
};
