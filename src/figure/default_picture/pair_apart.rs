//! Bodies apart: their closest points, and the origin outside of B ⊖ A.

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "pair-apart",
    about: "two bodies apart",
    fits: |case| case.scene.query.of.len() > 1,
    panels: r#"
[[panels]]
title = "World"
inset = "small"
layers = ["shapes", { layer = "separation", points = true }]

[[panels]]
title = "Configuration space"
space = "configuration"
inset = "small"
layers = ["axes", "difference", "origin", "closest"]
"#,
};
