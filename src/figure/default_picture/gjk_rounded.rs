//! Bodies that overlap by their radii alone: GJK ends outside of the difference of their cores, and the last
//! simplex has the distance from which the radii are taken.

use crate::trace::Event;

use super::Picture;

pub(super) const PICTURE: Picture = Picture {
    name: "gjk-rounded",
    about: "GJK on bodies that overlap by their radii alone, so that there is no polytope",
    fits: |case| case.overlaps() && case.count(|e| matches!(e, Event::SimplexUpdated { .. })) > 0,
    panels: r#"
[[panels]]
title = "World"
inset = "small"
layers = [
  "shapes",
  { layer = "ghosts", of = "B", at = "separated" },
  { layer = "separation", points = true },
]

[[panels]]
title = "Configuration space"
space = "configuration"
inset = "small"
layers = ["axes", "difference", { layer = "simplex", values = true }, "origin"]
"#,
};
