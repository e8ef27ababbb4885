//! Bodies apart, and the last simplex of GJK, whose closest point to the origin is the distance.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "gjk-distance",
    about: "GJK on bodies apart",
    fits: |case| case.count(|e| matches!(e, Event::SimplexUpdated { .. })) > 0,
    panels: r#"
[[panels]]
title = "World"
inset = "small"
layers = ["shapes", { layer = "separation", points = true }]

[[panels]]
title = "Configuration space"
space = "configuration"
inset = "small"
layers = ["axes", "difference", { layer = "simplex", values = true }, "origin"]
"#,
};
