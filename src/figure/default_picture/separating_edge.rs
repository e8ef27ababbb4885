//! Bodies apart: the shadows on the normal of the edge that separates them, and B ⊖ A without the origin.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "separating-edge",
    about: "bodies that an edge of B ⊖ A separates, where no other was looked at",
    fits: |case| case.count(|e| matches!(e, Event::SeparatingAxisFound { .. })) > 0,
    panels: r#"
[[panels]]
title = "World"
inset = "small"
layers = ["shapes", "projection"]

[[panels]]
title = "Configuration space"
space = "configuration"
inset = "small"
layers = ["axes", "difference", "origin", "closest"]
"#,
};
